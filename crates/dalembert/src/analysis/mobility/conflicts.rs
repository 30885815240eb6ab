//! Constraints that cannot hold together.

use super::super::AnalysisError;
use super::nearby::nearby_poses;
use super::ranked::{Ranked, evaluated};
use crate::formulation::column_scale;
use crate::space::Space;
use crate::system::{Role, State, System, Workspace};
use nalgebra::{DMatrix, DVector};
use serde::Serialize;
use std::fmt;

/// A set of elements of which each is needed for the contradiction.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Conflict {
    /// Names of the elements that contradict each other: drivers and initial conditions where the
    /// joints and constraints alone can be met, else joints and constraints.
    pub elements: Vec<String>,
    /// Names of the joints and constraints that the contradiction passes through.
    pub through: Vec<String>,
    /// Their worst row, in words.
    pub worst: String,
    /// Its residual at the best compromise.
    pub residual: f64,
    /// Its unit: "m", "rad" or none.
    pub unit: &'static str,
}

/// Machines with more coordinates than this are not searched for smallest sets: all elements that
/// keep a residual are named.
const DENSE_LIMIT: usize = 400;
/// Residual (in units of the row scales) above which rows contradict each other.
const CONTRADICTION: f64 = 1e-8;
/// Elements beyond this number are not tried one by one.
const MOST_ELEMENTS: usize = 60;

/// The sets of constraints, drivers and initial conditions that keep a machine from being
/// assembled, near a state: empty where there is no contradiction.
///
/// Where the joints and constraints alone can be met, the smallest sets of drivers and initial
/// conditions that they do not admit are looked for. Else, at the best compromise in the sense of
/// least squares, J^T C = 0: the residual itself is a left null vector, and the rows where it is
/// not zero contradict each other; elements without which the contradiction remains are left out.
///
/// # Errors
/// An element gives values that are not finite.
pub fn conflicts<S: Space>(
    system: &System<S>,
    state: &State,
) -> Result<Vec<Conflict>, AnalysisError> {
    let full = system.start_positions();
    let best = compromise(&full, state)?;
    if !contradicts(&full, &best) {
        return Ok(Vec::new());
    }
    let mut trials = Trials::new(&full, state);
    if full.nv() <= DENSE_LIMIT && full.elements.len() <= MOST_ELEMENTS {
        let askers: Vec<usize> = (0..full.elements.len())
            .filter(|&e| asks(&full, e))
            .collect();
        let found = trials.among(&askers)?;
        if !found.is_empty() {
            return Ok(found);
        }
    }
    let ws = evaluated(&full, &best);
    let (worst, _) = full.violation(&ws);
    let involved: Vec<usize> = (0..full.elements.len())
        .filter(|&e| scaled_residual(&full, &ws, e) > 1e-3 * worst)
        .collect();
    let mut list = Vec::new();
    for group in groups(&full, &involved) {
        let kept = if group.len() <= MOST_ELEMENTS && full.nv() <= DENSE_LIMIT {
            trials.start_from(&best);
            trials.reduce(&group, &[])?
        } else {
            group
        };
        list.extend(Conflict::new(&full, &best, &kept, &[]));
    }
    Ok(list)
}

/// Is an element a driver or an initial condition that can be left out? Elements with coordinates
/// of their own must stay for these to keep their places.
fn asks<S: Space>(system: &System<S>, element: usize) -> bool {
    let e = &system.elements[element];
    matches!(e.role, Role::Driver | Role::Start) && e.aux.is_empty()
}

fn contradicts<S: Space>(system: &System<S>, state: &State) -> bool {
    system.violation(&evaluated(system, state)).0 > CONTRADICTION
}

/// Part of a machine's elements.
fn part<S: Space>(system: &System<S>, stay: &[usize]) -> System<S> {
    // First rows tell elements apart.
    let rows: Vec<usize> = stay
        .iter()
        .map(|&e| system.elements[e].rows.start)
        .collect();
    system.with_elements(|e| !e.aux.is_empty() || rows.contains(&e.rows.start))
}

/// Attempts to assemble parts of a machine, from several poses: the way down from one of them may
/// end at a dead centre.
struct Trials<'a, S: Space> {
    system: &'a System<S>,
    starts: Vec<State>,
}

/// Most poses that are tried from.
const MOST_STARTS: usize = 8;
/// Singular values up to this part of the largest one count as zero.
const RANK: f64 = 1e-8;
/// Distance of further poses, relative to the size or in radians.
const ASIDE: f64 = 0.3;

impl<'a, S: Space> Trials<'a, S> {
    fn new(system: &'a System<S>, state: &State) -> Self {
        Self {
            system,
            starts: vec![state.clone()],
        }
    }

