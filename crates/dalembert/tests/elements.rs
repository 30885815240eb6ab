//! Every constraint element and force element against numerical differentiation at random states that are off the
//! constraint manifold, with all velocities different from zero.

mod support;

use dalembert::space::{Planar, PlanarMarker};
use dalembert::system::{State, System, Workspace};
use serde_json::{Value, json};
use support::{Random, compiled, evaluated};

const SEED: u64 = 20_011_213;
const STATES: usize = 5;

/// Two bodies whose frames are not at their centres of mass, and one that carries others.
fn bodies() -> Value {
    json!([
        {"name": "a", "mass": 2.0, "inertia": 0.4, "center": [0.13, -0.21], "position": [0.2, 0.5], "angle": 0.3},
        {"name": "b", "mass": 1.5, "inertia": 0.3, "center": [-0.17, 0.08], "position": [1.1, 0.9], "angle": -0.4},
        {"name": "c", "mass": 0.7, "inertia": 0.1, "center": [0.05, 0.11], "position": [-0.6, 0.4], "angle": 1.2}
    ])
}

fn system(parts: Value) -> System<Planar> {
    let mut model = json!({"model": {"name": "test", "gravity": [0, 0]}, "body": bodies()});
    for (key, value) in parts.as_object().unwrap() {
        model[key] = value.clone();
    }
    compiled(model).system.running()
}

fn joint(kind: &str, bodies: [&str; 2], more: Value) -> Value {
    let mut joint = json!({"name": "J", "kind": kind, "bodies": bodies,
                           "at": [[0.31, -0.12], [-0.23, 0.19]], "angles": [0.35, -0.8]});
    for (key, value) in more.as_object().unwrap() {
        joint[key] = value.clone();
    }
    joint
}

fn random_state(system: &System<Planar>, random: &mut Random) -> State {
    let mut draw = |n: usize, limit: f64| (0..n).map(|_| random.uniform(-limit, limit)).collect();
    let (mut q, v): (Vec<f64>, Vec<f64>) = (draw(system.nq(), 1.0), draw(system.nv(), 1.0));
    for angle in q.iter_mut().take(system.body_nv()).skip(2).step_by(3) {
        *angle *= 3.0;
    }
    State {
        t: random.uniform(0.1, 0.9),
        q,
        v,
    }
}

/// Step of the differences. Angles turn by some radians per unit of the path and profiles double that: the formulas of
/// tenth order then err by less than 1e-11, and so does rounding.
const STEP: f64 = 0.03;
/// What that leaves, relative to the largest entry and to one.
const TOLERANCE: f64 = 1e-11;

/// First and second derivative at zero by central differences of tenth order (Fornberg 1988).
fn differentiate(f: impl Fn(f64) -> Vec<f64>) -> (Vec<f64>, Vec<f64>) {
    let first = [
        5.0 / 6.0,
        -5.0 / 21.0,
        5.0 / 84.0,
        -5.0 / 504.0,
        1.0 / 1260.0,
    ];
    let second = [
        5.0 / 3.0,
        -5.0 / 21.0,
        5.0 / 126.0,
        -5.0 / 1008.0,
        1.0 / 3150.0,
    ];
    let middle = f(0.0);
    let mut d = vec![0.0; middle.len()];
    let mut dd: Vec<f64> = middle.iter().map(|x| -5269.0 / 1800.0 * x).collect();
    for (k, (first, second)) in first.into_iter().zip(second).enumerate() {
        let h = STEP * (k + 1) as f64;
        let (plus, minus) = (f(h), f(-h));
        for i in 0..d.len() {
            d[i] += first * (plus[i] - minus[i]);
            dd[i] += second * (plus[i] + minus[i]);
        }
    }
    for i in 0..d.len() {
        d[i] /= STEP;
        dd[i] /= STEP * STEP;
    }
    (d, dd)
}

fn constraints(system: &System<Planar>, t: f64, q: &[f64], v: &[f64]) -> Vec<f64> {
    let mut ws = Workspace::new(system);
    system.update_markers(q, v, &mut ws);
    system.evaluate_constraints(t, &mut ws);
    ws.value.clone()
}

