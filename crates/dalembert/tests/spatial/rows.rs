//! The rows of joints and quantities from their geometry, for any kind of number.

use super::machine::{Machine, Spot, between};
use super::oracle::{Marker, Number, dot};
use std::f64::consts::TAU;

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

/// The angle about z of the first frame to the x axis of the second, on the turn nearest to a memory.
fn angle<D: Number>(a: &Marker<D>, b: &Marker<D>, memory: f64) -> D {
    let x = dot(&a.axes[0], &b.axes[0]);
    let y = dot(&a.axes[1], &b.axes[0]);
    let principal = y.atan2(x);
    principal + TAU * ((memory - principal.re()) / TAU).round()
}

/// A joint of two frames. Rows are minus the geometry: C = first - second.
pub struct Pair {
    pub kind: &'static str,
    pub spots: [Spot; 2],
    /// Pitch of a screw.
    pub pitch: f64,
}

impl Residual for Pair {
    fn rows<D: Number>(&self, machine: &Machine<D>) -> Vec<D> {
        let [a, b] = [0, 1].map(|k| machine.marker(&self.spots[k]));
        let d = between(&a, &b);
        let along = |k: usize| -dot(&a.axes[k], &d);
        let cosine = |i: usize, j: usize| -dot(&a.axes[i], &b.axes[j]);
        let together = || d.map(|x| -x).to_vec();
        let on_axis = || vec![along(0), along(1)];
        let parallel = || vec![cosine(0, 2), cosine(1, 2)];
        let alike = || vec![cosine(0, 1), cosine(1, 2), cosine(2, 0)];
        match self.kind {
            "spherical" => together(),
            "revolute" => [together(), parallel()].concat(),
            "cylindrical" => [on_axis(), parallel()].concat(),
            "prismatic" => [on_axis(), alike()].concat(),
            "weld" => [together(), alike()].concat(),
            // z of the first frame and x of the second are the axes of the cross.
            "universal" => [together(), vec![cosine(2, 0)]].concat(),
            "constant-velocity" => [together(), vec![cosine(0, 1) - cosine(1, 0)]].concat(),
            "screw" => {
                let turn = angle(&a, &b, machine.memory[0]);
                let thread = along(2) + turn * (self.pitch / TAU);
                [on_axis(), parallel(), vec![thread]].concat()
            }
            "planar" => [vec![along(2)], parallel()].concat(),
            "distance" => vec![-dot(&d, &d).sqrt()],
            "point-on-line" => on_axis(),
            "point-on-plane" => vec![along(2)],
            "parallel-axes" => parallel(),
            "perpendicular-axes" => vec![cosine(2, 2)],
            other => panic!("no oracle for {other}"),
        }
    }

    fn constants(&self, estimate: &Machine<f64>) -> Vec<f64> {
        let mut rows = self.rows(estimate);
        let kept = match self.kind {
            "distance" => 0,
            "screw" => 4,
            _ => rows.len(),
        };
        rows[..kept].fill(0.0);
        rows
    }
}

/// The curve of these tests, in the axes of the first frame.
pub struct Curve(pub [Spot; 2]);

impl Curve {
    pub const TEXT: [&'static str; 3] = ["0.3 m * cos(u)", "0.2 m * u^2", "0.1 m * exp(0.5 * u)"];
}

impl Residual for Curve {
    fn rows<D: Number>(&self, machine: &Machine<D>) -> Vec<D> {
        let [a, b] = [0, 1].map(|k| machine.marker(&self.0[k]));
        let d = between(&a, &b);
        let s = machine.auxiliary[0];
        let curve = [s.cos() * 0.3, s * s * 0.2, (s * 0.5).exp() * 0.1];
        [0, 1, 2].map(|k| curve[k] - dot(&a.axes[k], &d)).to_vec()
    }
}

/// A scalar quantity.
#[derive(Clone, Copy)]
pub enum What {
    /// Ground coordinate of a point.
    Ground(Spot, usize),
    /// Angle of two frames, and the number of its memory.
    Angle([Spot; 2], usize),
    /// Displacement along z of the first frame.
    Along([Spot; 2]),
    Distance([Spot; 2]),
    /// Difference of a ground coordinate of two points.
    Difference([Spot; 2], usize),
}

impl What {
    pub fn value<D: Number>(&self, machine: &Machine<D>) -> D {
        let both = |spots: &[Spot; 2]| [machine.marker(&spots[0]), machine.marker(&spots[1])];
        match self {
            Self::Ground(spot, axis) => machine.marker(spot).point[*axis],
            Self::Angle(spots, memory) => {
                let [a, b] = both(spots);
                angle(&a, &b, machine.memory[*memory])
            }
            Self::Along(spots) => {
                let [a, b] = both(spots);
                dot(&a.axes[2], &between(&a, &b))
            }
            Self::Distance(spots) => {
                let [a, b] = both(spots);
                let d = between(&a, &b);
                dot(&d, &d).sqrt()
            }
            Self::Difference(spots, axis) => {
                let [a, b] = both(spots);
                between(&a, &b)[*axis]
            }
        }
    }
}

/// A sum of quantities with factors that keeps a value; none: that of the estimate.
pub struct Sum(pub Vec<(f64, What)>, pub Option<f64>);

impl Residual for Sum {
    fn rows<D: Number>(&self, machine: &Machine<D>) -> Vec<D> {
        let terms = self.0.iter().map(|(f, what)| what.value(machine) * *f);
        vec![terms.fold(D::from(0.0), |sum, term| sum + term)]
    }

    fn constants(&self, estimate: &Machine<f64>) -> Vec<f64> {
        vec![self.1.unwrap_or_else(|| self.rows(estimate)[0])]
    }
}

/// The motions of these tests.
#[derive(Clone, Copy)]
pub enum Motion {
    /// 0.2 + 0.3 sin(1.5 t) + 0.1 t^3.
    Sine,
    /// 0.3 and the integral of 0.4 cos(1.5 t) + 0.2.
    ByRate,
    /// 0.4 cos(2 t).
    Cosine,
}

/// A quantity that follows a motion.
pub struct Follow(pub What, pub Motion);

impl Residual for Follow {
    fn rows<D: Number>(&self, machine: &Machine<D>) -> Vec<D> {
        let t = machine.t;
        let sine = (t * 1.5).sin();
        let motion = match self.1 {
            Motion::Sine => sine * 0.3 + t * t * t * 0.1 + 0.2,
            Motion::ByRate => sine * (0.4 / 1.5) + t * 0.2 + 0.3,
            Motion::Cosine => (t * 2.0).cos() * 0.4,
        };
        vec![self.0.value(machine) - motion]
    }
}