    fn start_from(&mut self, state: &State) {
        if self.starts.len() < MOST_STARTS {
            self.starts.push(state.clone());
        }
    }

    /// A pose that meets these elements, where one is found.
    fn meet(&self, elements: &[usize]) -> Result<Option<State>, AnalysisError> {
        let own = part(self.system, elements);
        for start in &self.starts {
            let pose = compromise(&own, start)?;
            if !contradicts(&own, &pose) {
                return Ok(Some(pose));
            }
        }
        Ok(None)
    }

    /// The smallest sets among drivers and initial conditions that the joints and constraints do not
    /// admit: single ones, then pairs, then one larger set. None where the joints themselves fail.
    fn among(&mut self, askers: &[usize]) -> Result<Vec<Conflict>, AnalysisError> {
        let joints: Vec<usize> = (0..self.system.elements.len())
            .filter(|e| !askers.contains(e))
            .collect();
        let with = |more: &[usize]| [&joints[..], more].concat();
        let Some(pose) = self.meet(&joints)? else {
            return Ok(Vec::new());
        };
        self.start_from(&pose);
        // At a dead centre every way to where a driver wants to go begins level.
        let base = part(self.system, &joints);
        let ranked = Ranked::new(&base, &pose, RANK, DENSE_LIMIT)?;
        if let Some(dense) = &ranked.dense {
            for near in nearby_poses(&base, &pose, &dense.null_space, 2, ASIDE) {
                self.start_from(&near);
            }
        }
        let mut sets: Vec<Vec<usize>> = Vec::new();
        let mut fine = Vec::new();
        for &e in askers {
            match self.meet(&with(&[e]))? {
                Some(pose) => {
                    self.start_from(&pose);
                    fine.push(e);
                }
                None => sets.push(vec![e]),
            }
        }
        for (k, &a) in fine.iter().enumerate() {
            for &b in &fine[k + 1..] {
                if self.meet(&with(&[a, b]))?.is_none() {
                    sets.push(vec![a, b]);
                }
            }
        }
        if sets.is_empty() && self.meet(&with(&fine))?.is_none() {
            let mut kept = fine.clone();
            for &candidate in &fine {
                let rest: Vec<usize> = kept.iter().copied().filter(|&e| e != candidate).collect();
                if self.meet(&with(&rest))?.is_none() {
                    kept = rest;
                }
            }
            sets.push(kept);
        }
        let mut list = Vec::new();
        for set in sets {
            let through: Vec<usize> = self
                .reduce(&with(&set), &set)?
                .into_iter()
                .filter(|e| !set.contains(e))
                .collect();
            let own = part(self.system, &with(&set));
            let mut best: Option<(f64, State)> = None;
            for start in &self.starts {
                let pose = compromise(&own, start)?;
                let (off, _) = own.violation(&evaluated(&own, &pose));
                if best.as_ref().is_none_or(|(least, _)| off < *least) {
                    best = Some((off, pose));
                }
            }
            let Some((_, pose)) = best else { continue };
            list.extend(Conflict::new(self.system, &pose, &set, &through));
        }
        Ok(list)
    }

    /// Leaves out every element of a group without which the group still contradicts itself, but for
    /// those that must stay; in both orders, of which the smaller set counts.
    fn reduce(&self, group: &[usize], stay: &[usize]) -> Result<Vec<usize>, AnalysisError> {
        let forward = self.reduce_along(group.iter().copied(), group, stay)?;
        let backward = self.reduce_along(group.iter().rev().copied(), group, stay)?;
        Ok(if backward.len() < forward.len() {
            backward
        } else {
            forward
        })
    }

    fn reduce_along(
        &self,
        order: impl Iterator<Item = usize>,
        group: &[usize],
        stay: &[usize],
    ) -> Result<Vec<usize>, AnalysisError> {
        let mut kept = group.to_vec();
        for candidate in order {
            if stay.contains(&candidate) || !self.system.elements[candidate].aux.is_empty() {
                continue;
            }
            let rest: Vec<usize> = kept.iter().copied().filter(|&e| e != candidate).collect();
            if self.meet(&rest)?.is_none() {
                kept = rest;
            }
        }
        kept.sort_unstable();
        Ok(kept)
    }
}

impl Conflict {
    /// With the worst row of the elements at the best compromise.
    fn new<S: Space>(
        system: &System<S>,
        best: &State,
        elements: &[usize],
        through: &[usize],
    ) -> Option<Self> {
        let ws = evaluated(system, best);
        let names = |list: &[usize]| {
            list.iter()
                .map(|&e| system.elements[e].name.clone())
                .collect::<Vec<_>>()
        };
        let row = elements
            .iter()
            .flat_map(|&e| system.elements[e].rows.clone())
            .max_by(|&a, &b| scaled(system, &ws, a).total_cmp(&scaled(system, &ws, b)))?;
        Some(Self {
            elements: names(elements),
            through: names(through),
            worst: system.row_name(row),
            residual: ws.value[row].abs(),
            unit: system.row_refs()[row].label.unit.symbol(),
        })
    }
}

