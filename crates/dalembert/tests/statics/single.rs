//! One body: closed forms.

use crate::common::{G, close, pendulum, run, run_both, slide, system, value};
use dalembert::analysis::{Stability, Statics};
use serde_json::json;
use std::f64::consts::{FRAC_PI_2, PI};

/// M = m g l/2 cos(angle): the lower of the two poses is the stable one.
#[test]
fn a_pendulum_with_a_moment_has_two_equilibria() {
    for moment in [0.0, 3.0, -5.0, 9.8] {
        let s = pendulum(0.3, moment);
        let report = run_both(&s);
        assert_eq!(
            report.equilibria.len(),
            2,
            "{moment}: {:?}",
            report.equilibria
        );
        let most = 2.0 * G * 0.5;
        let expected = -(moment / most).acos();
        let turned = |a: f64| (a - expected).rem_euclid(2.0 * PI);
        let off = turned(value(&report, "bob.angle"));
        // The slope at the equilibrium, sqrt(most^2 - M^2), sets how well the angle is known.
        assert!(off.min(2.0 * PI - off) < 1e-12, "{moment}: {off:e}");
        let e = &report.equilibria[0];
        assert_eq!(e.stability, Stability::Stable);
        assert_eq!(report.equilibria[1].stability, Stability::Unstable);
        assert!(e.conservative);
        // K = m g l/2 |sin| for a turn of one radian, in which the centre moves half a metre.
        let share = 1.0 + (0.5 / s.size).powi(2);
        close(
            e.stiffness[0] * share,
            most * expected.sin().abs(),
            1e-7 * most,
        );
        // The pin carries the weight.
        close(value(&report, "O.force_x"), 0.0, 1e-10);
        close(value(&report, "O.force_y"), 2.0 * G, 1e-10);
        close(value(&report, "O.moment"), 0.0, 1e-10);
        close(value(&report, "bob.alpha"), 0.0, 0.0);
    }
}

#[test]
fn an_estimate_in_equilibrium_is_the_answer_even_where_it_is_unstable() {
    let report = run_both(&pendulum(FRAC_PI_2, 0.0));
    let e = &report.equilibria[0];
    close(e.q[2], FRAC_PI_2, 1e-15);
    assert_eq!(e.stability, Stability::Unstable);
    assert_eq!(e.motions, ["unstable: bob turns"]);
    assert_eq!(report.equilibria[1].stability, Stability::Stable);
    close(report.equilibria[1].distance, PI, 1e-12);
}

#[test]
fn without_further_starts_only_the_surroundings_are_searched() {
    let s = pendulum(0.3, 0.0);
    let report = Statics {
        starts: Some(0),
        ..Statics::default()
    }
    .run(&s)
    .unwrap();
    assert_eq!(report.starts, 1);
    assert_eq!(report.equilibria[0].stability, Stability::Stable);
}

fn hanging(
    gravity: f64,
    stiffness: f64,
    start: f64,
) -> dalembert::system::System<dalembert::space::Planar> {
    system(json!({
        "model": {"name": "spring and mass", "gravity": [0.0, -gravity]},
        "body": [{"name": "mass", "mass": 3.0, "inertia": 0.1, "position": [0.0, start]}],
        "joint": [slide("guide", "mass", [0.0, 0.0], FRAC_PI_2)],
        "force": [{"name": "spring", "kind": "spring-damper", "bodies": ["ground", "mass"],
            "at": [[0.0, 2.0], [0.0, 0.0]], "stiffness": stiffness, "damping": 7.0,
            "free_length": 0.5}]
    }))
}

#[test]
fn a_mass_hangs_on_its_spring() {
    for (gravity, stiffness) in [(G, 100.0), (G, 1e7), (0.0, 100.0), (G, 60.0)] {
        let report = run_both(&hanging(gravity, stiffness, 0.9));
        let expected = 2.0 - 0.5 - 3.0 * gravity / stiffness;
        close(value(&report, "mass.y"), expected, 1e-12);
        assert_eq!(report.equilibria[0].stability, Stability::Stable);
        close(value(&report, "spring.force"), 3.0 * gravity, 1e-8);
        close(value(&report, "guide.force_y"), 0.0, 1e-8);
    }
}

