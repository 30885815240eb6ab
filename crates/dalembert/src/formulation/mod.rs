//! Formulations of the equations of motion: the same accelerations by different routes.
//!
//! All solve M a + C_q^T lambda = Q_e + Q_v, C_q a = Q_d. The sparse augmented form is the one that analyses use; the
//! dense ones follow Shabana, *Computational Dynamics*, chapters 4 to 6, and check it and each other. Auxiliary
//! coordinates (without mass) and redundant rows are allowed in all of them.

mod accelerations;
mod amalgamated;
mod augmented;
mod augmented_dense;
mod dense_solve;
mod elimination;
mod embedding;
mod error;
mod motion_basis;
mod row_space;
mod terms;

pub use accelerations::Accelerations;
pub use amalgamated::amalgamated;
pub use augmented::augmented;
pub(crate) use augmented::general;
pub use augmented_dense::augmented_dense;
pub use elimination::elimination;
pub use embedding::{Embedding, embedding};
pub use error::FormulationError;
pub use motion_basis::{Basis, MotionBasis};
pub use row_space::RowSpace;
pub use terms::{Terms, column_scale};

use crate::space::Space;
use crate::system::{System, Workspace};

/// How the equations of motion are solved for accelerations and multipliers.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Formulation {
    /// Absolute coordinates and multipliers, block-sparse (Shabana 6.141).
    #[default]
    Augmented,
    /// The same system as one dense matrix.
    AugmentedDense,
    /// Independent accelerations only; multipliers afterwards (Shabana 4.14 to 4.16, 6.82 to 6.91).
    Embedding(Basis),
    /// Independent accelerations and multipliers together (Shabana 4.6 to 4.8).
    Elimination(Basis),
    /// Accelerations, constraint forces and independent accelerations together (Shabana 4.17 to 4.20).
    Amalgamated(Basis),
}

impl Formulation {
    /// Solves for accelerations and multipliers.
    ///
    /// The workspace holds markers, constraints and forces of the state (`update_markers`, `evaluate_constraints`,
    /// `evaluate_forces`). The coordinates are the engine's own: centres of mass, for which Q_v = 0.
    ///
    /// # Errors
    /// An input is not finite, or the masses do not determine the accelerations.
    pub fn solve<S: Space>(
        &self,
        system: &System<S>,
        ws: &mut Workspace<S>,
    ) -> Result<Accelerations, FormulationError> {
        match self {
            Self::Augmented => augmented(system, ws),
            dense => dense.solve_terms(&Terms::of(system, ws)),
        }
    }

    /// Solves dense equations in any coordinates; the sparse form has no other coordinates than its own and is
    /// replaced by the dense one.
    ///
    /// # Errors
    /// An input is not finite, or the masses do not determine the accelerations.
    pub fn solve_terms(&self, terms: &Terms) -> Result<Accelerations, FormulationError> {
        match self {
            Self::Augmented | Self::AugmentedDense => augmented_dense(terms),
            Self::Embedding(basis) => embedding(terms, basis).map(|e| e.solution),
            Self::Elimination(basis) => elimination(terms, basis),
            Self::Amalgamated(basis) => amalgamated(terms, basis),
        }
    }
}