fn scaled<S: Space>(system: &System<S>, ws: &Workspace<S>, row: usize) -> f64 {
    ws.value[row].abs() / system.row_scale(row)
}

fn scaled_residual<S: Space>(system: &System<S>, ws: &Workspace<S>, element: usize) -> f64 {
    let rows = system.elements[element].rows.clone();
    rows.fold(0.0, |m, row| f64::max(m, scaled(system, ws, row)))
}

/// Elements that share bodies, in groups.
fn groups<S: Space>(system: &System<S>, elements: &[usize]) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for &e in elements {
        let touches = |group: &Vec<usize>| {
            group.iter().any(|&other| {
                let bodies = &system.elements[other].bodies;
                system.elements[e].bodies.iter().any(|b| bodies.contains(b))
            })
        };
        let (mut joined, rest): (Vec<_>, Vec<_>) = groups.into_iter().partition(touches);
        let mut group: Vec<usize> = joined.drain(..).flatten().collect();
        group.push(e);
        group.sort_unstable();
        groups = rest;
        groups.push(group);
    }
    groups.sort();
    groups
}

/// The pose of least squares of the scaled residuals, by Levenberg's and Marquardt's method.
fn compromise<S: Space>(system: &System<S>, state: &State) -> Result<State, AnalysisError> {
    let mut best = state.clone();
    if system.nv() > DENSE_LIMIT || system.rows == 0 {
        return Ok(best);
    }
    let columns = column_scale(system);
    let rows: Vec<f64> = (0..system.rows).map(|row| system.row_scale(row)).collect();
    let mut ws = Workspace::new(system);
    let residual = |at: &State, ws: &mut Workspace<S>| {
        system.update_markers(&at.q, &at.v, ws);
        system.evaluate_positions(at.t, ws);
        DVector::from_fn(rows.len(), |k, _| ws.value[k] / rows[k])
    };
    let mut c = residual(&best, &mut ws);
    let mut damping = 1e-3;
    for _ in 0..200 {
        if let Some(row) = c.iter().position(|x| !x.is_finite()) {
            return Err(AnalysisError::NotFinite {
                element: system.row_name(row),
                time: state.t,
            });
        }
        let dense = system.dense_jacobian(&ws);
        let jacobian = DMatrix::from_fn(dense.nrows(), dense.ncols(), |i, j| {
            dense[(i, j)] * columns[j] / rows[i]
        });
        let gradient = jacobian.tr_mul(&c);
        if c.amax() <= 1e-13 || gradient.amax() <= 1e-14 * c.amax() {
            break;
        }
        let square = jacobian.tr_mul(&jacobian);
        let mut improved = false;
        while damping < 1e12 {
            let mut left = square.clone();
            for k in 0..left.nrows() {
                left[(k, k)] += damping;
            }
            let Some(factor) = left.cholesky() else {
                damping *= 10.0;
                continue;
            };
            let mut step = factor.solve(&(-&gradient));
            // Far steps mean nothing: the rows are not linear.
            let largest = step.amax();
            if largest > 0.5 {
                step *= 0.5 / largest;
            }
            let mut trial = best.clone();
            for (x, scale) in step.iter_mut().zip(&columns) {
                *x *= scale;
            }
            system.advance(&mut trial.q, 1.0, step.as_slice());
            let found = residual(&trial, &mut ws);
            if found.norm_squared() < c.norm_squared() {
                let gain = c.norm() - found.norm();
                improved = gain > 1e-15 * c.norm();
                best = trial;
                c = found;
                damping = (damping * 0.1).max(1e-12);
                break;
            }
            damping *= 10.0;
        }
        if !improved {
            // The workspace must match the best pose for whoever looks at it next.
            break;
        }
    }
    Ok(best)
}

impl fmt::Display for Conflict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use crate::words::{listed, readable};
        match (&self.elements[..], &self.through[..]) {
            ([only], []) => write!(f, "{only} cannot be met"),
            ([only], through) => {
                write!(
                    f,
                    "{only} cannot be met: {} do not allow it near this pose",
                    listed(through)
                )
            }
            (names, []) => write!(f, "{} cannot hold together near this pose", listed(names)),
            (names, through) => write!(
                f,
                "{} cannot hold together near this pose: they depend on each other through {}",
                listed(names),
                listed(through)
            ),
        }?;
        let space = if self.unit.is_empty() { "" } else { " " };
        write!(
            f,
            " (at the best compromise {} is off by {}{space}{})",
            self.worst,
            readable(self.residual),
            self.unit
        )
    }
}
