//! Mobility by rank, redundant rows, free motions, conflicts, singular poses of drivers.

mod machines;

use dalembert::analysis::{
    Assembly, Mobility, MobilityReport, SingularKind, SweepOptions, conflicts, driver_singularities,
};
use dalembert::space::Planar;
use dalembert::system::System;
use machines::{
    Machine, double_parallelogram, four_bar, peaucellier, ring, slider_crank, slider_crank_at,
    tracked_vehicle,
};
use serde_json::json;
use std::f64::consts::{FRAC_PI_2, PI};

fn report_of(system: &System<Planar>) -> MobilityReport {
    let (state, _) = Assembly::default().run(system).unwrap();
    Mobility::default().run(system, &state).unwrap()
}

fn report(machine: Machine) -> MobilityReport {
    report_of(&machine.system())
}

fn drive_angle(joint: &str, value: &str) -> serde_json::Value {
    json!({ "name": "motor", "kind": "angle", "joint": joint, "value": value })
}

#[test]
fn slider_crank_has_one_freedom() {
    let r = report(slider_crank(0.2, 0.5, 0.6));
    assert_eq!((r.coordinates, r.mobility.rows), (9, 8));
    assert_eq!((r.mobility.count, r.mobility.rank, r.freedoms()), (1, 8, 1));
    assert!(r.redundant.is_empty() && r.reactions_not_unique.is_empty());
    assert_eq!(r.motions.len(), 1);
    assert_eq!(
        r.motions[0].to_string(),
        "O.angle: crank turns, rod moves and turns, slider slides"
    );
}

#[test]
fn a_driven_slider_crank_has_none() {
    let r = report(slider_crank(0.2, 0.5, 0.6).driver(drive_angle("O", "0.6 + 3 * t")));
    assert_eq!((r.freedoms(), r.freedoms_left()), (1, 0));
    assert!(r.over_driven.is_empty() && !r.is_singular());
    assert!(r.to_string().contains("every motion is driven"), "{r}");
}

#[test]
fn four_bar_has_one_freedom() {
    let r = report(four_bar());
    assert_eq!((r.mobility.count, r.freedoms()), (1, 1));
    assert_eq!(
        r.motions[0].to_string(),
        "O.angle: crank turns, coupler moves and turns, rocker turns"
    );
}

#[test]
fn double_parallelogram_moves_although_the_count_is_zero() {
    let r = report(double_parallelogram(1.0));
    assert_eq!(
        (r.coordinates, r.mobility.rows, r.mobility.count),
        (12, 12, 0)
    );
    assert_eq!((r.mobility.rank, r.freedoms()), (11, 1));
    assert_eq!(r.mobility.generic_rank, 11);
    assert!(!r.is_singular() && !r.locked && r.singular.is_empty());
    assert_eq!(r.redundant.len(), 1);
    assert_eq!(r.redundant[0].element, "J6");
    assert_eq!(r.redundant[0].depends_on.len(), 5);
    // The coupler stays parallel to itself.
    assert!(r.motions[0].to_string().contains("coupler moves"), "{r}");
    assert!(
        !r.motions[0].to_string().contains("coupler moves and turns"),
        "{r}"
    );
    // Forces along the rockers can be shared in more than one way by all three of them.
    assert_eq!(r.reactions_not_unique.len(), 6, "{r}");
}

#[test]
fn driving_a_parallelogram_twice_is_named() {
    let r = report(
        double_parallelogram(1.0)
            .driver(
                json!({ "name": "first", "kind": "coordinate", "body": "rocker 1",
                "coordinate": "angle", "value": 1.0 }),
            )
            .driver(
                json!({ "name": "second", "kind": "coordinate", "body": "rocker 2",
                "coordinate": "angle", "value": 1.0 }),
            ),
    );
    assert_eq!(r.freedoms_left(), 0);
    assert_eq!(r.over_driven.len(), 1);
    assert_eq!(r.over_driven[0].element, "second");
    assert!(r.over_driven[0].depends_on.contains(&"first".to_owned()));
    assert!(r.dead_drivers.is_empty());
}

