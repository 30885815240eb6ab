//! Points that stay on curves.

use super::super::built::Built;
use super::super::context::Context;
use super::super::place::Place;
use super::placement::Zero;
use crate::joint::PointOnCurve;
use crate::model::{Placement, SpaceCurve, Value};
use crate::space::Spatial;
use dalembert_expr::Dim;
use smallvec::{SmallVec, smallvec};
use std::sync::Arc;

impl Context<'_, Spatial> {
    pub(super) fn point_on_curve(
        &mut self,
        placement: &Placement,
        curve: &SpaceCurve,
        start: Option<&Value>,
        place: &Place,
    ) -> Option<Built<Spatial>> {
        let m = self.sit(placement, place, false, Zero::OfEstimate);
        let [x, y, z] = [(&curve.x, "x"), (&curve.y, "y"), (&curve.z, "z")].map(|(value, key)| {
            let key = format!("curve.{key}");
            self.length_program(value, &["u"], "a curve", place, &key)
        });
        let start = match start {
            Some(value) => self.number(value, Dim::NONE, &place.owner, &place.key("u"))?,
            None => 0.0,
        };
        let m = m?;
        Some(Built {
            kind: "point-on-curve",
            element: Arc::new(PointOnCurve {
                curve: [x?, y?, z?],
            }),
            markers: SmallVec::from_slice(&m),
            coordinates: SmallVec::new(),
            auxiliary_start: smallvec![start],
            reaction_marker: 1,
        })
    }
}
