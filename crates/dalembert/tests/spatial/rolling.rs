//! Machines that roll and skate, against motions that are known.

use super::moving_machine::{G, compiled, mobility, motion, run, solved, spread, start};
use super::*;
use dalembert::analysis::{AnalysisError, Inverse, Kinematics};
use dalembert::system::compile::Options;
use nalgebra::Vector3;
use serde_json::{Value, json};
use std::f64::consts::TAU;

const MASS: f64 = 2.0;
const RADIUS: f64 = 0.3;

/// A thin disc whose axle (its z axis) stands at an angle to the vertical, and turns about x.
fn disc(angle: f64, velocity: Vector3<f64>, omega: Vector3<f64>, rounding: f64) -> Value {
    let (across, along) = (0.25 * MASS * RADIUS * RADIUS, 0.5 * MASS * RADIUS * RADIUS);
    let height = (RADIUS - rounding) * angle.sin() + rounding;
    let mut joint = json!({"name": "roll", "kind": "rolling-disc", "bodies": ["ground", "disc"],
        "at": [[0, 0, 0], [0, 0, 0]], "axes": [[0, 0, 1], [0, 0, 1]], "radius": RADIUS});
    if rounding > 0.0 {
        joint["rounding"] = json!(rounding);
    }
    json!({
        "body": [{"name": "disc", "mass": MASS, "inertia": [across, across, along],
                  "position": [0, 0, height], "orientation": {"axis": [1, 0, 0], "angle": angle},
                  "velocity": velocity.as_slice(), "angular_velocity": omega.as_slice()}],
        "joint": [joint]
    })
}

/// Velocity of the wheel's material point that touches, from its state alone.
fn slip(state: &dalembert::system::State, rounding: f64) -> (f64, f64) {
    let (pose, v, omega) = motion(state, 0);
    let axle = pose.axes.column(2).into_owned();
    let n = Vector3::z();
    let u = (n - n.dot(&axle) * axle).normalize();
    let arm = -(RADIUS - rounding) * u - rounding * n;
    ((v + omega.cross(&arm)).norm(), (pose.point + arm).z)
}

#[test]
fn coins_and_wheels_keep_their_energy_and_do_not_slip() {
    for rounding in [0.0, 0.08] {
        let omega = Vector3::new(0.3, -0.4, 9.0);
        let system = compiled(disc(1.3, Vector3::zeros(), omega, rounding)).system;
        let mobility = mobility(&system);
        assert_eq!(mobility.position_freedoms, Some(5));
        assert_eq!((mobility.freedoms(), mobility.velocity_rows), (3, 2));
        let mut system = system;
        for leg in 0..5 {
            let from = 2.0 * f64::from(leg);
            let instants: Vec<f64> = (0..=20).map(|k| from + 0.1 * f64::from(k)).collect();
            let report = run(&system, &instants, 1e-11);
            let energy = report.results.channel("energy.total").unwrap().values[0];
            // The wheel wobbles; ten seconds are some hundred turns of it.
            assert!(energy > 1.0, "{energy}");
            let drift = spread(&report, "energy.total");
            assert!(drift < 1e-10 * energy, "leg {leg}: {drift:e} of {energy}");
            let (slip, height) = slip(&report.state, rounding);
            assert!(slip < 1e-12 && height.abs() < 1e-12, "{slip:e} {height:e}");
            system.estimate = report.state;
        }
    }
}

