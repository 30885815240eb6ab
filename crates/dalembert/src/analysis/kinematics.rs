//! Kinematics of driven machines: positions, velocities, accelerations, and the forces that the
//! motion takes.

use super::contradiction::contradiction;
use super::least_reactions::LeastReactions;
use super::meeting::Meeting;
use super::newton::{NewtonOptions, correct_positions};
use super::open_reactions::{OpenReactions, at_time};
use super::recorder::{Extra, Recorder};
use super::weights::Weights;
use super::{AnalysisError, Assembly, AssemblyReport};
use crate::results::Results;
use crate::solve::independent_rows;
use crate::space::Planar;
use crate::system::compile::Options;
use crate::system::{Role, State, System, Workspace};
use crate::words::listed;
use nalgebra::DMatrix;

/// Kinematic analysis (Shabana 3.7, 3.8) at given instants.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Kinematics {
    /// Instants, ascending; the first is the start.
    pub instants: Vec<f64>,
    /// Newton's options.
    pub newton: NewtonOptions,
}

/// A kinematic run: what was computed, and why it ended early if it did.
#[derive(Clone, Debug)]
pub struct KinematicsRun {
    /// Channels up to the last good instant.
    pub results: Results,
    /// What the assembly did.
    pub assembly: AssemblyReport,
    /// Why the run ended before the last instant.
    pub stopped: Option<AnalysisError>,
}

/// Systems up to this many coordinates are watched for singular poses by a dense factorization.
const DENSE: usize = 300;
/// Ratio of pivots of C_q below which a pose is singular to working precision.
const SINGULAR: f64 = 1e-9;
/// Pivot ratio below which an over-determined machine is watched by other rows.
const RECHOOSE: f64 = 1e-3;
/// How often an interval between two instants may be halved.
const HALVINGS: usize = 12;

/// Watches the sign of the determinant of the independent rows: a change means that a singular
/// pose lies between two instants, where Newton could land on either branch.
#[derive(Debug)]
struct Watch {
    /// Independent rows; empty where the system is too large to be watched.
    rows: Vec<usize>,
    sign: f64,
    smallest: f64,
}

impl Watch {
    fn new(c: &DMatrix<f64>) -> Self {
        let mut watch = Self {
            // Columns are scaled already; a failure (not finite) leaves nothing to watch.
            rows: independent_rows(c, &vec![1.0; c.ncols()], 1e-8).unwrap_or_default(),
            sign: 0.0,
            smallest: 1.0,
        };
        watch.look(c);
        watch
    }

    fn none() -> Self {
        Self {
            rows: Vec::new(),
            sign: 0.0,
            smallest: 1.0,
        }
    }

    /// Sign of the determinant and smallest pivot ratio.
    fn look(&mut self, c: &DMatrix<f64>) {
        if self.rows.len() != c.ncols() {
            return;
        }
        let mut square = c.select_rows(&self.rows);
        for mut row in square.row_iter_mut() {
            let norm = row.norm();
            if norm > 0.0 {
                row /= norm;
            }
        }
        let lu = square.full_piv_lu();
        let diagonal = lu.u().diagonal();
        let largest = diagonal.amax();
        self.smallest = if largest > 0.0 {
            diagonal.amin() / largest
        } else {
            0.0
        };
        self.sign = lu.determinant().signum();
    }
}

/// C_q with columns in units of the machine's size.
fn scaled_jacobian(system: &System<Planar>, ws: &Workspace<Planar>) -> DMatrix<f64> {
    let mut c = system.dense_jacobian(ws);
    for b in 0..system.bodies.len() {
        for k in 0..2 {
            c.column_mut(3 * b + k).scale_mut(system.size);
        }
    }
    c
}

/// The forces of a known motion in a machine with actuators instead of drivers.
struct Actuated<'a> {
    system: &'a System<Planar>,
    ws: Workspace<Planar>,
    weights: Weights,
}

impl<'a> Actuated<'a> {
    fn new(system: &'a System<Planar>) -> Self {
        Self {
            ws: Workspace::new(system),
            weights: Weights::even(system),
            system,
        }
    }

