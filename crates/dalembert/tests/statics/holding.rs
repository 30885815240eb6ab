//! Loads that hold a given pose (Shabana 5.6).

use crate::common::{G, at, close, pin, rod, slide, system};
use dalembert::analysis::{AnalysisError, HoldingLoads, Unknown, holding_loads};
use dalembert::space::Planar;
use dalembert::system::System;
use serde_json::json;

fn hold(system: &System<Planar>, unknowns: &[Unknown]) -> Result<HoldingLoads, AnalysisError> {
    holding_loads(system, &system.estimate, unknowns)
}

fn effort(name: &str) -> Unknown {
    Unknown::Effort(name.to_owned())
}

fn force(name: &str) -> Unknown {
    Unknown::Force(name.to_owned())
}

/// Equation 5.116: crank moment against a slider force and gravity, with all pin forces.
#[test]
fn the_crank_moment_of_a_slider_crank() {
    let (l2, l3, angle) = (0.2, 0.4, std::f64::consts::FRAC_PI_4);
    let phi = -0.3613671239067078_f64;
    let tip = [l2 * angle.cos(), l2 * angle.sin()];
    let model = |driver: bool| {
        let mut model = json!({
            "model": {"name": "slider crank", "gravity": [0.0, -G]},
            "body": [rod("crank", 0.5, l2, [0.0, 0.0], angle), rod("rod", 0.8, l3, tip, phi),
                     {"name": "slider", "mass": 1.0, "inertia": 0.1, "position": [tip[0] + l3 * phi.cos(), 0.0]}],
            "joint": [pin("O", ["ground", "crank"], [[0.0, 0.0], [-l2 / 2.0, 0.0]]),
                      pin("A", ["crank", "rod"], [[l2 / 2.0, 0.0], [-l3 / 2.0, 0.0]]),
                      pin("B", ["rod", "slider"], [[l3 / 2.0, 0.0], [0.0, 0.0]]),
                      slide("guide", "slider", [0.0, 0.0], 0.0)],
            "force": [{"name": "F4", "kind": "force", "body": "slider", "value": [-30.0, 0.0]},
                      {"name": "M2", "kind": "moment", "body": "crank", "value": 1.0}]
        });
        if driver {
            model["driver"] =
                json!([{"name": "motor", "kind": "angle", "joint": "O", "value": angle}]);
        }
        system(model)
    };
    // By an actuator in the pin (whose model moment of 1 N m then stays), by the moment itself, and
    // by a driver.
    for (driver, unknown, expected) in [
        (false, effort("O"), -4.944434860546627 - 1.0),
        (false, force("M2"), -4.944434860546627),
        (true, effort("motor"), -4.944434860546627 - 1.0),
    ] {
        let held = hold(&model(driver), std::slice::from_ref(&unknown)).unwrap();
        close(held.loads[0].value, expected, 1e-11);
        assert!(held.loads[0].unique);
        assert_eq!(held.loads[0].unit, "N m");
        for (joint, f) in [
            ("O", [30.0, -2.509934190276815]),
            ("A", [30.0, -7.414934190276815]),
            ("B", [30.0, -15.262934190276816]),
        ] {
            close(
                at(&held.results, &format!("{joint}.force_x"), 0),
                f[0],
                1e-11,
            );
            close(
                at(&held.results, &format!("{joint}.force_y"), 0),
                f[1],
                1e-11,
            );
        }
        if driver {
            close(at(&held.results, "motor.moment", 0), expected, 1e-11);
        }
    }
}

/// Example 5.7: M4 = l4 sin(th3 - th4)/(l2 sin(th2 - th3)) M2, M2 clockwise, no gravity.
#[test]
fn the_rocker_moment_of_a_four_bar() {
    let (l1, l2, l3, l4, th2) = (0.35_f64, 0.2_f64, 0.4_f64, 0.3_f64, 1.2217304763960306_f64);
    let a = [l2 * th2.cos(), l2 * th2.sin()];
    // The upper intersection of the circles about A and about the rocker's pin.
    let (dx, dy) = (l1 - a[0], -a[1]);
    let d = dx.hypot(dy);
    let th3 = dy.atan2(dx) + ((l3 * l3 + d * d - l4 * l4) / (2.0 * l3 * d)).acos();
    let b = [a[0] + l3 * th3.cos(), a[1] + l3 * th3.sin()];
    let th4 = b[1].atan2(b[0] - l1);
    let s = system(json!({
        "model": {"name": "four-bar", "gravity": [0.0, 0.0]},
        "body": [rod("crank", 1.0, l2, [0.0, 0.0], th2), rod("coupler", 1.0, l3, a, th3), rod("rocker", 1.0, l4, [l1, 0.0], th4)],
        "joint": [pin("O", ["ground", "crank"], [[0.0, 0.0], [-l2 / 2.0, 0.0]]),
                  pin("A", ["crank", "coupler"], [[l2 / 2.0, 0.0], [-l3 / 2.0, 0.0]]),
                  pin("B", ["coupler", "rocker"], [[l3 / 2.0, 0.0], [l4 / 2.0, 0.0]]),
                  pin("C", ["ground", "rocker"], [[l1, 0.0], [-l4 / 2.0, 0.0]])],
        "force": [{"name": "M2", "kind": "moment", "body": "crank", "value": -10.0}]
    }));
    let held = hold(&s, &[effort("C")]).unwrap();
    close(held.loads[0].value, 14.82021991825736, 1e-10);
    // The book's th4 points from B to C, half a turn away from the rocker's own angle.
    let book = th4 + std::f64::consts::PI;
    close(
        held.loads[0].value,
        10.0 * l4 * (th3 - book).sin() / (l2 * (th2 - th3).sin()),
        1e-10,
    );
}

