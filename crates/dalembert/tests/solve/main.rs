//! Tests of the linear algebra: saddle systems and rank decisions.

mod problem;
mod random;
mod saddle_dependent;
mod saddle_regular;
