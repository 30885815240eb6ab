//! Constraints that cannot hold together.

use super::super::AnalysisError;
use super::ranked::evaluated;
use crate::formulation::column_scale;
use crate::space::Planar;
use crate::system::{State, System, Workspace};
use nalgebra::{DMatrix, DVector};
use serde::Serialize;
use std::fmt;

/// A set of elements of which each is needed for the contradiction.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Conflict {
    /// Names of the elements.
    pub elements: Vec<String>,
    /// Their worst row, in words.
    pub worst: String,
    /// Its residual at the best compromise [SI units].
    pub residual: f64,
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
/// At the best compromise in the sense of least squares, J^T C = 0: the residual itself is a left
/// null vector, and the rows where it is not zero contradict each other. An element without
/// which the contradiction remains is then left out.
///
/// # Errors
/// An element gives values that are not finite.
pub fn conflicts(system: &System<Planar>, state: &State) -> Result<Vec<Conflict>, AnalysisError> {
    let full = system.start_positions();
    let best = compromise(&full, state)?;
    let ws = evaluated(&full, &best);
    let (worst, _) = full.violation(&ws);
    if worst <= CONTRADICTION {
        return Ok(Vec::new());
    }
    let involved: Vec<usize> = (0..full.elements.len())
        .filter(|&e| scaled_residual(&full, &ws, e) > 1e-3 * worst)
        .collect();
    let mut list = Vec::new();
    for group in groups(&full, &involved) {
        let kept = if group.len() <= MOST_ELEMENTS && full.nv() <= DENSE_LIMIT {
            reduce(&full, &best, &group)?
        } else {
            group
        };
        let row = kept
            .iter()
            .flat_map(|&e| full.elements[e].rows.clone())
            .max_by(|&a, &b| scaled(&full, &ws, a).total_cmp(&scaled(&full, &ws, b)));
        let Some(row) = row else { continue };
        list.push(Conflict {
            elements: kept
                .iter()
                .map(|&e| full.elements[e].name.clone())
                .collect(),
            worst: full.row_name(row),
            residual: ws.value[row].abs(),
        });
    }
    Ok(list)
}

fn scaled(system: &System<Planar>, ws: &Workspace<Planar>, row: usize) -> f64 {
    ws.value[row].abs() / system.row_scale(row)
}

fn scaled_residual(system: &System<Planar>, ws: &Workspace<Planar>, element: usize) -> f64 {
    let rows = system.elements[element].rows.clone();
    rows.fold(0.0, |m, row| f64::max(m, scaled(system, ws, row)))
}

/// Elements that share bodies, in groups.
fn groups(system: &System<Planar>, elements: &[usize]) -> Vec<Vec<usize>> {
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

/// Leaves out every element of a group without which the group still contradicts itself.
fn reduce(
    system: &System<Planar>,
    state: &State,
    group: &[usize],
) -> Result<Vec<usize>, AnalysisError> {
    let mut kept = group.to_vec();
    for &candidate in group {
        // Elements with coordinates of their own must stay for these to keep their places.
        if !system.elements[candidate].aux.is_empty() {
            continue;
        }
        // First rows tell elements apart.
        let stay: Vec<usize> = kept
            .iter()
            .filter(|&&e| e != candidate)
            .map(|&e| system.elements[e].rows.start)
            .collect();
        let rest = system.with_elements(|e| !e.aux.is_empty() || stay.contains(&e.rows.start));
        let best = compromise(&rest, state)?;
        let (worst, _) = rest.violation(&evaluated(&rest, &best));
        if worst > CONTRADICTION {
            kept.retain(|&e| e != candidate);
        }
    }
    Ok(kept)
}

/// The pose of least squares of the scaled residuals, by Levenberg's and Marquardt's method.
fn compromise(system: &System<Planar>, state: &State) -> Result<State, AnalysisError> {
    let mut best = state.clone();
    if system.nv() > DENSE_LIMIT || system.rows == 0 {
        return Ok(best);
    }
    let columns = column_scale(system);
    let rows: Vec<f64> = (0..system.rows).map(|row| system.row_scale(row)).collect();
    let mut ws = Workspace::new(system);
    let residual = |at: &State, ws: &mut Workspace<Planar>| {
        system.update_markers(&at.q, &at.v, ws);
        system.evaluate_constraints(at.t, ws);
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
            for (k, x) in trial.q.iter_mut().enumerate() {
                *x += columns[k] * step[k];
            }
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
        match &self.elements[..] {
            [only] => write!(f, "{only} cannot be met"),
            names => write!(
                f,
                "{} cannot hold together near this pose",
                crate::words::listed(names)
            ),
        }?;
        write!(
            f,
            " (at the best compromise {} is off by {})",
            self.worst,
            crate::words::readable(self.residual)
        )
    }
}
