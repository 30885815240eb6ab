//! Shapes of bodies: for the picture, and for mass properties where they carry mass.

use super::{Inertia, Orientation, Point, Value};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Form of a shape; every length in metres.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum ShapeKind {
    /// A link with round ends: its end points are `length` apart; its mass properties are those of a slender rod (planar).
    Bar {
        /// Distance of the two ends.
        length: Value,
        /// Drawn width; default a tenth of the length.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        width: Option<Value>,
    },
    /// A rectangle, centred at `at` (planar).
    Rectangle {
        /// Size along its own x.
        width: Value,
        /// Size along its own y.
        height: Value,
    },
    /// A full circle (disk), centred at `at` (planar).
    Circle {
        /// Radius.
        radius: Value,
    },
    /// A ring, centred at `at` (planar).
    Ring {
        /// Outer radius.
        outer: Value,
        /// Inner radius.
        inner: Value,
    },
    /// A simple polygon; points in the shape's frame, in order around it (planar).
    Polygon {
        /// Corners.
        points: Vec<Point>,
    },
    /// A part known by its mass and inertia only; drawn as a dot.
    Lump {
        /// Inertia about the part's own centre of mass [kg m^2]: a number (planar), or [Ixx, Iyy, Izz] or the rows of
        /// the tensor in the shape's axes (spatial); default 0.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        inertia: Option<Inertia>,
    },
    /// A block, centred at `at` (spatial).
    Box {
        /// Sizes along its own x, y, z.
        size: [Value; 3],
    },
    /// A full cylinder about its own z axis, centred at `at` (spatial).
    Cylinder {
        /// Radius.
        radius: Value,
        /// Length along its own z.
        length: Value,
    },
    /// A hollow cylinder about its own z axis, centred at `at` (spatial).
    Tube {
        /// Outer radius.
        outer: Value,
        /// Inner radius.
        inner: Value,
        /// Length along its own z.
        length: Value,
    },
    /// A full ball, centred at `at` (spatial).
    Sphere {
        /// Radius.
        radius: Value,
    },
    /// A thin spherical shell, centred at `at`; `density` needs `thickness` (spatial).
    Shell {
        /// Radius.
        radius: Value,
    },
    /// Half of a full ball: `at` is the centre of the flat face, its own z points to the round side (spatial).
    Hemisphere {
        /// Radius.
        radius: Value,
    },
    /// A full cone: `at` is the centre of the base, its own z points to the apex (spatial).
    Cone {
        /// Radius of the base.
        radius: Value,
        /// Height.
        height: Value,
    },
    /// A thin rod along its own x, centred at `at`; `density` needs `radius` (spatial).
    Rod {
        /// Length.
        length: Value,
        /// Radius, for the picture and for `density`; its mass properties stay those of a thin rod. Drawn by default as a
        /// fortieth of the length.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        radius: Option<Value>,
    },
    /// A thin disk across its own z, centred at `at`; `density` needs `thickness`, which is also drawn (spatial).
    Disk {
        /// Radius.
        radius: Value,
    },
    /// A thin plate across its own z, centred at `at`; `density` needs `thickness`, which is also drawn (spatial).
    Plate {
        /// Size along its own x.
        width: Value,
        /// Size along its own y.
        height: Value,
    },
    /// A full ellipsoid, centred at `at` (spatial).
    Ellipsoid {
        /// Half axes along its own x, y, z.
        semi_axes: [Value; 3],
    },
    /// A body bounded by triangles; `at` is the origin of its file (spatial). For mass it must be closed.
    Mesh {
        /// STL or OBJ file beside the model file; a reader of model files fills the vertices and triangles from it.
        file: String,
        /// Length of one unit of the file [m], for example "1 mm"; default 1 m.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        scale: Option<Value>,
        /// Corners, in units of the file.
        #[serde(skip)]
        vertices: Vec<[f64; 3]>,
        /// Numbers of the corners of each triangle, from 0, counter-clockwise seen from outside.
        #[serde(skip)]
        triangles: Vec<[usize; 3]>,
    },
    /// A ring about its own z axis, centred at `at`; for the picture only, it carries no mass (spatial).
    Torus {
        /// Radius of the circle in the middle of the tube.
        radius: Value,
        /// Radius of the tube.
        tube: Value,
    },
}

/// A part of a body: drawn, and with `mass` or `density` also a part of its mass properties.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Shape {
    /// Form and sizes.
    #[serde(flatten)]
    pub kind: ShapeKind,
    /// Place of the shape in the body frame [m], its centre except where its kind says otherwise; default the origin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<Point>,
    /// Angle of the shape in the body frame [rad]; default 0 (planar).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle: Option<Value>,
    /// Orientation of the shape's own axes, seen from the body frame; default not turned (spatial).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientation: Option<Orientation>,
    /// Mass of the part, spread evenly [kg].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass: Option<Value>,
    /// Density [kg/m^3]; with `thickness` for planar shapes and for shells, disks and plates.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub density: Option<Value>,
    /// Thickness [m]: out of the plane, with `density` (planar); of a shell, disk or plate (spatial).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thickness: Option<Value>,
    /// Is the part cut out of the body? Its mass and inertia then count negative.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub cut: bool,
    /// Colour for the picture, "#rrggbb".
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub color: Option<String>,
}
