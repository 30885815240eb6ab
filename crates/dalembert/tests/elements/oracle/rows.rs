//! Sums of coordinates that follow a function of time, and the user expressions of these tests.

use super::{Machine, Number, Residual, dot};

/// A coordinate of the machine.
#[derive(Clone, Copy)]
pub enum What {
    X(&'static str, [f64; 2]),
    Y(&'static str, [f64; 2]),
    Angle(&'static str, &'static str),
    /// Along the x axis of the first marker, which is turned by the angle.
    Along([&'static str; 2], [[f64; 2]; 2], f64),
    Distance([&'static str; 2], [[f64; 2]; 2]),
}

impl What {
    pub fn value<D: Number>(self, machine: &Machine<D>) -> D {
        match self {
            Self::X(body, at) => machine.marker(body, at, 0.0).point[0],
            Self::Y(body, at) => machine.marker(body, at, 0.0).point[1],
            Self::Angle(first, second) => {
                let angle = |body| machine.marker(body, [0.0; 2], 0.0).angle;
                angle(second) - angle(first)
            }
            Self::Along(bodies, at, angle) => {
                let first = machine.marker(bodies[0], at[0], angle);
                dot(first.ex(), first.to(&machine.marker(bodies[1], at[1], 0.0)))
            }
            Self::Distance(bodies, at) => {
                let [a, b] = [0, 1].map(|k| machine.marker(bodies[k], at[k], 0.0));
                let d = a.to(&b);
                dot(d, d).sqrt()
            }
        }
    }
}

/// A factor of a coordinate, and a constant that is added to the coordinate.
pub struct Term(pub f64, pub What, pub f64);

/// A sum of terms that keeps a value.
pub struct Sum(pub Vec<Term>, pub f64);

impl Residual for Sum {
    fn rows<D: Number>(&self, machine: &Machine<D>) -> Vec<D> {
        let terms = self
            .0
            .iter()
            .map(|Term(f, what, c)| (what.value(machine) + *c) * *f);
        vec![terms.fold(D::from(-self.1), |sum, term| sum + term)]
    }
}

/// The motions of these tests.
#[derive(Clone, Copy)]
pub enum Motion {
    Length,
    Angle,
    /// 0.3 and the integral of 0.4 cos(1.5 t).
    LengthByRate,
    /// 0.3 and the integral of 0.4 cos(1.5 t) + 0.2.
    AngleByRate,
    Cosine,
}

impl Motion {
    fn at<D: Number>(self, t: D) -> D {
        let sine = (t * 1.5).sin();
        match self {
            Self::Length => sine * 0.3 + t * t * t * 0.1 + 0.2,
            Self::Angle => sine * 0.3 + t * t * t * 0.4 + 0.2,
            Self::LengthByRate => sine * (0.4 / 1.5) + 0.3,
            Self::AngleByRate => sine * (0.4 / 1.5) + t * 0.2 + 0.3,
            Self::Cosine => (t * 2.0).cos() * 0.4,
        }
    }
}

/// A coordinate, and a constant that is added to it, that follows a motion.
pub struct Follow(pub What, pub f64, pub Motion);

impl Residual for Follow {
    fn rows<D: Number>(&self, machine: &Machine<D>) -> Vec<D> {
        vec![self.0.value(machine) + self.1 - self.2.at(machine.t)]
    }
}

/// The difference of two coordinates that follows a motion.
pub struct Difference {
    pub from: What,
    pub to: What,
    pub motion: Motion,
}

impl Residual for Difference {
    fn rows<D: Number>(&self, machine: &Machine<D>) -> Vec<D> {
        let d = self.to.value(machine) - self.from.value(machine);
        vec![d - self.motion.at(machine.t)]
    }
}

/// The user expressions of these tests.
pub enum Expression {
    Polynomial,
    Root,
}

impl Residual for Expression {
    fn rows<D: Number>(&self, m: &Machine<D>) -> Vec<D> {
        let [a, b, c] = ["a", "b", "c"].map(|body| m.marker(body, [0.0; 2], 0.0));
        vec![match self {
            Self::Polynomial => {
                let d = a.point[0] - b.point[0];
                d * d + (a.point[1] + b.point[1]) * (a.angle - b.angle * 2.0).sin() * 0.5
                    - (m.t * 3.0).cos() * b.angle * 0.1
            }
            Self::Root => {
                let tip = m.marker("b", [0.4, -0.2], 0.0);
                // The joint's markers are turned by 0.35 and -0.8.
                let angle = b.angle - 0.8 - (a.angle + 0.35);
                let d = tip.point[0] - c.point[0];
                (angle * 0.3).exp() * (d * d + 1.0).sqrt() - m.t * 0.2
            }
        }]
    }
}
