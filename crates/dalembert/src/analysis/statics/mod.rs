//! Static equilibrium: poses at which all forces balance while the drivers stand still
//! (Shabana 6.14).

mod diagnosis;
mod family;
mod holding;
mod motions;
mod multipliers;
mod problem;
mod record;
mod reduced;
mod report;
mod search;
mod singular;
mod solution;
#[cfg(test)]
mod spatial_test;
mod stability;

pub use holding::{HoldingLoad, HoldingLoads, Unknown, holding_loads};
pub use report::{Equilibrium, StaticsReport};
pub use stability::Stability;

use super::newton::NewtonOptions;
use super::recorder::Recording;
use super::sides::{facing, fitting};
use super::{AnalysisError, Assembly};
use crate::results::Results;
use crate::space::Space;
use crate::system::System;
use family::connected;
use motions::Motions;
use nalgebra::DVector;
use problem::Problem;
use record::record;
use search::{Numbers, distance, target, wander};
use solution::{Goal, Solution};
use stability::judge;

/// How the equations of equilibrium are solved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Route {
    /// In the free motions: B^T Q_e = 0, C = 0 (Shabana 6.176).
    #[default]
    Reduced,
    /// In positions and multipliers: C_q^T lambda = Q_e, C = 0 (Shabana 6.171, 6.179).
    Multipliers,
}

/// Static equilibrium near the estimate, and others.
///
/// Works with dense matrices: made for machines of up to some hundred bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Statics {
    /// How the equations are solved.
    pub route: Route,
    /// Unbalanced force, relative to the largest force, that counts as zero.
    pub tolerance: f64,
    /// Most Newton iterations from one start.
    pub max_iterations: usize,
    /// Further poses, spread over the free motions, from which equilibria are looked for; none given:
    /// 24, and fewer for machines with more than 50 freedoms.
    pub starts: Option<usize>,
    /// Seed of these poses: the same seed finds the same equilibria.
    pub seed: u64,
    /// Newton's options for the constraints.
    pub newton: NewtonOptions,
    /// What is written.
    pub recording: Recording,
}

impl Default for Statics {
    fn default() -> Self {
        Self {
            route: Route::default(),
            tolerance: 1e-10,
            max_iterations: 200,
            starts: None,
            seed: 1,
            newton: NewtonOptions::default(),
            recording: Recording::default(),
        }
    }
}

/// Poses closer than this are one equilibrium.
const SAME: f64 = 1e-6;
/// Unbalanced force, relative to the largest, at which the second route takes over from the walk
/// downhill.
const NEAR: f64 = 1e-2;
/// Freedoms up to which unstable equilibria are looked for without being asked.
const MANY: usize = 50;
/// Most equilibria that are kept.
const MOST: usize = 64;

/// Equilibria found so far.
struct Found {
    equilibria: Vec<Equilibrium>,
    /// Elastic energies, to tell poses apart that differ by whole turns.
    stored: Vec<f64>,
    /// Numbers of neutral motions.
    neutral: Vec<usize>,
    /// The largest force that any run met.
    scale: f64,
    /// Ways down from unstable equilibria that have not been tried.
    exits: Vec<(Vec<f64>, DVector<f64>)>,
    /// How many more of them are tried.
    budget: usize,
}

impl Statics {
    /// Looks for equilibria of a system (with the rows of all phases).
    ///
    /// # Errors
    /// The machine cannot be assembled, or no equilibrium was found.
    pub fn run<S: Space>(&self, system: &System<S>) -> Result<StaticsReport, AnalysisError> {
        let running = system.running();
        let mut problem = Problem::new(&running, self.newton);
        let mut report = self.search(system, &mut problem)?;
        let results = record(&mut problem, &report.equilibria, self.recording)?;
        let notes = std::mem::replace(&mut report.results, results).notes;
        report.results.notes.extend(notes);
        Ok(report)
    }