#[test]
fn a_free_body_is_free_in_x_y_and_angle() {
    let r = report(
        four_bar().body(json!({ "name": "ball", "mass": 1, "inertia": 1, "position": [3, 3] })),
    );
    assert_eq!((r.mobility.count, r.freedoms()), (4, 4));
    let words: Vec<String> = r.motions.iter().map(ToString::to_string).collect();
    assert_eq!(words.len(), 2);
    assert_eq!(words[1], "body ball is free in x, y and angle");
    assert!(
        r.warnings
            .iter()
            .any(|w| w.contains("nothing connects ball"))
    );

    let alone = report(Machine::default().body(json!({ "name": "ball", "mass": 1, "inertia": 1 })));
    assert_eq!((alone.freedoms(), alone.mobility.rows), (3, 0));
    assert_eq!(
        alone.motions[0].to_string(),
        "body ball is free in x, y and angle"
    );
    assert!(alone.warnings.is_empty());
}

#[test]
fn a_floating_hexagon_has_six_freedoms() {
    let r = report(ring(Machine::default(), 6, [0.3, 0.2], 1.0));
    assert_eq!((r.coordinates, r.mobility.rank, r.freedoms()), (18, 12, 6));
    let count: usize = r.motions.iter().map(|m| m.coordinates.len()).sum();
    assert_eq!(count, 6);
    assert!(
        r.motions
            .iter()
            .any(|m| m.rigid && m.bodies.len() == 6 && m.coordinates.len() == 3)
    );
}

#[test]
fn tracked_vehicle_counts() {
    let r = report(tracked_vehicle());
    // The book counts the ground among its 54 bodies, with three constraints.
    assert_eq!((r.bodies, r.coordinates), (53, 162 - 3));
    assert_eq!(
        (r.mobility.rows, r.mobility.rank, r.freedoms()),
        (104, 107 - 3, 55)
    );
    let driven = report(tracked_vehicle().driver(drive_angle("pin of sprocket", "2 * t")));
    assert_eq!((driven.freedoms(), driven.freedoms_left()), (55, 54));
    assert_eq!(driven.coordinates + driven.driven.rows, 270 - 6);
}

#[test]
fn peaucellier_has_one_freedom() {
    let r = report(peaucellier());
    assert_eq!((r.coordinates, r.mobility.rows), (21, 20));
    assert_eq!((r.freedoms(), r.mobility.count), (1, 1));
    assert!(r.redundant.is_empty());
}

#[test]
fn a_massless_slider_is_held_and_a_massless_pendulum_is_not() {
    let light = |joint: serde_json::Value| {
        Machine::default()
            .bar("crank", [0.0, 0.0], [0.2, 0.0])
            .bar("rod", [0.2, 0.0], [0.7, 0.0])
            .body(json!({ "name": "light", "position": [0.7, 0.0] }))
            .pin("O", "ground", "crank", [0.0, 0.0])
            .pin("A", "crank", "rod", [0.2, 0.0])
            .pin("B", "rod", "light", [0.7, 0.0])
            .joint(joint)
    };
    let slide = json!({ "name": "S", "kind": "prismatic", "bodies": ["ground", "light"],
        "point": [0.7, 0.0], "direction": [1, 0] });
    let r = report(light(slide));
    assert!(r.massless.is_empty(), "{r}");

    // Held by the rod's end and a pin in a slot: its angle has neither mass nor constraint.
    let slot = json!({ "name": "S", "kind": "pin-slot", "bodies": ["ground", "light"],
        "point": [0.7, 0.0], "direction": [1, 0] });
    let r = report(light(slot));
    assert_eq!(r.massless.len(), 1);
    assert_eq!(r.massless[0].coordinates, ["light.angle"]);

    let r = report(
        Machine::default()
            .body(json!({ "name": "rod", "position": [0.5, 0.0] }))
            .pin("O", "ground", "rod", [0.0, 0.0]),
    );
    assert_eq!(r.massless.len(), 1);
    assert_eq!(r.massless[0].bodies, ["rod"]);
    assert!(r.to_string().contains("Masses are missing"), "{r}");
    // Driven, the same rod needs no mass.
    let r = report(
        Machine::default()
            .body(json!({ "name": "rod", "position": [0.5, 0.0] }))
            .pin("O", "ground", "rod", [0.0, 0.0])
            .driver(drive_angle("O", "t / 1 s")),
    );
    assert!(r.massless.is_empty(), "{r}");
}

