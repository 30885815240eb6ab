//! Generalized coordinates of the orientations: origins of the frames and the coordinates of a set.

use super::coordinates::CoordinateTerms;
use crate::analysis::AnalysisError;
use crate::space::Space;
use crate::space::orientation::{EulerSequence, OrientationSet, Rotation, rotation_of};
use crate::system::{System, Workspace};
use nalgebra::{DMatrix, DVector, Vector3};

/// u = W x', u' = W x'' + w: from the rates of generalized coordinates x to the velocities u of the body frames, with the
/// angular ones in body axes; and the conditions among the coordinates as further rows.
#[derive(Clone, Debug)]
pub(super) struct InSet {
    /// Names of the coordinates.
    pub names: Vec<String>,
    /// x.
    pub positions: DVector<f64>,
    /// x'.
    pub rates: DVector<f64>,
    /// W.
    pub transform: DMatrix<f64>,
    /// w: Gbar' x' of every body (Shabana 7.83).
    pub bias: DVector<f64>,
    /// Typical sizes of the coordinates.
    pub scale: Vec<f64>,
    /// Names of the rows of the conditions.
    pub rows: Vec<String>,
    /// Conditions: their values.
    pub value: DVector<f64>,
    /// Their gradients by x.
    pub jacobian: DMatrix<f64>,
    /// Their right sides.
    pub qd: DVector<f64>,
}

/// The sequence about body axes that is farthest from its singular pose.
fn best_sequence(rotation: &Rotation) -> OrientationSet {
    let regularity = |s: &EulerSequence| s.regularity(&s.angles(rotation).angles);
    let best = EulerSequence::all(false).max_by(|a, b| regularity(a).total_cmp(&regularity(b)));
    OrientationSet::Euler(best.unwrap_or(EulerSequence::ZXZ))
}

impl InSet {
    /// The coordinates of a set at the velocities of some terms; the frames of the bodies have the axes of `markers`.
    ///
    /// # Errors
    /// The machine is planar, or a body stands at a singular pose of the set.
    pub fn new<S: Space>(
        system: &System<S>,
        ws: &Workspace<S>,
        set: OrientationSet,
        markers: impl Fn(usize) -> usize,
        at: &CoordinateTerms,
    ) -> Result<Self, AnalysisError> {
        if S::ANGULAR.len() != 3 {
            return Err(AnalysisError::PlanarOrientation);
        }
        let (own, linear) = (set.names(), S::LINEAR);
        let (bodies, aux) = (system.bodies.len(), system.aux);
        let n = linear + own.len();
        let (old, new) = (bodies * S::NV + aux, bodies * n + aux);
        let mut found = Self {
            names: Vec::with_capacity(new),
            positions: DVector::zeros(new),
            rates: DVector::zeros(new),
            transform: DMatrix::zeros(old, new),
            bias: DVector::zeros(old),
            scale: Vec::with_capacity(new),
            rows: Vec::new(),
            value: DVector::zeros(0),
            jacobian: DMatrix::zeros(0, new),
            qd: DVector::zeros(0),
        };
        let names = system.coordinate_names();
        let mut conditions = Vec::new();
        for (b, body) in system.bodies.iter().enumerate() {
            let (from, to) = (S::NV * b, n * b);
            let axes = S::axes(&ws.markers[markers(b)]);
            let rotation = rotation_of(&axes);
            let omegabar =
                Vector3::from_column_slice(at.velocities.rows(from + linear, 3).as_slice());
            let x = set.rates(&rotation, &omegabar).ok_or_else(|| {
                AnalysisError::SingularOrientation {
                    body: body.name.clone(),
                    set: set.to_string(),
                    better: best_sequence(&rotation).to_string(),
                }
            })?;
            for k in 0..linear {
                found.names.push(names[from + k].clone());
                found.positions[to + k] = at.positions[S::NQ * b + k];
                found.rates[to + k] = at.velocities[from + k];
                found.transform[(from + k, to + k)] = 1.0;
                found.scale.push(at.terms.column_scale[from + k]);
            }
            let turn = to + linear;
            found
                .names
                .extend(own.iter().map(|c| format!("{}.{c}", body.name)));
            found.scale.extend(own.iter().map(|_| 1.0));
            found
                .positions
                .rows_mut(turn, own.len())
                .copy_from(&x.values);
            found.rates.rows_mut(turn, own.len()).copy_from(&x.rates);
            found
                .transform
                .view_mut((from + linear, turn), (3, own.len()))
                .copy_from(&x.gbar);
            found
                .bias
                .rows_mut(from + linear, 3)
                .copy_from(&x.gbar_rate_times);
            conditions.extend(x.conditions.into_iter().map(|c| (b, turn, c)));
        }
        for k in 0..aux {
            let (from, to) = (bodies * S::NV + k, bodies * n + k);
            found.names.push(names[from].clone());
            found.positions[to] = at.positions[bodies * S::NQ + k];
            found.rates[to] = at.velocities[from];
            found.transform[(from, to)] = 1.0;
            found.scale.push(at.terms.column_scale[from]);
        }
        let count = conditions.len();
        found.value = DVector::zeros(count);
        found.jacobian = DMatrix::zeros(count, new);
        found.qd = DVector::zeros(count);
        for (row, (b, turn, c)) in conditions.into_iter().enumerate() {
            let body = &system.bodies[b].name;
            found.rows.push(format!("{body} ({set}): {}", c.name));
            found.value[row] = c.value;
            found.qd[row] = c.qd;
            let gradient = c.gradient.transpose();
            found
                .jacobian
                .view_mut((row, turn), (1, gradient.len()))
                .copy_from(&gradient);
        }
        Ok(found)
    }

    /// u' of accelerations x''.
    pub fn accelerations(&self, a: &[f64]) -> DVector<f64> {
        &self.transform * DVector::from_column_slice(a) + &self.bias
    }
}
