//! Where a joint or a bushing sits on its two bodies.

use super::{Point, Value};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Where a joint sits on its two bodies.
///
/// Points: `at` (one in each body's frame), or `point` (one in ground axes at the initial
/// estimate). Directions in the plane: `angles` (of the joint's x axis in each body's frame), or
/// `direction` (of the joint's x axis in ground axes at the initial estimate). Directions in
/// space: `axes` (of the joint's z axis in each body's frame), or `axis` (in ground axes at the
/// initial estimate), and where the joint's x axis matters, `x_axes` or `x_axis`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Placement {
    /// First and second body; "ground" is the fixed one.
    pub bodies: [String; 2],
    /// The joint's point in each body's frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<[Point; 2]>,
    /// The joint's point in ground axes at the initial estimate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub point: Option<Point>,
    /// Angle of the joint's x axis in each body's frame [rad] (planar).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angles: Option<[Value; 2]>,
    /// Direction of the joint's x axis in ground axes at the initial estimate (planar).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub direction: Option<Point>,
    /// Direction of the joint's z axis in ground axes at the initial estimate, of any length (spatial).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis: Option<Point>,
    /// Direction of the joint's z axis in each body's frame, of any length (spatial).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axes: Option<[Point; 2]>,
    /// Direction of the joint's x axis in ground axes at the initial estimate: there the joint's angle is zero; its part
    /// across the z axis counts; default: zero between bodies with parallel frames (spatial).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub x_axis: Option<Point>,
    /// Direction of the joint's x axis in each body's frame: where the two agree the joint's angle is zero (spatial).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub x_axes: Option<[Point; 2]>,
}