#[test]
fn a_point_mass_on_a_massless_rod_is_enough() {
    // Mass without inertia, away from the pin: the motion has kinetic energy.
    let r = report(
        Machine::default()
            .body(json!({ "name": "bob", "mass": 1, "center": [1, 0] }))
            .pin("O", "ground", "bob", [0.0, 0.0]),
    );
    assert_eq!(r.freedoms(), 1);
    assert!(r.massless.is_empty(), "{r}");
}

#[test]
fn equal_crank_and_rod_are_singular_when_the_slider_is_at_the_pivot() {
    let at = |angle: f64| {
        let l = 0.3;
        let pin = [l * angle.cos(), l * angle.sin()];
        // The branch theta3 = -theta2, where the slider goes through the pivot.
        slider_crank_at(pin, 2.0 * pin[0]).driver(drive_angle("O", &format!("{angle:?}")))
    };
    let r = report(at(FRAC_PI_2));
    assert_eq!(r.driven.rank, 8, "{r}");
    assert_eq!(r.driven.generic_rank, 9, "{r}");
    assert!(r.driven.is_singular());
    let beside = report(at(FRAC_PI_2 - 0.3));
    assert_eq!(beside.driven.rank, 9);
    assert!(!beside.is_singular());
}

#[test]
fn a_flat_parallelogram_is_singular_not_redundant() {
    let machine = Machine::default()
        .bar("left", [0.0, 0.0], [0.5, 0.0])
        .bar("coupler", [0.5, 0.0], [1.5, 0.0])
        .bar("right", [1.0, 0.0], [1.5, 0.0])
        .pin("O", "ground", "left", [0.0, 0.0])
        .pin("A", "left", "coupler", [0.5, 0.0])
        .pin("B", "coupler", "right", [1.5, 0.0])
        .pin("C", "right", "ground", [1.0, 0.0]);
    let r = report(machine);
    assert_eq!((r.mobility.rank, r.mobility.generic_rank), (7, 8));
    assert_eq!(r.freedoms(), 2);
    assert!(r.redundant.is_empty());
    assert_eq!(r.singular.len(), 1);
    assert!(r.to_string().contains("Singular pose"), "{r}");
}

#[test]
fn a_stretched_truss_is_locked() {
    // Two bars in line between fixed pins: the middle moves to first order only.
    let r = report(
        Machine::default()
            .bar("a", [0.0, 0.0], [1.0, 0.0])
            .bar("b", [1.0, 0.0], [2.0, 0.0])
            .pin("P", "ground", "a", [0.0, 0.0])
            .pin("Q", "a", "b", [1.0, 0.0])
            .pin("R", "b", "ground", [2.0, 0.0]),
    );
    assert_eq!((r.mobility.count, r.mobility.rank), (0, 5));
    assert!(r.locked && r.redundant.is_empty(), "{r}");
    assert_eq!(r.singular.len(), 1);
}

#[test]
fn a_locked_truss_is_seen_beside_free_motions_and_redundant_rows() {
    let r = report(
        double_parallelogram(1.0)
            .bar("a", [0.0, 5.0], [1.0, 5.0])
            .bar("b", [1.0, 5.0], [2.0, 5.0])
            .pin("P", "ground", "a", [0.0, 5.0])
            .pin("Q", "a", "b", [1.0, 5.0])
            .pin("R", "b", "ground", [2.0, 5.0]),
    );
    assert!(r.locked, "{r}");
    assert_eq!(r.freedoms(), 2);
    assert_eq!(r.redundant.len(), 1);
    assert_eq!(r.redundant[0].element, "J6");
    assert_eq!(r.singular.len(), 1);
    assert_eq!(r.singular[0].element, "R");
}

#[test]
fn a_joint_between_fixed_bodies_has_no_effect() {
    let r = report(
        four_bar()
            .body(json!({ "name": "frame", "fixed": true, "position": [0.6, 0.0] }))
            .pin("Z", "ground", "frame", [0.6, 0.0]),
    );
    assert_eq!(r.freedoms(), 1);
    assert_eq!(r.redundant.len(), 2);
    assert!(
        r.redundant
            .iter()
            .all(|d| d.element == "Z" && d.without_effect),
        "{r}"
    );
}

