//! Tops and gyroscopes.

use super::power::G;
use super::run::{Run, close};
use super::space::{axes, dot, vector};
use std::f64::consts::{PI, TAU};

/// Nothing turns the plate: its angular momentum stays upright and its tilt as it is.
#[test]
fn torque_free_top() {
    let run = Run::new("simulate", "torque-free-top", &[]);
    let (m, r, tilt, spin) = (0.4, 0.12, 15.0_f64.to_radians(), 3.0 * TAU);
    let (i1, i3) = (m * r * r / 4.0, m * r * r / 2.0);
    let momentum = i3 * spin / tilt.cos();
    run.follows("momentum.angular_x", 1e-12, |_| 0.0);
    run.follows("momentum.angular_y", 1e-12, |_| 0.0);
    run.follows("momentum.angular_z", 1e-12, |_| momentum);
    run.follows("plate.theta", 1e-9, |_| tilt);
    run.follows("plate.phi", 1e-8, |t| momentum / i1 * t);
    run.follows("plate.psi", 1e-8, |t| (i1 - i3) / i1 * spin * t);
    assert!(run.largest("energy.balance") < 1e-10);
}

/// Elliptic functions of Euler's top (L. D. Landau and E. M. Lifshitz, Mechanics, section 37).
#[test]
fn intermediate_axis_flip() {
    let (bar, stem, shift): (f64, f64, f64) = (0.3, 0.1, 0.0125);
    let (bar_length, bar_radius, stem_length, stem_radius): (f64, f64, f64, f64) =
        (0.2, 0.012, 0.1, 0.01);
    let along = |m: f64, r: f64| m * r * r / 2.0;
    let across = |m: f64, r: f64, l: f64| m * (3.0 * r * r + l * l) / 12.0;
    let apart = bar * shift * shift + stem * (stem_length / 2.0 - shift).powi(2);
    let ix = along(bar, bar_radius) + across(stem, stem_radius, stem_length) + apart;
    let iy = across(bar, bar_radius, bar_length) + along(stem, stem_radius);
    let iz = across(bar, bar_radius, bar_length) + across(stem, stem_radius, stem_length) + apart;
    assert!(ix < iy && iy < iz);
    let (spin, small): (f64, f64) = (10.0, 0.02);
    let energy2 = ix * small * small + iy * spin * spin;
    let momentum2 = (ix * small).powi(2) + (iy * spin).powi(2);
    let rate2 = (iy - ix) * (energy2 * iz - momentum2) / (ix * iy * iz);
    // 1 - k^2, without the difference of nearly equal numbers.
    let other =
        (iz - ix) * ix * small * small * (iy - ix) / ((iy - ix) * (energy2 * iz - momentum2));
    let (mut a, mut g) = (1.0, other.sqrt());
    for _ in 0..12 {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    let quarter = PI / (2.0 * a) / rate2.sqrt();
    // A half period is a turning over; after a whole one all is as at the start.
    let (end, step) = ((4.0 * quarter).to_string(), (2.0 * quarter).to_string());
    let run = Run::new(
        "simulate",
        "intermediate-axis-flip",
        &["--end", &end, "--step", &step, "--tolerance", "1e-12"],
    );
    for (half, sign) in [(0, 1.0), (1, -1.0), (2, 1.0)] {
        let i = run.instant(half);
        let omega = vector(i, "handle.omega_");
        let [x, y, z] = axes(i, "handle").map(|axis| dot(axis, omega));
        close("about the stem", y, sign * spin, 1e-8);
        close("along the bar", x, small, 1e-6);
        close("across both", z, 0.0, 1e-6);
    }
    let all = Run::new("simulate", "intermediate-axis-flip", &[]);
    for axis in ["x", "y", "z"] {
        let name = format!("momentum.angular_{axis}");
        let first = all.instant(0).get(&name);
        all.follows(&name, 1e-11, |_| first);
    }
    assert!(all.largest("energy.balance") < 1e-11);
    assert!(all.range("stem end.z").0 < -0.087, "it turns over");
}

/// A top on its point: moments of inertia about the point, weight times height.
#[derive(Clone, Copy)]
struct Top {
    i1: f64,
    i3: f64,
    moment: f64,
}

const TOP: Top = Top {
    i1: 0.0125,
    i3: 0.005,
    moment: 0.981,
};

impl Top {
    /// 2 I1 sin^2 times what is left of the energy for nodding, where the cosine of the tilt is u; it is a cubic in u.
    fn nodding(&self, tilt: f64, spin: f64, precession: f64) -> impl Fn(f64) -> f64 {
        let (u0, Self { i1, i3, moment }) = (tilt.cos(), *self);
        let along = i3 * spin;
        let upright = i1 * precession * (1.0 - u0 * u0) + along * u0;
        let energy = 0.5 * i1 * precession * precession * (1.0 - u0 * u0) + moment * u0;
        move |u| 2.0 * i1 * (energy - moment * u) * (1.0 - u * u) - (upright - along * u).powi(2)
    }
}

/// Where a function changes its sign.
fn root(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    assert!(f(low) * f(high) < 0.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if f(low) * f(middle) <= 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    0.5 * (low + high)
}

/// Both parts of the angular momentum that gravity leaves alone, and the energy.
fn conserved(run: &Run, spin: f64) {
    let upright = run.instant(0).get("momentum.angular_z");
    run.follows("momentum.angular_z", 1e-10, |_| upright);
    run.always("spin", 1e-8, |i| {
        let (s, c) = i.get("top.theta").sin_cos();
        let (sp, cp) = i.get("top.phi").sin_cos();
        (dot([s * sp, -s * cp, c], vector(i, "top.omega_")), spin)
    });
    assert!(run.largest("energy.balance") < 1e-9);
}

#[test]
fn heavy_top_steady() {
    let run = Run::new("simulate", "heavy-top-steady", &[]);
    let (tilt, spin) = (30.0_f64.to_radians(), 150.0);
    let Top { i1, i3, moment } = TOP;
    let h = i3 * spin;
    let precession =
        (h - (h * h - 4.0 * i1 * tilt.cos() * moment).sqrt()) / (2.0 * i1 * tilt.cos());
    run.follows("top.theta", 1e-9, |_| tilt);
    run.follows("top.phi", 1e-8, |t| precession * t);
    run.follows("axis.x", 1e-8, |t| 0.08 * (precession * t).sin());
    run.follows("axis.y", 1e-8, |t| -0.08 * (precession * t).cos());
    // The point carries the weight and leads the centre round.
    run.follows("point.force_z", 1e-6, |_| G);
    run.always("force to the middle", 1e-6, |i| {
        let [x, y, _] = vector(i, "point.force_");
        (x.hypot(y), precession * precession * 0.05)
    });
    conserved(&run, spin);
}

#[test]
fn heavy_top_cuspidal() {
    let run = Run::new("simulate", "heavy-top-cuspidal", &[]);
    let (tilt, spin) = (40.0_f64.to_radians(), 100.0);
    let f = TOP.nodding(tilt, spin, 0.0);
    let lowest = root(f, 0.5, tilt.cos() - 1e-6).acos();
    let (low, high) = run.range("top.theta");
    close("highest", low, tilt, 1e-9);
    assert!(high <= lowest + 1e-9);
    // Instants are 2 ms apart, so one is within 1 ms of the turning point: w^2/2 of the swing.
    close("lowest", high, lowest, 1e-4);
    conserved(&run, spin);
    // It never goes back, and it stands still where it is highest.
    for i in run.instants() {
        let [x, y, _] = vector(i, "axis.");
        let [vx, vy, _] = vector(i, "axis.v");
        let around = (x * vy - y * vx) / (x * x + y * y);
        let u = i.get("top.theta").cos();
        let expected = TOP.i3 * spin * (tilt.cos() - u) / (TOP.i1 * (1.0 - u * u));
        close("precession", around, expected, 1e-7);
        assert!(around > -1e-7);
    }
}

#[test]
fn heavy_top_looping() {
    let run = Run::new("simulate", "heavy-top-looping", &[]);
    let (tilt, spin, precession) = (40.0_f64.to_radians(), 100.0, -3.0);
    let f = TOP.nodding(tilt, spin, precession);
    let lowest = root(f, 0.4, tilt.cos() - 1e-6).acos();
    let (low, high) = run.range("top.theta");
    close("highest", low, tilt, 1e-9);
    assert!(high <= lowest + 1e-9);
    close("lowest", high, lowest, 3e-4);
    conserved(&run, spin);
    let sign = |i: super::run::Instant<'_>| {
        let ([x, y, _], [vx, vy, _]) = (vector(i, "axis."), vector(i, "axis.v"));
        (x * vy - y * vx).signum()
    };
    let (forth, back): (Vec<_>, Vec<_>) = run.instants().map(sign).partition(|s| *s > 0.0);
    assert!(forth.len() > 500 && back.len() > 200, "it draws loops");
}

const ROTOR_I3: f64 = 0.6 * 0.045 * 0.045 / 2.0;
const SPIN: f64 = 100.0 * PI;

#[test]
fn cardan_gyroscope() {
    let run = Run::new("simulate", "cardan-gyroscope", &[]);
    let precession = 0.05 * G * 0.08 / (ROTOR_I3 * SPIN);
    run.follows("outer bearing.angle", 1e-7, |t| precession * t);
    run.follows("inner bearing.angle", 1e-7, |_| 0.0);
    run.follows("rotor bearing.angle", 1e-6, |t| SPIN * t);
}

/// Let go instead: it nods, and keeps its energy and two momenta, those of both rings included.
#[test]
fn cardan_gyroscope_let_go() {
    let run = Run::new(
        "simulate",
        "cardan-gyroscope",
        &[
            "--set",
            "precession=0 rad/s",
            "--end",
            "0.5",
            "--tolerance",
            "1e-11",
        ],
    );
    let weight = 0.05 * 0.08 * 0.08;
    let across = 0.6 * (3.0 * 0.045 * 0.045 + 0.024 * 0.024) / 12.0;
    let momenta = |i: super::run::Instant<'_>| {
        let rate = |name: &str| i.get(&format!("{name} bearing.angle_rate"));
        let (s, c) = i.get("inner bearing.angle").sin_cos();
        let spin = rate("rotor") + rate("outer") * s;
        let inertia = 9e-4 + 4e-4 * s * s + (8e-4 + across + weight) * c * c;
        let upright = inertia * rate("outer") + ROTOR_I3 * spin * s;
        let energy = 0.5 * inertia * rate("outer").powi(2)
            + 0.5 * (4e-4 + across + weight) * rate("inner").powi(2)
            + 0.5 * ROTOR_I3 * spin * spin
            + 0.05 * G * 0.08 * s;
        [spin, upright, energy]
    };
    let start = momenta(run.instant(0));
    for (k, tolerance) in [1e-7, 1e-10, 1e-8].into_iter().enumerate() {
        run.always("conserved", tolerance, |i| (momenta(i)[k], start[k]));
    }
    assert!(run.largest("inner bearing.angle") > 1e-3, "it nods");
}

