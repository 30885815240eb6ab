//! Vectors over a surface.

use super::Partials;
use nalgebra::{Matrix3, Vector3};

/// A vector that is a function of the two parameters of a surface, with its first and second derivatives by them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field {
    /// Value.
    pub value: Vector3<f64>,
    /// First derivatives.
    pub by: [Vector3<f64>; 2],
    /// Second derivatives.
    pub second: [[Vector3<f64>; 2]; 2],
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
        let by = |k: usize| {
            let (a, b) = orders(k);
            p.of(i + a, j + b)
        };
        let second = |k: usize, l: usize| {
            let ((a, b), (c, d)) = (orders(k), orders(l));
            if i + j + 2 > 3 {
                return Vector3::zeros();
            }
            p.of(i + a + c, j + b + d)
        };
        Self {
            value: p.of(i, j),
            by: [by(0), by(1)],
            second: [[second(0, 0), second(0, 1)], [second(1, 0), second(1, 1)]],
        }
    }

    /// The cross product of two fields over the same surface.
    pub fn cross(&self, other: &Self) -> Self {
        let (a, b) = (self, other);
        let pair = |k: usize, l: usize| {
            a.second[k][l].cross(&b.value)
                + a.by[k].cross(&b.by[l])
                + a.by[l].cross(&b.by[k])
                + a.value.cross(&b.second[k][l])
        };
        Self {
            value: a.value.cross(&b.value),
            by: [0, 1].map(|k| a.by[k].cross(&b.value) + a.value.cross(&b.by[k])),
            second: [0, 1].map(|k| [0, 1].map(|l| pair(k, l))),
        }
    }

    /// The field with unit length; it must not vanish.
    pub fn unit(&self) -> Self {
        let length = self.value.norm();
        let unit = self.value / length;
        let slope = [0, 1].map(|k: usize| unit.dot(&self.by[k]));
        let by = [0, 1].map(|k: usize| (self.by[k] - slope[k] * unit) / length);
        let second = |k: usize, l: usize| {
            let bend = by[l].dot(&self.by[k]) + unit.dot(&self.second[k][l]);
            (self.second[k][l] - slope[k] * by[l] - bend * unit - slope[l] * by[k]) / length
        };
        Self {
            value: unit,
            by,
            second: [0, 1].map(|k| [0, 1].map(|l| second(k, l))),
        }
    }

    /// The sum with a multiple of another field over the same surface.
    pub fn plus(&self, factor: f64, other: &Self) -> Self {
        Self {
            value: self.value + factor * other.value,
            by: [0, 1].map(|k: usize| self.by[k] + factor * other.by[k]),
            second: [0, 1].map(|k: usize| {
                [0, 1].map(|l: usize| self.second[k][l] + factor * other.second[k][l])
            }),
        }
    }

    /// The field in other axes: the columns of `axes` are the axes in which it is given.
    pub fn turned(&self, axes: &Matrix3<f64>) -> Self {
        Self {
            value: axes * self.value,
            by: self.by.map(|x| axes * x),
            second: self.second.map(|row| row.map(|x| axes * x)),
        }
    }

    /// Rate with the parameters' rates s' and the angular velocity of the surface.
    pub fn rate(&self, s: &[f64], omega: &Vector3<f64>) -> Vector3<f64> {
        omega.cross(&self.value) + self.along(s)
    }

    /// Second rate where the accelerations of the parameters and of the surface's frame vanish.
    pub fn bias(&self, s: &[f64], omega: &Vector3<f64>) -> Vector3<f64> {
        let mut bend = Vector3::zeros();
        for k in 0..2 {
            for l in 0..2 {
                bend += s[k] * s[l] * self.second[k][l];
            }
        }
        omega.cross(&omega.cross(&self.value)) + 2.0 * omega.cross(&self.along(s)) + bend
    }

    fn along(&self, s: &[f64]) -> Vector3<f64> {
        s[0] * self.by[0] + s[1] * self.by[1]
    }
}
