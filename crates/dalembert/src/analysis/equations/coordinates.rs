//! Coordinates of the user's body frames.

use super::ReferenceFrame;
use super::body_frame::BodyFrame;
use super::in_set::InSet;
use crate::analysis::AnalysisError;
use crate::formulation::Terms;
use crate::space::orientation::OrientationSet;
use crate::space::{Space, Tuple};
use crate::system::{State, System, Workspace};
use nalgebra::{DMatrix, DVector};

/// The equations in coordinates (of the reference frames of the bodies, then auxiliaries).
#[derive(Clone, Debug)]
pub(super) struct CoordinateTerms {
    pub positions: DVector<f64>,
    pub velocities: DVector<f64>,
    /// Q_e.
    pub applied: DVector<f64>,
    /// Q_v.
    pub inertial: DVector<f64>,
    /// The rest, with Q = Q_e + Q_v.
    pub terms: Terms,
    /// The frame of each body that is not that of its centre of mass.
    frames: Vec<Option<BodyFrame>>,
    /// Velocities of the centres of mass.
    central: Vec<f64>,
    /// The coordinates of the orientations, where they are not turns about the axes of the frames.
    pub in_set: Option<InSet>,
}

impl CoordinateTerms {
    /// The terms at the state of a workspace.
    ///
    /// With v = T u, a = T u' + gamma: M = T^T M_c T holds the first moments, Q_v = T^T (Q_vc - M_c gamma), and
    /// C_q a = Q_d loses the same normal acceleration (Shabana 6.16 to 6.45, 7.78 to 7.85).
    pub fn new<S: Space>(
        system: &System<S>,
        state: &State,
        ws: &Workspace<S>,
        frame: ReferenceFrame,
    ) -> Self {
        let mut terms = Terms::of(system, ws);
        let mut positions = DVector::from_column_slice(&state.q);
        let mut velocities = DVector::from_column_slice(&state.v);
        let mut applied = DVector::from_column_slice(&ws.force);
        let mut inertial = DVector::zeros(system.nv());
        let mut frames = Vec::with_capacity(system.bodies.len());
        let n = S::NV;
        for b in 0..system.bodies.len() {
            let at = n * b;
            if S::GYROSCOPIC {
                let own = S::gyroscopic(system.mass_block(b), &state.v[at..at + n]);
                for (k, x) in own.as_slice().iter().enumerate() {
                    inertial[at + k] = *x;
                    // The forces of the workspace hold it already.
                    applied[at + k] -= x;
                }
            }
            let own = match frame {
                ReferenceFrame::Center => None,
                ReferenceFrame::User => BodyFrame::new(system, ws, b),
            };
            if let Some(own) = &own {
                positions
                    .rows_mut(S::NQ * b, S::NQ)
                    .copy_from_slice(&own.positions);
                velocities.rows_mut(at, n).copy_from(&own.velocities);
                let t = &own.transform;
                let mass = terms.mass.view((at, at), (n, n)).into_owned();
                let own_inertial = inertial.rows(at, n) - &mass * &own.bias;
                inertial.rows_mut(at, n).copy_from(&t.tr_mul(&own_inertial));
                let own_applied = t.tr_mul(&applied.rows(at, n));
                applied.rows_mut(at, n).copy_from(&own_applied);
                let mass = t.tr_mul(&(mass * t));
                terms.mass.view_mut((at, at), (n, n)).copy_from(&mass);
                let jacobian = terms.jacobian.columns(at, n).into_owned();
                terms.qd -= &jacobian * &own.bias;
                terms.jacobian.columns_mut(at, n).copy_from(&(jacobian * t));
            }
            frames.push(own);
        }
        terms.force = &applied + &inertial;
        Self {
            positions,
            velocities,
            applied,
            inertial,
            terms,
            frames,
            central: state.v.clone(),
            in_set: None,
        }
    }

    /// The same equations in the origins of the frames and the coordinates of a set of orientations: with u = W x' and
    /// u' = W x'' + w, M = W^T M_u W (Shabana 7.85), Q_v = W^T (Q_vu - M_u w) (7.104, 7.105), C_q = C_u W and
    /// Q_d = Q_du - C_u w; conditions among the coordinates are further rows (8.16).
    ///
    /// # Errors
    /// The machine is planar, or a body stands at a singular pose of the set.
    pub fn in_set<S: Space>(
        mut self,
        system: &System<S>,
        ws: &Workspace<S>,
        frame: ReferenceFrame,
        set: OrientationSet,
    ) -> Result<Self, AnalysisError> {
        let marker = |b: usize| match frame {
            ReferenceFrame::User => system.bodies[b].frame_marker,
            ReferenceFrame::Center => system.bodies[b].center_marker,
        };
        let x = InSet::new(system, ws, set, marker, &self)?;
        let w = &x.transform;
        let terms = &mut self.terms;
        self.inertial = w.tr_mul(&(&self.inertial - &terms.mass * &x.bias));
        self.applied = w.tr_mul(&self.applied);
        terms.mass = w.tr_mul(&(&terms.mass * w));
        let (rows, extra) = (terms.jacobian.nrows(), x.rows.len());
        let qd = &terms.qd - &terms.jacobian * &x.bias;
        let jacobian = &terms.jacobian * w;
        terms.jacobian = DMatrix::zeros(rows + extra, w.ncols());
        terms.jacobian.rows_mut(0, rows).copy_from(&jacobian);
        terms.jacobian.rows_mut(rows, extra).copy_from(&x.jacobian);
        terms.qd = DVector::zeros(rows + extra);
        terms.qd.rows_mut(0, rows).copy_from(&qd);
        terms.qd.rows_mut(rows, extra).copy_from(&x.qd);
        terms.force = &self.applied + &self.inertial;
        terms.column_scale.clone_from(&x.scale);
        self.positions.clone_from(&x.positions);
        self.velocities.clone_from(&x.rates);
        self.in_set = Some(x);
        Ok(self)
    }

    /// Half the integral of |acceleration|^2 dm (Shabana 5.164), with alpha and omega in body axes:
    /// m |a_c|^2 / 2 + alpha . J alpha / 2 + alpha . (omega x J omega) + omega^2 (omega . J omega) / 2 for each body.
    pub fn gibbs_appel<S: Space>(&self, system: &System<S>, a: &[f64]) -> f64 {
        let n = S::NV;
        let own = self.in_set.as_ref().map(|x| x.accelerations(a));
        let a = own.as_ref().map_or(a, DVector::as_slice);
        let mut sum = 0.0;
        for (b, frame) in self.frames.iter().enumerate() {
            let own = DVector::from_column_slice(&a[n * b..n * (b + 1)]);
            let a = match frame {
                Some(frame) => &frame.transform * own + &frame.bias,
                None => own,
            };
            let v = &self.central[n * b..n * (b + 1)];
            let block = system.mass_block(b);
            let gyroscopic = S::gyroscopic(block, v);
            let (mut square, mut spin) = (0.0, 0.0);
            for i in 0..n {
                sum -= a[i] * gyroscopic.as_slice()[i];
                for j in 0..n {
                    sum += 0.5 * a[i] * block[n * i + j] * a[j];
                    if i.min(j) >= S::LINEAR {
                        spin += v[i] * block[n * i + j] * v[j];
                    }
                }
                if i >= S::LINEAR {
                    square += v[i] * v[i];
                }
            }
            sum += 0.5 * square * spin;
        }
        sum
    }
}
