//! Small vectors of fixed length.

use nalgebra::SVector;
use std::fmt::Debug;

/// A small vector of numbers of fixed length: a twist, a wrench, a gradient.
pub trait Tuple: Copy + Debug + Default + Send + Sync + 'static {
    /// All components zero.
    fn zero() -> Self;
    /// The components of a slice of the same length.
    fn of(components: &[f64]) -> Self {
        let mut tuple = Self::zero();
        tuple.as_mut_slice().copy_from_slice(components);
        tuple
    }
    /// Scalar product.
    fn dot(&self, other: &Self) -> f64;
    /// self += factor * other.
    fn add_scaled(&mut self, factor: f64, other: &Self);
    /// The components.
    fn as_slice(&self) -> &[f64];
    /// The components, to be written.
    fn as_mut_slice(&mut self) -> &mut [f64];
}

impl<const N: usize> Tuple for SVector<f64, N>
where
    SVector<f64, N>: Default,
{
    fn zero() -> Self {
        Self::repeat(0.0)
    }

    fn dot(&self, other: &Self) -> f64 {
        let mut sum = 0.0;
        for (a, b) in self.iter().zip(other.iter()) {
            sum += a * b;
        }
        sum
    }

    fn add_scaled(&mut self, factor: f64, other: &Self) {
        for (a, b) in self.iter_mut().zip(other.iter()) {
            *a += factor * b;
        }
    }

    fn as_slice(&self) -> &[f64] {
        self.data.as_slice()
    }

    fn as_mut_slice(&mut self) -> &mut [f64] {
        self.data.as_mut_slice()
    }
}
