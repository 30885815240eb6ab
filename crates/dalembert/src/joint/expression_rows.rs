//! User constraints: an expression of time and of positions stays zero.

use super::{
    ConstraintElement, ConstraintInput, ConstraintOutput, Guarded, Measure, MeasureKind, RowLabel,
    RowUnit,
};
use crate::signal::{MAX_INPUTS, Signal, SignalKind};
use crate::space::{Planar, Space, Tuple};
use dalembert_expr::{Jet2, Program};

/// C = g(t, measures): gradient by the chain rule, bias by second-order Taylor arithmetic along the
/// motion (each measure enters with its own rate and bias).
#[derive(Clone, Debug)]
pub struct ExpressionRows<S: Space = Planar> {
    /// The expression.
    pub program: Program,
    /// What its inputs are, on the element's own markers; only time and values.
    pub inputs: Vec<Signal<S>>,
    /// Number of markers of the element.
    pub markers: usize,
}

impl<S: Space> ConstraintElement<S> for ExpressionRows<S> {
    fn labels(&self) -> Vec<RowLabel> {
        vec![RowLabel {
            text: self.program.text().to_owned(),
            unit: RowUnit::Other,
        }]
    }

    fn distances(&self) -> Vec<Measure<S>> {
        let values = self.inputs.iter().filter(|s| s.kind == SignalKind::Value);
        let measures = values.map(|s| s.measure);
        measures
            .filter(|m| m.kind == S::Measure::DISTANCE)
            .collect()
    }

    fn guarded(&self, markers: &[S::Marker], see: &mut dyn FnMut(Guarded)) {
        let inputs = self.inputs.iter();
        inputs
            .filter_map(|signal| signal.guarded(markers))
            .for_each(see);
    }

    fn evaluate(&self, input: &ConstraintInput<'_, S>, out: &mut ConstraintOutput<'_, S>) {
        let mut values = [0.0; MAX_INPUTS];
        let mut jets = [Jet2 {
            v: 0.0,
            d: 0.0,
            dd: 0.0,
        }; MAX_INPUTS];
        let mut slopes = [0.0; MAX_INPUTS];
        let n = self.inputs.len();
        for (k, signal) in self.inputs.iter().enumerate() {
            jets[k] = match signal.kind {
                SignalKind::Time => Jet2 {
                    v: input.t,
                    d: 1.0,
                    dd: 0.0,
                },
                SignalKind::Value | SignalKind::Rate => {
                    let x = signal.measure.evaluate(input.markers);
                    // With the accelerations of the markers zero, gradients still meet the
                    // markers' own normal accelerations; the assembly adds those.
                    Jet2 {
                        v: x.value,
                        d: x.rate,
                        dd: x.bias,
                    }
                }
            };
            values[k] = jets[k].v;
        }
        out.value[0] = self.program.gradient(&values[..n], &mut slopes[..n]);
        out.bias[0] = self.program.eval_jet(&jets[..n]).dd;
        for (slope, signal) in slopes.iter().zip(&self.inputs) {
            if signal.kind == SignalKind::Time {
                out.time[0] += slope;
                continue;
            }
            let m = signal.measure;
            let x = m.evaluate(input.markers);
            out.gradient[m.first].add_scaled(*slope, &x.first);
            out.gradient[m.second].add_scaled(*slope, &x.second);
        }
    }
}