fn two_arm(direction: f64, gravity: f64) -> System<Planar> {
    let (l2, l3, th2, th3) = (1.0, 0.8, 0.8726646259971648_f64, 0.3490658503988659_f64);
    let frame = |name: &str, mass: f64, center: f64, at: [f64; 2], angle: f64| json!({"name": name, "mass": mass, "inertia": 0.1, "center": [center, 0.0], "position": at, "angle": angle});
    system(json!({
        "model": {"name": "arm", "gravity": [0.0, -gravity]},
        "body": [frame("two", 2.0, 0.4, [0.0, 0.0], th2), frame("three", 1.5, 0.35, [l2 * th2.cos(), l2 * th2.sin()], th3)],
        "joint": [pin("O", ["ground", "two"], [[0.0, 0.0], [0.0, 0.0]]),
                  pin("A", ["two", "three"], [[l2, 0.0], [0.0, 0.0]])],
        "force": [{"name": "F3", "kind": "force", "body": "three", "at": [l3, 0.0],
                   "value": [3.0 * direction.cos(), 3.0 * direction.sin()]},
                  {"name": "M2", "kind": "moment", "body": "two", "value": 1.0}]
    }))
}

/// Example 5.8: moment on link 2 and size of a tip force of known direction.
#[test]
fn a_two_arm_manipulator_held_at_its_tip() {
    let held = hold(&two_arm(1.3089969389957472, G), &[force("F3"), force("M2")]).unwrap();
    close(held.loads[0].value, 7.385155103292437, 1e-10);
    close(held.loads[1].value, 11.382115424918481, 1e-10);
    assert_eq!(
        (held.loads[0].unit.as_str(), held.loads[1].unit.as_str()),
        ("N", "N m")
    );
    assert!(held.results.channel("F3.force_x").is_none());
}

/// Along the last link no tip force holds its weight; without gravity any size does.
#[test]
fn a_tip_force_along_the_link_holds_nothing() {
    let along = 0.3490658503988659;
    let error = hold(&two_arm(along, G), &[force("F3"), force("M2")]).unwrap_err();
    assert!(
        matches!(error, AnalysisError::NoEquilibrium { .. }),
        "{error}"
    );
    let held = hold(&two_arm(along, 0.0), &[force("F3"), force("M2")]).unwrap();
    assert!(!held.loads[0].unique);
    close(held.loads[0].value, 0.0, 1e-12);
}

/// Problems 5.16 and 5.17 (geometry assumed): a pinned rod at 45 deg, a force at its end at 60 deg.
#[test]
fn a_pinned_rod() {
    let angle = std::f64::consts::FRAC_PI_4;
    let phi = 1.0471975511965976_f64;
    let model = |gravity: f64, moment: f64| {
        system(json!({
            "model": {"name": "rod", "gravity": [0.0, -gravity]},
            "body": [rod("rod", 1.0, 1.0, [0.0, 0.0], angle)],
            "joint": [pin("O", ["ground", "rod"], [[0.0, 0.0], [-0.5, 0.0]])],
            "force": [{"name": "F", "kind": "force", "body": "rod", "at": [0.5, 0.0], "value": [5.0 * phi.cos(), 5.0 * phi.sin()]},
                      {"name": "M", "kind": "moment", "body": "rod", "value": moment},
                      {"name": "weight", "kind": "force", "body": "rod", "value": [0.0, -1.0]}]
        }))
    };
    let held = hold(&model(0.0, 3.0), &[force("weight")]).unwrap();
    close(held.loads[0].value, 12.145535412082955, 1e-11);
    // The unit weight in the model is part of the load in 5.16.
    let held = hold(&model(G - 1.0, 3.0), &[force("M")]).unwrap();
    close(held.loads[0].value, 2.1742635362074125, 1e-11);
    // An actuator in the pin does the same, on top of the 3 N m.
    let held = hold(&model(G - 1.0, 3.0), &[effort("O")]).unwrap();
    close(held.loads[0].value, 2.1742635362074125 - 3.0, 1e-11);
}

