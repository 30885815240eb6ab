//! Shapes as the viewer draws them: sizes are numbers, whatever the model file says.

use super::{Solid, rounded};
use serde::{Deserialize, Serialize};

/// A shape with its place in the frame of its body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shape {
    /// Form and sizes.
    #[serde(flatten)]
    pub form: Form,
    /// Centre of the shape (m).
    #[serde(serialize_with = "rounded::slice")]
    pub position: [f64; 3],
    /// Orientation of the shape, scalar first.
    #[serde(serialize_with = "rounded::slice")]
    pub quaternion: [f64; 4],
    /// Colour, "#rrggbb"; `None` takes the body's.
    pub color: Option<String>,
    /// Is it cut out of the body?
    pub cut: bool,
}

impl Shape {
    /// A solid shape at the origin, in the body's colour.
    pub fn new(form: impl Into<Form>) -> Self {
        Self {
            form: form.into(),
            position: [0.0; 3],
            quaternion: [1.0, 0.0, 0.0, 0.0],
            color: None,
            cut: false,
        }
    }

    /// Puts the shape at a point of the plane, turned by an angle (rad).
    #[must_use]
    pub fn planar(mut self, at: [f64; 2], angle: f64) -> Self {
        self.position = [at[0], at[1], 0.0];
        self.quaternion = [(0.5 * angle).cos(), 0.0, 0.0, (0.5 * angle).sin()];
        self
    }

    /// Puts the frame of the shape at a point (m), turned by a unit quaternion, scalar first.
    #[must_use]
    pub fn spatial(mut self, at: [f64; 3], quaternion: [f64; 4]) -> Self {
        self.position = at;
        self.quaternion = quaternion;
        self
    }
}

/// Form of a shape; every length in metres.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Form {
    /// A link with round ends along its own x, its end points `length` apart.
    Bar {
        /// Distance of the two ends.
        #[serde(serialize_with = "rounded::number")]
        length: f64,
        /// Drawn width.
        #[serde(serialize_with = "rounded::number")]
        width: f64,
    },
    /// A rectangle.
    Rectangle {
        /// Size along its own x.
        #[serde(serialize_with = "rounded::number")]
        width: f64,
        /// Size along its own y.
        #[serde(serialize_with = "rounded::number")]
        height: f64,
    },
    /// A full circle.
    Circle {
        /// Radius.
        #[serde(serialize_with = "rounded::number")]
        radius: f64,
    },
    /// A ring.
    Ring {
        /// Outer radius.
        #[serde(serialize_with = "rounded::number")]
        outer: f64,
        /// Inner radius.
        #[serde(serialize_with = "rounded::number")]
        inner: f64,
    },
    /// A simple polygon in its own plane, corners in order around it.
    Polygon {
        /// Corners.
        #[serde(serialize_with = "rounded::points")]
        points: Vec<[f64; 2]>,
    },
    /// A part without form, drawn as a dot.
    Lump,
    /// A form of a spatial machine; its fields stand beside `kind` in the same object.
    #[serde(untagged)]
    Solid(Solid),
}

impl From<Solid> for Form {
    fn from(solid: Solid) -> Self {
        Self::Solid(solid)
    }
}
