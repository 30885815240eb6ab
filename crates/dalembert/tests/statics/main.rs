//! Static equilibrium.

mod chain;
mod common;
mod holding;
mod linkage;
mod neutral;
mod none;
mod several;
mod single;
