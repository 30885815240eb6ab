//! A cam and its follower, held in contact.

use super::{ConstraintElement, ConstraintInput, ConstraintOutput, RowLabel, RowUnit};
use crate::space::{Planar, perpendicular};
use dalembert_expr::Program;
use nalgebra::{Vector2, Vector3};
use std::f64::consts::TAU;

/// Profile of a cam in the axes of its marker, by the surface parameter phi.
#[derive(Clone, Debug)]
pub enum Profile {
    /// u = d(phi) (cos phi, sin phi) (Shabana 3.95).
    Polar(Program),
    /// u = (x(phi), y(phi)).
    Cartesian(Program, Program),
}

/// What touches the cam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Follower {
    /// The point of the second marker lies on the profile (Shabana 3.96).
    KnifeEdge,
    /// A roller of this radius about the point of the second marker (Shabana 3.98).
    Roller(f64),
    /// The x axis of the second marker is tangent to the profile (Shabana 3.101).
    Flat,
}

/// Contact of a cam (first marker) with its follower (second marker).
///
/// Auxiliary coordinate: phi. With P the profile's point and T = dP/dphi in ground axes:
/// knife edge: P - r_b = 0 (2 rows);
/// roller: (n.n - r^2)/(2 r) = 0 and T.n/r = 0 with n = P - r_b;
/// flat: e_y.(P - r_b) = 0 and e_y.T = 0 with e_y the normal of the face.
/// The second row of roller and face holds d3u/dphi3 in its bias.
#[derive(Clone, Debug)]
pub struct Cam {
    /// Profile.
    pub profile: Profile,
    /// Follower.
    pub follower: Follower,
}

fn derivatives(program: &Program, phi: f64) -> [f64; 4] {
    program.eval_third(if program.slots().is_empty() {
        &[]
    } else {
        std::slice::from_ref(&phi)
    })
}

impl Profile {
    /// u and its first three derivatives by phi.
    pub fn derivatives(&self, phi: f64) -> [Vector2<f64>; 4] {
        match self {
            Self::Cartesian(x, y) => {
                let (x, y) = (derivatives(x, phi), derivatives(y, phi));
                std::array::from_fn(|k| Vector2::new(x[k], y[k]))
            }
            Self::Polar(radius) => {
                let d = derivatives(radius, phi);
                let (s, c) = phi.sin_cos();
                let e = Vector2::new(c, s);
                let n = Vector2::new(-s, c);
                // Leibniz with e' = n, n' = -e.
                [
                    d[0] * e,
                    d[1] * e + d[0] * n,
                    (d[2] - d[0]) * e + 2.0 * d[1] * n,
                    (d[3] - 3.0 * d[1]) * e + (3.0 * d[2] - d[0]) * n,
                ]
            }
        }
    }
}

/// Points of a cam's outline: a corner every two degrees is finer than a screen shows.
const OUTLINE: u32 = 180;

/// How far apart the ends of a closed outline may be, relative to its size.
const CLOSED: f64 = 1e-6;

/// A vector that moves with the cam and along its profile: value, derivative by phi, derivative by
/// the cam's angle, rate of change of itself at zero accelerations, second rate.
struct Moving {
    value: Vector2<f64>,
    by_phi: Vector2<f64>,
    by_angle: Vector2<f64>,
    rate: Vector2<f64>,
    bias: Vector2<f64>,
}

impl Moving {
    /// A u(phi) with u's first two derivatives; w the cam's angular velocity, s the rate of phi.
    fn new(u: [Vector2<f64>; 3], ex: &Vector2<f64>, w: f64, s: f64) -> Self {
        let turn = |a: Vector2<f64>| a.x * ex + a.y * perpendicular(ex);
        let [u, u1, u2] = u.map(turn);
        Self {
            value: u,
            by_phi: u1,
            by_angle: perpendicular(&u),
            rate: w * perpendicular(&u) + s * u1,
            bias: -w * w * u + 2.0 * w * s * perpendicular(&u1) + s * s * u2,
        }
    }
}

impl ConstraintElement<Planar> for Cam {
    fn labels(&self) -> Vec<RowLabel> {
        let texts = match self.follower {
            Follower::KnifeEdge => ["contact x", "contact y"],
            Follower::Roller(_) | Follower::Flat => ["contact", "tangency"],
        };
        texts
            .map(|text| RowLabel {
                text: text.to_owned(),
                unit: RowUnit::Length,
            })
            .to_vec()
    }

