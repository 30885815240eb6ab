//! Tests of the plots.

mod decimation;
mod pictures;
mod rounding;
mod scales;
