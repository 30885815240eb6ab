//! Forms of spatial machines, in the frames that `dalembert::mass::Solid` gives to its solids.

use super::check::{enough, finite, list, ordered, points, positive, triples};
use super::{AnimationError, rounded};
use serde::{Deserialize, Serialize};

/// Form of a spatial shape; every length in metres, its frame at the centre unless said otherwise.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Solid {
    /// A block with its edges along x, y, z.
    Box {
        /// Lengths of the edges.
        #[serde(serialize_with = "rounded::slice")]
        size: [f64; 3],
    },
    /// A cylinder about z.
    Cylinder {
        /// Radius.
        #[serde(serialize_with = "rounded::number")]
        radius: f64,
        /// Length along z.
        #[serde(serialize_with = "rounded::number")]
        length: f64,
    },
    /// A hollow cylinder about z.
    Tube {
        /// Outer radius.
        #[serde(serialize_with = "rounded::number")]
        outer: f64,
        /// Inner radius.
        #[serde(serialize_with = "rounded::number")]
        inner: f64,
        /// Length along z.
        #[serde(serialize_with = "rounded::number")]
        length: f64,
    },
    /// A ball.
    Sphere {
        /// Radius.
        #[serde(serialize_with = "rounded::number")]
        radius: f64,
    },
    /// Half of a ball: the frame sits at the centre of the flat face, z points to the round side.
    Hemisphere {
        /// Radius.
        #[serde(serialize_with = "rounded::number")]
        radius: f64,
    },
    /// A right circular cone: the frame sits at the centre of the base, z points to the apex.
    Cone {
        /// Radius of the base.
        #[serde(serialize_with = "rounded::number")]
        radius: f64,
        /// Height.
        #[serde(serialize_with = "rounded::number")]
        height: f64,
    },
    /// A round rod along x.
    Rod {
        /// Length along x.
        #[serde(serialize_with = "rounded::number")]
        length: f64,
        /// Radius.
        #[serde(serialize_with = "rounded::number")]
        radius: f64,
    },
    /// A round disk across z.
    Disk {
        /// Radius.
        #[serde(serialize_with = "rounded::number")]
        radius: f64,
        /// Size along z.
        #[serde(serialize_with = "rounded::number")]
        thickness: f64,
    },
    /// A rectangular plate across z.
    Plate {
        /// Size along x.
        #[serde(serialize_with = "rounded::number")]
        width: f64,
        /// Size along y.
        #[serde(serialize_with = "rounded::number")]
        height: f64,
        /// Size along z.
        #[serde(serialize_with = "rounded::number")]
        thickness: f64,
    },
    /// An ellipsoid.
    Ellipsoid {
        /// Half axes along x, y, z.
        #[serde(serialize_with = "rounded::slice")]
        semi_axes: [f64; 3],
    },
    /// A torus about z.
    Torus {
        /// Distance of the middle of its tube from the axis.
        #[serde(serialize_with = "rounded::number")]
        radius: f64,
        /// Radius of its tube.
        #[serde(serialize_with = "rounded::number")]
        tube: f64,
    },
    /// A surface of triangles.
    Mesh {
        /// Corners: x, y, z of every corner in one row.
        #[serde(serialize_with = "rounded::slice")]
        vertices: Vec<f64>,
        /// Three numbers of corners a triangle, counted from 0, counter-clockwise seen from outside.
        triangles: Vec<u32>,
    },
    /// The surface that a curve sweeps when it turns about z.
    Revolved {
        /// Points [r, z] of the curve in order, r not negative.
        #[serde(serialize_with = "rounded::points")]
        profile: Vec<[f64; 2]>,
    },
    /// A curved surface as a grid of points.
    Surface {
        /// Number of points along the first parameter.
        nu: usize,
        /// Number of points along the second parameter.
        nv: usize,
        /// x, y, z of every point in one row; the second parameter runs fastest.
        #[serde(serialize_with = "rounded::slice")]
        points: Vec<f64>,
    },
    /// A curve, drawn as a line through its points.
    Curve {
        /// x, y, z of every point in one row.
        #[serde(serialize_with = "rounded::slice")]
        points: Vec<f64>,
    },
}