/// A thin disc on a circle: with its axle at an angle b to the vertical, W the rate about the vertical and w that about the
/// axle, Newton and Euler in the frame that goes with it give
///   W sin b (I_t W cos b - I_a w) = m r (W r w sin b + g cos b).
#[test]
fn discs_roll_on_steady_circles() {
    let (angle, rate) = (1.1_f64, 2.3_f64);
    let (s, c) = angle.sin_cos();
    let (across, along) = (0.25 * MASS * RADIUS * RADIUS, 0.5 * MASS * RADIUS * RADIUS);
    let spin = (across * rate * rate * s * c - MASS * RADIUS * G * c)
        / (rate * s * (MASS * RADIUS * RADIUS + along));
    // The axle, and from the contact to the centre.
    let (a, n) = (Vector3::new(0.0, -s, c), Vector3::z());
    let u = (n - c * a) / s;
    let omega = rate * s * u + spin * a;
    let velocity = omega.cross(&(RADIUS * u));
    let system = compiled(disc(angle, velocity, omega, 0.0)).system;
    let first = start(&system);
    let (_, v, w) = motion(&first, 0);
    assert!((v - velocity).amax() < 1e-14 && (w - omega).amax() < 1e-14);
    let period = TAU / rate;
    let report = run(&system, &[0.0, 0.5 * period, period], 1e-12);
    let x = &report.results.channel("disc.x").unwrap().values;
    let y = &report.results.channel("disc.y").unwrap().values;
    // Half way across the circle of the centre, then back.
    let across = 2.0 * velocity.norm() / rate;
    assert!(((x[1] - x[0]).hypot(y[1] - y[0]) - across).abs() < 1e-9);
    assert!((x[2] - x[0]).hypot(y[2] - y[0]) < 1e-9);
    let (pose, v, w) = motion(&report.state, 0);
    assert!((pose.axes.column(2) - a).amax() < 1e-9);
    assert!((v - velocity).amax() < 1e-9 && (w - omega).amax() < 1e-9);
}

fn ball(table: &str, position: [f64; 3], velocity: [f64; 3], spin: [f64; 3]) -> Value {
    let inertia = 0.4 * 0.5 * 0.1 * 0.1;
    json!({
        "body": [{"name": "ball", "mass": 0.5, "inertia": [inertia, inertia, inertia],
                  "position": position, "velocity": velocity, "angular_velocity": spin}],
        "joint": [{"name": "roll", "kind": "rolling-ball", "bodies": [table, "ball"],
                   "at": [[0, 0, 0], [0, 0, 0]], "axis": [0, 0, 1], "radius": 0.1}]
    })
}

#[test]
fn balls_on_planes_have_three_freedoms() {
    let system = compiled(ball("ground", [0.2, 0.1, 0.1], [0.0; 3], [1.0, 2.0, 3.0])).system;
    let report = mobility(&system);
    assert_eq!((report.position_freedoms, report.freedoms()), (Some(5), 3));
    assert!(
        report.to_string().contains("Mobility of positions: 5"),
        "{report}"
    );
    // On a plane that stands still it goes straight on, v = omega x r n.
    let report = run(&system, &[0.0, 3.0], 1e-11);
    let first = start(&system);
    let ((from, v, w), (to, _, _)) = (motion(&first, 0), motion(&report.state, 0));
    assert!((v - w.cross(&Vector3::new(0.0, 0.0, 0.1))).amax() < 1e-15);
    assert!((to.point - from.point - 3.0 * v).amax() < 1e-10);
}

/// A ball on a turntable: m a = F, (2/5) m r^2 omega' = -r n x F and v + r n x omega = W n x x give a = (2/7) W n x v, a circle
/// about a fixed centre, wherever it starts.
#[test]
fn balls_on_turntables_go_round_in_circles() {
    let (table, spin) = (3.0_f64, [-1.0, 2.0, 5.0]);
    let mut model = ball("table", [0.4, -0.1, 0.1], [0.0; 3], spin);
    model["body"]
        .as_array_mut()
        .unwrap()
        .push(json!({"name": "table", "mass": 4, "inertia": [1, 1, 2]}));
    model["joint"].as_array_mut().unwrap().push(
        json!({"name": "axis", "kind": "revolute", "bodies": ["ground", "table"],
               "point": [0, 0, 0], "axis": [0, 0, 1]}),
    );
    let mut driven = model.clone();
    driven["driver"] = json!([{"name": "motor", "kind": "angle", "joint": "axis", "rate": table}]);
    // A table that is free takes part: it is so heavy here that it hardly does.
    let mut free = model;
    free["body"][1]["inertia"] = json!([1e12, 1e12, 1e12]);
    free["initial"] = json!([{"kind": "angle", "joint": "axis", "rate": table}]);
    for (name, model) in [("driven", driven), ("free", free)] {
        let system = compiled(model).system;
        let first = start(&system);
        let (pose, v, w) = motion(&first, 0);
        let n = Vector3::z();
        // No slip at the start.
        let slip = v + w.cross(&(-0.1 * n)) - table * n.cross(&pose.point);
        assert!(slip.amax() < 1e-14, "{name}: {slip}");
        let rate = 2.0 / 7.0 * table;
        let center = pose.point + n.cross(&v) / rate;
        let arm = pose.point - center;
        let instants = [0.0, 0.25 * TAU / rate, 0.5 * TAU / rate, TAU / rate];
        let report = run(&system, &instants, 1e-11);
        let of = |c: &str| &report.results.channel(&format!("ball.{c}")).unwrap().values;
        for (k, t) in instants.into_iter().enumerate() {
            let (s, c) = (rate * t).sin_cos();
            let expected = center + c * arm + s * n.cross(&arm);
            let found = Vector3::new(of("x")[k], of("y")[k], of("z")[k]);
            assert!(
                (found - expected).amax() < 1e-9,
                "{name} at {t}: {found} for {expected}"
            );
        }
    }
}

