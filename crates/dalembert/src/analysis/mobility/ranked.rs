//! The rank of a system's rows at a pose, dense or sparse.

use super::super::AnalysisError;
use super::super::weights::Weights;
use crate::formulation::column_scale;
use crate::solve::{RankError, RowRank, analyse_rows, redundant_rows};
use crate::space::Space;
use crate::system::{State, System, Workspace};

/// What is known of the rows of a system at a pose.
#[derive(Debug)]
pub(super) struct Ranked<S: Space> {
    /// Number of independent rows.
    pub rank: usize,
    /// Dependent rows and the rows that they follow from, with their coefficients (none where only
    /// the sparse factors are known, or where the row has no gradient).
    pub redundant: Vec<(usize, Vec<(usize, f64)>)>,
    /// Everything else; missing for a machine that is too large for a dense decomposition.
    pub dense: Option<RowRank>,
    /// Workspace with the markers and rows of the pose.
    pub ws: Workspace<S>,
}

/// Evaluates the rows of a system at a state.
pub(super) fn evaluated<S: Space>(system: &System<S>, state: &State) -> Workspace<S> {
    let mut ws = Workspace::new(system);
    system.update_markers(&state.q, &state.v, &mut ws);
    system.evaluate_constraints(state.t, &mut ws);
    ws
}

/// Names the row behind a failed rank decision.
fn blame<S: Space>(system: &System<S>, state: &State, error: RankError) -> AnalysisError {
    match error {
        RankError::NotFinite { row, .. } => AnalysisError::NotFinite {
            element: system.row_name(row),
            time: state.t,
        },
        other => AnalysisError::Rank(other),
    }
}

impl<S: Space> Ranked<S> {
    /// Ranks the rows of a system at a state: by singular values up to `dense_limit` columns, by
    /// the pivots of the sparse factors above.
    pub fn new(
        system: &System<S>,
        state: &State,
        tolerance: f64,
        dense_limit: usize,
    ) -> Result<Self, AnalysisError> {
        Self::of(
            system,
            state,
            evaluated(system, state),
            tolerance,
            dense_limit,
        )
    }

    /// Ranks the rows that hold positions.
    pub fn positions(
        system: &System<S>,
        state: &State,
        tolerance: f64,
        dense_limit: usize,
    ) -> Result<Self, AnalysisError> {
        let mut ws = Workspace::new(system);
        system.update_markers(&state.q, &state.v, &mut ws);
        system.evaluate_positions(state.t, &mut ws);
        Self::of(system, state, ws, tolerance, dense_limit)
    }

    fn of(
        system: &System<S>,
        state: &State,
        mut ws: Workspace<S>,
        tolerance: f64,
        dense_limit: usize,
    ) -> Result<Self, AnalysisError> {
        if let Some(row) = ws.value.iter().position(|c| !c.is_finite()) {
            return Err(AnalysisError::NotFinite {
                element: system.row_name(row),
                time: state.t,
            });
        }
        if system.nv() > dense_limit {
            if let Some(row) = not_finite(system, &ws) {
                return Err(AnalysisError::NotFinite {
                    element: system.row_name(row),
                    time: state.t,
                });
            }
            let factored = ws.factor(&Weights::even(system).inverse);
            let rows = redundant_rows(&factored);
            return Ok(Self {
                rank: system.rows - rows.len(),
                redundant: rows.into_iter().map(|row| (row, Vec::new())).collect(),
                dense: None,
                ws,
            });
        }
        // A row that vanishes is told from others by its size, which no unit may decide.
        let mut jacobian = system.dense_jacobian(&ws);
        for (row, mut gradient) in jacobian.row_iter_mut().enumerate() {
            gradient /= system.row_scale(row);
        }
        let found = analyse_rows(&jacobian, &column_scale(system), tolerance)
            .map_err(|e| blame(system, state, e))?;
        let redundant = found
            .redundant
            .iter()
            .map(|r| {
                let own = system.row_scale(r.row);
                let in_units = |&(row, c): &(usize, f64)| (row, c * own / system.row_scale(row));
                (r.row, r.depends_on.iter().map(in_units).collect())
            })
            .collect();
        Ok(Self {
            rank: found.rank,
            redundant,
            dense: Some(found),
            ws,
        })
    }

    /// Does a row have no gradient at this pose?
    pub fn is_zero_row(&self, row: usize) -> bool {
        self.dense.is_some()
            && self
                .redundant
                .iter()
                .any(|(r, others)| *r == row && others.is_empty())
    }
}

/// The first row with an entry that is not finite.
fn not_finite<S: Space>(system: &System<S>, ws: &Workspace<S>) -> Option<usize> {
    let probe = vec![1.0; system.nv()];
    let mut product = vec![0.0; system.rows];
    system.jac_mul(ws, &probe, &mut product);
    product.iter().position(|x| !x.is_finite())
}
