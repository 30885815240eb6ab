//! What a solution of the saddle system needs beside the factors.

use super::pattern::Pattern;

/// Arrays of a solution, allocated once.
#[derive(Clone, Debug)]
pub(super) struct Work {
    pub force: Vec<f64>,
    pub row: Vec<f64>,
    pub aux: Vec<f64>,
    pub turned: Vec<f64>,
    pub step_a: Vec<f64>,
    pub step_l: Vec<f64>,
    pub step_s: Vec<f64>,
    pub best_a: Vec<f64>,
    pub best_l: Vec<f64>,
    pub best_s: Vec<f64>,
    pub kept_a: Vec<f64>,
    pub kept_l: Vec<f64>,
    pub kept_s: Vec<f64>,
    pub local: Vec<f64>,
    /// Square of the largest weighted term of the last residual.
    pub scale: f64,
}

impl Work {
    /// Allocates the arrays for a pattern.
    pub fn new(pattern: &Pattern) -> Self {
        let (coordinates, rows, aux) = (pattern.coordinates(), pattern.rows(), pattern.aux());
        let longest = pattern
            .shape()
            .elements
            .iter()
            .map(|e| e.rows)
            .max()
            .unwrap_or(0);
        Self {
            force: vec![0.0; coordinates],
            row: vec![0.0; rows],
            aux: vec![0.0; aux],
            turned: vec![0.0; rows],
            step_a: vec![0.0; coordinates],
            step_l: vec![0.0; rows],
            step_s: vec![0.0; aux],
            best_a: vec![0.0; coordinates],
            best_l: vec![0.0; rows],
            best_s: vec![0.0; aux],
            kept_a: vec![0.0; coordinates],
            kept_l: vec![0.0; rows],
            kept_s: vec![0.0; aux],
            local: vec![0.0; longest],
            scale: 0.0,
        }
    }
}
