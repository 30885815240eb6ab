//! The mobility report.

use super::{Dependence, FreeMotion, MasslessMotion};
use serde::Serialize;

/// Count and rank of a set of rows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Rank {
    /// Number of rows.
    pub rows: usize,
    /// Coordinates (with auxiliaries) minus rows: Gruebler's count; negative where rows abound.
    pub count: i64,
    /// Independent rows at this pose.
    pub rank: usize,
    /// Largest rank seen at this and nearby poses.
    pub generic_rank: usize,
    /// Freedoms at this pose: coordinates minus rank.
    pub freedoms: usize,
}

impl Rank {
    pub(super) fn new(coordinates: usize, rows: usize, rank: usize, generic_rank: usize) -> Self {
        Self {
            rows,
            count: coordinates as i64 - rows as i64,
            rank,
            generic_rank,
            freedoms: coordinates - rank,
        }
    }

    /// Is the rank lower here than at nearby poses?
    pub fn is_singular(&self) -> bool {
        self.rank < self.generic_rank
    }
}

/// What a machine can do, and what its constraints repeat.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MobilityReport {
    /// Name of the model.
    pub model: String,
    /// Number of movable bodies.
    pub bodies: usize,
    /// Coordinates of the bodies.
    pub coordinates: usize,
    /// Auxiliary coordinates of contacts.
    pub auxiliaries: usize,
    /// The machine without its drivers: its freedoms are the mobility.
    pub mobility: Rank,
    /// The machine with its drivers: its freedoms are the motions left over.
    pub driven: Rank,
    /// Freedoms in positions, where rows hold for velocities only (nonholonomic): those rows take none. Missing where there
    /// are no such rows: positions and velocities then have the same freedoms.
    pub position_freedoms: Option<usize>,
    /// Rows that hold for velocities only.
    pub velocity_rows: usize,
    /// Rows of drivers.
    pub driver_rows: usize,
    /// Rows of joints and constraints that follow from others at every pose nearby.
    pub redundant: Vec<Dependence>,
    /// Rows of joints and constraints that follow from others only at this pose.
    pub singular: Vec<Dependence>,
    /// Rows of drivers that follow from others at every pose nearby: the machine is driven twice.
    pub over_driven: Vec<Dependence>,
    /// Rows of drivers that lose their hold only at this pose (dead centre).
    pub dead_drivers: Vec<Dependence>,
    /// Do free motions of this pose exist to first order only, so that the machine is locked in
    /// them at a singular pose?
    pub locked: bool,
    /// Free motions without drivers.
    pub motions: Vec<FreeMotion>,
    /// Free motions that the drivers leave.
    pub motions_left: Vec<FreeMotion>,
    /// Names of elements whose reactions are not unique.
    pub reactions_not_unique: Vec<String>,
    /// Motions that no mass and no row resists.
    pub massless: Vec<MasslessMotion>,
    /// Largest over smallest singular value of the rows that count (scaled, with drivers); missing
    /// for large machines.
    pub condition: Option<f64>,
    /// What else is unusual.
    pub warnings: Vec<String>,
}

impl MobilityReport {
    /// Freedoms without drivers: coordinates minus rank.
    pub fn freedoms(&self) -> usize {
        self.mobility.freedoms
    }

    /// Freedoms that the drivers leave.
    pub fn freedoms_left(&self) -> usize {
        self.driven.freedoms
    }

    /// Is the pose singular, with or without drivers?
    pub fn is_singular(&self) -> bool {
        self.mobility.is_singular() || self.driven.is_singular()
    }
}
