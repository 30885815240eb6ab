//! What a dimension must say about itself for models to become systems of it.

use super::built::Built;
use super::context::{Context, GlobalMeasure};
use super::drawing::DrawnShape;
use super::names::Property;
use super::place::Place;
use crate::model::{
    AxialVector, Body, CoordinateName, HeldCoordinate, JointKind, Placement, Point, Shape, Trace,
    Value,
};
use crate::space::Space;
use crate::space::orientation::Rotation;
use nalgebra::Vector3;
use smallvec::SmallVec;

/// A body as its user describes it, in numbers.
pub(super) struct BodyParts<S: Space> {
    /// Estimate of the user's frame, ground axes.
    pub frame: S::Frame,
    /// Centre of mass in the user's frame.
    pub center: Vector3<f64>,
    /// Mass block, NV x NV row-major.
    pub mass: Vec<f64>,
    /// Is it singular?
    pub massless: bool,
    /// Estimates of the position and velocity coordinates.
    pub q: SmallVec<[f64; 7]>,
    pub v: SmallVec<[f64; 6]>,
    /// Does the user say something of each coordinate?
    pub position_known: SmallVec<[bool; 6]>,
    pub velocity_known: SmallVec<[bool; 6]>,
}

/// What a placement needs of its direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Direction {
    /// Axes of the bodies where none is given.
    Optional,
    /// The relative angle of the estimate where none is given.
    Keep,
    /// Must be given.
    Needed,
}

/// A dimension in which models are compiled.
pub(super) trait Geometry: Space {
    /// "planar", "spatial".
    const NAME: &'static str;
    /// Gravity where a model says nothing [m/s^2].
    const GRAVITY: Vector3<f64>;
    /// A frame at a point with the axes of what it is in.
    fn frame(at: &Vector3<f64>) -> Self::Frame;
    /// The point of a frame; z is zero in the plane.
    fn origin(frame: &Self::Frame) -> Vector3<f64>;
    /// A frame inside another, in what the other is in.
    fn compose(outer: &Self::Frame, inner: &Self::Frame) -> Self::Frame;
    /// A point, in what a frame is in, as the frame sees it.
    fn seen_from(frame: &Self::Frame, point: &Vector3<f64>) -> Vector3<f64>;
    /// A frame inside its body's user frame, from the centre of mass.
    fn from_center(frame: &Self::Frame, center: &Vector3<f64>) -> Self::Frame;
    /// How a frame stands.
    fn rotation(frame: &Self::Frame) -> Rotation;
    /// Direction of a joint's axis by its frame.
    fn direction(frame: &Self::Frame) -> Vector3<f64>;
    /// The second direction that says how a joint's frame stands; none in the plane.
    fn reference(frame: &Self::Frame) -> Option<Vector3<f64>>;
    /// Position along an axis of the ground.
    fn along_ground(axis: usize) -> Self::Measure;
    /// The measure, from the ground's frame to a frame on a body, that a coordinate of a body is; none where the space
    /// has no such coordinate.
    fn coordinate(name: CoordinateName) -> Option<Self::Measure>;
    /// The measures, from a frame on the ground to that of a body, that are held with a coordinate; none where the space
    /// has no such coordinate.
    fn held(name: HeldCoordinate) -> Vec<Self::Measure>;
    /// The angle of a second body seen from a first, about an axis that is given in space.
    fn relative_angle(
        context: &mut Context<'_, Self>,
        bodies: &[String; 2],
        axis: Option<&Point>,
        place: &Place,
    ) -> Option<GlobalMeasure<Self>>;
    /// The components of a moment.
    fn axial(vector: &AxialVector) -> &[Value];
    /// Reads a body.
    fn body(context: &mut Context<'_, Self>, body: &Body, place: &Place) -> BodyParts<Self>;
    /// What expressions may ask of a body or a trace by its marker.
    fn point_properties(marker: usize) -> Vec<Property<Self>>;
    /// Frame of a trace in the frame of its body.
    fn trace(context: &mut Context<'_, Self>, trace: &Trace, place: &Place) -> Self::Frame;
    /// Markers of a placement on its two bodies.
    fn placement(
        context: &mut Context<'_, Self>,
        placement: &Placement,
        place: &Place,
        direction: Direction,
    ) -> Option<[usize; 2]>;
    /// Rows and coordinates of a joint.
    fn joint(
        context: &mut Context<'_, Self>,
        kind: &JointKind,
        place: &Place,
    ) -> Option<Built<Self>>;
    /// The shape of a body, drawn.
    fn shape(context: &mut Context<'_, Self>, shape: &Shape, place: &Place) -> Option<DrawnShape>;
    /// Gives the ends of a joint the curves by which it touches.
    fn outline(
        context: &mut Context<'_, Self>,
        name: &str,
        kind: &JointKind,
        place: &Place,
    ) -> Option<[Vec<[f64; 2]>; 2]>;
}
