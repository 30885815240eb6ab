//! Linkages with pins and slides.

use super::geometry::{Point, angle, from, meet, near};
use super::power::{Mass, energy_rate};
use super::run::{Run, close};
use std::f64::consts::{FRAC_PI_3, PI, TAU};

/// Shabana, Computational Dynamics (2nd ed., 2001), section 3.9, recomputed from the closed form.
#[test]
fn slider_crank() {
    let (r, l, w, start) = (0.15_f64, 0.35_f64, 150.0, 30.0_f64.to_radians());
    let run = Run::new("inverse", "slider-crank", &[]);
    let rod = |t: f64| -(r * (start + w * t).sin() / l).asin();
    run.follows("crank.angle", 1e-13, |t| start + w * t);
    run.follows("rod.angle", 1e-13, rod);
    run.follows("slider.x", 1e-13, |t| {
        r * (start + w * t).cos() + l * rod(t).cos()
    });
    // Digits of the table, at the start and half a turn later.
    let first = run.instant(0);
    close(
        "rod rate",
        first.get("rod.omega"),
        -56.99704467430113,
        3e-13,
    );
    close(
        "slider velocity",
        first.get("slider.vx"),
        -15.524778350572582,
        1e-13,
    );
    close(
        "rod acceleration",
        first.get("rod.alpha"),
        4223.391540413374,
        2e-11,
    );
    close(
        "slider acceleration",
        first.get("slider.ax"),
        -3716.7013663845573,
        2e-11,
    );
    let half = run.instant(180);
    close(
        "slider, half a turn later",
        half.get("slider.x"),
        0.2119660477117678,
        1e-13,
    );
    close(
        "its velocity",
        half.get("slider.vx"),
        6.975221649427421,
        2e-12,
    );
    close(
        "its acceleration",
        half.get("slider.ax"),
        2128.970109160404,
        5e-11,
    );
    // What the motor gives is what the bodies take.
    let masses = [
        Mass("crank", 0.5, 0.5 * r * r / 12.0, 0.0),
        Mass("rod", 0.8, 0.8 * l * l / 12.0, 0.0),
        Mass("slider", 0.6, 4e-4, 0.0),
    ];
    run.always("power", 2e-10, |i| {
        (w * i.get("motor.moment"), energy_rate(i, &masses))
    });
}

#[test]
fn slider_crank_driven_by_the_slider() {
    let (r, l) = (0.15_f64, 0.35);
    let run = Run::new("kinematics", "slider-driven", &[]);
    run.follows("slider.x", 1e-15, |t| 0.35 + 0.12 * (TAU * t).sin());
    run.always("crank", 4e-13, |i| {
        let x = i.get("slider.x");
        (
            i.get("crank.angle"),
            ((x * x + r * r - l * l) / (2.0 * x * r)).acos(),
        )
    });
    // x'(crank) from x = r cos + sqrt(l^2 - r^2 sin^2).
    run.always("crank rate", 1e-13, |i| {
        let (s, c) = i.get("crank.angle").sin_cos();
        let ratio = -r * s - r * r * s * c / (l * l - r * r * s * s).sqrt();
        (i.get("crank.omega"), i.get("slider.vx") / ratio)
    });
}

/// At the dead centre the slider does not move the crank; the program stops before it and says so.
#[test]
fn the_slider_cannot_pass_its_dead_centre() {
    let answer = std::process::Command::new(env!("CARGO_BIN_EXE_dalembert"))
        .arg("kinematics")
        .arg(super::run::example("slider-driven"))
        .args(["--set", "stroke=160 mm"])
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&answer.stderr);
    assert!(!answer.status.success());
    assert!(said.contains("0.19"), "{said}");
}

/// Crank, coupler and rocker in a chain over the base: checks the angles at every instant.
fn four_bar(run: &Run, [crank, coupler, rocker, base]: [f64; 4], names: [&str; 3]) {
    let joints = |turn: f64| -> [Point; 2] {
        let a = from([0.0, 0.0], crank, turn);
        let c = [base, 0.0];
        // The joint starts above the base, and never crosses the line from A to C.
        [
            a,
            if crank < base {
                meet(a, coupler, c, rocker)
            } else {
                meet(c, rocker, a, coupler)
            },
        ]
    };
    run.always("coupler", 5e-13, |i| {
        let [a, b] = joints(i.get(&format!("{}.angle", names[0])));
        let found = i.get(&format!("{}.angle", names[1]));
        (found, near(angle(a, b), found))
    });
    run.always("rocker", 5e-13, |i| {
        let [_, b] = joints(i.get(&format!("{}.angle", names[0])));
        let found = i.get(&format!("{}.angle", names[2]));
        (found, near(angle([base, 0.0], b), found))
    });
}

#[test]
fn four_bar_with_coupler_curve() {
    let (w, start) = (TAU, 60.0_f64.to_radians());
    let run = Run::new("kinematics", "four-bar", &[]);
    run.follows("crank.angle", 1e-13, |t| start + w * t);
    four_bar(&run, [0.1, 0.25, 0.2, 0.25], ["crank", "coupler", "rocker"]);
    let point = |i: super::run::Instant<'_>| {
        let a = from([0.0, 0.0], 0.1, i.get("crank.angle"));
        let turn = angle(a, meet(a, 0.25, [0.25, 0.0], 0.2));
        from(from(a, 0.125, turn), 0.11, turn + PI / 2.0)
    };
    run.always("coupler point, x", 1e-15, |i| {
        (i.get("coupler point.x"), point(i)[0])
    });
    run.always("coupler point, y", 1e-15, |i| {
        (i.get("coupler point.y"), point(i)[1])
    });
    // The curve is closed: the second turn draws it again.
    close(
        "closed",
        run.instant(0).get("coupler point.x"),
        run.last().get("coupler point.x"),
        1e-14,
    );
}