/// A skate on an incline (Neimark and Fufaev): its blade at the centre of mass, turning with the rate w that it keeps, started
/// downhill at rest: x = G/(2 w^2) sin^2(w t), y = G/(2 w^2) (w t - sin(2 w t)/2), G = g sin(incline): a cycloid across.
#[test]
fn skates_on_inclines_make_cycloids() {
    let (incline, rate) = (0.4_f64, 1.7);
    let down = G * incline.sin();
    let system = compiled(json!({
        "gravity": [down, 0.0, -G * incline.cos()],
        "body": [{"name": "skate", "mass": 3, "inertia": [0.1, 0.2, 0.25], "angular_velocity": [0, 0, rate]}],
        "joint": [
            {"name": "ice", "kind": "planar", "bodies": ["ground", "skate"], "point": [0, 0, 0], "axis": [0, 0, 1]},
            {"name": "blade", "kind": "knife-edge", "bodies": ["ground", "skate"], "point": [0, 0, 0],
             "axis": [0, 1, 0]}
        ]
    }))
    .system;
    let report = mobility(&system);
    assert_eq!((report.position_freedoms, report.freedoms()), (Some(3), 2));
    let instants: Vec<f64> = (0..=10).map(|k| 0.5 * f64::from(k)).collect();
    let report = run(&system, &instants, 1e-11);
    let of = |c: &str| {
        &report
            .results
            .channel(&format!("skate.{c}"))
            .unwrap()
            .values
    };
    for (k, t) in instants.into_iter().enumerate() {
        let scale = down / (2.0 * rate * rate);
        let x = scale * (rate * t).sin().powi(2);
        let y = scale * (rate * t - 0.5 * (2.0 * rate * t).sin());
        near("x and y", &[of("x")[k], of("y")[k]], &[x, y], 1e-10);
    }
}

/// The same skate by a constraint of the user.
#[test]
fn users_can_write_a_blade() {
    let parts = |blade: Value| {
        let mut parts = json!({
            "gravity": [2.0, 0.0, -9.0],
            "body": [{"name": "skate", "mass": 3, "inertia": [0.1, 0.2, 0.25], "angular_velocity": [0, 0, 1.7]}],
            "joint": [
                {"name": "ice", "kind": "planar", "bodies": ["ground", "skate"], "point": [0, 0, 0], "axis": [0, 0, 1]},
                {"name": "axis", "kind": "parallel-axes", "bodies": ["ground", "skate"], "axis": [0, 0, 1]}
            ]
        });
        let (list, entry) = (blade["list"].as_str().unwrap(), blade["entry"].clone());
        match parts.get_mut(list) {
            Some(list) => list.as_array_mut().unwrap().push(entry),
            None => parts[list] = json!([entry]),
        }
        compiled(parts).system
    };
    let blade = parts(json!({"list": "joint", "entry":
        {"name": "blade", "kind": "knife-edge", "bodies": ["ground", "skate"], "point": [0, 0, 0], "axis": [0, 1, 0]}}));
    let user = parts(json!({"list": "constraint", "entry":
        {"name": "blade", "kind": "velocity",
         "expression": "skate.vy * cos(1.7 * t) - skate.vx * sin(1.7 * t)"}}));
    let instants = [0.0, 1.3, 2.9];
    let [a, b] = [blade, user].map(|system| run(&system, &instants, 1e-11));
    for channel in ["skate.x", "skate.y"] {
        let [a, b] = [&a, &b].map(|r| r.results.channel(channel).unwrap().values.clone());
        near(channel, &a, &b, 1e-10);
    }
}

