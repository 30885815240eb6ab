//! Gears and racks: joints whose coordinates move in a ratio.

use super::super::built::Built;
use super::super::constraints::measure_rows;
use super::super::context::Context;
use super::super::place::Place;
use crate::diagnostic::Diagnostic;
use crate::joint::TimeFunction;
use crate::model::Value;
use crate::space::Spatial;
use dalembert_expr::Dim;

impl Context<'_, Spatial> {
    /// second angle - ratio * first angle = constant, the value of the estimate.
    pub(super) fn gear_pair(
        &mut self,
        joints: &[String; 2],
        ratio: &Value,
        place: &Place,
    ) -> Option<Built<Spatial>> {
        let ratio = self.factor(ratio, Dim::NONE, "ratio", place);
        self.pair("gear-pair", joints, "angle", ratio, place)
    }

    /// displacement - radius * angle = constant, the value of the estimate.
    pub(super) fn rack_pair(
        &mut self,
        joints: &[String; 2],
        radius: &Value,
        place: &Place,
    ) -> Option<Built<Spatial>> {
        let radius = self.factor(radius, Dim::LENGTH, "radius", place);
        self.pair("rack-pair", joints, "displacement", radius, place)
    }

    /// A factor that is not zero.
    fn factor(&mut self, value: &Value, dim: Dim, key: &str, place: &Place) -> Option<f64> {
        let x = self.number(value, dim, &place.owner, &place.key(key))?;
        if x != 0.0 {
            return Some(x);
        }
        self.report(
            Diagnostic::error(
                "zero-ratio",
                place.key(key),
                format!("{}: {key} is zero", place.owner),
            )
            .help(
                "give the ratio of the two motions; its sign says whether they have the same sense",
            ),
        );
        None
    }

    fn pair(
        &mut self,
        kind: &'static str,
        joints: &[String; 2],
        second: &str,
        factor: Option<f64>,
        place: &Place,
    ) -> Option<Built<Spatial>> {
        let [a, b] = [("angle", 0), (second, 1)].map(|(name, k)| {
            let path = place.key(&format!("joints[{k}]"));
            self.coordinate_at(&joints[k], name, &place.owner, &path)
        });
        let (factor, a, b) = (factor?, a?, b?);
        if a == b {
            let said = format!("{}: both joints are '{}'", place.owner, joints[0]);
            self.report(
                Diagnostic::error("same-joint", place.key("joints[1]"), said).help(
                    "name the joints of two different axes; a pair makes them move in a ratio",
                ),
            );
            return None;
        }
        let value = self.estimate(b) - factor * self.estimate(a);
        let target = TimeFunction::Constant(value);
        Some(measure_rows(
            kind,
            &[(1.0, b), (-factor, a)],
            target,
            "mesh",
        ))
    }
}
