//! Linkages that lead a point along a line.

use super::geometry::{from, meet};
use super::run::Run;

/// P stays on x = (arm^2 - side^2) / (2 crank), at y = x tan(crank angle / 2).
#[test]
fn peaucellier_is_exact() {
    let run = Run::new("kinematics", "peaucellier", &[]);
    let x = (0.5_f64.powi(2) - 0.2_f64.powi(2)) / (2.0 * 0.18);
    // The size of the machine is about x.
    run.follows("straight line.x", 5e-14 * x, |_| x);
    run.always("y", 2e-13, |i| {
        (
            i.get("straight line.y"),
            x * (0.5 * i.get("crank.angle")).tan(),
        )
    });
    let (low, high) = run.range("straight line.y");
    assert!(high - low > 0.5, "the line is long: {low} to {high}");
}

/// The middle of the coupler between equal arms, from the intersection of two circles.
#[test]
fn watt_is_nearly_straight() {
    let (arm, coupler) = (0.25, 0.14);
    let run = Run::new("kinematics", "watt", &[]);
    let middle = |turn: f64| {
        let a = from([-arm, 0.5 * coupler], arm, turn);
        let b = meet([arm, -0.5 * coupler], arm, a, coupler);
        [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
    };
    run.always("x", 1e-14, |i| {
        (i.get("middle.x"), middle(i.get("left arm.angle"))[0])
    });
    run.always("y", 2e-14, |i| {
        (i.get("middle.y"), middle(i.get("left arm.angle"))[1])
    });
    let (low, high) = run.range("middle.y");
    assert!(high - low > 0.13, "{low} to {high}");
    assert!(run.largest("middle.x") < 2.1e-4);
    // Not exact: the line bends when the arms swing further.
    let far = Run::new("kinematics", "watt", &["--set", "swing=30 deg"]);
    assert!(far.largest("middle.x") > 5e-3);
}
