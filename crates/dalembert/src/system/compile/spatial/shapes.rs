//! Spatial shapes: their forms in numbers, and drawn.

use super::super::context::Context;
use super::super::drawing::{DrawnForm, DrawnShape};
use super::super::place::Place;
use super::Geometry;
use crate::diagnostic::Diagnostic;
use crate::mass::Solid;
use crate::model::{Shape, ShapeKind, Value};
use crate::space::orientation::Rotation;
use crate::space::{Spatial, SpatialFrame};
use dalembert_expr::Dim;

/// Part of its length that a rod is thick in the picture where no radius is given, and of its size a thin part.
const THIN: f64 = 0.025;

impl Context<'_, Spatial> {
    fn size(&mut self, value: &Value, place: &Place, key: &str) -> Option<f64> {
        self.positive(value, Dim::LENGTH, key, place, key)
    }

    fn sizes(&mut self, values: &[Value; 3], place: &Place, key: &str) -> Option<[f64; 3]> {
        let [a, b, c] = [0, 1, 2].map(|k| {
            let key = format!("{key}[{k}]");
            self.positive(&values[k], Dim::LENGTH, &key, place, &key)
        });
        Some([a?, b?, c?])
    }

    /// The homogeneous solid of a form; none for forms that are not one, and after mistakes.
    pub(super) fn solid(&mut self, kind: &ShapeKind, place: &Place) -> Option<Solid> {
        Some(match kind {
            ShapeKind::Box { size } => Solid::Box(self.sizes(size, place, "size")?),
            ShapeKind::Cylinder { radius, length } => {
                let (r, l) = (
                    self.size(radius, place, "radius"),
                    self.size(length, place, "length"),
                );
                Solid::Cylinder {
                    radius: r?,
                    length: l?,
                }
            }
            ShapeKind::Tube {
                outer,
                inner,
                length,
            } => {
                let (o, i, l) = (
                    self.size(outer, place, "outer"),
                    self.size(inner, place, "inner"),
                    self.size(length, place, "length"),
                );
                let (outer, inner, length) = (o?, i?, l?);
                if inner >= outer {
                    self.report(
                        Diagnostic::error(
                            "bad-ring",
                            place.key("inner"),
                            format!(
                                "{}: the inner radius is not smaller than the outer",
                                place.owner
                            ),
                        )
                        .help("exchange or correct the radii"),
                    );
                    return None;
                }
                Solid::Tube {
                    inner,
                    outer,
                    length,
                }
            }
            ShapeKind::Sphere { radius } => Solid::Sphere {
                radius: self.size(radius, place, "radius")?,
            },
            ShapeKind::Shell { radius } => Solid::Shell {
                radius: self.size(radius, place, "radius")?,
            },
            ShapeKind::Hemisphere { radius } => Solid::Hemisphere {
                radius: self.size(radius, place, "radius")?,
            },
            ShapeKind::Cone { radius, height } => {
                let (r, h) = (
                    self.size(radius, place, "radius"),
                    self.size(height, place, "height"),
                );
                Solid::Cone {
                    radius: r?,
                    height: h?,
                }
            }
            ShapeKind::Rod { length, .. } => Solid::Rod {
                length: self.size(length, place, "length")?,
            },
            ShapeKind::Disk { radius } => Solid::Disk {
                radius: self.size(radius, place, "radius")?,
            },
            ShapeKind::Plate { width, height } => {
                let (w, h) = (
                    self.size(width, place, "width"),
                    self.size(height, place, "height"),
                );
                Solid::Plate([w?, h?])
            }
            ShapeKind::Ellipsoid { semi_axes } => {
                Solid::Ellipsoid(self.sizes(semi_axes, place, "semi_axes")?)
            }
            _ => return None,
        })
    }

    /// Length of a unit of a mesh's file [m].
    pub(super) fn mesh_scale(&mut self, kind: &ShapeKind, place: &Place) -> Option<f64> {
        match kind {
            ShapeKind::Mesh {
                scale: Some(scale), ..
            } => self.size(scale, place, "scale"),
            _ => Some(1.0),
        }
    }

    pub(super) fn spatial_shape(&mut self, shape: &Shape, place: &Place) -> Option<DrawnShape> {
        let thickness = match &shape.thickness {
            Some(t) => Some(self.size(t, place, "thickness")?),
            None => None,
        };
        let form = match &shape.kind {
            ShapeKind::Lump { .. } => DrawnForm::Lump,
            ShapeKind::Mesh {
                vertices,
                triangles,
                ..
            } => {
                let scale = self.mesh_scale(&shape.kind, place)?;
                DrawnForm::Mesh {
                    vertices: vertices.iter().map(|v| v.map(|x| scale * x)).collect(),
                    triangles: triangles.clone(),
                }
            }
            ShapeKind::Torus { radius, tube } => {
                let (r, t) = (
                    self.size(radius, place, "radius"),
                    self.size(tube, place, "tube"),
                );
                DrawnForm::Torus(r?, t?)
            }
            kind => match self.solid(kind, place)? {
                Solid::Rod { length } => {
                    let radius = match kind {
                        ShapeKind::Rod {
                            radius: Some(radius),
                            ..
                        } => self.size(radius, place, "radius")?,
                        _ => 0.5 * THIN * length,
                    };
                    DrawnForm::Rod(length, radius)
                }
                Solid::Disk { radius } => {
                    DrawnForm::Disk(radius, thickness.unwrap_or(THIN * radius))
                }
                Solid::Plate([w, h]) => {
                    DrawnForm::Plate(w, h, thickness.unwrap_or(THIN * w.min(h)))
                }
                solid => DrawnForm::Solid(solid),
            },
        };
        let at = self.optional_point(shape.at.as_ref(), place, "at")?;
        let axes = self.axes_of(shape.orientation.as_ref(), place, "orientation");
        let rotation: Rotation = Spatial::rotation(&SpatialFrame { at, axes });
        Some(DrawnShape {
            form,
            at: at.into(),
            quaternion: [rotation.w, rotation.i, rotation.j, rotation.k],
            color: shape.color.clone(),
            cut: shape.cut,
        })
    }
}
