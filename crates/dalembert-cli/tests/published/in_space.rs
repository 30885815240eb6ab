//! Vectors and orientations of spatial runs.

use super::harness::Run;

const AXES: [&str; 3] = ["x", "y", "z"];

impl Run {
    /// A vector at an instant, from the channels of its three components, without their last letter:
    /// "bar." for the position, "bar.v", "pin.force_".
    pub fn vector(&self, time: f64, name: &str) -> [f64; 3] {
        AXES.map(|axis| self.at(time, &format!("{name}{axis}")))
    }

    /// A vector must have three components to an absolute tolerance.
    pub fn near_vector(&mut self, time: f64, name: &str, expected: [f64; 3], tolerance: f64) {
        for (axis, value) in AXES.into_iter().zip(expected) {
            self.near(time, &format!("{name}{axis}"), value, tolerance);
        }
    }

    /// Matrix A of a body, whose columns are its axes, from its Euler parameters.
    pub fn matrix(&self, time: f64, body: &str) -> [[f64; 3]; 3] {
        let [w, x, y, z] = [0, 1, 2, 3].map(|k| self.at(time, &format!("{body}.b{k}")));
        [
            [
                1.0 - 2.0 * (y * y + z * z),
                2.0 * (x * y - w * z),
                2.0 * (x * z + w * y),
            ],
            [
                2.0 * (x * y + w * z),
                1.0 - 2.0 * (x * x + z * z),
                2.0 * (y * z - w * x),
            ],
            [
                2.0 * (x * z - w * y),
                2.0 * (y * z + w * x),
                1.0 - 2.0 * (x * x + y * y),
            ],
        ]
    }

    /// A vector of ground axes in the axes of a body: A^T v.
    pub fn in_body(&self, time: f64, body: &str, name: &str) -> [f64; 3] {
        let a = self.matrix(time, body);
        let v = self.vector(time, name);
        [0, 1, 2].map(|k| (0..3).map(|row| a[row][k] * v[row]).sum())
    }

    /// A vector in the axes of a body must have three components to an absolute tolerance.
    pub fn near_in_body(
        &mut self,
        time: f64,
        body: &str,
        name: &str,
        expected: [f64; 3],
        tolerance: f64,
    ) {
        let found = self.in_body(time, body, name);
        for ((axis, found), value) in AXES.into_iter().zip(found).zip(expected) {
            let what = format!("{name}{axis} in the axes of {body} at {time} s");
            self.same(&what, found, value, tolerance);
        }
    }

    /// Channels that must be zero at an instant, to an absolute tolerance.
    pub fn zero_at(&mut self, time: f64, owner: &str, suffixes: &[&str], tolerance: f64) {
        for suffix in suffixes {
            self.near(time, &format!("{owner}.{suffix}"), 0.0, tolerance);
        }
    }

    /// Channels that must stay zero at every instant, to an absolute tolerance.
    pub fn zero(&mut self, owner: &str, suffixes: &[&str], tolerance: f64) {
        for time in self.channel("time").to_vec() {
            self.zero_at(time, owner, suffixes, tolerance);
        }
    }
}
