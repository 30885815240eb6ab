//! Motions that no mass and no constraint resists.

use crate::formulation::column_scale;
use crate::solve::{RankError, analyse_rows};
use crate::space::Space;
use crate::system::System;
use nalgebra::{DMatrix, RowDVector};
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

/// Principal moments of inertia below this part of the largest one of a body are rounding.
const NO_INERTIA: f64 = 1e-12;

/// Directions of the velocity coordinates that carry mass, a row each: a motion without kinetic energy has no part along
/// any. A body may lack inertia about an axis that is none of its own (a thin rod), so its tensor is taken to its
/// principal axes.
fn heavy_directions<S: Space>(system: &System<S>) -> DMatrix<f64> {
    let (n, linear) = (S::NV, S::LINEAR);
    let mut rows = Vec::new();
    for b in 0..system.bodies.len() {
        let block = system.mass_block(b);
        let mut put = |k: usize, components: &[f64]| {
            let mut row = RowDVector::zeros(system.nv());
            row.as_mut_slice()[n * b + k..n * b + k + components.len()].copy_from_slice(components);
            rows.push(row);
        };
        for k in (0..linear).filter(|k| block[(n + 1) * k] > 0.0) {
            put(k, &[1.0]);
        }
        let tensor = DMatrix::from_fn(n - linear, n - linear, |i, j| {
            block[n * (linear + i) + linear + j]
        });
        let eigen = tensor.symmetric_eigen();
        let least = NO_INERTIA * eigen.eigenvalues.amax();
        for (moment, axis) in eigen
            .eigenvalues
            .iter()
            .zip(eigen.eigenvectors.column_iter())
        {
            if *moment > least {
                put(linear, axis.into_owned().as_slice());
            }
        }
    }
    if rows.is_empty() {
        return DMatrix::zeros(0, system.nv());
    }
    DMatrix::from_rows(&rows)
}

/// Null vectors of the constraint rows on which M vanishes: combinations y of the free motions N
/// with M N y = 0. `motions` are the free motions of the driven machine.
pub(super) fn massless_motions<S: Space>(
    system: &System<S>,
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
    let mut rows = heavy_directions(system) * &scaled;
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
            let name = &system.bodies[k / S::NV].name;
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
