//! Gears and racks.

use super::run::Run;
use std::f64::consts::{PI, TAU};

/// Willis: with the ring at rest the carrier turns at 2/7 of the sun's speed, the planets at -2/3 of it;
/// the train accelerates evenly.
#[test]
fn planetary_gear() {
    let run = Run::new("simulate", "planetary-gear", &[]);
    let (carrier, planet) = (2.0 / 7.0, -2.0 / 3.0);
    // Inertia of everything, seen by the sun: a planet turns, and is carried around at 70 mm.
    let inertia = 0.002
        + (0.01 + 3.0 * 0.5 * 0.07 * 0.07) * carrier * carrier
        + 3.0 * 0.001 * planet * planet;
    let alpha = 0.05 / inertia;
    run.follows("sun.omega", 1e-9, |t| alpha * t);
    run.follows("sun.angle", 1e-9, |t| 0.5 * alpha * t * t);
    run.always("carrier", 2e-14, |i| {
        (i.get("carrier.omega"), carrier * i.get("sun.omega"))
    });
    for name in ["planet 1.omega", "planet 2.omega", "planet 3.omega"] {
        run.always(name, 2e-14, |i| (i.get(name), planet * i.get("sun.omega")));
    }
}

#[test]
fn rack_and_pinion() {
    let (radius, swing) = (0.08, 1.5);
    let run = Run::new("inverse", "rack-and-pinion", &[]);
    run.follows("rack.x", 2e-16, |t| radius * swing * (PI * t).sin());
    run.follows("rack.vx", 2e-15, |t| radius * swing * PI * (PI * t).cos());
    // The motor turns the pinion and pushes the rack against its load.
    let inertia = 0.8 * radius * radius / 2.0 + 1.5 * radius * radius;
    run.follows("motor.moment", 1e-14, |t| {
        -inertia * swing * PI * PI * (PI * t).sin() + 30.0 * radius
    });
    run.follows("pinion.angle", 1e-15, |t| swing * (0.5 * TAU * t).sin());
}