    fn solve(&mut self, state: &State, a: &[f64]) -> Result<(), AnalysisError> {
        let (system, ws) = (self.system, &mut self.ws);
        system.update_markers(&state.q, &state.v, ws);
        system.evaluate_constraints(state.t, ws);
        system.evaluate_forces(state.t, ws);
        ws.factor(&self.weights.inverse);
        ws.a.copy_from_slice(a);
        let missing = solve_multipliers(system, ws, &self.weights);
        // The rows of the actuators do not hold a value: no violation to report.
        for e in system.elements.iter().filter(|e| e.role == Role::Driver) {
            ws.value[e.rows.clone()].fill(0.0);
            let rate: f64 = e
                .coordinates
                .iter()
                .map(|c| {
                    let (i, j) = (e.markers[c.measure.first], e.markers[c.measure.second]);
                    c.measure.kind.evaluate(&ws.markers[i], &ws.markers[j]).rate
                })
                .sum();
            // The recorder takes the power of a driver from C_t = -(rate).
            ws.time[e.rows.clone()].fill(-rate);
        }
        if missing <= 1e-8 {
            return Ok(());
        }
        let names: Vec<&str> = system
            .elements
            .iter()
            .filter(|e| e.role == Role::Driver)
            .map(|e| e.name.as_str())
            .collect();
        Err(AnalysisError::Singular {
            time: state.t,
            last: state.t,
            kind: "actuators without a grip",
            detail: format!(
                "{} cannot produce this motion in this pose; choose other joints",
                names.join(", ")
            ),
        })
    }
}

struct Runner<'a> {
    system: &'a System<Planar>,
    ws: Workspace<Planar>,
    weights: Weights,
    watch: Watch,
    trial: Vec<f64>,
    newton: NewtonOptions,
    iterations: usize,
    substeps: usize,
}

impl Kinematics {
    /// With the options of a compiled model.
    pub fn new(options: &Options) -> Self {
        Self {
            instants: options.instants(),
            newton: NewtonOptions::of(options),
        }
    }

    /// Runs the analysis.
    ///
    /// # Errors
    /// The machine cannot be assembled, or is not driven in every freedom. A singular pose on the
    /// way ends the run with what was computed before it (`stopped`).
    pub fn run(&self, system: &System<Planar>) -> Result<KinematicsRun, AnalysisError> {
        self.run_with(system, None)
    }

    /// The same motion, with the forces of a machine whose drivers are replaced by actuators.
    pub(super) fn run_actuated(
        &self,
        system: &System<Planar>,
        actuated: &System<Planar>,
    ) -> Result<KinematicsRun, AnalysisError> {
        self.run_with(system, Some(actuated))
    }

    fn run_with(
        &self,
        system: &System<Planar>,
        actuated: Option<&System<Planar>>,
    ) -> Result<KinematicsRun, AnalysisError> {
        let (mut state, assembly) = Assembly {
            newton: self.newton,
        }
        .run(system)?;
        let mut notes: Vec<String> = super::missing_mass::note(system).into_iter().collect();
        let running = system.running();
        let mut runner = Runner::new(&running, self.newton);
        runner.start(&mut state)?;
        let mut recorder = Recorder::new(true);
        let mut forces = actuated.map(Actuated::new);
        let mut least = LeastReactions::new(actuated.unwrap_or(&running));
        let mut open = OpenReactions::default();
        let meeting = Meeting::new(&running);
        let mut stopped = None;
        for (k, &t) in self.instants.iter().enumerate() {
            let from = state.t;
            let reached = if k > 0 {
                runner.advance(&mut state, t)
            } else {
                Ok(())
            };
            if let Err(error) = reached {
                // The way to a meeting ends one shortest interval before it.
                let horizon = 2e-3 * (t - from);
                let met = meeting.ahead(&running, &mut runner.ws, &state, horizon);
                let other = || contradiction(&running, &state, t);
                stopped = Some(met.or_else(other).unwrap_or(error));
                break;
            }
            if let Err(error) = meeting.check(&running, &runner.ws, t) {
                stopped = Some(error);
                break;
            }
            if let Some(forces) = &mut forces {
                if let Err(error) = forces.solve(&state, &runner.ws.a) {
                    stopped = Some(error);
                    break;
                }
                least.settle(forces.system, &mut forces.ws);
                open.pose(&least.not_unique(forces.system), || at_time(t));
                recorder.record(forces.system, &forces.ws, &state, Extra::default());
            } else {
                runner.forces(&state);
                least.settle(&running, &mut runner.ws);
                open.pose(&least.not_unique(&running), || at_time(t));
                recorder.record(&running, &runner.ws, &state, Extra::default());
            }
        }
        let (iterations, substeps) = (runner.iterations, runner.substeps);
        let mut results = recorder.into_results(&system.name, "kinematics");
        notes.extend(open.notes());
        if running.nv() > DENSE {
            notes.push(format!(
                "warning: not checked for singular poses between the instants: the machine has more than {DENSE} coordinates"
            ));
        }
        results.notes = notes;
        let instants = results.len();
        results
            .statistics
            .insert("instants".to_owned(), instants as f64);
        results
            .statistics
            .insert("newton iterations".to_owned(), iterations as f64);
        results
            .statistics
            .insert("substeps".to_owned(), substeps as f64);
        Ok(KinematicsRun {
            results,
            assembly,
            stopped,
        })
    }
}