    /// The equilibria of a system, whose running part is that of the problem; of the results only the notes.
    fn search<S: Space>(
        &self,
        system: &System<S>,
        problem: &mut Problem<'_, S>,
    ) -> Result<StaticsReport, AnalysisError> {
        let estimate = self.assemble(system, problem)?;
        problem.evaluate(&estimate)?;
        let freedoms = Motions::new(problem)?.basis.ncols();
        // Machines with many freedoms have more unstable equilibria than anyone wants to read, and
        // each run takes the cube of the freedoms.
        let all = self.starts.is_some() || freedoms <= MANY;
        let wanted = self.starts.unwrap_or(if all { 24 } else { 3 });
        let mut found = Found {
            equilibria: Vec::new(),
            stored: Vec::new(),
            neutral: Vec::new(),
            scale: 0.0,
            exits: Vec::new(),
            budget: if all { wanted.max(4) } else { 0 },
        };
        // From the estimate itself errors count; from other poses they only mean that there is
        // nothing to be found that way.
        let first = self.solve(problem, &estimate, Goal::Rest)?;
        self.keep(problem, &mut found, &estimate, &first)?;
        if let Ok(any) = self.solve(problem, &estimate, Goal::Any) {
            self.keep(problem, &mut found, &estimate, &any)?;
        }
        let mut starts = 1;
        let mut numbers = Numbers(self.seed);
        let further = if freedoms == 0 { 0 } else { wanted };
        for number in 0..further {
            let wanted = target(problem, number, &mut numbers);
            let Ok(from) = wander(problem, &estimate, &wanted) else {
                continue;
            };
            starts += 1;
            let goals: &[Goal] = if all {
                &[Goal::Rest, Goal::Any]
            } else {
                &[Goal::Rest]
            };
            self.try_from(problem, &mut found, &estimate, &from, goals)?;
            self.leave_unstable(problem, &mut found, &estimate)?;
        }
        self.leave_unstable(problem, &mut found, &estimate)?;
        if found.equilibria.is_empty() {
            return Err(diagnosis::none(problem, &first, starts));
        }
        let mut equilibria = found.equilibria;
        sort(&mut equilibria);
        let mut results = Results::default();
        if !all {
            results.notes.push(format!(
                "the machine has {freedoms} freedoms: further poses at which it comes to rest were looked for from {further} poses only, unstable ones not at all; set the number of starts to look for more"
            ));
        }
        Ok(StaticsReport {
            time: problem.time(),
            velocities: problem.system.nv(),
            equilibria,
            freedoms,
            starts,
            results,
        })
    }

    /// The estimate on the constraints; initial conditions hold at the start where they can.
    fn assemble<S: Space>(
        &self,
        system: &System<S>,
        problem: &mut Problem<'_, S>,
    ) -> Result<Vec<f64>, AnalysisError> {
        let assembly = Assembly {
            newton: self.newton,
        };
        let mut q = match assembly.run(system) {
            Ok((state, _)) => state.q,
            Err(_) => system.estimate.q.clone(),
        };
        problem.assemble(&mut q)?;
        Ok(q)
    }

    fn solve<S: Space>(
        &self,
        problem: &mut Problem<'_, S>,
        from: &[f64],
        goal: Goal,
    ) -> Result<Solution, AnalysisError> {
        match self.route {
            Route::Reduced => {
                reduced::solve(problem, from, goal, self.tolerance, self.max_iterations)
            }
            Route::Multipliers => {
                // Newton's method on the whole system knows no downhill: it takes over near the end.
                let (near, way) = match goal {
                    Goal::Rest => {
                        let near = reduced::solve(problem, from, goal, NEAR, self.max_iterations)?;
                        (near.q, near.way)
                    }
                    Goal::Any => (from.to_vec(), DVector::zeros(problem.unit.len())),
                };
                let found =
                    multipliers::solve(problem, &near, self.tolerance, self.max_iterations)?;
                Ok(Solution {
                    way: way + &found.way,
                    ..found
                })
            }
        }
    }

    fn try_from<S: Space>(
        &self,
        problem: &mut Problem<'_, S>,
        found: &mut Found,
        estimate: &[f64],
        from: &[f64],
        goals: &[Goal],
    ) -> Result<(), AnalysisError> {
        for goal in goals {
            if let Ok(solution) = self.solve(problem, from, *goal) {
                self.keep(problem, found, estimate, &solution)?;
            }
        }
        Ok(())
    }

    /// Follows the ways down from unstable equilibria: a stable one may lie at their end.
    fn leave_unstable<S: Space>(
        &self,
        problem: &mut Problem<'_, S>,
        found: &mut Found,
        estimate: &[f64],
    ) -> Result<(), AnalysisError> {
        while found.budget > 0
            && let Some((q, way)) = found.exits.pop()
        {
            found.budget -= 1;
            if let Ok(from) = wander(problem, &q, &way) {
                let goals = [Goal::Rest, Goal::Any];
                self.try_from(problem, found, estimate, &from, &goals)?;
            }
        }
        Ok(())
    }