#[test]
fn large_machines_are_ranked_by_sparse_factors() {
    let machine = double_parallelogram(1.0);
    let system = machine.system();
    let (state, _) = Assembly::default().run(&system).unwrap();
    let sparse = Mobility {
        dense_limit: 1,
        ..Mobility::default()
    };
    let r = sparse.run(&system, &state).unwrap();
    assert_eq!((r.mobility.rank, r.freedoms()), (11, 1));
    assert_eq!(r.redundant.len(), 1);
    assert!(r.redundant[0].element.starts_with('J'));
}

#[test]
fn the_smallest_conflict_is_named() {
    // A triangle that closes, and in it two drivers that want different angles of one pin.
    let system = four_bar()
        .driver(json!({ "name": "one", "kind": "angle", "joint": "O", "value": 0.1 }))
        .driver(json!({ "name": "two", "kind": "angle", "joint": "O", "value": 0.3 }))
        .system();
    assert!(Assembly::default().run(&system).is_err());
    let found = conflicts(&system, &system.estimate).unwrap();
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].elements, ["one", "two"]);
    assert!((found[0].residual - 0.1).abs() < 1e-6, "{found:?}");

    // Bars too short to reach between their pins: every joint of the loop is needed.
    let short = Machine::default()
        .bar("a", [0.0, 0.0], [0.4, 0.0])
        .bar("b", [0.6, 0.0], [1.0, 0.0])
        .bar("other", [5.0, 0.0], [6.0, 0.0])
        .pin("P", "ground", "a", [0.0, 0.0])
        .joint(
            json!({ "name": "Q", "kind": "revolute", "bodies": ["a", "b"],
            "at": [[0.2, 0.0], [-0.2, 0.0]] }),
        )
        .pin("R", "b", "ground", [1.0, 0.0])
        .pin("fine", "other", "ground", [5.0, 0.0])
        .system();
    let found = conflicts(&short, &short.estimate).unwrap();
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].elements, ["P", "Q", "R"]);

    let fine = four_bar().system();
    assert!(conflicts(&fine, &fine.estimate).unwrap().is_empty());
}

#[test]
fn drivers_that_contradict_each_other_at_a_dead_centre_are_both_named() {
    // Each driver alone can be met, though the slider's only away from the dead centre of the start;
    // the crank's holds it there.
    let system = slider_crank(0.2, 0.5, 0.0)
        .driver(json!({ "name": "motor", "kind": "angle", "joint": "O", "value": 0.0 }))
        .driver(json!({ "name": "piston", "kind": "displacement", "joint": "S", "value": -0.1 }))
        .system();
    assert!(Assembly::default().run(&system).is_err());
    let found = conflicts(&system, &system.estimate).unwrap();
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0].elements, ["motor", "piston"]);
    assert_eq!(found[0].through, ["O", "A", "B", "S"]);
    assert_eq!(found[0].unit, "m");

    // One driver that asks for more than the bars reach.
    let system = slider_crank(0.2, 0.5, 1.2)
        .driver(json!({ "name": "piston", "kind": "displacement", "joint": "S", "value": 0.9 }))
        .system();
    let found = conflicts(&system, &system.estimate).unwrap();
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0].elements, ["piston"]);
    assert!(!found[0].through.is_empty());
}

#[test]
fn a_driven_slider_stops_at_the_dead_centre() {
    // The slider is driven outwards; crank and rod are in line at x = 0.7, t = 1.25 s.
    let system = slider_crank(0.2, 0.5, 1.2)
        .driver(
            json!({ "name": "piston", "kind": "displacement", "joint": "S",
            "value": "X", }),
        )
        .model();
    let mut model = system;
    let x0 = 0.2 * 1.2_f64.cos() + (0.25 - (0.2 * 1.2_f64.sin()).powi(2)).sqrt();
    // The displacement counts from the joint's point, which lies at the start pose.
    model.drivers[0] = serde_json::from_value(json!({
        "name": "piston", "kind": "coordinate", "body": "slider", "coordinate": "x",
        "value": format!("{x0:?} m + {:?} m * t / 1 s", (0.7 - x0) / 1.25)
    }))
    .unwrap();
    let system = dalembert::system::compile::compile::<dalembert::space::Planar>(&model, &[])
        .unwrap()
        .system;
    let (state, _) = Assembly::default().run(&system).unwrap();
    let sweep = driver_singularities(&system, &state, &SweepOptions::until(2.0)).unwrap();
    assert_eq!(sweep.poses.len(), 1, "{sweep:?}");
    let pose = &sweep.poses[0];
    assert!((pose.time - 1.25).abs() < 1e-6, "{pose:?}");
    assert_eq!(pose.kind, SingularKind::DeadCentre);
    assert!(pose.end);
    assert_eq!(pose.drivers, ["piston"]);
    assert_eq!(pose.bodies, ["crank", "rod"]);
    assert!(
        pose.to_string()
            .contains("dead centre: piston cannot drive crank and rod")
    );
    assert!(sweep.stopped.is_some() && sweep.reached < 1.25 + 1e-6);
}

