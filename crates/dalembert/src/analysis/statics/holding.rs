//! Loads that hold a machine at a given pose (Shabana 5.6).

use super::diagnosis::largest;
use super::motions::Motions;
use super::problem::Problem;
use crate::analysis::recorder::{Extra, Recorder};
use crate::analysis::{AnalysisError, NewtonOptions};
use crate::joint::{Measure, MeasureKind};
use crate::results::Results;
use crate::solve::rank::Svd;
use crate::space::{Space, Tuple, norm};
use crate::system::{ElementData, Role, State, System};
use crate::words::listed;
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

/// A load whose size is wanted.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", tag = "kind", content = "name")]
pub enum Unknown {
    /// Moment or force of an actuator in the named joint, positive where it increases the joint's
    /// coordinate; or of the named driver, which then stops holding the machine.
    Effort(String),
    /// Size of the named force element; its direction is that of the element at the pose, its own
    /// value is left out.
    Force(String),
}

impl Unknown {
    /// Name of the joint, driver or force element.
    pub fn name(&self) -> &str {
        match self {
            Self::Effort(name) | Self::Force(name) => name,
        }
    }
}

/// One load that was found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct HoldingLoad {
    /// What was asked.
    pub unknown: Unknown,
    /// Its size: the least one where it is not unique.
    pub value: f64,
    /// "N" or "N m".
    pub unit: String,
    /// Is it the only size that holds the machine?
    pub unique: bool,
}

/// Loads that hold a machine at a pose.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct HoldingLoads {
    /// The loads, in the order of the unknowns.
    pub loads: Vec<HoldingLoad>,
    /// Multipliers of the rows that always hold; those of drivers among the unknowns are their loads.
    pub multipliers: Vec<f64>,
    /// Drivers that hold what an unknown load is to hold: they were left out.
    #[serde(default)]
    pub released: Vec<String>,
    /// Coordinates and reactions under these loads.
    pub results: Results,
}

/// An unknown's scaled generalized force for the size one.
struct Direction {
    force: DVector<f64>,
    unit: &'static str,
    /// Row of the driver that it replaces.
    row: Option<usize>,
}

/// Finds the sizes of the unknown loads that hold a machine at rest at a pose:
/// B^T (Q_e + sum of unknown * g) = 0, then the multipliers from C_q^T lambda = Q_e + sum.
///
/// The pose is moved onto the constraints first. Drivers that are not among the unknowns hold as
/// constraints, but for one that alone holds what an unknown load is to hold: it is left out.
///
/// # Errors
/// An unknown does not exist, the pose cannot be assembled, several drivers hold what an unknown
/// load is to hold, or no sizes of these loads hold the pose.
pub fn holding_loads<S: Space>(
    system: &System<S>,
    state: &State,
    unknowns: &[Unknown],
) -> Result<HoldingLoads, AnalysisError> {
    let running = system.running();
    let mut problem = Problem::new(&running, NewtonOptions::default());
    problem.set_time(state.t);
    let mut q = state.q.clone();
    problem.assemble(&mut q)?;
    problem.evaluate(&q)?;
    let mut found = loads_at(&problem, unknowns)?;
    let results = record(&mut problem, &q, &found.multipliers, unknowns);
    let notes = std::mem::replace(&mut found.results, results).notes;
    found.results.notes.extend(notes);
    Ok(found)
}

