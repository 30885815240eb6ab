//! Steps of a kinematic analysis.

use super::multipliers::solve_multipliers;
use super::watch::{Watch, scaled_jacobian};
use crate::analysis::AnalysisError;
use crate::analysis::newton::{NewtonOptions, correct_positions};
use crate::analysis::weights::Weights;
use crate::space::{Space, Tuple, norm};
use crate::system::{State, System, Workspace};
use crate::words::listed;
use nalgebra::DMatrix;

/// Systems up to this many coordinates are watched for singular poses by a dense factorization.
pub(super) const DENSE: usize = 300;
/// Ratio of pivots of C_q below which a pose is singular to working precision.
const SINGULAR: f64 = 1e-9;
/// Pivot ratio below which an over-determined machine is watched by other rows.
pub(super) const RECHOOSE: f64 = 1e-3;
/// How often an interval between two instants may be halved.
const HALVINGS: usize = 12;

/// A driven motion on its way.
pub(super) struct Runner<'a, S: Space> {
    system: &'a System<S>,
    pub(super) ws: Workspace<S>,
    weights: Weights,
    watch: Watch,
    trial: Vec<f64>,
    newton: NewtonOptions,
    pub(super) iterations: usize,
    pub(super) substeps: usize,
}

impl<'a, S: Space> Runner<'a, S> {
    pub(super) fn new(system: &'a System<S>, newton: NewtonOptions) -> Self {
        Self {
            ws: Workspace::new(system),
            weights: Weights::even(system),
            watch: Watch::none(),
            trial: Vec::new(),
            newton,
            iterations: 0,
            substeps: 0,
            system,
        }
    }

    /// Checks at the start that the drivers give the whole motion.
    pub(super) fn start(&mut self, state: &mut State) -> Result<(), AnalysisError> {
        self.motion(state);
        if self.system.nv() > DENSE {
            // Large machines: the sparse factors tell the rank.
            let rank = self.ws.saddle.factored().rank();
            let free = self.system.nv().saturating_sub(rank);
            if free == 0 {
                return Ok(());
            }
            let names = "run 'check' for their names".to_owned();
            return Err(AnalysisError::NotDriven {
                freedoms: free,
                names,
            });
        }
        let c = scaled_jacobian(self.system, &self.ws);
        self.watch = Watch::new(&c);
        let free = c.ncols() - self.watch.rows.len();
        if free == 0 {
            return Ok(());
        }
        // A dead centre at the very start looks like a freedom; a nearby pose tells them apart
        // only where there are as many independent rows as coordinates, so say both.
        let svd = c.clone().svd(false, true);
        let names = self.system.coordinate_names();
        let mut moving = Vec::new();
        if let Some(v) = svd.v_t {
            let null = c.nrows().min(v.nrows());
            for (k, name) in names.iter().enumerate() {
                let span: f64 = (0..null).map(|r| v[(r, k)] * v[(r, k)]).sum();
                if 1.0 - span > 1e-12 || svd_null_part(&svd.singular_values, &v, k) > 1e-6 {
                    moving.push(name.clone());
                }
            }
        }
        moving.truncate(6);
        let rows = self.system.rows;
        if rows >= c.ncols() && self.system.is_driven() {
            return Err(AnalysisError::Singular {
                time: state.t,
                last: state.t,
                kind: "dead centre, or redundant constraints and a missing driver",
                detail: format!(
                    "the constraints and drivers leave {free} motion(s) open at the start: {}. Start at another pose, drive another coordinate, or run 'check'",
                    moving.join(", ")
                ),
            });
        }
        Err(AnalysisError::NotDriven {
            freedoms: free,
            names: moving.join(", "),
        })
    }