#[test]
fn bicycle_wheel_gyroscope() {
    let run = Run::new("simulate", "bicycle-wheel-gyroscope", &[]);
    let (m, r, arm, spin) = (2.0, 0.3, 0.2, 8.0 * PI);
    let precession = m * G * arm / (m * r * r * spin);
    run.follows("hook.angle_1", 1e-7, |t| precession * t);
    run.follows("hook.angle_2", 1e-7, |_| 0.0);
    run.follows("hub.angle", 1e-6, |t| spin * t);
    run.follows("hook.force_z", 1e-6, |_| m * G);
    run.always("force of the hook, inwards", 1e-6, |i| {
        let [x, y, _] = vector(i, "hook.force_");
        (x.hypot(y), m * arm * precession * precession)
    });
    // Without spin it falls: a pendulum, at the bottom (I/2 + m arm^2) w^2 / 2 = m g arm.
    let falls = Run::new(
        "simulate",
        "bicycle-wheel-gyroscope",
        &["--set", "spin=0 rpm"],
    );
    let inertia = m * r * r / 2.0 + m * arm * arm;
    falls.always("energy", 1e-6, |i| {
        let kinetic = 0.5 * inertia * i.get("hook.angle_2_rate").powi(2);
        (kinetic + m * G * i.get("wheel.z"), 0.0)
    });
}