/// The loads at the evaluated pose of a problem; of the results only the notes.
pub(super) fn loads_at<S: Space>(
    problem: &Problem<'_, S>,
    unknowns: &[Unknown],
) -> Result<HoldingLoads, AnalysisError> {
    let running = problem.system;
    let scale = problem.force_scale();
    let directions = unknowns
        .iter()
        .map(|u| direction(problem, u))
        .collect::<Result<Vec<_>, _>>()?;

    // What remains when the unknown elements are taken away.
    let mut known = problem.forces();
    for u in unknowns {
        if let Unknown::Force(name) = u
            && let Some(f) = running.forces.iter().find(|f| f.name == *name)
        {
            known -= problem.generalized(&problem.wrenches(f));
        }
    }
    let full = problem.jacobian();
    let mut held = full.clone();
    for row in directions.iter().filter_map(|d| d.row) {
        held.row_mut(row).fill(0.0);
    }
    let released = release(problem, &mut held, &directions, unknowns, &known)?;
    let motions = Motions::of(problem, &held)?;
    let basis = &motions.basis;
    let loads = solve(problem, basis, &directions, &known)?;

    let mut total = known;
    for (d, (value, _)) in directions.iter().zip(&loads) {
        total.axpy(*value, &d.force, 1.0);
    }
    let rest = basis * (basis.transpose() * &total);
    if rest.amax() > 1e-9 * scale.max(total.amax()) {
        let (coordinate, residual) = largest(problem, &rest);
        return Err(AnalysisError::NoEquilibrium {
            coordinate,
            residual,
            reason: "no sizes of the unknown loads hold this pose; name more unknowns, or another direction"
                .to_owned(),
        });
    }
    let mut multipliers: Vec<f64> = motions
        .multipliers(&total)
        .iter()
        .zip(problem.row_unit.iter())
        .map(|(l, u)| l / u)
        .collect();
    for (d, (value, _)) in directions.iter().zip(&loads) {
        if let Some(row) = d.row {
            // The driver pushes its quantity with -lambda.
            multipliers[row] = -value;
        }
    }
    for &e in &released {
        let rows = running.elements[e].rows.clone();
        multipliers[rows].fill(0.0);
    }
    let released: Vec<String> = released
        .iter()
        .map(|&e| running.elements[e].name.clone())
        .collect();
    let mut results = Results::default();
    results.notes.extend(released.iter().map(|name| {
        format!("driver {name} holds the machine as well: it was left out, so that the loads asked for hold instead of it")
    }));
    Ok(HoldingLoads {
        loads: unknowns
            .iter()
            .zip(directions.iter().zip(loads))
            .map(|(u, (d, (value, unique)))| HoldingLoad {
                unknown: u.clone(),
                value,
                unit: d.unit.to_owned(),
                unique,
            })
            .collect(),
        multipliers,
        released,
        results,
    })
}

/// Clears the rows of drivers that leave an unknown load nothing to hold; returns their elements.
fn release<S: Space>(
    problem: &Problem<'_, S>,
    held: &mut DMatrix<f64>,
    directions: &[Direction],
    unknowns: &[Unknown],
    known: &DVector<f64>,
) -> Result<Vec<usize>, AnalysisError> {
    let mut released = Vec::new();
    let unique = |held: &DMatrix<f64>| -> Result<Vec<bool>, AnalysisError> {
        let motions = Motions::of(problem, held)?;
        let loads = solve(problem, &motions.basis, directions, known)?;
        Ok(loads.into_iter().map(|(_, unique)| unique).collect())
    };
    for (j, unknown) in unknowns.iter().enumerate() {
        let before = unique(held)?;
        if before[j] {
            continue;
        }
        let mut freeing = Vec::new();
        for (e, element) in problem.system.elements.iter().enumerate() {
            let asked = |d: &Direction| d.row.is_some_and(|row| element.rows.contains(&row));
            if element.role != Role::Driver || released.contains(&e) || directions.iter().any(asked)
            {
                continue;
            }
            let without = without_rows(held, element);
            let after = unique(&without)?;
            // A driver whose place this load takes costs no other load its size.
            if after[j] && before.iter().zip(&after).all(|(old, new)| *new || !old) {
                freeing.push(e);
            }
        }
        match freeing.as_slice() {
            [] => {}
            [only] => {
                *held = without_rows(held, &problem.system.elements[*only]);
                released.push(*only);
            }
            several => {
                let names: Vec<String> = several
                    .iter()
                    .map(|&e| problem.system.elements[e].name.clone())
                    .collect();
                return Err(AnalysisError::BadName {
                    what: match unknown {
                        Unknown::Effort(_) => "joint or driver",
                        Unknown::Force(_) => "force",
                    },
                    name: unknown.name().to_owned(),
                    detail: format!(
                        "the drivers {} hold the machine already, and this load could take the place of each; ask for the load of one of these drivers instead, or leave one of them out of the model",
                        listed(&names)
                    ),
                });
            }
        }
    }
    Ok(released)
}

fn without_rows<S: Space>(held: &DMatrix<f64>, element: &ElementData<S>) -> DMatrix<f64> {
    let mut rest = held.clone();
    for row in element.rows.clone() {
        rest.row_mut(row).fill(0.0);
    }
    rest
}

/// Sizes of the loads by least squares in the free motions, and whether each is unique.
fn solve<S: Space>(
    problem: &Problem<'_, S>,
    basis: &DMatrix<f64>,
    directions: &[Direction],
    known: &DVector<f64>,
) -> Result<Vec<(f64, bool)>, AnalysisError> {
    let k = directions.len();
    let mut g = DMatrix::zeros(basis.ncols(), k);
    // Columns of one unit of generalized force: a load without arm shows as zero then.
    let size: Vec<f64> = directions.iter().map(|d| d.force.norm()).collect();
    for (j, d) in directions.iter().enumerate() {
        g.set_column(j, &(basis.transpose() * &d.force / size[j]));
    }
    let svd = Svd::new(&g).map_err(|e| problem.rank_error(e))?;
    // Against one, not against the largest: where all loads lack an arm the rank is zero.
    let rank = svd.values.iter().filter(|s| **s > 1e-9).count();
    let mut part = svd.u.columns(0, rank).transpose() * -(basis.transpose() * known);
    for (x, s) in part.iter_mut().zip(&svd.values) {
        *x /= s;
    }
    let y = svd.v.columns(0, rank) * part;
    Ok((0..k)
        .map(|j| {
            let unique = (rank..k).all(|c| svd.v[(j, c)].abs() < 1e-7);
            (y[j] / size[j], unique)
        })
        .collect())
}

