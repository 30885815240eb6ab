//! The mobility analysis.

use super::super::AnalysisError;
use super::dependence::Dependence;
use super::free_motion::describe;
use super::massless::massless_motions;
use super::nearby::{bent_rows, nearby_poses};
use super::ranked::Ranked;
use super::report::{MobilityReport, Rank};
use crate::network::{Network, TerminalGraph};
use crate::space::Space;
use crate::system::{Role, State, System};

/// Mobility of a machine at an assembled pose, by rank.
///
/// Lengths count relative to the machine's size, angles as they are. Where rows depend on each
/// other, the ranks are compared with those at nearby poses: a machine whose rank is low
/// everywhere has redundant rows, one whose rank is low only here is at a singular pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mobility {
    /// Singular values up to this part of the largest one count as zero.
    pub tolerance: f64,
    /// Number of nearby poses.
    pub poses: usize,
    /// Distance of the nearby poses: relative to the machine's size, or in radians.
    pub step: f64,
    /// Machines with more coordinates than this are ranked by sparse factors alone: redundant rows
    /// are named, but not what they follow from, nor the free motions.
    pub dense_limit: usize,
}

impl Default for Mobility {
    fn default() -> Self {
        // Poses are assembled to 1e-13, so that repeated rows leave singular values of that size;
        // machines far from singular poses have condition numbers below 1e6.
        Self {
            tolerance: 1e-8,
            poses: 3,
            step: 0.02,
            dense_limit: 800,
        }
    }
}

/// Condition from which on a pose is called nearly singular.
const NEARLY_SINGULAR: f64 = 1e6;

impl Mobility {
    /// Analyses a system (with the rows of all phases) at an assembled state.
    ///
    /// # Errors
    /// An element gives values that are not finite, or no rank decision is possible.
    pub fn run<S: Space>(
        &self,
        system: &System<S>,
        state: &State,
    ) -> Result<MobilityReport, AnalysisError> {
        let (undriven, driven) = (system.undriven(), system.running());
        let rank = |s: &System<S>, at: &State| Ranked::new(s, at, self.tolerance, self.dense_limit);
        let own = rank(&undriven, state)?;
        let with_drivers = if driven.rows > undriven.rows {
            Some(rank(&driven, state)?)
        } else {
            None
        };
        let own_driven = with_drivers.as_ref().unwrap_or(&own);
        let mut report = self.counts(system, &undriven, &driven, [&own, own_driven]);

        if report.velocity_rows > 0 {
            let positions = Ranked::positions(&undriven, state, self.tolerance, self.dense_limit)?;
            report.position_freedoms = Some(system.nv() - positions.rank);
        }

        // Nearby poses tell repeated rows from singular poses.
        let (mut generic, mut generic_driven) = (None, None);
        let deficient = own.rank < undriven.rows || own_driven.rank < driven.rows;
        if let (true, Some(dense)) = (deficient, &own.dense) {
            let poses = nearby_poses(&undriven, state, &dense.null_space, self.poses, self.step);
            for pose in &poses {
                keep_better(&mut generic, rank(&undriven, pose)?, own.rank);
                if with_drivers.is_some() {
                    keep_better(&mut generic_driven, rank(&driven, pose)?, own_driven.rank);
                }
            }
        }
        let generic_rank = generic.as_ref().map_or(own.rank, |r| r.rank);
        let generic_driven = if with_drivers.is_some() {
            generic_driven.as_ref()
        } else {
            generic.as_ref()
        };
        let generic_driven_rank = generic_driven.map_or(own_driven.rank, |r| r.rank);
        let columns = system.nv();
        report.mobility = Rank::new(columns, undriven.rows, own.rank, generic_rank);
        report.driven = Rank::new(columns, driven.rows, own_driven.rank, generic_driven_rank);

        let everywhere = generic.as_ref().unwrap_or(&own);
        // Where no pose nearby has a larger rank, rows that bend apart along the motions lock them.
        let bent = match (&generic, &own.dense) {
            (None, Some(dense)) => bent_rows(&undriven, state, &own.redundant, &dense.null_space),
            _ => Vec::new(),
        };
        report.locked = !bent.is_empty();
        report.redundant = rows_of(&undriven, everywhere, |row| !bent.contains(&row));
        report.singular = rows_of(&undriven, &own, |row| {
            bent.contains(&row) || !is_redundant(everywhere, row)
        });
        let everywhere = generic_driven.unwrap_or(own_driven);
        let is_driver =
            |row: usize| driven.elements[driven.row_refs()[row].element].role == Role::Driver;
        report.over_driven = rows_of(&driven, everywhere, is_driver);
        report.dead_drivers = rows_of(&driven, own_driven, |row| {
            is_driver(row) && !is_redundant(everywhere, row)
        });

        if let (Some(a), Some(b)) = (&own.dense, &own_driven.dense) {
            report.motions = describe(&undriven, &own.ws, &a.null_space);
            if driven.rows > undriven.rows {
                report.motions_left = describe(&driven, &own_driven.ws, &b.null_space);
            }
            report.massless = massless_motions(&driven, &b.null_space)?;
            report.condition = Some(b.condition);
        }
        if let Some(dense) = &everywhere.dense {
            for (row, _) in dense
                .unique
                .iter()
                .enumerate()
                .filter(|(_, unique)| !**unique)
            {
                let name = &driven.elements[driven.row_refs()[row].element].name;
                if !report.reactions_not_unique.contains(name) {
                    report.reactions_not_unique.push(name.clone());
                }
            }
        }
        self.warn(system, &mut report);
        Ok(report)
    }

