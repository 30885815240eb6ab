//! Rows that are weighted sums of measures: most joints, drivers, couplers, gears, racks.

use super::{
    ConstraintElement, ConstraintInput, ConstraintOutput, Guarded, Measure, MeasureKind, RowLabel,
    RowUnit, TimeFunction,
};
use crate::space::{Planar, Space, Tuple};
use smallvec::SmallVec;

/// One term of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasureTerm<S: Space = Planar> {
    /// Factor.
    pub factor: f64,
    /// Measure between two markers of the element.
    pub measure: Measure<S>,
}

/// One row: C = sum of factor * measure - f(t).
#[derive(Clone, Debug)]
pub struct MeasureRow<S: Space = Planar> {
    /// The terms.
    pub terms: SmallVec<[MeasureTerm<S>; 1]>,
    /// f(t).
    pub target: TimeFunction,
    /// What the row holds.
    pub label: String,
}

/// A constraint element whose rows are weighted sums of measures.
#[derive(Clone, Debug)]
pub struct MeasureRows<S: Space = Planar> {
    /// Number of markers of the element.
    pub markers: usize,
    /// The rows.
    pub rows: SmallVec<[MeasureRow<S>; 2]>,
    /// Sums of cosines that are one in the pose that is meant.
    pub alike: SmallVec<[SumOfMeasures<S>; 1]>,
}

/// A weighted sum of measures.
pub type SumOfMeasures<S> = SmallVec<[MeasureTerm<S>; 1]>;

/// Value of a weighted sum of measures.
pub fn sum_of<S: Space>(terms: &[MeasureTerm<S>], markers: &[S::Marker]) -> f64 {
    let value = |term: &MeasureTerm<S>| term.factor * term.measure.value(markers);
    terms.iter().map(value).sum()
}

impl<S: Space> MeasureRow<S> {
    /// A row of a single measure with factor -1: C = -(measure) + constant, so that C = first - second
    /// and the multiplier is the reaction on the second body (Shabana 3.129, 6.107).
    pub fn minus(measure: Measure<S>, target: f64, label: &str) -> Self {
        Self {
            terms: SmallVec::from_elem(
                MeasureTerm {
                    factor: -1.0,
                    measure,
                },
                1,
            ),
            target: TimeFunction::Constant(-target),
            label: label.to_owned(),
        }
    }

    /// C = measure - f(t).
    pub fn follow(measure: Measure<S>, target: TimeFunction, label: &str) -> Self {
        Self {
            terms: SmallVec::from_elem(
                MeasureTerm {
                    factor: 1.0,
                    measure,
                },
                1,
            ),
            target,
            label: label.to_owned(),
        }
    }

    /// Value of the sum of measures.
    pub fn sum(&self, markers: &[S::Marker]) -> f64 {
        sum_of(&self.terms, markers)
    }

    fn unit(&self) -> RowUnit {
        let mut unit = None;
        for term in &self.terms {
            let own = if term.measure.kind.is_length() {
                RowUnit::Length
            } else {
                RowUnit::Angle
            };
            match unit {
                None => unit = Some(own),
                // A factor makes lengths of the angles: a rack, a rope.
                Some(u) if u != own => unit = Some(RowUnit::Length),
                Some(_) => {}
            }
        }
        unit.unwrap_or(RowUnit::Other)
    }
}

impl<S: Space> MeasureRows<S> {
    /// Rows on a number of markers; every pose in which they hold is meant.
    pub fn new(markers: usize, rows: SmallVec<[MeasureRow<S>; 2]>) -> Self {
        Self {
            markers,
            rows,
            alike: SmallVec::new(),
        }
    }
}

impl<S: Space> ConstraintElement<S> for MeasureRows<S> {
    fn labels(&self) -> Vec<RowLabel> {
        self.rows
            .iter()
            .map(|r| RowLabel {
                text: r.label.clone(),
                unit: r.unit(),
            })
            .collect()
    }

    fn distances(&self) -> Vec<Measure<S>> {
        let terms = self.rows.iter().flat_map(|row| &row.terms);
        let measures = terms.map(|term| term.measure);
        measures
            .filter(|m| m.kind == S::Measure::DISTANCE)
            .collect()
    }

    fn guarded(&self, markers: &[S::Marker], see: &mut dyn FnMut(Guarded)) {
        let terms = self.rows.iter().flat_map(|row| &row.terms);
        terms
            .filter_map(|term| term.measure.guarded(markers))
            .for_each(see);
    }

    fn alike(&self) -> &[SumOfMeasures<S>] {
        &self.alike
    }

    fn evaluate(&self, input: &ConstraintInput<'_, S>, out: &mut ConstraintOutput<'_, S>) {
        for (k, row) in self.rows.iter().enumerate() {
            let gradient = &mut out.gradient[k * self.markers..(k + 1) * self.markers];
            for term in &row.terms {
                let Measure { first, second, .. } = term.measure;
                let m = term.measure.evaluate(input.markers);
                out.value[k] += term.factor * m.value;
                out.bias[k] += term.factor * m.bias;
                gradient[first].add_scaled(term.factor, &m.first);
                gradient[second].add_scaled(term.factor, &m.second);
            }
            match &row.target {
                TimeFunction::Constant(value) => out.value[k] -= value,
                moving => {
                    let f = moving.jet(input.t);
                    out.value[k] -= f.v;
                    out.time[k] -= f.d;
                    out.bias[k] -= f.dd;
                }
            }
        }
    }
}