    fn auxiliaries(&self) -> Vec<RowLabel> {
        vec![RowLabel {
            text: "phi".to_owned(),
            unit: RowUnit::Angle,
        }]
    }

    fn outline(&self) -> Vec<[f64; 2]> {
        let at = |k: u32| {
            let phi = TAU * f64::from(k) / f64::from(OUTLINE);
            self.profile.derivatives(phi)[0]
        };
        let points: Vec<Vector2<f64>> = (0..OUTLINE).map(at).collect();
        let size = points.iter().fold(0.0, |m: f64, p| m.max(p.norm()));
        // A profile that does not close on itself in a turn, or is not defined all around, is no
        // outline.
        let gap = (at(OUTLINE) - at(0)).norm();
        if gap > CLOSED * size
            || gap.is_nan()
            || points.iter().any(|p| !p.x.is_finite() || !p.y.is_finite())
        {
            return Vec::new();
        }
        points.iter().map(|p| [p.x, p.y]).collect()
    }

    fn evaluate(
        &self,
        input: &ConstraintInput<'_, Planar>,
        out: &mut ConstraintOutput<'_, Planar>,
    ) {
        let (a, b) = (&input.markers[0], &input.markers[1]);
        let (phi, s) = (input.s[0], input.s_rate[0]);
        let [u0, u1, u2, u3] = self.profile.derivatives(phi);
        let p = Moving::new([u0, u1, u2], &a.ex, a.omega, s);
        let t = Moving::new([u1, u2, u3], &a.ex, a.omega, s);
        // n = P - r_b; its derivatives: by the point of a: +1, by the point of b: -1.
        let n = a.point + p.value - b.point;
        let n_rate = a.velocity + p.rate - b.velocity;
        match self.follower {
            Follower::KnifeEdge => {
                for k in 0..2 {
                    out.value[k] = n[k];
                    let mut unit = Vector3::zeros();
                    unit[k] = 1.0;
                    out.gradient[2 * k + 1] = -unit;
                    unit.z = p.by_angle[k];
                    out.gradient[2 * k] = unit;
                    out.auxiliary[k] = p.by_phi[k];
                    out.bias[k] = p.bias[k];
                }
            }
            Follower::Roller(radius) => {
                let f = 1.0 / radius;
                out.value[0] = 0.5 * f * (n.norm_squared() - radius * radius);
                out.gradient[0] = f * Vector3::new(n.x, n.y, n.dot(&p.by_angle));
                out.gradient[1] = -f * Vector3::new(n.x, n.y, 0.0);
                out.auxiliary[0] = f * n.dot(&p.by_phi);
                out.bias[0] = f * (n_rate.norm_squared() + n.dot(&p.bias));
                out.value[1] = f * t.value.dot(&n);
                out.gradient[2] = f * Vector3::new(
                    t.value.x,
                    t.value.y,
                    t.value.dot(&p.by_angle) + t.by_angle.dot(&n),
                );
                out.gradient[3] = -f * Vector3::new(t.value.x, t.value.y, 0.0);
                out.auxiliary[1] = f * (t.value.dot(&p.by_phi) + t.by_phi.dot(&n));
                out.bias[1] =
                    f * (t.value.dot(&p.bias) + 2.0 * t.rate.dot(&n_rate) + t.bias.dot(&n));
            }
            Follower::Flat => {
                // The face's normal turns with the follower.
                let (w, ex, ey) = (b.omega, b.ex, b.ey());
                let ey_rate = -w * ex;
                let ey_bias = -w * w * ey;
                out.value[0] = ey.dot(&n);
                out.gradient[0] = Vector3::new(ey.x, ey.y, ey.dot(&p.by_angle));
                out.gradient[1] = Vector3::new(-ey.x, -ey.y, -ex.dot(&n));
                out.auxiliary[0] = ey.dot(&p.by_phi);
                out.bias[0] = ey.dot(&p.bias) + 2.0 * ey_rate.dot(&n_rate) + ey_bias.dot(&n);
                out.value[1] = ey.dot(&t.value);
                out.gradient[2] = Vector3::new(0.0, 0.0, ey.dot(&t.by_angle));
                out.gradient[3] = Vector3::new(0.0, 0.0, -ex.dot(&t.value));
                out.auxiliary[1] = ey.dot(&t.by_phi);
                out.bias[1] = ey.dot(&t.bias) + 2.0 * ey_rate.dot(&t.rate) + ey_bias.dot(&t.value);
            }
        }
    }
}
