//! Tests of the plots.

mod decimation;
mod pictures;
mod scales;
