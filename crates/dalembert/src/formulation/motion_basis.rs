//! Bases of the motions that the constraints leave free.

use super::row_space::RANK_TOLERANCE;
use super::{FormulationError, RowSpace, Terms};
use crate::solve::{Partition, null_basis_lu, null_basis_qr, null_basis_svd, partition};
use nalgebra::{DMatrix, DVector};

/// Which basis of the free motions.
#[derive(Clone, Debug, PartialEq)]
pub enum Basis {
    /// Independent coordinates by full pivoting; these are preferred (Shabana 6.5).
    Partition(Vec<usize>),
    /// Orthonormal quasi-velocities by QR (Shabana 6.9).
    Qr,
    /// Orthonormal quasi-velocities by singular values (Shabana 6.9).
    Svd,
}

impl Default for Basis {
    fn default() -> Self {
        Self::Partition(Vec::new())
    }
}

/// v = B u + g, a = B u' + gamma: the velocities and accelerations that the constraints allow.
#[derive(Clone, Debug)]
pub struct MotionBasis {
    /// B: a column for each free motion, C_q B = 0.
    pub b: DMatrix<f64>,
    /// The split of the coordinates, where the basis is one of coordinates.
    pub partition: Option<Partition>,
    /// The independent rows.
    pub rows: RowSpace,
}

impl MotionBasis {
    /// Finds the basis at the pose of the terms.
    ///
    /// # Errors
    /// A value is not finite, or the rank is doubtful.
    pub fn new(terms: &Terms, basis: &Basis) -> Result<Self, FormulationError> {
        terms.check()?;
        let (c, scale) = (&terms.jacobian, &terms.column_scale);
        let rows = RowSpace::new(c, scale)?;
        let (b, partition) = match basis {
            Basis::Partition(preferred) => {
                let split = partition(c, scale, preferred)?;
                (null_basis_lu(c, scale, &split)?, Some(split))
            }
            Basis::Qr => (null_basis_qr(c, scale, RANK_TOLERANCE)?, None),
            Basis::Svd => (null_basis_svd(c, scale, RANK_TOLERANCE)?, None),
        };
        let (rank, pivots) = (rows.independent.len(), b.nrows() - b.ncols());
        if rank != pivots {
            return Err(FormulationError::DoubtfulRank { rank, pivots });
        }
        Ok(Self { b, partition, rows })
    }

    /// A particular solution of C_q x = rhs: zero in the independent coordinates, or orthogonal to B in scaled
    /// coordinates where the basis has none.
    pub fn particular(&self, rhs: &DVector<f64>) -> DVector<f64> {
        let mut x = self.rows.particular(rhs);
        if let Some(split) = &self.partition {
            // The columns of B carry the identity at the independent coordinates.
            let own = x.select_rows(&split.independent);
            x -= &self.b * own;
            for &k in &split.independent {
                x[k] = 0.0;
            }
        }
        x
    }

    /// The independent velocities u of v = B u + g.
    pub fn independent_velocities(&self, v: &DVector<f64>, scale: &[f64]) -> DVector<f64> {
        if let Some(split) = &self.partition {
            return v.select_rows(&split.independent);
        }
        // B / scale is orthonormal, g / scale orthogonal to it.
        DVector::from_iterator(
            self.b.ncols(),
            self.b.column_iter().map(|column| {
                column
                    .iter()
                    .zip(v.iter())
                    .zip(scale)
                    .map(|((b, v), s)| b * v / (s * s))
                    .sum::<f64>()
            }),
        )
    }
}