#[test]
fn the_reaction_of_a_rolling_ball_is_its_weight() {
    let system = compiled(ball("ground", [0.0, 0.0, 0.1], [0.0; 3], [1.0, 2.0, 0.0])).system;
    let state = start(&system);
    let ws = solved(&system, &state);
    // The row of the contact grows upwards: its multiplier is minus the force on the ball.
    near("multipliers", &ws.lambda, &[-0.5 * G, 0.0, 0.0], 1e-14);
}

/// A ball on an incline rolls with 5/7 of the acceleration of one that slides.
#[test]
fn balls_roll_down() {
    let mut model = ball("ground", [0.0, 0.0, 0.1], [0.0; 3], [0.0; 3]);
    model["gravity"] = json!([3.0, 0.0, -9.0]);
    let system = compiled(model).system;
    let ws = solved(&system, &start(&system));
    near("a", &ws.a[..3], &[15.0 / 7.0, 0.0, 0.0], 1e-15);
    // Friction 2/7 of the pull, uphill.
    near("lambda", &ws.lambda, &[-4.5, 3.0 / 7.0, 0.0], 1e-14);
}

#[test]
fn only_simulation_follows_velocity_constraints() {
    let mut model = ball("ground", [0.0, 0.0, 0.1], [0.0; 3], [0.0; 3]);
    model["driver"] =
        json!([{"name": "way", "kind": "path", "body": "ball", "x": "0.1*t", "y": "0"}]);
    let system = compiled(model).system;
    let refused = |e: AnalysisError| {
        assert!(matches!(&e, AnalysisError::Nonholonomic { .. }), "{e}");
        let text = e.to_string();
        assert!(
            text.contains("roll") && text.contains("use simulate"),
            "{text}"
        );
    };
    let kinematics = Kinematics::new(&Options::default());
    refused(kinematics.run(&system).unwrap_err());
    let inverse = Inverse {
        instants: vec![0.0, 1.0],
        ..Inverse::default()
    };
    refused(inverse.run(&system).unwrap_err());
}

/// The ground pushes with m (g + a) and the rim touches it; a wheel that is pulled up would part.
#[test]
fn the_ground_pushes_and_a_lifted_wheel_is_told() {
    for (rounding, ball) in [(0.0, false), (0.08, false), (0.0, true)] {
        let omega = Vector3::new(0.3, -0.4, 9.0);
        let mut parts = disc(1.3, Vector3::zeros(), omega, rounding);
        if ball {
            parts["body"][0]["position"] = json!([0, 0, RADIUS]);
            parts["joint"] = json!([{"name": "roll", "kind": "rolling-ball", "bodies": ["ground", "disc"],
                "at": [[0, 0, 0], [0, 0, 0]], "axes": [[0, 0, 1], [0, 0, 1]], "radius": RADIUS}]);
        }
        let instants: Vec<f64> = (0..=20).map(|k| 0.1 * f64::from(k)).collect();
        let report = run(&compiled(parts.clone()).system, &instants, 1e-11);
        assert!(report.results.notes.iter().all(|n| !n.contains("pull")));
        let values = |name: &str| &report.results.channel(name).expect(name).values;
        for k in 0..instants.len() {
            let push = MASS * (G + values("disc.az")[k]);
            near(
                "push",
                &[values("roll.normal_force")[k]],
                &[push],
                1e-10 * MASS * G,
            );
            near("touch", &[values("roll.point_z")[k]], &[0.0], 1e-11);
        }
        parts["force"] = json!([{"name": "crane", "kind": "force", "body": "disc", "at": [0, 0, 0],
            "value": [0, 0, 1.5 * MASS * G]}]);
        let report = run(&compiled(parts).system, &[0.0, 0.01], 1e-9);
        let told = |n: &String| n.contains("'roll' would have to pull");
        assert!(
            report.results.notes.iter().any(told),
            "{:?}",
            report.results.notes
        );
    }
}
