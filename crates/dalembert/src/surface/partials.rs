//! Partial derivatives of a surface.

use nalgebra::Vector3;

/// A point u(a, b) of a surface and its partial derivatives up to the third order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Partials([Vector3<f64>; 10]);

/// Place of the derivative of order i by the first and j by the second parameter.
const fn place(i: usize, j: usize) -> usize {
    // Orders 0, 1, 2, 3 start at 0, 1, 3, 6.
    let order = i + j;
    order * (order + 1) / 2 + j
}

impl Partials {
    /// From a function of the two orders.
    pub fn new(mut of: impl FnMut(usize, usize) -> Vector3<f64>) -> Self {
        let mut all = [Vector3::zeros(); 10];
        for order in 0..4 {
            for j in 0..=order {
                all[place(order - j, j)] = of(order - j, j);
            }
        }
        Self(all)
    }

    /// The derivative of order i by the first and j by the second parameter, i + j <= 3.
    pub fn of(&self, i: usize, j: usize) -> Vector3<f64> {
        self.0[place(i, j)]
    }
}