    /// From one instant to the next, `passed` is told every pose on the way: predictor, Newton, velocities,
    /// accelerations; the interval is halved where Newton does not converge.
    pub(super) fn advance(
        &mut self,
        state: &mut State,
        t: f64,
        passed: &mut dyn FnMut(&State) -> Result<(), AnalysisError>,
    ) -> Result<(), AnalysisError> {
        let start = state.t;
        let mut h = t - state.t;
        let smallest = h / f64::from(1 << HALVINGS);
        while state.t < t {
            h = h.min(t - state.t).min(self.longest(state)).max(smallest);
            let mut next = self.predict(state, h);
            if t - next.t < 0.5 * smallest {
                next.t = t;
            }
            let sign = self.watch.sign;
            let moved = correct_positions(
                self.system,
                &mut self.ws,
                &mut next,
                &self.weights,
                &self.newton,
                &mut self.trial,
            );
            match moved {
                Ok(report) if self.near(state, &next) => {
                    self.iterations += report.iterations;
                    self.motion(&mut next);
                    if self.watch.rows.is_empty() {
                        // Large machines: a pose is looked at itself, not the way to it.
                        let rank = self.ws.saddle.factored().rank();
                        if rank < self.system.nv() {
                            if h <= smallest {
                                return Err(self.singular(next.t, start));
                            }
                            h *= 0.5;
                            self.substeps += 1;
                            continue;
                        }
                    } else {
                        let c = scaled_jacobian(self.system, &self.ws);
                        self.watch.look(&c);
                        let mut crossed = sign * self.watch.sign < 0.0;
                        if (crossed || self.watch.smallest < RECHOOSE) && c.nrows() > c.ncols() {
                            // With more rows than coordinates others may hold what these let go.
                            let other = Watch::new(&c);
                            if other.rows.len() == c.ncols() && other.smallest > RECHOOSE {
                                self.watch = other;
                                crossed = false;
                            }
                        }
                        if (crossed || self.watch.smallest < SINGULAR) && h > smallest {
                            self.watch.sign = sign;
                            h *= 0.5;
                            self.substeps += 1;
                            continue;
                        }
                        if crossed || self.watch.smallest < SINGULAR {
                            return Err(self.singular(next.t, start));
                        }
                    }
                    passed(&next)?;
                    *state = next;
                }
                Ok(_) | Err(AnalysisError::NotAssembled { .. }) if h > smallest => {
                    h *= 0.5;
                    self.substeps += 1;
                }
                Ok(_) => return Err(self.singular(next.t, start)),
                Err(AnalysisError::NotAssembled { .. }) if !self.watch.rows.is_empty() => {
                    return Err(self.singular(next.t, start));
                }
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }

    /// The longest interval in which a singular pose cannot be passed twice unseen: a fraction of a
    /// turn, a fraction of the machine's size.
    pub(super) fn longest(&self, state: &State) -> f64 {
        if self.watch.rows.is_empty() {
            return f64::INFINITY;
        }
        let bodies = state.v[..self.system.body_nv()].chunks_exact(S::NV);
        let fastest = bodies
            .map(|v| {
                let (linear, angular) = v.split_at(S::LINEAR);
                (norm(linear) / self.system.size).max(2.0 * norm(angular))
            })
            .fold(0.0, f64::max);
        if fastest > 0.0 {
            0.5 / fastest
        } else {
            f64::INFINITY
        }
    }

    /// Did Newton stay on the branch? The correction must be small beside the predicted motion.
    pub(super) fn near(&self, from: &State, to: &State) -> bool {
        // A turn of more than a radian or a move of more than the machine's size in one substep
        // that the velocities did not announce is a jump.
        let h = to.t - from.t;
        let mut moved = S::Twist::zero();
        (0..self.system.bodies.len()).all(|b| {
            let own = b * S::NQ..(b + 1) * S::NQ;
            S::difference(&from.q[own.clone()], &to.q[own], moved.as_mut_slice());
            let velocity = &from.v[b * S::NV..(b + 1) * S::NV];
            let pairs = moved.as_slice().iter().zip(velocity).enumerate();
            pairs.into_iter().all(|(k, (moved, v))| {
                let expected = v * h;
                let scale = if k < S::LINEAR { self.system.size } else { 1.0 };
                (moved - expected).abs() <= 0.5 * scale + expected.abs()
            })
        })
    }

    /// q + h v + h^2/2 a (Shabana 3.138).
    pub(super) fn predict(&self, state: &State, h: f64) -> State {
        let mut next = state.clone();
        next.t += h;
        let rates = state.v.iter().zip(&self.ws.a);
        let step: Vec<f64> = rates.map(|(v, a)| h * v + 0.5 * h * h * a).collect();
        self.system.advance(&mut next.q, 1.0, &step);
        next
    }

    /// Velocities and accelerations with one factorization; the workspace then holds C_q, C_t, Q_d
    /// and the accelerations.
    pub(super) fn motion(&mut self, state: &mut State) {
        let (system, ws) = (self.system, &mut self.ws);
        system.update_markers(&state.q, &state.v, ws);
        system.evaluate_constraints(state.t, ws);
        ws.factor(&self.weights.inverse);
        for (r, t) in ws.rhs.iter_mut().zip(&ws.time) {
            *r = -t;
        }
        ws.solve(&self.weights.blocks, &self.weights.zero);
        state.v.copy_from_slice(&ws.a);
        // Q_d depends on the velocities; C_q does not.
        system.update_markers(&state.q, &state.v, ws);
        system.evaluate_constraints(state.t, ws);
        ws.rhs.copy_from_slice(&ws.qd);
        ws.solve(&self.weights.blocks, &self.weights.zero);
    }

    /// Multipliers of the known motion: C_q^T lambda = Q_e - M a (Shabana 6.13).
    pub(super) fn forces(&mut self, state: &State) {
        let (system, ws) = (self.system, &mut self.ws);
        system.evaluate_forces(state.t, ws);
        solve_multipliers(system, ws, &self.weights);
    }

    pub(super) fn singular(&self, time: f64, last: f64) -> AnalysisError {
        let drivers: Vec<&str> = self.system.drivers().map(|e| e.name.as_str()).collect();
        let (word, verb) = if drivers.len() == 1 {
            ("driver", "does")
        } else {
            ("drivers", "do")
        };
        AnalysisError::Singular {
            time,
            last,
            kind: "dead centre or bifurcation",
            detail: format!(
                "here the {word} {} {verb} not determine the motion; drive another coordinate, or end the motion before this pose",
                listed(&drivers)
            ),
        }
    }
}

/// Part of a coordinate in the right singular vectors of vanishing singular values.
fn svd_null_part(values: &nalgebra::DVector<f64>, v_t: &DMatrix<f64>, k: usize) -> f64 {
    let largest = values.amax();
    (0..values.len())
        .filter(|&r| values[r] <= 1e-9 * largest)
        .map(|r| v_t[(r, k)] * v_t[(r, k)])
        .sum()
}
