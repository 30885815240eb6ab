//! Planar shapes, drawn.

use super::super::context::Context;
use super::super::drawing::{DrawnForm, DrawnShape};
use super::super::place::Place;
use crate::model::{Shape, ShapeKind};
use crate::space::Planar;
use dalembert_expr::Dim;

impl Context<'_, Planar> {
    pub(super) fn planar_shape(&mut self, shape: &Shape, place: &Place) -> Option<DrawnShape> {
        let mut n = |v| self.number(v, Dim::LENGTH, &place.owner, &place.path);
        let form = match &shape.kind {
            ShapeKind::Bar { length, width } => {
                let l = n(length)?;
                DrawnForm::Bar(l, width.as_ref().and_then(&mut n).unwrap_or(0.1 * l))
            }
            ShapeKind::Rectangle { width, height } => DrawnForm::Rectangle(n(width)?, n(height)?),
            ShapeKind::Circle { radius } => DrawnForm::Circle(n(radius)?),
            ShapeKind::Ring { outer, inner } => DrawnForm::Ring(n(outer)?, n(inner)?),
            ShapeKind::Polygon { points } => {
                let corners: Option<Vec<[f64; 2]>> = points
                    .iter()
                    .map(|p| Some([n(p.first()?)?, n(p.get(1)?)?]))
                    .collect();
                DrawnForm::Polygon(corners?)
            }
            ShapeKind::Lump { .. } => DrawnForm::Lump,
            // Refused before.
            ShapeKind::Box { .. }
            | ShapeKind::Cylinder { .. }
            | ShapeKind::Tube { .. }
            | ShapeKind::Sphere { .. }
            | ShapeKind::Shell { .. }
            | ShapeKind::Hemisphere { .. }
            | ShapeKind::Cone { .. }
            | ShapeKind::Rod { .. }
            | ShapeKind::Disk { .. }
            | ShapeKind::Plate { .. }
            | ShapeKind::Ellipsoid { .. }
            | ShapeKind::Mesh { .. }
            | ShapeKind::Torus { .. } => return None,
        };
        let at = self.optional_point(shape.at.as_ref(), place, "shape")?;
        let angle = self
            .optional(shape.angle.as_ref(), Dim::NONE, place, "shape")
            .unwrap_or(0.0);
        let (s, c) = (0.5 * angle).sin_cos();
        Some(DrawnShape {
            form,
            at: at.into(),
            quaternion: [c, 0.0, 0.0, s],
            color: shape.color.clone(),
            cut: shape.cut,
        })
    }
}
