//! Shapes of bodies: for the picture, and for mass properties where they carry mass.

use super::{Point, Value};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Form of a planar shape; every length in metres.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum ShapeKind {
    /// A link with round ends: its end points are `length` apart; its mass properties are those of a slender rod.
    Bar {
        /// Distance of the two ends.
        length: Value,
        /// Drawn width; default a tenth of the length.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        width: Option<Value>,
    },
    /// A rectangle, centred at `at`.
    Rectangle {
        /// Size along its own x.
        width: Value,
        /// Size along its own y.
        height: Value,
    },
    /// A full circle (disk), centred at `at`.
    Circle {
        /// Radius.
        radius: Value,
    },
    /// A ring, centred at `at`.
    Ring {
        /// Outer radius.
        outer: Value,
        /// Inner radius.
        inner: Value,
    },
    /// A simple polygon; points in the shape's frame, in order around it.
    Polygon {
        /// Corners.
        points: Vec<Point>,
    },
    /// A part known by its mass and inertia only; drawn as a dot.
    Lump {
        /// Moment of inertia about the part's own centre of mass [kg m^2]; default 0.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        inertia: Option<Value>,
    },
}

/// A part of a body: drawn, and with `mass` or `density` also a part of its mass properties.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Shape {
    /// Form and sizes.
    #[serde(flatten)]
    pub kind: ShapeKind,
    /// Centre of the shape in the body frame; default the origin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<Point>,
    /// Angle of the shape in the body frame [rad].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle: Option<Value>,
    /// Mass of the part, spread evenly [kg].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass: Option<Value>,
    /// Density [kg/m^3], with `thickness`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub density: Option<Value>,
    /// Thickness out of the plane [m], with `density`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thickness: Option<Value>,
    /// Is the part cut out of the body? Its mass and inertia then count negative.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub cut: bool,
    /// Colour for the picture, "#rrggbb".
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub color: Option<String>,
}