impl Solid {
    /// Checks that sizes are finite and positive and that lists hang together.
    pub(super) fn check(&self, element: &str) -> Result<(), AnimationError> {
        let form = self.name();
        let positive = |sizes: &[(&'static str, f64)]| positive(element, form, sizes);
        match self {
            Self::Box { size: [x, y, z] } => positive(&[("size", *x), ("size", *y), ("size", *z)]),
            Self::Cylinder { radius, length } | Self::Rod { length, radius } => {
                positive(&[("radius", *radius), ("length", *length)])
            }
            Self::Tube {
                outer,
                inner,
                length,
            } => {
                positive(&[("outer", *outer), ("inner", *inner), ("length", *length)])?;
                ordered(element, form, ("inner", *inner), ("outer", *outer))
            }
            Self::Sphere { radius } | Self::Hemisphere { radius } => {
                positive(&[("radius", *radius)])
            }
            Self::Cone { radius, height } => positive(&[("radius", *radius), ("height", *height)]),
            Self::Disk { radius, thickness } => {
                positive(&[("radius", *radius), ("thickness", *thickness)])
            }
            Self::Plate {
                width,
                height,
                thickness,
            } => positive(&[
                ("width", *width),
                ("height", *height),
                ("thickness", *thickness),
            ]),
            Self::Ellipsoid {
                semi_axes: [a, b, c],
            } => positive(&[("semi_axes", *a), ("semi_axes", *b), ("semi_axes", *c)]),
            Self::Torus { radius, tube } => positive(&[("radius", *radius), ("tube", *tube)]),
            Self::Mesh {
                vertices,
                triangles,
            } => {
                let corners = points(element, form, "vertices", vertices, 3)?;
                triples(element, form, "triangles", triangles.len(), 1)?;
                match triangles.iter().find(|corner| **corner as usize >= corners) {
                    Some(corner) => Err(AnimationError::UnknownCorner {
                        element: element.to_owned(),
                        corner: *corner,
                        corners,
                    }),
                    None => Ok(()),
                }
            }
            Self::Revolved { profile } => {
                finite(element, "profile", profile.as_flattened())?;
                enough(element, form, "profile", profile.len(), 2)?;
                match profile.iter().find(|[r, _]| *r < 0.0) {
                    Some([r, _]) => Err(AnimationError::NegativeRadius {
                        element: element.to_owned(),
                        value: *r,
                    }),
                    None => Ok(()),
                }
            }
            Self::Surface { nu, nv, points: at } => {
                for (field, count) in [("nu", *nu), ("nv", *nv)] {
                    enough(element, form, field, count, 2)?;
                }
                list(element, "points of its surface", at, 3 * nu * nv)
            }
            Self::Curve { points: at } => points(element, form, "points", at, 2).map(drop),
        }
    }

    /// The value of `kind`.
    fn name(&self) -> &'static str {
        match self {
            Self::Box { .. } => "box",
            Self::Cylinder { .. } => "cylinder",
            Self::Tube { .. } => "tube",
            Self::Sphere { .. } => "sphere",
            Self::Hemisphere { .. } => "hemisphere",
            Self::Cone { .. } => "cone",
            Self::Rod { .. } => "rod",
            Self::Disk { .. } => "disk",
            Self::Plate { .. } => "plate",
            Self::Ellipsoid { .. } => "ellipsoid",
            Self::Torus { .. } => "torus",
            Self::Mesh { .. } => "mesh",
            Self::Revolved { .. } => "revolved",
            Self::Surface { .. } => "surface",
            Self::Curve { .. } => "curve",
        }
    }
}
