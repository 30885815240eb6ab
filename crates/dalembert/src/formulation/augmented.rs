//! The augmented formulation, block-sparse.

use super::{Accelerations, FormulationError, Terms, augmented_dense};
use crate::solve::{RankError, Rhs, SingularKkt, solve_general};
use crate::space::Space;
use crate::system::{System, Workspace};

/// Solves [M C_q^T; C_q 0] [a; lambda] = [Q; Q_d] (Shabana 6.141) on the graph of the elements; with singular M as one
/// dense matrix. Leaves `a` and `lambda` in the workspace too.
///
/// # Errors
/// A value is not finite, or the masses do not determine the accelerations.
pub fn augmented<S: Space>(
    system: &System<S>,
    ws: &mut Workspace<S>,
) -> Result<Accelerations, FormulationError> {
    ws.rhs.copy_from_slice(&ws.qd);
    let residual = if system.massless {
        general(system, ws)?
    } else {
        system.metric.clone().factor(system, ws);
        ws.solve_forces(&system.mass).relative
    };
    if !ws.a.iter().chain(&ws.lambda).all(|x| x.is_finite()) {
        return Err(FormulationError::NotFinite);
    }
    Ok(Accelerations {
        a: ws.a.clone(),
        lambda: ws.lambda.clone(),
        residual,
    })
}

/// Solves M a + C_q^T lambda = Q, C_q a = rhs of the workspace as one dense matrix, so that motions without mass are
/// named.
pub(crate) fn general<S: Space>(
    system: &System<S>,
    ws: &mut Workspace<S>,
) -> Result<f64, FormulationError> {
    let bodies = system.body_nv();
    let zero = vec![0.0; system.aux];
    let rhs = Rhs {
        f: &ws.force[..bodies],
        g: &ws.rhs,
        h: &zero,
    };
    match solve_general(system.shape(), &system.mass, &ws.jac, &ws.jac_aux, rhs) {
        Ok(found) => {
            ws.a[..bodies].copy_from_slice(&found.a);
            ws.a[bodies..].copy_from_slice(&found.s);
            ws.lambda.copy_from_slice(&found.l);
            Ok(found.residual)
        }
        // Redundant rows that contradict each other by more than rounding: the independent ones decide.
        Err(SingularKkt::Inconsistent { .. }) => {
            let found = augmented_dense(&Terms::of(system, ws))?;
            ws.a.copy_from_slice(&found.a);
            ws.lambda.copy_from_slice(&found.lambda);
            Ok(found.residual)
        }
        Err(SingularKkt::FreeCoordinates { motions }) => {
            let mut coordinates: Vec<usize> = motions
                .iter()
                .flat_map(|m| {
                    let bodies_part = m.coordinates.iter().map(|c| c.0);
                    bodies_part.chain(m.auxiliaries.iter().map(|c| bodies + c.0))
                })
                .collect();
            coordinates.sort_unstable();
            coordinates.dedup();
            Err(FormulationError::Massless { coordinates })
        }
        Err(SingularKkt::NotFinite) => Err(FormulationError::NotFinite),
        Err(SingularKkt::NoConvergence) => Err(RankError::NoConvergence.into()),
    }
}
