//! Time per acceleration evaluation of a chain of n pinned bars in free fall from the horizontal.
//!
//! `cargo bench -p dalembert --bench chain`. The whole evaluation is timed: markers, constraints,
//! Jacobian, forces, factorization, solution. Linear growth means a constant time a body.
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use dalembert::analysis::{Dynamics, Motion};
use dalembert::model::{Body, Info, Joint, JointKind, Model, Placement, Value};
use dalembert::system::compile::compile;
use std::hint::black_box;

fn chain(n: usize) -> Model {
    let mut model = Model {
        info: Info {
            name: format!("chain of {n}"),
            ..Info::default()
        },
        ..Model::default()
    };
    let point = |x: f64| vec![Value::from(x), Value::from(0.0)];
    for k in 0..n {
        model.bodies.push(Body {
            name: format!("bar {k}"),
            mass: Some(1.0.into()),
            inertia: Some((1.0 / 12.0).into()),
            position: Some(point(k as f64 + 0.5)),
            ..Body::default()
        });
        let (previous, end) = if k == 0 {
            ("ground".to_owned(), 0.0)
        } else {
            (format!("bar {}", k - 1), 0.5)
        };
        model.joints.push(Joint {
            name: format!("pin {k}"),
            kind: JointKind::Revolute {
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
    let mut group = c.benchmark_group("chain acceleration");
    for n in [10, 100, 1000, 10000] {
        let Ok(compiled) = compile::<dalembert::space::Planar>(&chain(n), &[]) else {
            unreachable!("the chain is a valid model")
        };
        let system = compiled.system.running();
        let options = Dynamics::new(&compiled.options);
        let mut motion = Motion::new(&system, &options);
        let mut y = system.estimate.q.clone();
        y.extend_from_slice(&system.estimate.v);
        y.push(0.0);
        // A small bend and spin, so that no term is zero by accident.
        for k in 0..n {
            y[3 * k + 2] += 1e-3 * (k as f64).sin();
            y[3 * n + 3 * k + 2] = 0.1 * (k as f64).cos();
        }
        group.throughput(Throughput::Elements(n as u64));
        group.bench_with_input(BenchmarkId::from_parameter(n), &n, |b, _| {
            b.iter(|| motion.evaluate(0.0, black_box(&y)).is_ok());
        });
    }
    group.finish();
}

criterion_group!(benches, accelerations);
criterion_main!(benches);
