//! User constraints on velocities.

use super::{
    ConstraintElement, ConstraintInput, ConstraintOutput, Guarded, Measure, MeasureKind, RowLabel,
    RowUnit,
};
use crate::signal::{MAX_INPUTS, Signal, SignalKind};
use crate::space::{Planar, Space, Tuple};
use dalembert_expr::{Jet2, Program};
use std::ops::Range;

/// A row g(t, measures, rates) = 0 that is linear in the rates: the gradient by the rates is the row's, what is left
/// without rates its C_t, and the bias is its time derivative where the accelerations of the markers vanish.
#[derive(Clone, Debug)]
pub struct VelocityRows<S: Space = Planar> {
    /// The expression.
    pub program: Program,
    /// What its inputs are, on the element's own markers.
    pub inputs: Vec<Signal<S>>,
    /// Number of markers of the element.
    pub markers: usize,
}

impl<S: Space> ConstraintElement<S> for VelocityRows<S> {
    fn labels(&self) -> Vec<RowLabel> {
        vec![RowLabel {
            text: self.program.text().to_owned(),
            unit: RowUnit::Other,
        }]
    }

    fn velocity_rows(&self) -> Range<usize> {
        0..1
    }

    fn distances(&self) -> Vec<Measure<S>> {
        let measures = self.inputs.iter().filter(|s| s.kind != SignalKind::Time);
        let measures = measures.map(|s| s.measure);
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
        let mut jets = [Jet2::constant(0.0); MAX_INPUTS];
        let mut slopes = [0.0; MAX_INPUTS];
        let n = self.inputs.len();
        for (k, signal) in self.inputs.iter().enumerate() {
            jets[k] = match signal.kind {
                SignalKind::Time => Jet2::new(input.t, 1.0, 0.0),
                SignalKind::Value | SignalKind::Rate => {
                    let x = signal.measure.evaluate(input.markers);
                    if signal.kind == SignalKind::Value {
                        Jet2::new(x.value, x.rate, 0.0)
                    } else {
                        Jet2::new(x.rate, x.bias, 0.0)
                    }
                }
            };
            values[k] = jets[k].v;
        }
        let residual = self.program.gradient(&values[..n], &mut slopes[..n]);
        out.bias[0] = self.program.eval_jet(&jets[..n]).d;
        out.time[0] = residual;
        for ((slope, signal), value) in slopes.iter().zip(&self.inputs).zip(&values) {
            if signal.kind != SignalKind::Rate {
                continue;
            }
            let m = signal.measure;
            let x = m.evaluate(input.markers);
            out.time[0] -= slope * value;
            out.gradient[m.first].add_scaled(*slope, &x.first);
            out.gradient[m.second].add_scaled(*slope, &x.second);
        }
    }
}