#[test]
fn a_torsion_spring_makes_whole_turns_differ() {
    // k angle = m g l/2 ... has several roots where the spring is soft; each lies at its own turn.
    let s = system(json!({
        "model": {"name": "wound pendulum", "gravity": [0.0, -G]},
        "body": [crate::common::rod("bob", 2.0, 1.0, [0.0, 0.0], -1.5)],
        "joint": [crate::common::pin("O", ["ground", "bob"], [[0.0, 0.0], [-0.5, 0.0]])],
        "force": [{"name": "k", "kind": "torsion-spring", "bodies": ["ground", "bob"],
            "stiffness": 0.4, "free_angle": -FRAC_PI_2}]
    }));
    let report = run(&s);
    assert_eq!(report.equilibria[0].stability, Stability::Stable);
    close(value(&report, "bob.angle"), -FRAC_PI_2, 1e-12);
    // Every one found satisfies the closed form m g l/2 cos(angle) + k (angle + pi/2) = 0.
    assert!(report.equilibria.len() > 2, "{}", report.equilibria.len());
    for e in &report.equilibria {
        let a = e.q[2];
        close(G * a.cos() + 0.4 * (a + FRAC_PI_2), 0.0, 1e-8);
        let slope = -G * a.sin() + 0.4;
        let expected = if slope > 0.0 {
            Stability::Stable
        } else {
            Stability::Unstable
        };
        assert_eq!(e.stability, expected);
    }
}

#[test]
fn a_driver_stands_still_at_the_start() {
    let s = system(json!({
        "model": {"name": "held", "gravity": [0.0, -G]},
        "body": [crate::common::rod("arm", 2.0, 1.0, [0.0, 0.0], 0.4)],
        "joint": [crate::common::pin("O", ["ground", "arm"], [[0.0, 0.0], [-0.5, 0.0]])],
        "driver": [{"name": "motor", "kind": "angle", "joint": "O", "value": "0.5 + 3 * t"}],
        "analysis": {"start": 0.1, "end": 1.0}
    }));
    let report = run_both(&s);
    assert_eq!(report.freedoms, 0);
    close(report.time, 0.1, 0.0);
    close(value(&report, "time"), 0.1, 0.0);
    close(value(&report, "arm.angle"), 0.8, 1e-12);
    close(
        value(&report, "motor.moment"),
        2.0 * G * 0.5 * 0.8_f64.cos(),
        1e-11,
    );
    assert_eq!(report.equilibria[0].stability, Stability::Stable);
}

#[test]
fn what_nothing_pushes_is_neutral() {
    let s = system(json!({
        "model": {"name": "free", "gravity": [0.0, 0.0]},
        "body": [{"name": "stone", "mass": 1.0, "inertia": 1.0, "position": [1.0, 2.0]}]
    }));
    let report = run_both(&s);
    assert_eq!(report.equilibria.len(), 1);
    assert_eq!(report.equilibria[0].stability, Stability::Neutral);
    assert_eq!(
        report.equilibria[0].motions,
        ["neutral along stone.x, stone.y, stone.angle: stone moves and turns"]
    );
    assert_eq!(report.equilibria[0].q, [1.0, 2.0, 0.0]);

    let s = system(json!({
        "model": {"name": "level slide", "gravity": [0.0, -G]},
        "body": [{"name": "sled", "mass": 1.0, "inertia": 1.0, "position": [0.3, 0.0]}],
        "joint": [slide("rail", "sled", [0.0, 0.0], 0.0)]
    }));
    let report = run_both(&s);
    assert_eq!(report.equilibria.len(), 1);
    assert_eq!(
        report.equilibria[0].motions,
        ["neutral along rail.displacement: sled slides"]
    );
    close(value(&report, "rail.force_y"), G, 1e-12);
}

#[test]
fn a_report_can_be_written_and_read() {
    let report = run(&pendulum(0.3, 1.0));
    // Through values, not text: the parser of this JSON library rounds the last digit.
    let value = serde_json::to_value(&report).unwrap();
    let back: dalembert::analysis::StaticsReport = serde_json::from_value(value).unwrap();
    assert_eq!(report, back);
    let state = report.state(0).unwrap();
    assert_eq!(state.q, report.first().unwrap().q);
    assert!(report.state(2).is_none());
}
