//! Vectors that must not vanish: an element takes a direction or an angle from them.

use nalgebra::Vector3;
use std::fmt;

/// What an element loses where one of its vectors vanishes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lost {
    /// A disc that rolls on a plane lies flat on it: every point of its rim touches.
    Contact,
    /// An axis of the second body stands along the axis about which its angle is measured.
    Angle,
    /// A bushing is turned by half a turn: its rotation vector changes its sign there.
    RotationVector,
}

impl Lost {
    /// What to do about it.
    pub fn remedy(self) -> &'static str {
        match self {
            Self::Contact => {
                "end the run before, or describe the disc that lies by a contact on its flat side (kind = \"planar\")"
            }
            Self::Angle => {
                "end the run before, hold the bodies on a common axis by a joint, or measure about another axis"
            }
            Self::RotationVector => {
                "a bushing is meant for small turns: make it stiffer, or use a joint with a torsion spring, which counts turns"
            }
        }
    }
}

/// What happened, as the rest of a sentence about the element.
impl fmt::Display for Lost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Contact => "has no point of contact: the disc lies flat on its plane",
            Self::Angle => {
                "has no angle: its bodies are tilted against each other by a quarter turn about another axis"
            }
            Self::RotationVector => {
                "is turned by half a turn: its moment would change its sign there"
            }
        })
    }
}

/// A vector, as long as one where it is at its best, that must not vanish on the way of a machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Guarded {
    /// The vector, in axes that do not jump where it vanishes.
    pub vector: Vector3<f64>,
    /// Its rate [1/s]; as far as it changes the length.
    pub rate: Vector3<f64>,
    /// Length up to which it counts as vanished.
    pub limit: f64,
    /// What is lost there.
    pub lost: Lost,
}

impl Guarded {
    /// Length at which a direction has lost half of its digits.
    pub const DIGITS: f64 = 1e-8;

    /// Has it vanished?
    pub fn vanished(&self) -> bool {
        self.vector.norm() <= self.limit
    }

    /// Does it vanish within a time, at its present rate?
    pub fn vanishes_within(&self, horizon: f64) -> bool {
        let length = self.vector.norm();
        let approach = -self.vector.dot(&self.rate) / length;
        length <= self.limit || length <= approach * horizon
    }
}
