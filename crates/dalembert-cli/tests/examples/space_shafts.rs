//! Shafts: universal and constant-velocity joints, screws.

use super::power::G;
use super::run::{Run, close};
use super::space::vector;
use std::f64::consts::TAU;

/// Speed ratio of a universal joint with its driving fork at an angle from the plane of the shafts.
fn ratio(bend: f64, angle: f64) -> f64 {
    bend.cos() / (1.0 - (bend.sin() * angle.cos()).powi(2))
}

#[test]
fn universal_joint() {
    let run = Run::new("inverse", "universal-joint", &[]);
    let bend = 40.0_f64.to_radians();
    run.follows("load.rate", 1e-12, |t| TAU * ratio(bend, TAU * t));
    // tan(output) = tan(input) / cos(bend), counted over turns.
    run.always("angle", 1e-12, |i| {
        let (s, c) = i.get("motor.angle").sin_cos();
        let wrapped = (s / bend.cos()).atan2(c);
        let angle = i.get("load.angle");
        (angle - TAU * ((angle - wrapped) / TAU).round(), wrapped)
    });
    close("two turns", run.last().get("load.angle"), 2.0 * TAU, 1e-11);
    // What the brake takes the motor gives.
    run.always("moment", 1e-11, |i| {
        let k = ratio(bend, i.get("motor.angle"));
        (i.get("motor.moment"), 2.0 * TAU * k * k)
    });
}

#[test]
fn double_universal_joint() {
    let run = Run::new("kinematics", "double-universal-joint", &[]);
    run.always("even", 1e-12, |i| {
        (i.get("output bearing.angle"), i.get("input bearing.angle"))
    });
    run.follows("output bearing.angle_rate", 1e-11, |_| TAU);
    let bend = 35.0_f64.to_radians();
    run.follows("middle.omega_x", 1e-11, |t| {
        TAU * ratio(bend, TAU * t) * bend.cos()
    });
    // Forks a quarter turn apart: the output takes the ratio of both.
    let wrong = Run::new(
        "kinematics",
        "double-universal-joint",
        &["--set", "phase=90 deg"],
    );
    let (low, high) = wrong.range("output bearing.angle_rate");
    close("slowest", low, TAU * bend.cos().powi(2), 1e-11);
    close("fastest", high, TAU / bend.cos().powi(2), 1e-11);
}

#[test]
fn constant_velocity_joint() {
    let run = Run::new("kinematics", "constant-velocity-joint", &[]);
    let bend = |t: f64| 45.0_f64.to_radians() * (1.0 - (TAU * t / 4.0).cos()) / 2.0;
    let swing = |t: f64| 45.0_f64.to_radians() * (TAU * t / 4.0).sin() * TAU / 8.0;
    // The output turns as the input does about its own axis, and with the arm about the upright one.
    for (axis, expected) in [
        (
            "x",
            Box::new(|t: f64| TAU * bend(t).cos()) as Box<dyn Fn(f64) -> f64>,
        ),
        ("y", Box::new(|t: f64| TAU * bend(t).sin())),
        ("z", Box::new(swing)),
    ] {
        run.follows(&format!("output.omega_{axis}"), 1e-11, expected);
    }
}

#[test]
fn screw_jack() {
    let run = Run::new("inverse", "screw-jack", &[]);
    let (pitch, speed) = (6e-3, 0.5 * TAU);
    let rise = move |t: f64| pitch * speed * t / TAU;
    run.follows("table.z", 1e-13, |t| 0.22 + rise(t));
    run.follows("spindle.z", 1e-13, rise);
    // The spindle is lifted too.
    run.follows("hand.moment", 1e-11, |_| 304.0 * G * pitch / TAU);
    run.always("force under the table", 1e-9, |i| {
        let [_, _, z] = vector(i, "head.force_");
        (z, -300.0 * G)
    });
}
