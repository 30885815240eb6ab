//! Motions that no mass and no constraint resists.

use crate::formulation::column_scale;
use crate::solve::{RankError, analyse_rows};
use crate::space::Planar;
use crate::system::System;
use nalgebra::DMatrix;
use serde::Serialize;

/// A motion without kinetic energy that constraints and drivers leave free: its acceleration is
/// not determined.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct MasslessMotion {
    /// Names of the coordinates that move, the largest first.
    pub coordinates: Vec<String>,
    /// Names of the bodies that need mass or inertia.
    pub bodies: Vec<String>,
}

/// Parts of a motion below this are rounding.
const SILENT: f64 = 1e-7;

/// Null vectors of the constraint rows on which M vanishes: combinations y of the free motions N
/// with M N y = 0. `motions` are the free motions of the driven machine.
pub(super) fn massless_motions(
    system: &System<Planar>,
    motions: &DMatrix<f64>,
) -> Result<Vec<MasslessMotion>, RankError> {
    let free = motions.ncols();
    if free == 0 || !system.massless {
        return Ok(Vec::new());
    }
    let scale = column_scale(system);
    let mut scaled = motions.clone();
    for (mut row, s) in scaled.row_iter_mut().zip(&scale) {
        row /= *s;
    }
    // Central planar frames: M is diagonal. A coordinate with mass must not move.
    let heavy: Vec<usize> = (0..system.body_nv())
        .filter(|&k| system.mass[3 * k + k % 3] > 0.0)
        .collect();
    let mut rows = scaled.select_rows(&heavy);
    // Rounding must not be taken for motion when rows are brought to unit norm.
    rows.apply(|x| {
        if x.abs() < SILENT {
            *x = 0.0;
        }
    });
    let found = analyse_rows(&rows, &vec![1.0; free], 1e-9)?;
    let names = system.coordinate_names();
    let mut list = Vec::new();
    for column in found.null_space.column_iter() {
        let motion = &scaled * column;
        let largest = motion.amax();
        let mut parts: Vec<usize> = (0..motion.len())
            .filter(|&k| motion[k].abs() > 1e-6 * largest)
            .collect();
        parts.sort_by(|a, b| motion[*b].abs().total_cmp(&motion[*a].abs()));
        let mut bodies: Vec<String> = Vec::new();
        for &k in parts.iter().filter(|k| **k < system.body_nv()) {
            let name = &system.bodies[k / 3].name;
            if !bodies.contains(name) {
                bodies.push(name.clone());
            }
        }
        list.push(MasslessMotion {
            coordinates: parts.iter().map(|&k| names[k].clone()).collect(),
            bodies,
        });
    }
    Ok(list)
}
