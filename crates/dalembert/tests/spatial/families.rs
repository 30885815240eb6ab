//! Poses of equilibrium that go over into each other are one.

use super::moving_machine::compiled;
use dalembert::analysis::{AnalysisError, Assembly, Stability, Statics, StaticsReport};
use serde_json::{Value, json};

fn statics(parts: Value) -> StaticsReport {
    Statics::default().run(&compiled(parts).system).unwrap()
}

/// The number of equilibria, and the stability of the first.
fn equilibria(parts: Value) -> (usize, Stability) {
    let report = statics(parts);
    (report.equilibria.len(), report.equilibria[0].stability)
}

/// It comes to stand anywhere on its plane, with any heading, although the blade lets it slide one way only.
#[test]
fn a_skate_has_one_family_of_poses() {
    let joint = |kind: &str, axis: [f64; 3]| {
        json!({"name": kind, "kind": kind, "bodies": ["ground", "e"],
               "at": [[0, 0, 0], [0, 0, 0]], "axis": axis})
    };
    let skate = json!({
        "body": [{"name": "e", "mass": 1, "inertia": [1, 1, 1]}],
        "joint": [joint("planar", [0.0, 0.0, 1.0]), joint("knife-edge", [0.0, 1.0, 0.0])]
    });
    assert_eq!(equilibria(skate), (1, Stability::Neutral));
}

/// Upright, anywhere, with any heading and any point of its rim below; it would fall over.
#[test]
fn a_rolling_coin_has_one_family_of_poses() {
    let coin = json!({
        "body": [{"name": "coin", "position": [0, 0, 0.012], "mass": 0.0075,
                  "inertia": [3e-7, 3e-7, 6e-7], "orientation": {"axis": [1, 0, 0], "angle": "90 deg"}}],
        "joint": [{"name": "floor", "kind": "rolling-disc", "bodies": ["ground", "coin"],
                   "at": [[0, 0, 0], [0, 0, 0]], "axes": [[0, 0, 1], [0, 0, 1]], "radius": 0.012}]
    });
    assert_eq!(equilibria(coin), (1, Stability::Unstable));
}

/// It lies on one of its axes, either end of it below, anywhere and with any heading: firmly on the shortest one, on a
/// saddle on the middle one, and on the longest one it topples both ways. As a pebble and as a hill.
#[test]
fn an_egg_on_a_plane_has_six_families_of_poses() {
    for size in [1e-2, 1.0, 1e3] {
        let semi_axes = [0.3, 0.2, 0.15].map(|x| x * size);
        let inertia = [0.025, 0.045, 0.052].map(|x| x * size * size);
        let egg = json!({
            "body": [{"name": "egg", "position": [0, 0, 0.165 * size], "mass": 2, "inertia": inertia,
                      "orientation": {"euler": "zxz", "angles": [0, "25 deg", "40 deg"]}}],
            "joint": [{"name": "floor", "kind": "surface-contact", "bodies": ["egg", "ground"],
                       "surfaces": [{"kind": "ellipsoid", "semi_axes": semi_axes}, {"kind": "plane"}]}]
        });
        let mut count = [0; 3];
        for e in &statics(egg).equilibria {
            // Forces balance to 1e-10 of the weight, so the height is good to far better.
            let lying = |h: &f64| (e.q[2] - h).abs() < 1e-9 * size;
            let axis = semi_axes.iter().position(lying).unwrap();
            count[axis] += 1;
            // Stiffnesses are energies, and the weight has 20 N.
            let pushed_away = e.stiffness.iter().filter(|k| **k < -1e-3 * size).count();
            let neutral = e.stiffness.iter().filter(|k| k.abs() < 1e-6 * size).count();
            assert_eq!((pushed_away, neutral), (2 - axis, 3), "size {size}");
            let expected = if axis == 2 {
                Stability::Neutral
            } else {
                Stability::Unstable
            };
            assert_eq!(e.stability, expected);
        }
        assert_eq!(count, [2, 2, 2], "size {size}");
    }
}

