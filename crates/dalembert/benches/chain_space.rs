//! Time per acceleration evaluation of a chain of n bars on ball joints in free fall from the horizontal.
//!
//! `cargo bench -p dalembert --bench chain_space`. The whole evaluation is timed: markers, constraints, Jacobian, forces,
//! factorization, solution. Linear growth means a constant time a body.
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use dalembert::analysis::{Dynamics, Motion};
use dalembert::model::{
    Body, Inertia, Info, Joint, JointKind, Model, Placement, Point, SpaceKind, Value,
};
use dalembert::space::Spatial;
use dalembert::system::compile::compile;
use std::hint::black_box;

fn chain(n: usize) -> Model {
    let mut model = Model {
        info: Info {
            name: format!("chain of {n}"),
            space: SpaceKind::Spatial,
            ..Info::default()
        },
        ..Model::default()
    };
    let point = |x: f64| -> Point { [x, 0.0, 0.0].map(Value::from).to_vec() };
    for k in 0..n {
        model.bodies.push(Body {
            name: format!("bar {k}"),
            mass: Some(1.0.into()),
            inertia: Some(Inertia::Moments(
                [0.01, 1.0 / 12.0, 1.0 / 12.0].map(Value::from),
            )),
            position: Some(point(k as f64 + 0.5)),
            ..Body::default()
        });
        let (previous, end) = if k == 0 {
            ("ground".to_owned(), 0.0)
        } else {
            (format!("bar {}", k - 1), 0.5)
        };
        model.joints.push(Joint {
            name: format!("ball {k}"),
            kind: JointKind::Spherical {
                placement: Placement {
                    bodies: [previous, format!("bar {k}")],
                    at: Some([point(end), point(-0.5)]),
                    ..Placement::default()
                },
            },
        });
    }
    model
}

fn accelerations(c: &mut Criterion) {
    let mut group = c.benchmark_group("spatial chain acceleration");
    for n in [10, 100, 1000, 10000] {
        let Ok(compiled) = compile::<Spatial>(&chain(n), &[]) else {
            unreachable!("the chain is a valid model")
        };
        let system = compiled.system.running();
        let options = Dynamics::new(&compiled.options);
        let mut motion = Motion::new(&system, &options);
        let mut q = system.estimate.q.clone();
        // A small bend and spin, so that no term is zero by accident.
        let wave = |k: usize, phase: f64| (k as f64 + phase).sin();
        let step: Vec<f64> = (0..6 * n)
            .map(|k| if k % 6 > 2 { 1e-3 * wave(k, 0.0) } else { 0.0 })
            .collect();
        system.advance(&mut q, 1.0, &step);
        let v = (0..6 * n).map(|k| if k % 6 > 2 { 0.1 * wave(k, 1.0) } else { 0.0 });
        let mut y = q;
        y.extend(v);
        y.push(0.0);
        group.throughput(Throughput::Elements(n as u64));
        group.bench_with_input(BenchmarkId::from_parameter(n), &n, |b, _| {
            b.iter(|| motion.evaluate(0.0, black_box(&y)).is_ok());
        });
    }
    group.finish();
}

criterion_group!(benches, accelerations);
criterion_main!(benches);
