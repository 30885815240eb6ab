//! The two-link arm, forward and inverse.

use super::power::G;
use super::run::{Instant, Run};
use std::f64::consts::TAU;

const UPPER: f64 = 0.5;
const LOWER: f64 = 0.4;

/// Moments of the motors in shoulder and elbow, from the motion (Shabana, Computational Dynamics, 2nd
/// ed., 2001, Example 5.9 and 4.40): a motor in the elbow acts on both links.
fn moments(i: Instant<'_>) -> [f64; 2] {
    let (m2, m3, half2, half3) = (3.0, 2.0, UPPER / 2.0, LOWER / 2.0);
    let (j2, j3) = (m2 * UPPER * UPPER / 12.0, m3 * LOWER * LOWER / 12.0);
    let (th2, th3) = (i.get("upper arm.angle"), i.get("lower arm.angle"));
    let (w2, w3) = (i.get("upper arm.omega"), i.get("lower arm.omega"));
    let (a2, a3) = (i.get("upper arm.alpha"), i.get("lower arm.alpha"));
    let (s, c) = (th2 - th3).sin_cos();
    let m12 = m3 * UPPER * half3 * c;
    let on_upper = (j2 + m2 * half2 * half2 + m3 * UPPER * UPPER) * a2
        + m12 * a3
        + m3 * UPPER * half3 * s * w3 * w3
        + (m2 * half2 + m3 * UPPER) * G * th2.cos();
    let on_lower = m12 * a2 + (j3 + m3 * half3 * half3) * a3 - m3 * UPPER * half3 * s * w2 * w2
        + m3 * half3 * G * th3.cos();
    [on_upper + on_lower, on_lower]
}

#[test]
fn forward() {
    let run = Run::new("inverse", "robot-arm-forward", &[]);
    // From rest to rest: 6 u^5 - 15 u^4 + 10 u^3.
    let share = |t: f64| {
        let u = t / 2.0;
        u * u * u * (10.0 + u * (6.0 * u - 15.0))
    };
    let shoulder = |t: f64| (20.0 + 90.0 * share(t)).to_radians();
    let elbow = |t: f64| (100.0 - 70.0 * share(t)).to_radians();
    run.follows("shoulder.angle", 3e-13, shoulder);
    run.follows("elbow.angle", 3e-13, elbow);
    run.follows("hand.x", 3e-13, |t| {
        UPPER * shoulder(t).cos() + LOWER * (shoulder(t) + elbow(t)).cos()
    });
    run.follows("hand.y", 3e-13, |t| {
        UPPER * shoulder(t).sin() + LOWER * (shoulder(t) + elbow(t)).sin()
    });
    run.always("shoulder motor", 1e-13, |i| {
        (i.get("shoulder motor.moment"), moments(i)[0])
    });
    run.always("elbow motor", 1e-13, |i| {
        (i.get("elbow motor.moment"), moments(i)[1])
    });
}

#[test]
fn inverse() {
    let run = Run::new("inverse", "robot-arm-inverse", &[]);
    let hand = |t: f64| {
        let (s, c) = (TAU * t / 3.0).sin_cos();
        [0.45 + 0.15 * c, 0.25 + 0.15 * s]
    };
    run.follows("hand.x", 1e-13, |t| hand(t)[0]);
    run.follows("hand.y", 1e-13, |t| hand(t)[1]);
    let elbow = |t: f64| {
        let [x, y] = hand(t);
        ((x * x + y * y - UPPER * UPPER - LOWER * LOWER) / (2.0 * UPPER * LOWER)).acos()
    };
    run.follows("elbow.angle", 1e-12, elbow);
    run.follows("shoulder.angle", 1e-12, |t| {
        let [x, y] = hand(t);
        let (s, c) = elbow(t).sin_cos();
        y.atan2(x) - (LOWER * s).atan2(UPPER + LOWER * c)
    });
    run.always("shoulder", 2e-13, |i| {
        (i.get("actuator shoulder.moment"), moments(i)[0])
    });
    run.always("elbow", 2e-13, |i| {
        (i.get("actuator elbow.moment"), moments(i)[1])
    });
}
