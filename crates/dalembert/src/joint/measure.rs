//! Scalar measures between two markers: what joints, drivers and force elements are made of.

use super::Guarded;
use crate::space::{Planar, PoseCoordinate, Space};
use nalgebra::Vector3;
use std::fmt::Debug;
use std::hash::Hash;

/// The scalars that a space measures from one marker to another.
pub trait MeasureKind<S: Space>: Copy + Debug + Eq + Hash + Send + Sync + 'static {
    /// The distance of the two points [m].
    const DISTANCE: Self;
    /// Is the value an angle?
    fn is_angle(self) -> bool;
    /// Is the value a length?
    fn is_length(self) -> bool;
    /// Value alone.
    fn value(self, a: &S::Marker, b: &S::Marker) -> f64;
    /// The vector that it takes an angle from, where that can vanish.
    fn guarded(self, _a: &S::Marker, _b: &S::Marker) -> Option<Guarded> {
        None
    }
    /// Value, rate, gradients and bias.
    fn evaluate(self, a: &S::Marker, b: &S::Marker) -> Measured<S::Twist>;
}

/// A measure between two of the markers of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Measure<S: Space = Planar> {
    /// Which.
    pub kind: S::Measure,
    /// Number of the first marker.
    pub first: usize,
    /// Number of the second marker.
    pub second: usize,
}

/// Value and derivatives of a measure; `T` is the twist of the space.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measured<T = Vector3<f64>> {
    /// Value.
    pub value: f64,
    /// Rate.
    pub rate: f64,
    /// Second time derivative where the accelerations of both markers vanish.
    pub bias: f64,
    /// Gradient with respect to the twist of the first marker.
    pub first: T,
    /// Gradient with respect to the twist of the second marker.
    pub second: T,
}

impl<T> From<Measured<T>> for PoseCoordinate<T> {
    fn from(m: Measured<T>) -> Self {
        Self {
            value: m.value,
            rate: m.rate,
            first: m.first,
            second: m.second,
        }
    }
}

impl<S: Space> Measure<S> {
    /// Value between markers of the element that owns the measure.
    pub fn value(&self, markers: &[S::Marker]) -> f64 {
        self.kind.value(&markers[self.first], &markers[self.second])
    }

    /// The vector between markers of the element that owns the measure which must not vanish.
    pub fn guarded(&self, markers: &[S::Marker]) -> Option<Guarded> {
        self.kind
            .guarded(&markers[self.first], &markers[self.second])
    }

    /// Value and derivatives between markers of the element that owns the measure.
    pub fn evaluate(&self, markers: &[S::Marker]) -> Measured<S::Twist> {
        self.kind
            .evaluate(&markers[self.first], &markers[self.second])
    }
}
