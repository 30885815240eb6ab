//! Multibody dynamics: the engine of dalembert.
//!
//! One linear graph describes a machine; a formulation is a choice of its spanning tree.
//! The way of data: [`model::Model`] -> network -> system -> analysis -> [`results::Results`].
#![forbid(unsafe_code)]

pub mod analysis;
pub mod diagnostic;
pub mod force;
pub mod formulation;
#[doc(hidden)]
pub mod instances;
pub mod integrate;
pub mod joint;
pub mod mass;
pub mod model;
pub mod network;
pub mod results;
pub mod signal;
pub mod solve;
pub mod space;
pub mod surface;
pub mod system;
pub mod words;