/// Problem 5.20 (dimensions assumed): static moments on three links; as actuators of the joints they
/// are sums of these.
#[test]
fn a_three_link_chain() {
    let angles = [
        std::f64::consts::FRAC_PI_4,
        std::f64::consts::FRAC_PI_6,
        std::f64::consts::FRAC_PI_4,
    ];
    let names = ["one", "two", "three"];
    let (mut from, mut bodies, mut joints, mut forces) = ([0.0, 0.0], vec![], vec![], vec![]);
    for (k, angle) in angles.into_iter().enumerate() {
        bodies.push(rod(names[k], 1.0, 1.0, from, angle));
        from = [from[0] + angle.cos(), from[1] + angle.sin()];
        let (before, at) = if k == 0 {
            ("ground", [0.0, 0.0])
        } else {
            (names[k - 1], [0.5, 0.0])
        };
        joints.push(pin(&format!("J{k}"), [before, names[k]], [at, [-0.5, 0.0]]));
        forces.push(
            json!({"name": format!("M{k}"), "kind": "moment", "body": names[k], "value": 1.0}),
        );
    }
    forces.push(
        json!({"name": "F", "kind": "force", "body": "three", "at": [0.5, 0.0],
                       "value": [6.92820323027551, 3.9999999999999996]}),
    );
    let s = system(
        json!({"model": {"name": "chain", "gravity": [0.0, -G]}, "body": bodies, "joint": joints, "force": forces}),
    );
    let moments = [19.412346169420246, 12.743563816688017, 5.538911122540182];
    let held = hold(&s, &[force("M0"), force("M1"), force("M2")]).unwrap();
    for (load, m) in held.loads.iter().zip(moments) {
        close(load.value, m, 1e-10);
    }
    let held = hold(&s, &[effort("J0"), effort("J1"), effort("J2")]).unwrap();
    for (k, load) in held.loads.iter().enumerate() {
        // The unit moments of the model act beside the actuators.
        let sum: f64 = moments[k..].iter().map(|m| m - 1.0).sum();
        close(load.value, sum, 1e-10);
    }
}

#[test]
fn names_that_do_not_fit_are_reported() {
    let s = two_arm(1.0, G);
    for unknown in [
        effort("nowhere"),
        force("nowhere"),
        effort("M2"),
        force("O"),
    ] {
        let error = hold(&s, std::slice::from_ref(&unknown)).unwrap_err();
        let AnalysisError::BadName { name, .. } = error else {
            panic!("{error}");
        };
        assert_eq!(name, unknown.name());
    }
}

/// A driver that holds what the load is to hold gives way to it; of two that could, neither is chosen.
#[test]
fn a_driver_gives_way_to_the_load_that_is_asked_for() {
    let pendulum = |drivers: serde_json::Value, further: serde_json::Value| {
        let mut joints = vec![pin("O", ["ground", "bar"], [[0.0, 0.0], [-0.5, 0.0]])];
        joints.extend(further.as_array().unwrap().clone());
        system(json!({
            "model": {"name": "bar", "gravity": [0.0, -G]},
            "body": [rod("bar", 2.0, 1.0, [0.0, 0.0], 0.0), rod("tip", 1.0, 1.0, [1.0, 0.0], 0.0)],
            "joint": joints,
            "driver": drivers,
        }))
    };
    let hinge = json!([pin("A", ["bar", "tip"], [[0.5, 0.0], [-0.5, 0.0]])]);
    let drive = |name: &str, joint: &str| json!({"name": name, "kind": "angle", "joint": joint, "value": 0.0});
    // Both pins are driven: only the driver of O gives way, A stays held.
    let machine = pendulum(json!([drive("one", "O"), drive("two", "A")]), hinge);
    let held = hold(&machine, &[effort("O")]).unwrap();
    assert_eq!(held.released, ["one"]);
    assert!(held.loads[0].unique);
    close(held.loads[0].value, G * (2.0 * 0.5 + 1.0 * 1.5), 1e-11);
    assert!(held.results.notes[0].contains("driver one"));
    // Asked for a driver, nothing else gives way.
    let own = hold(&machine, &[effort("one")]).unwrap();
    assert!(own.released.is_empty());
    close(own.loads[0].value, held.loads[0].value, 1e-11);
}