#[test]
fn a_slider_that_turns_back_at_the_dead_centre_is_found_too() {
    let system = slider_crank(0.2, 0.5, 0.5)
        .driver(
            json!({ "name": "piston", "kind": "coordinate", "body": "slider",
            "coordinate": "x", "value": "0.7 m - 0.05 m * (t / 1 s - 0.613)^2" }),
        )
        .system();
    let (state, _) = Assembly::default().run(&system).unwrap();
    let sweep = driver_singularities(&system, &state, &SweepOptions::until(1.0)).unwrap();
    assert_eq!(sweep.poses.len(), 1, "{sweep:?}");
    assert!((sweep.poses[0].time - 0.613).abs() < 1e-6, "{sweep:?}");
    assert_eq!(sweep.poses[0].drivers, ["piston"]);
}

#[test]
fn a_driven_crank_meets_the_change_points_of_equal_lengths() {
    let start = 0.3_f64;
    let l = 0.25;
    let pin = [l * start.cos(), l * start.sin()];
    let system = slider_crank_at(pin, 2.0 * pin[0])
        .driver(drive_angle("O", &format!("{start:?} + 2 * t / 1 s")))
        .system();
    let (state, _) = Assembly::default().run(&system).unwrap();
    let sweep = driver_singularities(&system, &state, &SweepOptions::until(2.5)).unwrap();
    let times: Vec<f64> = sweep.poses.iter().map(|p| p.time).collect();
    let expected = [(FRAC_PI_2 - start) / 2.0, (1.5 * PI - start) / 2.0];
    assert_eq!(times.len(), 2, "{sweep:?}");
    for (found, exact) in times.iter().zip(expected) {
        assert!((found - exact).abs() < 1e-6, "{found} {exact} {sweep:?}");
    }
    assert!(sweep.stopped.is_none());
    assert!(
        sweep
            .poses
            .iter()
            .all(|p| p.bodies.contains(&"rod".to_owned()))
    );
}

#[test]
fn a_coarse_sweep_divides_its_steps() {
    // Two revolutions in three steps: no step can be made at once.
    let system = slider_crank(0.2, 0.5, 0.4)
        .driver(drive_angle("O", "0.4 + 4 * pi * t / 1 s"))
        .system();
    let (state, _) = Assembly::default().run(&system).unwrap();
    let options = SweepOptions {
        steps: 3,
        ..SweepOptions::until(1.0)
    };
    let sweep = driver_singularities(&system, &state, &options).unwrap();
    assert!(sweep.stopped.is_none(), "{sweep}");
    assert_eq!(sweep.reached, 1.0);
}

#[test]
fn without_drivers_there_is_nothing_to_sweep() {
    let system = four_bar().system();
    let (state, _) = Assembly::default().run(&system).unwrap();
    let sweep = driver_singularities(&system, &state, &SweepOptions::until(1.0)).unwrap();
    assert!(sweep.stopped.is_some() && sweep.poses.is_empty());
}

#[test]
fn values_that_are_not_finite_name_their_element() {
    let system = four_bar().system();
    let mut state = system.estimate.clone();
    state.q[0] = f64::NAN;
    let error = Mobility::default().run(&system, &state).unwrap_err();
    assert!(error.to_string().contains('O'), "{error}");
    assert!(conflicts(&system, &state).is_err());
}

#[test]
fn a_well_driven_machine_has_no_singular_pose() {
    let system = four_bar()
        .driver(drive_angle("O", "0.2 * sin(t / 1 s)"))
        .system();
    let (state, _) = Assembly::default().run(&system).unwrap();
    let sweep = driver_singularities(&system, &state, &SweepOptions::until(6.0)).unwrap();
    assert!(
        sweep.poses.is_empty() && sweep.stopped.is_none(),
        "{sweep:?}"
    );
    assert_eq!(sweep.reached, 6.0);
}
