//! Machines with bodies that lack mass or inertia, or have next to none.

use super::AnalysisError;
use crate::formulation::{FormulationError, column_scale, general};
use crate::space::Space;
use crate::system::{Metric, System, Workspace};
use crate::words::listed;

/// Accelerations beyond this, where what was lent would give a few units, belong to masses of rounding size.
const WITHOUT_END: f64 = 1e10;

/// Makes sure that no motion lacks both mass and constraint; the Jacobian of the workspace is that of the start.
///
/// A force that only the bodies without mass feel has a finite answer exactly if the constraints pass it on.
///
/// # Errors
/// A coordinate that neither mass nor constraint holds.
pub(super) fn check<S: Space>(
    system: &System<S>,
    ws: &mut Workspace<S>,
    metric: &mut Metric,
) -> Result<(), AnalysisError> {
    let mut force = vec![0.0; system.nv()];
    for (k, force) in force[..system.body_nv()].iter_mut().enumerate() {
        let at = S::NV * k + k % S::NV;
        if system.mass[at] == 0.0 {
            // No special direction: no two coordinates cancel.
            *force = metric.blocks[at] * (1.0 + k as f64).sin();
        }
    }
    ws.rhs.fill(0.0);
    metric.factor(system, ws);
    if !ws.solve(&system.mass, &force).converged {
        std::mem::swap(&mut ws.force, &mut force);
        let found = dense(system, ws);
        std::mem::swap(&mut ws.force, &mut force);
        found?;
    }
    // What was lent would turn by some radians: mass that is there by rounding only turns without end.
    let scale = column_scale(system);
    let scaled = ws.a.iter().zip(&scale).map(|(a, s)| (a / s).abs());
    let fastest = scaled.enumerate().max_by(|x, y| x.1.total_cmp(&y.1));
    match fastest {
        Some((k, rate)) if rate > WITHOUT_END => Err(AnalysisError::Massless {
            names: system.coordinate_names().swap_remove(k),
        }),
        _ => Ok(()),
    }
}

/// Solves the equations of the workspace as one dense matrix: for poses where refinement fails. Allocates.
///
/// # Errors
/// A coordinate that neither mass nor constraint holds.
pub(super) fn dense<S: Space>(
    system: &System<S>,
    ws: &mut Workspace<S>,
) -> Result<(), AnalysisError> {
    match general(system, ws) {
        Err(FormulationError::Massless { coordinates }) => {
            let names = system.coordinate_names();
            let names: Vec<&str> = coordinates.iter().map(|&k| names[k].as_str()).collect();
            Err(AnalysisError::Massless {
                names: listed(&names),
            })
        }
        // Whatever else it says of the equations, the best answer so far stays in the workspace.
        _ => Ok(()),
    }
}

/// A warning about bodies that were lent inertia during a run.
pub(super) fn note<S: Space>(system: &System<S>, metric: &Metric) -> Option<String> {
    let names: Vec<&str> = metric
        .borrowers()
        .map(|b| system.bodies[b].name.as_str())
        .collect();
    let them = match names.len() {
        0 => return None,
        1 => "it is",
        _ => "they are",
    };
    Some(format!(
        "warning: {} weigh{} next to nothing against the bodies around: {them} solved like bodies without mass, and \
         forces that only such small masses make are lost in rounding",
        listed(&names),
        if names.len() == 1 { "s" } else { "" },
    ))
}
