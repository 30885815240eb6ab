//! Machines that move by themselves.

use super::geometry::{angle, from, meet};
use super::power::G;
use super::run::{Run, close};
use std::f64::consts::{FRAC_PI_2, PI};

/// Classical Runge-Kutta with small steps: the referee of the closed-form equations of motion.
fn integrate<const N: usize>(
    rates: impl Fn(f64, [f64; N]) -> [f64; N],
    mut state: [f64; N],
    end: f64,
    steps: usize,
) -> [f64; N] {
    let h = end / steps as f64;
    let moved = |x: [f64; N], k: [f64; N], h: f64| std::array::from_fn(|n| x[n] + h * k[n]);
    for step in 0..steps {
        let t = h * step as f64;
        let k1 = rates(t, state);
        let k2 = rates(t + 0.5 * h, moved(state, k1, 0.5 * h));
        let k3 = rates(t + 0.5 * h, moved(state, k2, 0.5 * h));
        let k4 = rates(t + h, moved(state, k3, h));
        state = std::array::from_fn(|n| {
            state[n] + h / 6.0 * (k1[n] + 2.0 * k2[n] + 2.0 * k3[n] + k4[n])
        });
    }
    state
}

/// Period of a pendulum of one bar: the complete elliptic integral by the arithmetic-geometric mean.
fn pendulum_period(length: f64, amplitude: f64) -> f64 {
    let (mut a, mut g) = (1.0, (0.5 * amplitude).cos());
    for _ in 0..8 {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    2.0 * PI / a * (2.0 * length / (3.0 * G)).sqrt()
}

#[test]
fn pendulum() {
    let amplitude = 60.0_f64.to_radians();
    let period = pendulum_period(1.0, amplitude);
    let (end, step) = (period.to_string(), (0.25 * period).to_string());
    let run = Run::new("simulate", "pendulum", &["--end", &end, "--step", &step]);
    let start = amplitude - FRAC_PI_2;
    // At the quarters of the period: at the bottom, on the other side, at the bottom, back.
    for (quarter, expected) in [start, -FRAC_PI_2, -amplitude - FRAC_PI_2, -FRAC_PI_2, start]
        .into_iter()
        .enumerate()
    {
        close(
            "angle",
            run.instant(quarter).get("bar.angle"),
            expected,
            5e-10,
        );
    }
    let bottom = run.instant(1);
    let height = 1.0 - amplitude.cos();
    close(
        "speed",
        bottom.get("bar.omega"),
        -(3.0 * G * height).sqrt(),
        5e-10,
    );
    close(
        "force of the pin",
        bottom.get("pin.force_y"),
        2.0 * G * (1.0 + 1.5 * height),
        3e-9,
    );
    assert!(run.largest("energy.balance") < 5e-9);
}

#[test]
fn double_pendulum() {
    let run = Run::new("simulate", "double-pendulum", &[]);
    let (m2, m3, l2, l3) = (1.2, 0.8, 0.6, 0.4);
    let (m11, m22, k) = (
        m2 * l2 * l2 / 3.0 + m3 * l2 * l2,
        m3 * l3 * l3 / 3.0,
        0.5 * m3 * l2 * l3,
    );
    let rates = |_: f64, [a, b, u, v]: [f64; 4]| {
        let (s, c) = (a - b).sin_cos();
        let m12 = k * c;
        let upper = -k * s * v * v - (0.5 * m2 + m3) * l2 * G * a.cos();
        let lower = k * s * u * u - 0.5 * m3 * l3 * G * b.cos();
        let det = m11 * m22 - m12 * m12;
        [
            u,
            v,
            (m22 * upper - m12 * lower) / det,
            (m11 * lower - m12 * upper) / det,
        ]
    };
    // Later chaos has magnified the errors of both sides.
    for end in [0.5, 1.0, 2.0] {
        let [upper, lower, upper_rate, lower_rate] = integrate(rates, [0.0; 4], end, 20_000);
        let i = run.at(end);
        close("upper", i.get("upper.angle"), upper, 1e-9);
        close("lower", i.get("lower.angle"), lower, 1e-9);
        close("upper, rate", i.get("upper.omega"), upper_rate, 1e-9);
        close("lower, rate", i.get("lower.omega"), lower_rate, 1e-9);
    }
    assert!(run.largest("energy.balance") < 1e-9);
}

/// Shabana, Computational Dynamics (2nd ed., 2001), Example 5.5: the book's geometry, with the y of the
/// spring's point on the crank put right (the book's 5.466 N becomes 3.580 N).
#[test]
fn spring_damper_four_bar() {
    let run = Run::new("simulate", "spring-damper-four-bar", &[]);
    let first = run.instant(0);
    close(
        "coupler",
        first.get("coupler.angle"),
        0.2322764189254855,
        2e-15,
    );
    close(
        "rocker",
        first.get("rocker.angle"),
        4.345328481925324,
        2e-15,
    );
    close(
        "coupler rate",
        first.get("coupler.omega"),
        1.634382574285668,
        1e-13,
    );
    close(
        "rocker rate",
        first.get("rocker.omega"),
        101.21307296878346,
        1e-13,
    );
    close(
        "crank centre",
        first.get("crank.vx"),
        -14.095389311788626,
        3e-14,
    );
    close(
        "rocker centre",
        first.get("rocker.vy"),
        5.448400363344597,
        3e-14,
    );
    close(
        "length",
        first.get("spring.length"),
        0.3827882536778371,
        5e-16,
    );
    close(
        "rate",
        first.get("spring.rate"),
        -0.46170746828308906,
        3e-14,
    );
    close("force", first.get("spring.force"), 3.579988736628387, 1e-13);
    // The whole run against one equation in the angle of the crank.
    let [end, rate] = integrate(four_bar_rates, [70.0_f64.to_radians(), 150.0], 0.1, 20_000);
    let i = run.at(0.1);
    close("crank at 0.1 s", i.get("crank.angle"), end, 5e-8);
    close("its rate", i.get("crank.omega"), rate, 5e-6);
    // What the damper took is what is missing.
    let start = first.get("energy.total");
    assert!(run.largest("energy.balance") < 1e-8 * start);
    assert!(run.last().get("energy.total") < 0.95 * start);
}

/// Length of the spring, and moment of inertia seen by the crank, at an angle of the crank.
fn four_bar_seen_by_the_crank(turn: f64) -> (f64, f64) {
    let (l2, l3, l4, base) = (0.2, 0.4, 0.3, [0.35, 0.0]);
    let a = from([0.0, 0.0], l2, turn);
    let b = meet(a, l3, base, l4);
    let (th3, th4) = (angle(a, b), angle(b, base));
    let w3 = l2 * (th4 - turn).sin() / (l3 * (th3 - th4).sin());
    let w4 = l2 * (turn - th3).sin() / (l4 * (th3 - th4).sin());
    let (m2, m3, m4) = (1.0, 2.0, 1.5);
    let about_pin = |m: f64, l: f64| m * l * l / 3.0;
    // Velocity of the coupler's centre for a unit rate of the crank.
    let [x, y] = [
        -l2 * turn.sin() - 0.5 * l3 * w3 * th3.sin(),
        l2 * turn.cos() + 0.5 * l3 * w3 * th3.cos(),
    ];
    let inertia = about_pin(m2, l2)
        + m3 * (x * x + y * y)
        + m3 * l3 * l3 / 12.0 * w3 * w3
        + about_pin(m4, l4) * w4 * w4;
    let on_crank = from([0.0, 0.0], 0.5 * l2 + 0.03, turn);
    let on_rocker = from(b, 0.5 * l4 - 0.05, th4);
    (
        (on_rocker[0] - on_crank[0]).hypot(on_rocker[1] - on_crank[1]),
        inertia,
    )
}

/// J(theta) theta'' + J'(theta) theta'^2 / 2 = -f l'(theta), f the force of spring and damper.
fn four_bar_rates(_: f64, [turn, rate]: [f64; 2]) -> [f64; 2] {
    let h = 1e-5;
    let (ahead, behind) = (
        four_bar_seen_by_the_crank(turn + h),
        four_bar_seen_by_the_crank(turn - h),
    );
    let (length, inertia) = four_bar_seen_by_the_crank(turn);
    let length_ratio = (ahead.0 - behind.0) / (2.0 * h);
    let inertia_slope = (ahead.1 - behind.1) / (2.0 * h);
    let force = 250.0 * (length - 0.35) + 10.0 * length_ratio * rate;
    [
        rate,
        (-force * length_ratio - 0.5 * inertia_slope * rate * rate) / inertia,
    ]
}

/// Shabana, Computational Dynamics (2nd ed., 2001), Example 4.1, with numbers of our own.
#[test]
fn pendulum_on_a_moving_base() {
    let run = Run::new("simulate", "pendulum-moving-base", &[]);
    let i = run.at(2.0);
    close("angle at 2 s", i.get("rod.angle"), 0.2188695835763149, 1e-9);
    close("rate at 2 s", i.get("rod.omega"), 2.8905533974818627, 1e-9);
    run.follows("base.x", 5e-14, |t| 0.1 * (3.0 * t).sin());
    assert!(run.largest("energy.balance") < 5e-9);
    // The same state while the base is elsewhere.
    let later = Run::new(
        "simulate",
        "pendulum-moving-base",
        &["--start", "0.25", "--end", "0.26"],
    );
    let i = later.at(0.25);
    close(
        "acceleration",
        i.get("rod.alpha"),
        -12.876681327437048,
        5e-14,
    );
    close("pin, x", i.get("pin.force_x"), 1.7659709897424678, 5e-14);
    close("pin, y", i.get("pin.force_y"), 5.803074904587258, 5e-14);
}

/// Shabana, Computational Dynamics (2nd ed., 2001), section 4.3, with numbers of our own.
#[test]
fn rod_and_disk() {
    let run = Run::new("simulate", "rod-and-disk", &[]);
    let i = run.instant(0);
    for (channel, expected) in [
        ("rod.ax", 1.2796989694133387),
        ("rod.ay", -3.7889771774713346),
        ("rod.alpha", -7.675507150336374),
        ("disk.ax", 2.5593979388266788),
        ("disk.ay", -7.577954354942668),
        ("disk.alpha", 17.777777777777775),
        ("O.force_x", 10.237591755306713),
        ("O.force_y", 18.738182580229328),
        ("A.force_x", 7.678193816480036),
        ("A.force_y", 6.696136935171995),
    ] {
        close(channel, i.get(channel), expected, 5e-14);
    }
    let i = run.at(1.0);
    close("rod at 1 s", i.get("rod.angle"), -1.6102717853196857, 3e-12);
    close("its rate", i.get("rod.omega"), -5.573819703534966, 3e-12);
    // No moment passes the pin: the disk turns as if it were alone.
    run.follows("disk.angle", 3e-12, |t| {
        0.3 + t * (0.7 + 0.5 * 0.6 / 0.03375 * t)
    });
}

/// Shabana, Computational Dynamics (2nd ed., 2001), Example 5.11, with numbers of our own.
#[test]
fn rolling_cylinder() {
    let run = Run::new("simulate", "rolling-cylinder", &[]);
    let i = run.at(1.0);
    let turn: f64 = -0.5088609336050092;
    close("x at 1 s", i.get("cylinder.x"), 0.75 * turn.sin(), 2e-11);
    close("y at 1 s", i.get("cylinder.y"), -0.75 * turn.cos(), 2e-11);
    // The line of centres turns one way, the cylinder the other way and faster.
    close(
        "spin at 1 s",
        i.get("cylinder.omega").abs(),
        1.0685606306562248,
        5e-11,
    );
    // The force of the track, along the line of centres and square to it.
    let (s, c) = turn.sin_cos();
    let (x, y) = (i.get("rolling.force_x"), i.get("rolling.force_y"));
    close("normal force", y * c - x * s, 25.98667468023347, 2e-10);
    close("friction", (x * c + y * s).abs(), 4.779263429468924, 2e-10);
    assert!(run.largest("energy.balance") < 1e-9);
    // Half a period and a period, by the elliptic integral.
    let period: f64 = 2.164796686818239;
    let (end, step) = (period.to_string(), (0.5 * period).to_string());
    let swing = Run::new(
        "simulate",
        "rolling-cylinder",
        &["--end", &end, "--step", &step],
    );
    close(
        "half a period",
        swing.instant(1).get("cylinder.x"),
        -0.375,
        2e-11,
    );
    close("a period", swing.instant(2).get("cylinder.x"), 0.375, 2e-11);
}