/// Links 40, 100, 90 and 120 mm, the longest one fixed.
#[test]
fn crank_rocker() {
    let run = Run::new("kinematics", "crank-rocker", &[]);
    four_bar(
        &run,
        [0.04, 0.1, 0.09, 0.12],
        ["crank", "coupler", "rocker"],
    );
    // The ends of the swing: crank and coupler in line.
    let end = |reach: f64| {
        PI - ((0.12_f64.powi(2) + 0.09_f64.powi(2) - reach * reach) / (2.0 * 0.12 * 0.09)).acos()
    };
    let (low, high) = run.range("rocker.angle");
    // The crank is seen once a degree, the rocker stands still where it turns back.
    close("upper end", high, end(0.1 - 0.04), 3e-5);
    close("lower end", low, end(0.1 + 0.04), 3e-5);
}

/// The shortest link fixed.
#[test]
fn double_crank() {
    let run = Run::new("kinematics", "double-crank", &[]);
    four_bar(
        &run,
        [0.12, 0.09, 0.1, 0.04],
        ["crank", "coupler", "follower"],
    );
    let turned = |name: &str| run.last().get(name) - run.instant(0).get(name);
    close(
        "turns of the crank",
        turned("crank.angle"),
        2.0 * TAU,
        3e-13,
    );
    close(
        "turns of the second crank",
        turned("follower.angle"),
        2.0 * TAU,
        3e-13,
    );
    let (slow, _) = run.range("follower.omega");
    assert!(slow > 0.0, "the second crank never stops");
}

/// The link opposite to the shortest one fixed.
#[test]
fn double_rocker() {
    let run = Run::new("kinematics", "double-rocker", &[]);
    let (left, coupler, right, base) = (0.1, 0.04, 0.12, 0.09);
    // Seen from the left arm's end, the right arm turns about a point that the coupler carries.
    let joint = |turn: f64| meet([0.0, 0.0], left, from([base, 0.0], -coupler, turn), right);
    run.always("left arm", 5e-13, |i| {
        let a = joint(i.get("coupler.angle"));
        (i.get("left arm.angle"), angle([0.0, 0.0], a))
    });
    run.always("right arm", 5e-13, |i| {
        let turn = i.get("coupler.angle");
        let b = from(joint(turn), coupler, turn);
        (i.get("right arm.angle"), angle([base, 0.0], b))
    });
    close(
        "turns of the coupler",
        run.last().get("coupler.angle"),
        2.0 * TAU,
        2e-13,
    );
    for arm in ["left arm.angle", "right arm.angle"] {
        let (low, high) = run.range(arm);
        assert!(high - low < PI / 2.0, "{arm} swings from {low} to {high}");
    }
}

#[test]
fn quick_return() {
    let (r, d, lever, link, height) = (0.1_f64, 0.2_f64, 0.45_f64, 0.16_f64, 0.43_f64);
    let run = Run::new("inverse", "quick-return", &[]);
    run.always("lever", 1e-13, |i| {
        let (s, c) = i.get("crank.angle").sin_cos();
        (i.get("lever.angle"), (d + r * s).atan2(r * c))
    });
    run.always("ram", 2e-13, |i| {
        let (s, c) = i.get("lever.angle").sin_cos();
        (
            i.get("ram.x"),
            lever * c + (link * link - (height - lever * s).powi(2)).sqrt(),
        )
    });
    // The lever turns back where the crank is square to it: 120 degrees before and after the top, so
    // that one stroke takes 240 degrees and the other 120.
    for (index, lever_angle) in [(120, FRAC_PI_3), (240, 2.0 * FRAC_PI_3), (480, FRAC_PI_3)] {
        let end = run.instant(index);
        close(
            "end of the lever's swing",
            end.get("lever.angle"),
            lever_angle,
            2e-15,
        );
        close("the ram stands", end.get("ram.vx"), 0.0, 1e-13);
    }
    let stroke = run.instant(120).get("ram.x") - run.instant(240).get("ram.x");
    close("stroke, 2 lever sin(30 deg)", stroke, lever, 1e-15);
    // The motor moves the bodies and cuts.
    let masses = [
        Mass("crank", 2.0, 2.0 * r * r / 12.0, 0.5 * r),
        Mass("lever", 4.0, 4.0 * lever * lever / 12.0, 0.5 * lever),
        Mass("link", 0.5, 0.5 * link * link / 12.0, 0.5 * link),
        Mass("ram", 8.0, 0.2, 0.15),
    ];
    let speed = 40.0 * TAU / 60.0;
    run.always("power", 3e-12, |i| {
        let v = i.get("ram.vx");
        let cutting = if v > 0.0 { 800.0 * v } else { 0.0 };
        (
            -speed * i.get("motor.moment"),
            energy_rate(i, &masses) + cutting,
        )
    });
}

/// Counting says rigid; the closed form says that all cranks stay parallel.
#[test]
fn double_parallelogram() {
    let run = Run::new("kinematics", "double-parallelogram", &[]);
    let turn = |t: f64| 60.0_f64.to_radians() + 50.0_f64.to_radians() * (PI * t).sin();
    for crank in [
        "left crank.angle",
        "middle crank.angle",
        "right crank.angle",
    ] {
        run.follows(crank, 3e-14, turn);
    }
    run.follows("coupler.angle", 1e-14, |_| 0.0);
    run.follows("coupler.x", 2e-13, |t| 0.15 * turn(t).cos());
    run.follows("coupler.y", 2e-13, |t| 0.15 * turn(t).sin());
}
