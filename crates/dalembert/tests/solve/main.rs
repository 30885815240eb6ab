//! Tests of the linear algebra: saddle systems and rank decisions.

mod general;
mod problem;
mod random;
mod rank;
mod saddle_dependent;
mod saddle_regular;
