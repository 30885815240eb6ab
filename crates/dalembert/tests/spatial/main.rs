//! Spatial bodies, markers, measures and the joint catalogue against dual numbers; joints as machines.

mod bodies;
mod bushing;
mod check;
mod contact_rows;
mod families;
mod fitting;
mod guards;
mod joint_equations;
mod joints;
mod machine;
mod measures;
mod motion;
mod moving_machine;
mod oracle;
mod poles;
mod quantities;
mod ranks;
mod rolling;
mod rows;
mod shapes;
mod starts;
#[path = "../support/mod.rs"]
mod support;
mod surfaces;
mod touching;
mod traps;
mod turns;
mod twins;
mod velocity_rows;
mod written;

use support::{Random, near};

const SEED: u64 = 7_071;

fn random<const N: usize>(source: &mut Random, limit: f64) -> [f64; N] {
    [0.0; N].map(|_| source.uniform(-limit, limit))
}
