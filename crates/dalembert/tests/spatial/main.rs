//! Spatial bodies, markers and measures against dual numbers.

mod bodies;
mod measures;
mod oracle;
#[path = "../support/mod.rs"]
mod support;

use support::Random;

const SEED: u64 = 7_071;

fn random<const N: usize>(source: &mut Random, limit: f64) -> [f64; N] {
    [0.0; N].map(|_| source.uniform(-limit, limit))
}

#[track_caller]
fn near(what: &str, found: &[f64], expected: &[f64], tolerance: f64) {
    let most = expected.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
    for (k, (x, y)) in found.iter().zip(expected).enumerate() {
        assert!(
            (x - y).abs() <= tolerance * most,
            "{what}, entry {k}: {x} for {y}, off by {:e}",
            x - y
        );
    }
}