    fn counts<S: Space>(
        &self,
        system: &System<S>,
        undriven: &System<S>,
        driven: &System<S>,
        ranked: [&Ranked<S>; 2],
    ) -> MobilityReport {
        let columns = system.nv();
        MobilityReport {
            model: system.name.clone(),
            bodies: system.bodies.len(),
            coordinates: system.body_nv(),
            auxiliaries: system.aux,
            mobility: Rank::new(columns, undriven.rows, ranked[0].rank, ranked[0].rank),
            driven: Rank::new(columns, driven.rows, ranked[1].rank, ranked[1].rank),
            position_freedoms: None,
            velocity_rows: undriven.velocity_rows().len(),
            driver_rows: driven.rows - undriven.rows,
            redundant: Vec::new(),
            singular: Vec::new(),
            over_driven: Vec::new(),
            dead_drivers: Vec::new(),
            locked: false,
            motions: Vec::new(),
            motions_left: Vec::new(),
            reactions_not_unique: Vec::new(),
            massless: Vec::new(),
            condition: None,
            warnings: Vec::new(),
        }
    }

    fn warn<S: Space>(&self, system: &System<S>, report: &mut MobilityReport) {
        for part in Network::new(system, TerminalGraph::Arms).parts() {
            if part.unconnected() && system.bodies.len() > part.bodies.len() {
                report.warnings.push(format!(
                    "nothing connects {} with the ground or the rest of the machine",
                    crate::words::listed(&part.bodies)
                ));
            }
        }
        if let Some(condition) = report.condition
            && condition > NEARLY_SINGULAR
        {
            report.warnings.push(format!(
                "the pose is nearly singular, or lengths nearly fulfil a special condition: smallest to largest singular value 1 : {condition:.1e}"
            ));
        }
        if system.nv() > self.dense_limit {
            report.warnings.push(format!(
                "the machine has more than {} coordinates: redundant rows are found by sparse factors, free motions are counted, not described",
                self.dense_limit
            ));
        }
    }
}

/// Keeps the pose with the largest rank, where it is above that of the pose in question or equal to it.
fn keep_better<S: Space>(best: &mut Option<Ranked<S>>, found: Ranked<S>, own: usize) {
    let least = best.as_ref().map_or(own, |b| b.rank + 1);
    // An equal rank tells nothing new: the rows of the user's own pose are named then.
    if found.rank > own && found.rank >= least {
        *best = Some(found);
    }
}

fn is_redundant<S: Space>(ranked: &Ranked<S>, row: usize) -> bool {
    ranked.redundant.iter().any(|(r, _)| *r == row)
}

fn rows_of<S: Space>(
    system: &System<S>,
    ranked: &Ranked<S>,
    keep: impl Fn(usize) -> bool,
) -> Vec<Dependence> {
    ranked
        .redundant
        .iter()
        .filter(|(row, _)| keep(*row))
        .map(|(row, others)| Dependence::new(system, *row, others, ranked.is_zero_row(*row)))
        .collect()
}