fn moved(q: &[f64], v: &[f64], s: f64) -> Vec<f64> {
    q.iter().zip(v).map(|(q, v)| q + s * v).collect()
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

/// C_q, C_t and Q_d of a system against differences of its residual along each coordinate, along time, and along the
/// path q + v s, t + s, on which d2C/ds2 = -Q_d.
fn check(name: &str, parts: Value) {
    let system = system(parts);
    assert!(system.rows > 0, "{name} has no rows");
    let mut random = Random::new(SEED);
    for n in 0..STATES {
        let name = format!("{name}, state {n}");
        let state = random_state(&system, &mut random);
        let State { t, q, v } = &state;
        let ws = evaluated(&system, &state);
        assert!(
            ws.value.iter().any(|c| c.abs() > 1e-3),
            "{name} is on the manifold"
        );
        let jacobian = system.dense_jacobian(&ws);
        for k in 0..system.nv() {
            let mut unit = vec![0.0; system.nv()];
            unit[k] = 1.0;
            let (slope, _) = differentiate(|s| constraints(&system, *t, &moved(q, &unit, s), v));
            near(
                &format!("{name}: C_q column {k}"),
                jacobian.column(k).as_slice(),
                &slope,
                TOLERANCE,
            );
        }
        let (slope, _) = differentiate(|s| constraints(&system, t + s, q, v));
        near(&format!("{name}: C_t"), &ws.time, &slope, TOLERANCE);
        let (rate, second) = differentiate(|s| constraints(&system, t + s, &moved(q, v, s), v));
        let mut own = vec![0.0; system.rows];
        system.jac_mul(&ws, v, &mut own);
        for (own, time) in own.iter_mut().zip(&ws.time) {
            *own += time;
        }
        near(&format!("{name}: C_q v + C_t"), &own, &rate, TOLERANCE);
        let qd: Vec<f64> = ws.qd.iter().map(|x| -x).collect();
        near(&format!("{name}: -Q_d"), &qd, &second, TOLERANCE);
    }
}

#[test]
fn joints_without_parameters() {
    for kind in ["revolute", "prismatic", "weld", "distance", "pin-slot"] {
        for bodies in [["a", "b"], ["ground", "b"], ["a", "ground"]] {
            let mut joint = joint(kind, bodies, json!({}));
            if kind == "distance" {
                // Long, so that the direction turns slowly enough for the differences.
                joint["at"] = json!([[0.31, -0.12], [6.0, 0.19]]);
            }
            let parts = json!({"joint": [joint]});
            check(&format!("{kind} between {bodies:?}"), parts);
        }
    }
}

#[test]
fn gears() {
    for internal in [false, true] {
        for carrier in [Some("c"), None] {
            let mut gear = json!({"name": "G", "kind": "gear", "bodies": ["a", "b"],
                                  "radii": [0.3, 0.17], "internal": internal});
            if let Some(carrier) = carrier {
                gear["carrier"] = json!(carrier);
            }
            check(
                &format!("gear, internal {internal}, carrier {carrier:?}"),
                json!({"joint": [gear]}),
            );
        }
    }
}

#[test]
fn racks_and_rolling() {
    for kind in ["rack", "rolling-on-line"] {
        for side in ["left", "right"] {
            for bodies in [["a", "b"], ["ground", "b"], ["a", "ground"]] {
                let more = json!({"radius": 0.4, "side": side});
                let parts = json!({"joint": [joint(kind, bodies, more)]});
                check(&format!("{kind}, {side}, {bodies:?}"), parts);
            }
        }
    }
    for (radii, internal) in [([0.5, 0.2], false), ([0.5, 0.2], true), ([0.2, 0.5], true)] {
        for bodies in [["a", "b"], ["ground", "b"], ["a", "ground"]] {
            let more = json!({"radii": radii, "internal": internal});
            let parts = json!({"joint": [joint("rolling-on-circle", bodies, more)]});
            check(
                &format!("rolling on circle {radii:?}, internal {internal}, {bodies:?}"),
                parts,
            );
        }
    }
}

#[test]
fn cams() {
    let profiles = [
        json!({"radius": "0.3 m + 0.05 m * sin(2*phi) + 0.02 m * phi"}),
        json!({"x": "0.3 m * cos(phi) + 0.02 m * phi^2", "y": "0.2 m * sin(phi) - 0.03 m * cos(2*phi)"}),
    ];
    let followers = [
        json!({"kind": "knife-edge"}),
        json!({"kind": "roller", "radius": 0.11}),
        json!({"kind": "flat"}),
    ];
    for profile in &profiles {
        for follower in &followers {
            for bodies in [["a", "b"], ["ground", "b"], ["a", "ground"]] {
                let more = json!({"profile": profile, "follower": follower, "phi": 0.4});
                let parts = json!({"joint": [joint("cam", bodies, more)]});
                check(&format!("cam {profile} {follower} {bodies:?}"), parts);
            }
        }
    }
}

#[test]
fn fixed_coordinates_and_couplers() {
    for coordinate in ["x", "y", "angle"] {
        let fixed = json!({"name": "F", "kind": "fixed", "value": 0.3,
            "quantity": {"kind": "coordinate", "body": "b", "at": [0.2, 0.4], "coordinate": coordinate}});
        check(
            &format!("fixed {coordinate}"),
            json!({"constraint": [fixed]}),
        );
    }
    let coupler = json!({"name": "K", "kind": "coupler", "value": 0.2, "terms": [
        {"factor": 1.5, "kind": "angle", "joint": "R"},
        {"factor": -0.7, "kind": "displacement", "joint": "P"},
        {"factor": 0.4, "kind": "coordinate", "body": "c", "at": [0.1, -0.3], "coordinate": "y"},
        {"factor": 2.1, "kind": "relative-angle", "bodies": ["c", "b"]},
        {"factor": -1.2, "kind": "distance", "bodies": ["a", "c"], "at": [[0.1, 0.2], [6.5, -0.3]]}
    ]});
    let mut revolute = joint("revolute", ["a", "b"], json!({}));
    revolute["name"] = json!("R");
    let mut slide = joint("prismatic", ["c", "b"], json!({}));
    slide["name"] = json!("P");
    check(
        "coupler",
        json!({"joint": [revolute, slide], "constraint": [coupler]}),
    );
}

#[test]
fn user_expressions() {
    for expression in [
        "(a.x - b.x)^2 + 0.5 m * (a.y + b.y) * sin(a.angle - 2*b.angle) - 0.1 m^2 * cos(3 rad/s * t) * b.angle",
        "exp(0.3 * R.angle) * sqrt(1 m^2 + (tip.x - c.x)^2) - 0.2 m * t / 1 s",
    ] {
        let mut revolute = joint("revolute", ["a", "b"], json!({}));
        revolute["name"] = json!("R");
        let parts = json!({
            "trace": [{"name": "tip", "body": "b", "at": [0.4, -0.2]}],
            "joint": [revolute],
            "constraint": [{"name": "E", "kind": "expression", "expression": expression}]
        });
        check(expression, parts);
    }
}

#[test]
fn drivers() {
    let length = "0.2 m + 0.3 m * sin(1.5 rad/s * t) + 0.1 m/s^3 * t^3 / 1";
    let angle = "0.2 + 0.3 * sin(1.5 rad/s * t) + 0.4 * (t / 1 s)^3";
    let quantities = [
        (
            json!({"kind": "coordinate", "body": "b", "at": [0.3, 0.1], "coordinate": "x"}),
            true,
        ),
        (
            json!({"kind": "coordinate", "body": "b", "at": [0.3, 0.1], "coordinate": "y"}),
            true,
        ),
        (
            json!({"kind": "coordinate", "body": "b", "coordinate": "angle"}),
            false,
        ),
        (json!({"kind": "angle", "joint": "R"}), false),
        (json!({"kind": "displacement", "joint": "P"}), true),
        (
            json!({"kind": "relative-angle", "bodies": ["a", "b"]}),
            false,
        ),
        (
            json!({"kind": "distance", "bodies": ["a", "b"], "at": [[0.1, 0.2], [6.0, 0.1]]}),
            true,
        ),
    ];
    for (quantity, is_length) in quantities {
        let motions = if is_length {
            [
                json!({"value": length}),
                json!({"rate": "0.4 m/s * cos(1.5 rad/s * t)", "start": 0.3}),
            ]
        } else {
            [
                json!({"value": angle}),
                json!({"rate": "0.4 rad/s * cos(1.5 rad/s * t) + 0.2 rad/s", "start": 0.3}),
            ]
        };
        for motion in motions {
            let mut driver = quantity.clone();
            driver["name"] = json!("D");
            for (key, value) in motion.as_object().unwrap() {
                driver[key] = value.clone();
            }
            let mut revolute = joint("revolute", ["a", "b"], json!({}));
            revolute["name"] = json!("R");
            let mut slide = joint("prismatic", ["c", "b"], json!({}));
            slide["name"] = json!("P");
            check(
                &driver.to_string(),
                json!({"joint": [revolute, slide], "driver": [driver]}),
            );
        }
    }
    for from in [None, Some("c")] {
        let mut path = json!({"name": "D", "kind": "path", "body": "b", "at": [0.3, -0.2],
                              "x": length, "y": "0.4 m * cos(2 rad/s * t)"});
        if let Some(from) = from {
            path["from"] = json!(from);
            path["from_at"] = json!([0.2, 0.6]);
        }
        check(&path.to_string(), json!({"driver": [path]}));
    }
}

/// Potential energy of all force elements.
fn potential(system: &System<Planar>, t: f64, q: &[f64], v: &[f64]) -> f64 {
    let mut ws = Workspace::new(system);
    system.update_markers(q, v, &mut ws);
    let of = |markers: &[usize]| -> Vec<PlanarMarker> {
        markers.iter().map(|&m| ws.markers[m]).collect()
    };
    system
        .forces
        .iter()
        .map(|f| f.element.report(t, &of(&f.markers)).potential)
        .sum()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Q, v and the reports of the elements at random states.
fn at_random_states(
    system: &System<Planar>,
    mut look: impl FnMut(&State, &Workspace<Planar>, &[dalembert::force::ForceReport]),
) {
    let mut random = Random::new(SEED);
    for _ in 0..STATES {
        let state = random_state(system, &mut random);
        let ws = evaluated(system, &state);
        let reports: Vec<_> = system
            .forces
            .iter()
            .map(|f| {
                let markers: Vec<_> = f.markers.iter().map(|&m| ws.markers[m]).collect();
                f.element.report(state.t, &markers)
            })
            .collect();
        look(&state, &ws, &reports);
    }
}

/// Q = -dV/dq, V' = the reported rate, no power but that of V.
fn check_conservative(name: &str, parts: Value) {
    let system = system(parts);
    at_random_states(&system, |state, ws, reports| {
        let State { t, q, v } = state;
        for k in 0..system.nv() {
            let mut unit = vec![0.0; system.nv()];
            unit[k] = 1.0;
            let (slope, _) =
                differentiate(|s| vec![potential(&system, *t, &moved(q, &unit, s), v)]);
            let most = ws.force.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
            assert!(
                (ws.force[k] + slope[0]).abs() <= TOLERANCE * most,
                "{name}: Q[{k}] = {} for {}",
                ws.force[k],
                -slope[0]
            );
        }
        let rate: f64 = reports.iter().map(|r| r.potential_rate).sum();
        // Sums of a few products.
        assert!(
            (rate + dot(&ws.force, v)).abs() <= 1e-13 * rate.abs().max(1.0),
            "{name}: power"
        );
    });
}

/// The forces on all bodies add up to nothing, and their moments about the origin too.
fn check_balance(name: &str, parts: Value) {
    let system = system(parts);
    at_random_states(&system, |state, ws, _| {
        let mut sum = [0.0; 3];
        let mut most = 0.0_f64;
        for b in 0..system.bodies.len() {
            let (f, q) = (&ws.force[3 * b..3 * b + 3], &state.q[3 * b..3 * b + 3]);
            sum[0] += f[0];
            sum[1] += f[1];
            sum[2] += f[2] + q[0] * f[1] - q[1] * f[0];
            most = f.iter().fold(most, |m, x| m.max(x.abs()));
        }
        assert!(most > 1e-3, "{name} exerts nothing");
        assert!(
            sum.iter().all(|x| x.abs() <= 1e-14 * most.max(1.0) * 4.0),
            "{name}: {sum:?}"
        );
    });
}

/// Two-body elements with and without damping. The distance has long arms, so that it stays away from zero.
fn two_body_elements(damped: bool) -> Vec<(&'static str, Value)> {
    let on = |x: f64| if damped { x } else { 0.0 };
    let mut revolute = joint("revolute", ["a", "b"], json!({}));
    revolute["name"] = json!("R");
    let mut slide = joint("prismatic", ["a", "b"], json!({}));
    slide["name"] = json!("P");
    let mut bushing = joint(
        "bushing",
        ["a", "b"],
        json!({
            "stiffness": [[40.0, 5.0, -3.0], [5.0, 25.0, 2.0], [-3.0, 2.0, 8.0]]
        }),
    );
    if damped {
        bushing["damping"] = json!([[3.0, 0.4, -0.2], [0.1, 2.0, 0.3], [0.5, -0.6, 1.0]]);
    }
    vec![
        (
            "spring-damper",
            json!({"force": [{"name": "F", "kind": "spring-damper", "bodies": ["a", "b"],
            "at": [[0.1, 0.2], [4.0, 0.3]], "stiffness": 30.0, "damping": on(4.0), "free_length": 1.5}]}),
        ),
        (
            "torsion-spring",
            json!({"force": [{"name": "F", "kind": "torsion-spring", "bodies": ["a", "b"],
            "stiffness": 30.0, "damping": on(4.0), "free_angle": 0.4}]}),
        ),
        (
            "joint-spring on a pin",
            json!({"joint": [revolute], "force": [{"name": "F", "kind": "joint-spring",
            "joint": "R", "stiffness": 30.0, "damping": on(4.0), "free": 0.4}]}),
        ),
        (
            "joint-spring on a slide",
            json!({"joint": [slide], "force": [{"name": "F", "kind": "joint-spring",
            "joint": "P", "stiffness": 30.0, "damping": on(4.0), "free": 0.4}]}),
        ),
        ("bushing", json!({"force": [bushing]})),
    ]
}

#[test]
fn springs_have_potentials() {
    for (name, parts) in two_body_elements(false) {
        check_conservative(name, parts);
    }
    let gravity = json!({"force": [{"name": "G", "kind": "point-gravity", "body": "a", "mu": 3.0,
                                    "center": [4.0, -3.0]}]});
    check_conservative("point gravity", gravity);
}

#[test]
fn two_body_elements_balance() {
    let mut revolute = joint("revolute", ["a", "b"], json!({}));
    revolute["name"] = json!("R");
    let mut slide = joint("prismatic", ["a", "b"], json!({}));
    slide["name"] = json!("P");
    let mut all = two_body_elements(true);
    all.push(("moment actuator", json!({"joint": [revolute], "force": [
        {"name": "A", "kind": "actuator", "joint": "R", "value": "3 N*m + 1 N*m * sin(R.angle) * t / 1 s"}]})));
    all.push(("force actuator", json!({"joint": [slide], "force": [
        {"name": "A", "kind": "actuator", "joint": "P", "value": "3 N - 2 N*s/m * P.displacement_rate"}]})));
    all.push(("spring with an expression", json!({"force": [
        {"name": "F", "kind": "spring-damper", "bodies": ["a", "b"], "at": [[0.1, 0.2], [4.0, 0.3]],
         "stiffness": "30 N/m * (1 + (a.x / 1 m)^2)", "free_length": 1.5, "force": "2 N * cos(t * 1 rad/s)"}]})));
    for (name, parts) in all {
        check_balance(name, parts);
    }
}

/// Q.v = -V' - dissipation with the dissipation c x'^2, x' by differences of the reported x.
#[test]
fn dampers_dissipate() {
    for (name, parts) in two_body_elements(true) {
        let system = system(parts);
        at_random_states(&system, |state, ws, reports| {
            let pose = |s: f64| {
                let mut ws = Workspace::new(&system);
                system.update_markers(&moved(&state.q, &state.v, s), &state.v, &mut ws);
                let f = &system.forces[0];
                let markers: Vec<_> = f.markers.iter().map(|&m| ws.markers[m]).collect();
                if name == "bushing" {
                    let d = markers[1].point - markers[0].point;
                    let (ex, ey) = (markers[0].ex, markers[0].ey());
                    vec![ex.dot(&d), ey.dot(&d), markers[1].angle - markers[0].angle]
                } else {
                    vec![f.element.report(state.t, &markers).values[0]]
                }
            };
            let (x, _) = differentiate(pose);
            let dissipation = if name == "bushing" {
                let c = [[3.0, 0.4, -0.2], [0.1, 2.0, 0.3], [0.5, -0.6, 1.0]];
                (0..3)
                    .map(|i| (0..3).map(|j| x[i] * c[i][j] * x[j]).sum::<f64>())
                    .sum::<f64>()
            } else {
                4.0 * x[0] * x[0]
            };
            assert!(dissipation > 0.0);
            let (rate, _) = differentiate(|s| {
                vec![potential(
                    &system,
                    state.t,
                    &moved(&state.q, &state.v, s),
                    &state.v,
                )]
            });
            near(name, &[reports[0].potential_rate], &rate, TOLERANCE);
            let power = dot(&ws.force, &state.v);
            let most = power.abs().max(rate[0].abs()).max(1.0);
            assert!(
                (power + rate[0] + dissipation).abs() <= TOLERANCE * most,
                "{name}: {power}"
            );
            // What the element itself reports as its power.
            assert!(
                (power - reports[0].values[3]).abs() <= 1e-13 * most,
                "{name}: {power}"
            );
        });
    }
}

#[test]
fn stiffness_that_is_not_symmetric_has_the_potential_of_its_symmetric_part() {
    let bushing = joint(
        "bushing",
        ["a", "b"],
        json!({
            "stiffness": [[40.0, 9.0, -3.0], [1.0, 25.0, 2.0], [-3.0, 2.0, 8.0]]
        }),
    );
    let skew = system(json!({"force": [bushing]}));
    let even = joint(
        "bushing",
        ["a", "b"],
        json!({
            "stiffness": [[40.0, 5.0, -3.0], [5.0, 25.0, 2.0], [-3.0, 2.0, 8.0]]
        }),
    );
    let even = system(json!({"force": [even]}));
    at_random_states(&skew, |state, _, reports| {
        let expected = potential(&even, state.t, &state.q, &state.v);
        near("potential", &[reports[0].potential], &[expected], 1e-15);
    });
    check_balance(
        "skew bushing",
        json!({"force": [joint("bushing", ["a", "b"], json!({
            "stiffness": [[40.0, 9.0, -3.0], [1.0, 25.0, 2.0], [-3.0, 2.0, 8.0]]
        }))]}),
    );
}

/// The power of a force at a point is F . r', by differences of the point's position; a follower force turns with
/// its body.
#[test]
fn point_forces_have_the_power_of_their_point() {
    for axes in ["ground", "body"] {
        let at = [0.4, -0.3];
        let system = system(json!({
            "trace": [{"name": "P", "body": "b", "at": at}],
            "force": [{"name": "F", "kind": "force", "body": "b", "at": at, "axes": axes,
                       "value": ["3 N + 1 N * t / 1 s", "-2 N * cos(b.angle)"]},
                      {"name": "M", "kind": "moment", "body": "b", "value": "1.5 N*m * sin(a.angle)"}]
        }));
        let body = system.bodies.iter().position(|b| b.name == "b").unwrap();
        at_random_states(&system, |state, ws, reports| {
            let (r, _) = differentiate(|s| {
                let mut ws = Workspace::new(&system);
                system.update_markers(&moved(&state.q, &state.v, s), &state.v, &mut ws);
                let p = ws.markers[system.traces[0].marker].point;
                vec![p.x, p.y]
            });
            let angle = state.q[3 * body + 2];
            let (x, y) = (3.0 + state.t, -2.0 * angle.cos());
            let (s, c) = if axes == "body" {
                angle.sin_cos()
            } else {
                (0.0, 1.0)
            };
            let (fx, fy) = (c * x - s * y, s * x + c * y);
            let moment = 1.5 * state.q[2].sin() * state.v[3 * body + 2];
            let expected = fx * r[0] + fy * r[1] + moment;
            near(axes, &[dot(&ws.force, &state.v)], &[expected], TOLERANCE);
            near(
                axes,
                &[reports[0].values[2] + reports[1].values[1]],
                &[expected],
                TOLERANCE,
            );
            // Only the named body is pushed.
            assert!(
                ws.force[..3 * body]
                    .iter()
                    .chain(&ws.force[3 * body + 3..])
                    .all(|f| *f == 0.0)
            );
        });
    }
}

#[test]
fn gravity_acts_at_centres_of_mass() {
    let model = json!({"model": {"name": "test", "gravity": [1.0, -9.0]}, "body": bodies()});
    let system = compiled(model).system.running();
    let mut random = Random::new(SEED);
    let state = random_state(&system, &mut random);
    let ws = evaluated(&system, &state);
    let masses = [2.0, 1.5, 0.7];
    for (b, m) in masses.into_iter().enumerate() {
        assert_eq!(ws.force[3 * b..3 * b + 3], [m * 1.0, m * -9.0, 0.0]);
    }
}
