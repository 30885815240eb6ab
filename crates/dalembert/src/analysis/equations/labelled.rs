//! Matrices and vectors with names on them.

use nalgebra::{DMatrix, DVector};
use serde::Serialize;

/// A matrix with names on rows and columns.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct LabelledMatrix {
    /// Names of the rows.
    pub rows: Vec<String>,
    /// Names of the columns.
    pub columns: Vec<String>,
    /// The rows.
    pub values: Vec<Vec<f64>>,
}

impl LabelledMatrix {
    pub(super) fn new(matrix: &DMatrix<f64>, rows: &[String], columns: &[String]) -> Self {
        Self {
            rows: rows.to_vec(),
            columns: columns.to_vec(),
            values: matrix
                .row_iter()
                .map(|row| row.iter().copied().collect())
                .collect(),
        }
    }
}

/// A vector with names on its entries.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct LabelledVector {
    /// Names of the entries.
    pub rows: Vec<String>,
    /// The entries.
    pub values: Vec<f64>,
}

impl LabelledVector {
    pub(super) fn new(vector: &DVector<f64>, rows: &[String]) -> Self {
        Self {
            rows: rows.to_vec(),
            values: vector.as_slice().to_vec(),
        }
    }

    /// The entry of a name.
    pub fn get(&self, name: &str) -> Option<f64> {
        let at = self.rows.iter().position(|row| row == name)?;
        self.values.get(at).copied()
    }
}
