//! Force elements: potentials, power, action and reaction.

use super::*;

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
