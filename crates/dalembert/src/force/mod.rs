//! Force elements: they see markers and answer with wrenches on them.

mod bushing;
mod measure_force;
mod point_force;
mod point_gravity;

pub use bushing::Bushing;
pub use measure_force::MeasureForce;
pub use point_force::PointForce;
pub use point_gravity::PointGravity;

use crate::joint::{Guarded, Measure};
use crate::space::Space;
use smallvec::SmallVec;
use std::fmt::Debug;

/// Energy that a force element stores and scalars that it reports.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ForceReport {
    /// Potential energy of its conservative part [J].
    pub potential: f64,
    /// Rate of the potential energy [W].
    pub potential_rate: f64,
    /// Values in the order of [`ForceElement::channels`].
    pub values: SmallVec<[f64; 8]>,
}

/// Name suffix, unit and meaning of a value that a force element reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ForceChannel {
    /// Suffix of the channel's name, like "length".
    pub suffix: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// Meaning.
    pub meaning: &'static str,
}

/// A force element between markers.
pub trait ForceElement<S: Space>: Debug + Send + Sync {
    /// Adds the wrenches (force, moment about the marker's point, ground axes) that the element
    /// exerts on its markers.
    fn wrenches(&self, t: f64, markers: &[S::Marker], out: &mut [S::Twist]);
    /// How many of its markers it acts on; the markers after these are only read.
    fn terminals(&self) -> usize {
        2
    }
    /// Distances that it acts along.
    fn distances(&self) -> Vec<Measure<S>> {
        Vec::new()
    }
    /// Shows the vectors that must not vanish, at a state of its markers.
    fn guarded(&self, _markers: &[S::Marker], _see: &mut dyn FnMut(Guarded)) {}
    /// Does it exert a force along its distance where that is zero, so that the force has no
    /// direction?
    fn pulls_at_zero(&self, _t: f64, _markers: &[S::Marker]) -> bool {
        false
    }
    /// A part of its law whose value can jump, like "sign(x)".
    fn jump(&self) -> Option<&str> {
        None
    }
    /// Energy and reported values.
    fn report(&self, t: f64, markers: &[S::Marker]) -> ForceReport;
    /// What `report` reports.
    fn channels(&self) -> Vec<ForceChannel>;
}
