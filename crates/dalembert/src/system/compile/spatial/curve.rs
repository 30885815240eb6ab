//! Points that stay on curves.

use super::super::built::Built;
use super::super::context::{Context, text_of};
use super::super::names::ConstantScope;
use super::super::place::Place;
use super::placement::Zero;
use crate::joint::PointOnCurve;
use crate::model::{Placement, SpaceCurve, Value};
use crate::space::Spatial;
use dalembert_expr::{Dim, Program, Quantity, Resolved, Scope, UnknownName};
use smallvec::{SmallVec, smallvec};
use std::sync::Arc;

/// The one name of a curve.
struct CurveScope<'a>(ConstantScope<'a>);

impl Scope for CurveScope<'_> {
    fn variable(&self, path: &[&str]) -> Result<Resolved, UnknownName> {
        if path == ["u"] {
            return Ok(Resolved::Slot {
                index: 0,
                dim: Quantity::Known(Dim::NONE),
            });
        }
        self.0.variable(path).map_err(|mut e| {
            e.note = Some("a curve is a function of u and parameters".to_owned());
            e
        })
    }

    fn function(&self, name: &str) -> Option<Arc<dyn dalembert_expr::Function>> {
        self.0.function(name)
    }
}

impl Context<'_, Spatial> {
    fn curve_program(&mut self, value: &Value, place: &Place, key: &str) -> Option<Program> {
        let scope = CurveScope(ConstantScope {
            parameters: &self.parameters,
            functions: &self.functions,
        });
        let dim = Quantity::Known(Dim::LENGTH);
        let compiled = dalembert_expr::compile(&text_of(value), &scope, dim);
        let path = place.key(&format!("curve.{key}"));
        self.accept(compiled, &place.owner, &path)
    }

    pub(super) fn point_on_curve(
        &mut self,
        placement: &Placement,
        curve: &SpaceCurve,
        start: Option<&Value>,
        place: &Place,
    ) -> Option<Built<Spatial>> {
        let m = self.sit(placement, place, false, Zero::OfEstimate);
        let [x, y, z] = [(&curve.x, "x"), (&curve.y, "y"), (&curve.z, "z")]
            .map(|(value, key)| self.curve_program(value, place, key));
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
