//! A point that stays on a curve in space.

use super::{
    ConstraintElement, ConstraintInput, ConstraintOutput, RowLabel, RowUnit, SpatialMeasure,
};
use crate::space::Spatial;
use crate::space::orientation::Axis;
use dalembert_expr::Program;

/// The point of the second marker on a curve c(u) in the axes of the first: C_k = c_k(u) - e_k.d, with the curve
/// parameter u as auxiliary coordinate.
#[derive(Clone, Debug)]
pub struct PointOnCurve {
    /// x, y and z [m], expressions of u alone.
    pub curve: [Program; 3],
}

/// Value and the first two derivatives.
fn derivatives(program: &Program, s: f64) -> [f64; 3] {
    let inputs: &[f64] = if program.slots().is_empty() {
        &[]
    } else {
        std::slice::from_ref(&s)
    };
    let [value, first, second, _] = program.eval_third(inputs);
    [value, first, second]
}

impl ConstraintElement<Spatial> for PointOnCurve {
    fn labels(&self) -> Vec<RowLabel> {
        Axis::ALL
            .map(|axis| RowLabel {
                text: format!("off the curve, {}", axis.letter()),
                unit: RowUnit::Length,
            })
            .to_vec()
    }

    fn auxiliaries(&self) -> Vec<RowLabel> {
        vec![RowLabel {
            text: "u".to_owned(),
            unit: RowUnit::Other,
        }]
    }

    fn evaluate(
        &self,
        input: &ConstraintInput<'_, Spatial>,
        out: &mut ConstraintOutput<'_, Spatial>,
    ) {
        let (s, rate) = (input.s[0], input.s_rate[0]);
        for (k, axis) in Axis::ALL.into_iter().enumerate() {
            let along = SpatialMeasure::Along(axis).evaluate(&input.markers[0], &input.markers[1]);
            let [value, first, second] = derivatives(&self.curve[k], s);
            out.value[k] = value - along.value;
            out.gradient[2 * k] = -along.first;
            out.gradient[2 * k + 1] = -along.second;
            out.auxiliary[k] = first;
            out.bias[k] = second * rate * rate - along.bias;
        }
    }
}
