//! The hanging chain of ten links: closed form of the funicular polygon.

use crate::common::{G, close, pin, rod, run_both, system, value};
use dalembert::analysis::Stability;
use serde_json::{Value, json};

const LINKS: usize = 10;
const LENGTH: f64 = 0.15;
const MASS: f64 = 0.2;

/// Ten links between (0, 0) and (1, 0), started as two straight halves.
fn chain(apex: f64) -> dalembert::system::System<dalembert::space::Planar> {
    let slope = (apex / 0.5_f64).atan();
    let angle = |k: usize| if k < LINKS / 2 { slope } else { -slope };
    let mut from = [0.0, 0.0];
    let mut bodies: Vec<Value> = Vec::new();
    let mut joints = vec![pin(
        "j0",
        ["ground", "link0"],
        [[0.0, 0.0], [-LENGTH / 2.0, 0.0]],
    )];
    for k in 0..LINKS {
        let name = format!("link{k}");
        bodies.push(rod(&name, MASS, LENGTH, from, angle(k)));
        from[0] += LENGTH * angle(k).cos();
        from[1] += LENGTH * angle(k).sin();
        if k > 0 {
            let before = format!("link{}", k - 1);
            joints.push(pin(
                &format!("j{k}"),
                [&before, &name],
                [[LENGTH / 2.0, 0.0], [-LENGTH / 2.0, 0.0]],
            ));
        }
    }
    joints.push(pin(
        "j10",
        ["link9", "ground"],
        [[LENGTH / 2.0, 0.0], [1.0, 0.0]],
    ));
    let traces: Vec<Value> = (0..LINKS - 1)
        .map(|k| json!({"name": format!("p{}", k + 1), "body": format!("link{k}"), "at": [LENGTH / 2.0, 0.0]}))
        .collect();
    system(
        json!({"model": {"name": "chain", "gravity": [0.0, -G]}, "body": bodies, "joint": joints, "trace": traces}),
    )
}

/// Joint positions and support reaction from tan(phi_i) = (n m g/2 - (i + 1/2) m g)/H with
/// sum L cos(phi_i) = 1, evaluated with 30 digits (any statics text).
const JOINTS: [[f64; 2]; 9] = [
    [0.0622110905191137, -0.13649095287389065],
    [0.13805049086770194, -0.2659065058602553],
    [0.2331915775417546, -0.381872766585004],
    [0.3542677572058749, -0.47041969605148337],
    [0.5, -0.5059459315710845],
    [0.6457322427941251, -0.47041969605148337],
    [0.7668084224582454, -0.381872766585004],
    [0.8619495091322981, -0.2659065058602553],
    [0.9377889094808863, -0.13649095287389065],
];

#[test]
fn a_chain_hangs_in_its_funicular_polygon() {
    for apex in [-0.55, -0.3, 0.55] {
        let report = run_both(&chain(apex));
        assert_eq!(report.freedoms, 8);
        assert_eq!(report.equilibria[0].stability, Stability::Stable);
        for (k, p) in JOINTS.iter().enumerate() {
            close(value(&report, &format!("p{}.x", k + 1)), p[0], 1e-11);
            close(value(&report, &format!("p{}.y", k + 1)), p[1], 1e-11);
        }
        close(value(&report, "j0.force_x"), -4.024162090074492, 1e-10);
        close(value(&report, "j0.force_y"), 9.81, 1e-10);
    }
}