    fn keep<S: Space>(
        &self,
        problem: &mut Problem<'_, S>,
        found: &mut Found,
        estimate: &[f64],
        solution: &Solution,
    ) -> Result<(), AnalysisError> {
        if !solution.converged || found.equilibria.len() >= MOST {
            return Ok(());
        }
        // Where the search for a sharper pose fails, the pose is as good as it gets.
        let sharper = singular::beside(problem, solution, self.tolerance).unwrap_or(None);
        let solution = sharper.as_ref().unwrap_or(solution);
        let verdict = judge(problem, solution)?;
        problem.evaluate(&solution.q)?;
        // Surfaces that touch from the wrong side, at a pole, or run into each other are no pose of the machine.
        let (system, ws, t) = (problem.system, &problem.ws, problem.time());
        if facing(system, ws, t).is_err() || fitting(system, ws, t).is_err() {
            return Ok(());
        }
        let multipliers = problem.least_multipliers(&solution.lambda);
        let (stored, potential) = (problem.stored(), problem.potential());
        found.scale = found.scale.max(solution.scale);
        let scale = found.scale;
        let same = |x: f64, y: f64| (x - y).abs() <= 1e-8 * (scale + x.abs());
        // Where no force acts the stiffness says which energies are those of rounding.
        let stiffest = verdict
            .eigenvalues
            .iter()
            .fold(0.0, |m: f64, x| m.max(x.abs()));
        let alike = 1e-8 * (scale + potential.abs() + stiffest);
        let rounding = self.tolerance * (scale + stiffest);
        let settle = |problem: &mut Problem<'_, S>, q: &[f64]| {
            let settled =
                reduced::solve(problem, q, Goal::Any, self.tolerance, self.max_iterations)?;
            // A force that is nothing but rounding has no scale of its own to be small against.
            Ok(Solution {
                converged: settled.converged || settled.unbalanced.norm() <= rounding,
                ..settled
            })
        };
        // Rolling bodies stand on a slope as well as higher up on it.
        let rolling = !problem.system.velocity_rows().is_empty();
        let mut known = false;
        for (k, e) in found.equilibria.iter().enumerate() {
            // Along a neutral motion every pose is an equilibrium, of the same energy: one of them
            // stands for all.
            known = if rolling || verdict.neutral.max(found.neutral[k]) > 0 {
                (rolling || (e.potential - potential).abs() <= alike)
                    && (connected(problem, &e.q, &solution.q, &settle)
                        || connected(problem, &solution.q, &e.q, &settle))
            } else {
                distance(problem, &e.q, &solution.q) < SAME && same(found.stored[k], stored)
            };
            if known {
                break;
            }
        }
        if known {
            return Ok(());
        }
        // Along the motion that is pushed away hardest, to either side, by a third of a radian (or of
        // the size).
        if let Some(way) = &verdict.away {
            let push = way * (0.3 / way.amax());
            found.exits.push((solution.q.clone(), -&push));
            found.exits.push((solution.q.clone(), push));
        }
        found.stored.push(stored);
        found.neutral.push(verdict.neutral);
        found.equilibria.push(Equilibrium {
            q: solution.q.clone(),
            multipliers,
            stability: verdict.stability,
            stiffness: verdict.eigenvalues,
            conservative: verdict.symmetric,
            motions: verdict.motions,
            potential,
            distance: distance(problem, estimate, &solution.q),
            iterations: solution.iterations,
            residual: solution.residual,
        });
        Ok(())
    }
}

/// The estimate itself first where it is in equilibrium; then stable, neutral and unstable
/// equilibria, each by distance from the estimate.
fn sort(equilibria: &mut [Equilibrium]) {
    let class = |e: &Equilibrium| match e.stability {
        _ if e.distance < SAME => 0,
        Stability::Stable => 1,
        Stability::Neutral => 2,
        Stability::Unstable => 3,
    };
    equilibria.sort_by(|a, b| {
        class(a)
            .cmp(&class(b))
            .then(a.distance.total_cmp(&b.distance))
    });
}