impl<'a> Runner<'a> {
    fn new(system: &'a System<Planar>, newton: NewtonOptions) -> Self {
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
    fn start(&mut self, state: &mut State) -> Result<(), AnalysisError> {
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

    /// From one instant to the next: predictor, Newton, velocities, accelerations; the interval is
    /// halved where Newton does not converge.
    fn advance(&mut self, state: &mut State, t: f64) -> Result<(), AnalysisError> {
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
    fn longest(&self, state: &State) -> f64 {
        if self.watch.rows.is_empty() {
            return f64::INFINITY;
        }
        let fastest = (0..self.system.bodies.len())
            .map(|b| {
                let v = &state.v[3 * b..3 * b + 3];
                (v[0].hypot(v[1]) / self.system.size).max(2.0 * v[2].abs())
            })
            .fold(0.0, f64::max);
        if fastest > 0.0 {
            0.5 / fastest
        } else {
            f64::INFINITY
        }
    }

    /// Did Newton stay on the branch? The correction must be small beside the predicted motion.
    fn near(&self, from: &State, to: &State) -> bool {
        // A turn of more than a radian or a move of more than the machine's size in one substep
        // that the velocities did not announce is a jump.
        let h = to.t - from.t;
        (0..self.system.bodies.len()).all(|b| {
            (0..3).all(|k| {
                let i = 3 * b + k;
                let expected = from.v[i] * h;
                let scale = if k < 2 { self.system.size } else { 1.0 };
                (to.q[i] - from.q[i] - expected).abs() <= 0.5 * scale + expected.abs()
            })
        })
    }

    /// q + h v + h^2/2 a (Shabana 3.138).
    fn predict(&self, state: &State, h: f64) -> State {
        let mut next = state.clone();
        next.t += h;
        for ((q, v), a) in next.q.iter_mut().zip(&state.v).zip(&self.ws.a) {
            *q += h * v + 0.5 * h * h * a;
        }
        next
    }

    /// Velocities and accelerations with one factorization; the workspace then holds C_q, C_t, Q_d
    /// and the accelerations.
    fn motion(&mut self, state: &mut State) {
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
    fn forces(&mut self, state: &State) {
        let (system, ws) = (self.system, &mut self.ws);
        system.evaluate_forces(state.t, ws);
        solve_multipliers(system, ws, &self.weights);
    }

    fn singular(&self, time: f64, last: f64) -> AnalysisError {
        let drivers: Vec<String> = self
            .system
            .elements
            .iter()
            .filter(|e| e.role == Role::Driver)
            .map(|e| e.name.clone())
            .collect();
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

/// Solves C_q^T lambda = Q_e - M a in the metric of the weights, with the last factors, for the
/// accelerations in the workspace; keeps them. Returns the part of the forces that the rows cannot
/// carry, relative to all of them.
pub(super) fn solve_multipliers(
    system: &System<Planar>,
    ws: &mut Workspace<Planar>,
    weights: &Weights,
) -> f64 {
    // [W C_q^T; C_q 0] [x; lambda] = [Q_e - M a; 0]: with C_q of full column rank x = 0.
    let a = ws.a.clone();
    let mut f = ws.force.clone();
    let mut inertia = vec![0.0; system.body_nv()];
    system.mass_mul(&a, &mut inertia);
    for (f, i) in f.iter_mut().zip(&inertia) {
        *f -= i;
    }
    ws.rhs.fill(0.0);
    ws.solve(&weights.blocks, &f);
    ws.a.copy_from_slice(&a);
    let mut left = f.clone();
    system.jac_transpose_add(ws, -1.0, &ws.lambda, &mut left);
    let scale = |x: &[f64]| -> f64 {
        let force = (0..system.bodies.len())
            .map(|b| (x[3 * b].abs() + x[3 * b + 1].abs()) * system.size + x[3 * b + 2].abs());
        force.fold(0.0, f64::max)
    };
    let all = scale(&f);
    if all > 0.0 { scale(&left) / all } else { 0.0 }
}
