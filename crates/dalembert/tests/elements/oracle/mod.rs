//! The constraints once more, from their geometry alone and for any kind of number: dual numbers then give their exact
//! derivatives, independently of those that the engine has written out.

mod cam;
mod joints;
mod rows;

pub use cam::{CamOracle, CamProfile, Touch};
pub use joints::{Gear, Pair, Rolling, RollingCircle};
pub use rows::{Difference, Expression, Follow, Motion, Sum, Term, What};

use num_dual::DualNum;

/// A number: plain, dual, or dual of second order.
pub trait Number: DualNum<f64> + Copy {}
impl<D: DualNum<f64> + Copy> Number for D {}

/// A vector of the plane.
pub type Vector<D> = [D; 2];

/// Residuals of one or more elements.
pub trait Residual {
    /// All rows, up to their constants.
    fn rows<D: Number>(&self, machine: &Machine<D>) -> Vec<D>;

    /// Constants that the rows take from the estimated pose.
    fn constants(&self, estimate: &Machine<f64>) -> Vec<f64> {
        vec![0.0; self.rows(estimate).len()]
    }
}

/// The rows of one oracle, then those of another.
pub struct Both<A, B>(pub A, pub B);

impl<A: Residual, B: Residual> Residual for Both<A, B> {
    fn rows<D: Number>(&self, machine: &Machine<D>) -> Vec<D> {
        let mut rows = self.0.rows(machine);
        rows.extend(self.1.rows(machine));
        rows
    }

    fn constants(&self, estimate: &Machine<f64>) -> Vec<f64> {
        let mut rows = self.0.constants(estimate);
        rows.extend(self.1.constants(estimate));
        rows
    }
}

/// The three bodies of these tests (see `bodies`), a time, and auxiliary coordinates.
pub struct Machine<D> {
    pub t: D,
    /// Centre of mass x, y and angle of each body, then the auxiliary coordinates.
    pub q: Vec<D>,
}

/// Centres of mass in the bodies' frames and estimated frames, as in `bodies`.
const CENTERS: [[f64; 2]; 3] = [[0.13, -0.21], [-0.17, 0.08], [0.05, 0.11]];
const ESTIMATES: [[f64; 3]; 3] = [[0.2, 0.5, 0.3], [1.1, 0.9, -0.4], [-0.6, 0.4, 1.2]];

/// Number of coordinates of the bodies.
const BODY_COORDINATES: usize = 9;

impl Machine<f64> {
    /// The estimated pose of the model.
    pub fn estimate() -> Self {
        let mut q = Vec::new();
        for ([x, y, angle], [cx, cy]) in ESTIMATES.into_iter().zip(CENTERS) {
            let (s, c) = angle.sin_cos();
            q.extend([x + c * cx - s * cy, y + s * cx + c * cy, angle]);
        }
        Self { t: 0.0, q }
    }
}

impl<D: Number> Machine<D> {
    /// A frame on a body or on the ground.
    pub fn marker(&self, body: &str, at: [f64; 2], angle: f64) -> Marker<D> {
        let Some(k) = ["a", "b", "c"].iter().position(|name| *name == body) else {
            assert_eq!(body, "ground");
            return Marker {
                point: at.map(D::from),
                angle: D::from(angle),
            };
        };
        let [x, y, th] = [0, 1, 2].map(|i| self.q[3 * k + i]);
        let arm = [0, 1].map(|i| D::from(at[i] - CENTERS[k][i]));
        let turned = turn(th, arm);
        Marker {
            point: [x + turned[0], y + turned[1]],
            angle: th + angle,
        }
    }

    /// The auxiliary coordinate of the only element that has one.
    pub fn auxiliary(&self) -> D {
        self.q[BODY_COORDINATES]
    }
}

/// A frame: its point and its angle.
pub struct Marker<D> {
    pub point: Vector<D>,
    pub angle: D,
}

impl<D: Number> Marker<D> {
    /// Direction of the frame's x axis.
    pub fn ex(&self) -> Vector<D> {
        [self.angle.cos(), self.angle.sin()]
    }

    /// Direction of the frame's y axis.
    pub fn ey(&self) -> Vector<D> {
        [-self.angle.sin(), self.angle.cos()]
    }

    /// From this point to another's.
    pub fn to(&self, other: &Self) -> Vector<D> {
        [0, 1].map(|k| other.point[k] - self.point[k])
    }
}

/// A vector turned by an angle.
pub fn turn<D: Number>(angle: D, v: Vector<D>) -> Vector<D> {
    let (s, c) = angle.sin_cos();
    [c * v[0] - s * v[1], s * v[0] + c * v[1]]
}

/// Scalar product.
pub fn dot<D: Number>(a: Vector<D>, b: Vector<D>) -> D {
    a[0] * b[0] + a[1] * b[1]
}
