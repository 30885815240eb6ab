//! Factor and solve of planar chains of pinned bars: the cost should grow linearly with their number.
//!
//! Least times of many runs on a shared 3 GHz core, one thread, one residual evaluation included, no correction needed:
//! 10 bars 1.5 us, 100 bars 14 us, 1000 bars 0.14 ms, 10000 bars 1.5 ms.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use dalembert::solve::{ElementShape, Rhs, Saddle, SaddleShape};
use std::hint::black_box;

/// A chain of bars of length 1, each pinned to the one before, the first to the ground, in a bent pose.
struct Chain {
    saddle: Saddle,
    mass: Vec<f64>,
    mass_inverse: Vec<f64>,
    jac: Vec<f64>,
    force: Vec<f64>,
    acceleration: Vec<f64>,
}

impl Chain {
    fn new(bars: usize) -> Self {
        let elements = (0..bars)
            .map(|i| ElementShape {
                rows: 2,
                bodies: (i.saturating_sub(1)..=i).collect(),
                aux: 0,
            })
            .collect();
        let saddle = Saddle::new(SaddleShape {
            bodies: bars,
            dof: 3,
            elements,
        });
        let (mut mass, mut mass_inverse) = (vec![0.0; 9 * bars], vec![0.0; 9 * bars]);
        let mut jac = Vec::new();
        for i in 0..bars {
            for (k, m) in [2.0, 2.0, 2.0 / 12.0].into_iter().enumerate() {
                mass[9 * i + 4 * k] = m;
                mass_inverse[9 * i + 4 * k] = 1.0 / m;
            }
            let gradient = |body: usize, end: f64, sign: f64| {
                let (s, c) = (0.7 * body as f64).sin_cos();
                [sign, 0.0, -sign * s * end, 0.0, sign, sign * c * end]
            };
            if i > 0 {
                jac.extend(gradient(i - 1, 0.5, 1.0));
            }
            jac.extend(gradient(i, -0.5, -1.0));
        }
        let force = (0..bars)
            .flat_map(|i| [0.0, -9.81 * 2.0, 0.1 * (i as f64).sin()])
            .collect();
        let acceleration = (0..2 * bars).map(|i| (0.3 * i as f64).cos()).collect();
        Self {
            saddle,
            mass,
            mass_inverse,
            jac,
            force,
            acceleration,
        }
    }
}

fn chain(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("planar chain");
    for bars in [10, 100, 1000, 10000] {
        let mut chain = Chain::new(bars);
        let (mut a, mut l) = (vec![0.0; 3 * bars], vec![0.0; 2 * bars]);
        group.throughput(Throughput::Elements(bars as u64));
        group.bench_function(BenchmarkId::new("factor", bars), |bencher| {
            bencher.iter(|| {
                black_box(
                    chain
                        .saddle
                        .factor(&chain.mass_inverse, &chain.jac, &[])
                        .smallest,
                )
            });
        });
        group.bench_function(BenchmarkId::new("factor and solve", bars), |bencher| {
            bencher.iter(|| {
                chain.saddle.factor(&chain.mass_inverse, &chain.jac, &[]);
                let rhs = Rhs {
                    f: &chain.force,
                    g: &chain.acceleration,
                    h: &[],
                };
                let residual = chain
                    .saddle
                    .solve(&chain.mass, rhs, &mut a, &mut l, &mut []);
                assert!(residual.converged, "{residual:?}");
                black_box(residual)
            });
        });
    }
    group.finish();
}

criterion_group!(benches, chain);
criterion_main!(benches);