/// Two free bodies on a spring at its free length: no force anywhere gives energies or forces a scale.
#[test]
fn a_free_pair_on_a_spring_has_one_family_of_poses() {
    let body = |name: &str, x: f64| json!({"name": name, "position": [x, 0, 0], "mass": 1, "inertia": [1, 2, 3]});
    let pair = json!({
        "gravity": [0, 0, 0],
        "body": [body("a", 0.0), body("b", 0.7)],
        "force": [{"name": "s", "kind": "spring-damper", "bodies": ["a", "b"],
                   "at": [[0.1, 0, 0], [-0.1, 0.1, 0]], "stiffness": 100, "free_length": 0.4}]
    });
    assert_eq!(equilibria(pair), (1, Stability::Neutral));
}

/// It stands across the slope, anywhere on it, on any point of its rim; its axle points uphill or downhill.
#[test]
fn a_wheel_on_a_slope_has_two_families_of_poses() {
    let slope = 10_f64.to_radians();
    let wheel = json!({
        "body": [{"name": "wheel", "position": [0, 0, 0.3], "mass": 5, "inertia": [0.1125, 0.225, 0.1125]}],
        "joint": [{"name": "roll", "kind": "rolling-disc", "bodies": ["ground", "wheel"],
                   "at": [[0, 0, 0], [0, 0, 0]],
                   "axes": [[-slope.sin(), 0, slope.cos()], [0, 1, 0]], "radius": 0.3}]
    });
    let report = statics(wheel);
    assert_eq!(report.equilibria.len(), 2);
    // Only gravity acts.
    let notes = report.results.notes.join("\n");
    assert!(notes.contains("equilibria 1 and 2"), "{notes}");
    assert!(!notes.contains("forces without potential act"), "{notes}");
}

/// Four parallel legs depend on each other, to the fourth order of a swing: the hanging pose is one, and exactly there.
#[test]
fn a_table_hangs_from_its_legs_in_one_pose() {
    let corners = [[0.5, 0.5], [0.5, -0.5], [-0.5, -0.5], [-0.5, 0.5]];
    let leg = |[x, y]: [f64; 2]| {
        json!({"name": format!("leg {x} {y}"), "kind": "distance", "bodies": ["ground", "top"],
               "at": [[x, y, 0], [x, y, 0]]})
    };
    let table = json!({
        "body": [{"name": "top", "position": [0, 0, 0.7], "mass": 10, "inertia": [1, 1, 2]}],
        "joint": corners.map(leg)
    });
    let report = statics(table);
    let hanging: Vec<_> = report
        .equilibria
        .iter()
        .filter(|e| (e.q[2] + 0.7).abs() < 0.01)
        .collect();
    assert_eq!(hanging.len(), 1);
    assert_eq!(hanging[0].stability, Stability::Stable);
    // Newton's method ends at rounding: 1e-10 of the size is generous.
    for (x, expected) in hanging[0].q.iter().zip([0.0, 0.0, -0.7]) {
        assert!((x - expected).abs() < 1e-10, "{:?}", hanging[0].q);
    }
    assert!(report.equilibria.iter().all(|e| e.conservative));
}

/// Where the shafts are twisted by half a turn the rows hold too.
#[test]
fn a_twisted_constant_velocity_joint_is_refused() {
    let shafts = |twist: &str| {
        compiled(json!({
            "body": [{"name": "in", "mass": 1, "inertia": [1, 1, 1]},
                     {"name": "out", "mass": 1, "inertia": [1, 1, 1], "orientation":
                      {"axis": [0, 0, 1], "angle": twist}}],
            "joint": [{"name": "r", "kind": "revolute", "bodies": ["ground", "in"],
                       "at": [[0, 0, 0], [0, 0, 0]], "axes": [[0, 0, 1], [0, 0, 1]]},
                      {"name": "cv", "kind": "constant-velocity", "bodies": ["in", "out"],
                       "at": [[0, 0, 0], [0, 0, 0]], "axes": [[0, 0, 1], [0, 0, 1]],
                       "x_axes": [[1, 0, 0], [1, 0, 0]]}]
        }))
        .system
    };
    assert!(Assembly::default().run(&shafts("80 deg")).is_ok());
    let error = Assembly::default().run(&shafts("100 deg")).unwrap_err();
    let AnalysisError::WrongSide { elements, .. } = &error else {
        panic!("{error}");
    };
    assert!(elements.contains("'cv'"), "{error}");
}
