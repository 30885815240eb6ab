//! Gear pairs.

use super::super::built::Built;
use super::super::context::Context;
use super::super::place::Place;
use crate::diagnostic::Diagnostic;
use crate::joint::{Measure, MeasureRow, MeasureRows, MeasureTerm, PlanarMeasure, TimeFunction};
use crate::model::{GROUND, Value};
use crate::space::{Planar, PlanarFrame};
use dalembert_expr::Quantity;
use smallvec::{SmallVec, smallvec};
use std::sync::Arc;

impl Context<'_, Planar> {
    pub(super) fn gear(
        &mut self,
        bodies: &[String; 2],
        carrier: Option<&str>,
        radii: &[Value; 2],
        internal: bool,
        place: &Place,
    ) -> Option<Built<Planar>> {
        let names = [
            bodies[0].as_str(),
            bodies[1].as_str(),
            carrier.unwrap_or(GROUND),
        ];
        let twice = (names[0] == names[1] || names[0] == names[2] || names[1] == names[2])
            && names.iter().all(|n| !n.is_empty());
        if twice {
            self.report(
                Diagnostic::error(
                    "same-body",
                    place.key("bodies"),
                    format!(
                        "{}: the two gears and their carrier must be three different bodies",
                        place.owner
                    ),
                )
                .help("name two gears and, where it is not the ground, the body that carries both"),
            );
            return None;
        }
        let origin = |context: &mut Self, name: &str, path: String| {
            let body = context.place(name, &place.owner, &path);
            context.marker(&body, &PlanarFrame::default())
        };
        let k = origin(self, carrier.unwrap_or(GROUND), place.key("carrier"));
        let i = origin(self, &bodies[0], place.key("bodies[0]"));
        let j = origin(self, &bodies[1], place.key("bodies[1]"));
        let mut radius = |n: usize| {
            let path = place.key(&format!("radii[{n}]"));
            let x = self.constant(&radii[n], Quantity::Free, &place.owner, &path)?;
            if x > 0.0 {
                return Some(x);
            }
            self.report(
                Diagnostic::error(
                    "not-positive",
                    path,
                    format!("{}: a radius is {x}, it must be positive", place.owner),
                )
                .help("internal meshing is internal = true, not a negative radius"),
            );
            None
        };
        let (a, b) = (radius(0), radius(1));
        let (a, b) = (a?, b?);
        // (th_i - th_k) a_i = -+ (th_j - th_k) a_j (Shabana 3.103), divided by a_i: an angle.
        let ratio = if internal { -b / a } else { b / a };
        let markers: SmallVec<[usize; 4]> = smallvec![i, j, k];
        let mut row = MeasureRow {
            terms: smallvec![
                MeasureTerm {
                    factor: 1.0,
                    measure: Measure {
                        kind: PlanarMeasure::Angle,
                        first: 2,
                        second: 0
                    }
                },
                MeasureTerm {
                    factor: ratio,
                    measure: Measure {
                        kind: PlanarMeasure::Angle,
                        first: 2,
                        second: 1
                    }
                }
            ],
            target: TimeFunction::Constant(0.0),
            label: "mesh".to_owned(),
        };
        let poses = [i, j, k].map(|m| self.pose(m));
        row.target = TimeFunction::Constant(row.sum(&poses));
        Some(Built {
            kind: "gear",
            element: Arc::new(MeasureRows::new(3, smallvec![row])),
            markers,
            coordinates: SmallVec::new(),
            auxiliary_start: SmallVec::new(),
            reaction_marker: 1,
        })
    }
}