fn direction<S: Space>(
    problem: &Problem<'_, S>,
    unknown: &Unknown,
) -> Result<Direction, AnalysisError> {
    match unknown {
        Unknown::Effort(name) => effort(problem, name),
        Unknown::Force(name) => force(problem, name),
    }
}

fn effort<S: Space>(problem: &Problem<'_, S>, name: &str) -> Result<Direction, AnalysisError> {
    let bad = |detail: &str| AnalysisError::BadName {
        what: "joint or driver",
        name: name.to_owned(),
        detail: detail.to_owned(),
    };
    let element = problem
        .system
        .element(name)
        .ok_or_else(|| bad("there is none of this name"))?;
    let [coordinate] = element.coordinates.as_slice() else {
        return Err(bad(
            "it does not have exactly one coordinate that an effort could act along",
        ));
    };
    let is_driver = element.role == Role::Driver;
    if is_driver && element.rows.len() != 1 {
        return Err(bad("it drives more than one quantity"));
    }
    let force = along(problem, element, coordinate.measure);
    if force.norm() == 0.0 {
        return Err(bad("an effort in it moves no body"));
    }
    Ok(Direction {
        force,
        unit: if coordinate.measure.kind.is_angle() {
            "N m"
        } else {
            "N"
        },
        row: is_driver.then_some(element.rows.start),
    })
}

/// Generalized force of a unit effort along a measure of an element: its gradient.
fn along<S: Space>(
    problem: &Problem<'_, S>,
    element: &ElementData<S>,
    measure: Measure<S>,
) -> DVector<f64> {
    let (first, second) = (
        element.markers[measure.first],
        element.markers[measure.second],
    );
    let m = measure
        .kind
        .evaluate(&problem.ws.markers[first], &problem.ws.markers[second]);
    problem.generalized(&[(first, m.first), (second, m.second)])
}

fn force<S: Space>(problem: &Problem<'_, S>, name: &str) -> Result<Direction, AnalysisError> {
    let bad = |detail: &str| AnalysisError::BadName {
        what: "force",
        name: name.to_owned(),
        detail: detail.to_owned(),
    };
    let element = problem
        .system
        .forces
        .iter()
        .find(|f| f.name == name)
        .ok_or_else(|| bad("there is no force element of this name"))?;
    let wrenches = problem.wrenches(element);
    let parts = || {
        wrenches
            .iter()
            .map(|(_, w)| w.as_slice().split_at(S::LINEAR))
    };
    let linear = parts().map(|(force, _)| norm(force)).fold(0.0, f64::max);
    let (magnitude, unit) = if linear > 0.0 {
        (linear, "N")
    } else {
        (
            parts().map(|(_, moment)| norm(moment)).fold(0.0, f64::max),
            "N m",
        )
    };
    let unit_force = problem.generalized(&wrenches) / magnitude;
    if magnitude == 0.0 || unit_force.norm() == 0.0 {
        return Err(bad(
            "it exerts nothing at this pose, so its direction is unknown; give it the value 1",
        ));
    }
    Ok(Direction {
        force: unit_force,
        unit,
        row: None,
    })
}

fn record<S: Space>(
    problem: &mut Problem<'_, S>,
    q: &[f64],
    multipliers: &[f64],
    unknowns: &[Unknown],
) -> Results {
    problem.ws.a.fill(0.0);
    problem.ws.lambda.copy_from_slice(multipliers);
    let state = State {
        t: problem.time(),
        q: q.to_vec(),
        v: vec![0.0; problem.system.nv()],
    };
    let mut recorder = Recorder::new(true);
    recorder.record(problem.system, &problem.ws, &state, Extra::default());
    let mut results = recorder.into_results(&problem.system.name, "holding-loads");
    // The recorder knows the model's values of the unknown elements, not the found ones.
    for u in unknowns {
        if let Unknown::Force(name) = u {
            let prefix = format!("{name}.");
            results.channels.retain(|c| !c.name.starts_with(&prefix));
        }
    }
    results
}
