//! Spatial bodies, markers and measures against dual numbers.

mod bodies;
mod contact_rows;
mod machine;
mod measures;
mod oracle;
mod rolling;
mod shapes;
#[path = "../support/mod.rs"]
mod support;
mod surfaces;
mod touching;
mod velocity_rows;

use support::{Random, near};

const SEED: u64 = 7_071;

fn random<const N: usize>(source: &mut Random, limit: f64) -> [f64; N] {
    [0.0; N].map(|_| source.uniform(-limit, limit))
}
