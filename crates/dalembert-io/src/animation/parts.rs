//! The parts of an animation: bodies, joints, springs, traces and channels.

use super::{Shape, rounded};
use dalembert::results::Channel;
use serde::{Deserialize, Serialize};

/// A moving body.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct AnimatedBody {
    /// Name.
    pub name: String,
    /// Colour, "#rrggbb"; `None` leaves it to the viewer.
    pub color: Option<String>,
    /// Origin of the body frame in ground axes (m): x, y, z of every instant in one row.
    #[serde(serialize_with = "rounded::slice")]
    pub position: Vec<f64>,
    /// Orientation of the body frame: w, x, y, z of every instant in one row.
    #[serde(serialize_with = "rounded::slice")]
    pub quaternion: Vec<f64>,
    /// Shapes in the body frame.
    pub shapes: Vec<Shape>,
}

/// What stands still.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Ground {
    /// Shapes in ground axes.
    pub shapes: Vec<Shape>,
}

/// A joint between two bodies.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Joint {
    /// Name.
    pub name: String,
    /// Kind in the spelling of the model file: "revolute", "translational", ...
    pub kind: String,
    /// Where it sits on its first body.
    pub first: JointEnd,
    /// Where it sits on its second body.
    pub second: JointEnd,
}

/// One end of a joint.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct JointEnd {
    /// Body, or "ground".
    pub body: String,
    /// Point in the frame of the body (m).
    #[serde(serialize_with = "rounded::slice")]
    pub at: [f64; 3],
    /// Direction in the frame of the body, for joints that have one.
    #[serde(serialize_with = "rounded::optional")]
    pub direction: Option<[f64; 3]>,
    /// The joint's x axis in the frame of the body, for spatial joints that have a whole frame.
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        serialize_with = "rounded::optional"
    )]
    pub reference: Option<[f64; 3]>,
    /// Closed curve fixed to the body, in the frame of the body (m): a cam's profile, a
    /// gear's pitch circle. It is the form of a body that has no shapes.
    #[serde(
        default,
        skip_serializing_if = "Vec::is_empty",
        serialize_with = "rounded::points"
    )]
    pub outline: Vec<[f64; 2]>,
}

/// A force element between two points.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Spring {
    /// Name.
    pub name: String,
    /// Kind in the spelling of the model file: "spring-damper", ...
    pub kind: String,
    /// First end.
    pub first: SpringEnd,
    /// Second end.
    pub second: SpringEnd,
}

/// One end of a spring.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SpringEnd {
    /// Body, or "ground".
    pub body: String,
    /// Point in the frame of the body (m).
    #[serde(serialize_with = "rounded::slice")]
    pub at: [f64; 3],
}

/// An element that pushes or turns a body at a point.
///
/// Its channels NAME.force_x, NAME.force_y, NAME.force_z and NAME.moment_x, NAME.moment_y,
/// NAME.moment_z are the force and moment in ground axes. With a line, the channels NAME.force
/// and NAME.moment of one number each act along it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Load {
    /// Name.
    pub name: String,
    /// Where it pushes.
    pub on: SpringEnd,
    /// The line along which channels of one number act.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub along: Option<Line>,
}

/// A direction that is fixed to a body.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// Body, or "ground".
    pub body: String,
    /// Direction in the frame of the body; its length does not matter.
    #[serde(serialize_with = "rounded::slice")]
    pub direction: [f64; 3],
}

/// A point whose path is drawn.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct AnimatedTrace {
    /// Name.
    pub name: String,
    /// Body, or "ground".
    pub body: String,
    /// Point in the frame of the body (m).
    #[serde(serialize_with = "rounded::slice")]
    pub at: [f64; 3],
}

/// A channel to plot beside the picture.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct AnimatedChannel {
    /// Name.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// What it is, in a short sentence.
    pub meaning: String,
    /// One value a frame.
    #[serde(serialize_with = "rounded::slice")]
    pub values: Vec<f64>,
}

impl From<&Channel> for AnimatedChannel {
    fn from(channel: &Channel) -> Self {
        Self {
            name: channel.name.clone(),
            unit: channel.unit.clone(),
            meaning: channel.meaning.clone(),
            values: channel.values.clone(),
        }
    }
}
