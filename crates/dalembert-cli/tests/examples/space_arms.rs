//! Arms in space.

use super::power::G;
use super::run::{Run, close};
use super::space::vector;

/// A. A. Shabana, Computational Dynamics (2nd ed., 2001), Examples 7.11 and 7.12, with numbers of our own.
#[test]
fn two_revolutes() {
    let run = Run::new("simulate", "spatial-arm-2r", &[]);
    let i = run.instant(0);
    close("Q", i.get("Q.angle_acceleration"), 6.408224601354748, 1e-12);
    close(
        "P",
        i.get("P.angle_acceleration"),
        -6.872554286124972,
        1e-12,
    );
    for (stem, expected) in [
        (
            "arm.omega_",
            [-0.27259283961605535, 1.2, -0.6447426958020195],
        ),
        (
            "arm.alpha_",
            [-3.4499899324914214, 6.408224601354748, -6.002930274577788],
        ),
        (
            "arm.a",
            [
                -0.38226688537352804,
                -2.0443793109538544,
                -2.3810652372076073,
            ],
        ),
        (
            "P.force_",
            [-0.9556672134338202, 19.414051722615362, -5.952663093019017],
        ),
        (
            "Q.force_",
            [-1.2909149677957723, 58.654051722615364, -5.066717864431741],
        ),
    ] {
        let found = vector(i, stem);
        for k in 0..3 {
            close(stem, found[k], expected[k], 1e-11);
        }
    }
    // The motors' work is the energy that the arm has more.
    let energy = i.get("energy.total");
    run.always("work", 1e-8, |i| {
        let work = 3.0 * (i.get("Q.angle") - 0.4) + 5.0 * (i.get("P.angle") - 0.3);
        (i.get("energy.total") - energy, work)
    });
}

#[test]
fn three_revolutes() {
    let run = Run::new("inverse", "spatial-arm-3r", &[]);
    let share = |t: f64| {
        let u = t / 2.0;
        u * u * u * (10.0 + u * (6.0 * u - 15.0))
    };
    let angles = |t: f64| {
        [(-40.0, 80.0), (20.0, 70.0), (-30.0, -110.0)]
            .map(|(from, to): (f64, f64)| (from + (to - from) * share(t)).to_radians())
    };
    let reach = |t: f64| {
        let [_, lift, bend] = angles(t);
        0.35 * lift.cos() + 0.3 * (lift + bend).cos()
    };
    run.follows("hand.x", 1e-12, |t| reach(t) * angles(t)[0].cos());
    run.follows("hand.y", 1e-12, |t| reach(t) * angles(t)[0].sin());
    run.follows("hand.z", 1e-12, |t| {
        let [_, lift, bend] = angles(t);
        0.4 + 0.35 * lift.sin() + 0.3 * (lift + bend).sin()
    });
    // At rest at both ends the motors only carry the weights.
    for i in [run.instant(0), run.last()] {
        let [_, lift, bend] = angles(i.time());
        let elbow = (3.0 * 0.15 + 1.5 * 0.3) * G * (lift + bend).cos();
        let shoulder = elbow + (4.0 * 0.175 + 4.5 * 0.35) * G * lift.cos();
        close("waist", i.get("waist motor.moment"), 0.0, 1e-10);
        close("shoulder", i.get("shoulder motor.moment"), shoulder, 1e-10);
        close("elbow", i.get("elbow motor.moment"), elbow, 1e-10);
    }
    // Simpson's rule: the work of the motors lifts the arm.
    let power: Vec<f64> = run
        .instants()
        .map(|i| {
            ["waist", "shoulder", "elbow"]
                .map(|m| i.get(&format!("{m} motor.power")))
                .iter()
                .sum()
        })
        .collect();
    let h = 2.0 / 200.0;
    let work: f64 = power
        .windows(3)
        .step_by(2)
        .map(|p| h / 3.0 * (p[0] + 4.0 * p[1] + p[2]))
        .sum();
    let gain = run.last().get("energy.total") - run.instant(0).get("energy.total");
    close("work", work, gain, 1e-6);
}
