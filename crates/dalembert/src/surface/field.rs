//! Vectors over a surface.

use super::Partials;
use nalgebra::{Matrix3, Vector3};

/// A vector that is a function of the two or three coordinates of a point of a surface, with its first and second
/// derivatives by them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field {
    /// Value.
    pub value: Vector3<f64>,
    /// First derivatives; the third is zero where there are two coordinates.
    pub by: [Vector3<f64>; 3],
    /// Second derivatives.
    pub second: [[Vector3<f64>; 3]; 3],
    /// Number of coordinates.
    count: usize,
}

/// Orders of differentiation by (first, second) parameter for an index.
fn orders(index: usize) -> (usize, usize) {
    (1 - index, index)
}

impl Field {
    /// The point of a surface.
    pub fn point(p: &Partials) -> Self {
        Self::derivative(p, 0, 0)
    }

    /// The tangent along a parameter: du/da or du/db.
    pub fn tangent(p: &Partials, along: usize) -> Self {
        let (i, j) = orders(along);
        Self::derivative(p, i, j)
    }

    fn derivative(p: &Partials, i: usize, j: usize) -> Self {
        let mut field = Self::constant(p.of(i, j), 2);
        for k in 0..2 {
            let (a, b) = orders(k);
            field.by[k] = p.of(i + a, j + b);
            // Third derivatives are the highest that are known and needed.
            for l in 0..if i + j < 2 { 2 } else { 0 } {
                let (c, d) = orders(l);
                field.second[k][l] = p.of(i + a + c, j + b + d);
            }
        }
        field
    }

    fn constant(value: Vector3<f64>, count: usize) -> Self {
        Self {
            value,
            by: [Vector3::zeros(); 3],
            second: [[Vector3::zeros(); 3]; 3],
            count,
        }
    }

    /// The field diag(factors) w of three coordinates w.
    pub fn scaled(factors: &Vector3<f64>, w: &Vector3<f64>) -> Self {
        let mut field = Self::constant(factors.component_mul(w), 3);
        for k in 0..3 {
            field.by[k][k] = factors[k];
        }
        field
    }

    /// The cross product of two fields over the same surface.
    pub fn cross(&self, other: &Self) -> Self {
        let (a, b) = (self, other);
        let mut field = Self::constant(a.value.cross(&b.value), a.count);
        for k in 0..a.count {
            field.by[k] = a.by[k].cross(&b.value) + a.value.cross(&b.by[k]);
            for l in 0..a.count {
                field.second[k][l] = a.second[k][l].cross(&b.value)
                    + a.by[k].cross(&b.by[l])
                    + a.by[l].cross(&b.by[k])
                    + a.value.cross(&b.second[k][l]);
            }
        }
        field
    }

    /// The field with unit length; it must not vanish.
    pub fn unit(&self) -> Self {
        let length = self.value.norm();
        let unit = self.value / length;
        let slope = self.by.map(|by| unit.dot(&by));
        let mut field = Self::constant(unit, self.count);
        for (own, (by, slope)) in field.by.iter_mut().zip(self.by.iter().zip(slope)) {
            *own = (by - slope * unit) / length;
        }
        for k in 0..self.count {
            for l in 0..self.count {
                let bend = field.by[l].dot(&self.by[k]) + unit.dot(&self.second[k][l]);
                let turned = slope[k] * field.by[l] + bend * unit + slope[l] * field.by[k];
                field.second[k][l] = (self.second[k][l] - turned) / length;
            }
        }
        field
    }

    /// The sum with a multiple of another field over the same surface.
    pub fn plus(&self, factor: f64, other: &Self) -> Self {
        let mut field = *self;
        field.value += factor * other.value;
        for k in 0..self.count {
            field.by[k] += factor * other.by[k];
            for l in 0..self.count {
                field.second[k][l] += factor * other.second[k][l];
            }
        }
        field
    }

    /// The field in other axes: the columns of `axes` are the axes in which it is given.
    pub fn turned(&self, axes: &Matrix3<f64>) -> Self {
        let mut field = Self::constant(axes * self.value, self.count);
        for k in 0..self.count {
            field.by[k] = axes * self.by[k];
            for l in 0..self.count {
                field.second[k][l] = axes * self.second[k][l];
            }
        }
        field
    }

    /// Rate with the coordinates' rates s' and the angular velocity of the surface.
    pub fn rate(&self, s: &[f64], omega: &Vector3<f64>) -> Vector3<f64> {
        omega.cross(&self.value) + self.along(s)
    }

    /// Second rate where the accelerations of the coordinates and of the surface's frame vanish.
    pub fn bias(&self, s: &[f64], omega: &Vector3<f64>) -> Vector3<f64> {
        let mut bend = Vector3::zeros();
        for k in 0..self.count {
            for l in 0..self.count {
                bend += s[k] * s[l] * self.second[k][l];
            }
        }
        omega.cross(&omega.cross(&self.value)) + 2.0 * omega.cross(&self.along(s)) + bend
    }

    fn along(&self, s: &[f64]) -> Vector3<f64> {
        let parts = self.by[..self.count].iter().zip(s);
        parts.fold(Vector3::zeros(), |sum, (by, s)| sum + *s * by)
    }
}
