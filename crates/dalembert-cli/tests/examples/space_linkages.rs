//! Linkages in space, closed loops and a meshed body.

use super::power::G;
use super::run::{Instant, Run, answer, close};
use super::space::{cross, length, minus, plus, point, times, vector};
use std::f64::consts::TAU;

#[test]
fn rssr_four_bar() {
    let run = Run::new("kinematics", "rssr-four-bar", &[]);
    // The rod's length, with both balls where crank and rocker have them: p cos + q sin = r for the rocker's angle.
    let rocker = |t: f64| {
        let (s, c) = (TAU * t).sin_cos();
        let [dx, dy, dz] = [0.26 - 0.08 * c, 0.06 - 0.08 * s, 0.04_f64];
        let (p, q) = (0.36 * dx, 0.36 * dz);
        let r = 0.09 - 0.18 * 0.18 - dx * dx - dy * dy - dz * dz;
        q.atan2(p) + (r / p.hypot(q)).acos()
    };
    run.follows("C.angle", 1e-12, rocker);
    run.always("rod", 1e-13, |i| {
        (
            length(minus(vector(i, "ball A."), vector(i, "ball B."))),
            0.3,
        )
    });
}

/// Benchmark collection of the IFToMM; values from an independent integration.
#[test]
fn spatial_slider_crank() {
    let run = Run::new("simulate", "spatial-slider-crank", &[]);
    for (t, x, rate) in [
        (0.1, 0.22677920559855103, 5.8271807180582265),
        (0.2, 0.26301836485837504, 9.773858808670592),
        (0.5, 0.1850167017081352, 14.005727011710809),
        (1.0, 0.20830870461243345, 10.464104773979964),
        (2.0, 0.2900319188093745, 27.481185991497387),
        (5.0, 0.22254416762309087, 10.556467891516428),
    ] {
        let i = run.at(t);
        close("slider", i.get("slider.x"), x, 1e-7);
        close("rate", i.get("crank.omega_x"), rate, 1e-5);
    }
    run.always("Pythagoras", 1e-12, |i| {
        let (y, z) = (i.get("crank end.y"), i.get("crank end.z"));
        (i.get("slider.x"), (0.09 - y * y - z * z).sqrt())
    });
    run.follows("energy.total", 1e-9, |_| 0.766116);
}

/// Benchmark collection of the IFToMM, A04 with slender rods; values from an independent integration.
#[test]
fn bricard() {
    let run = Run::new("simulate", "bricard", &[]);
    for (t, expected) in [
        (
            0.5,
            [0.9681538711727653, -1.225035436322025, 0.7496440898776529],
        ),
        (
            1.0,
            [0.5086647602300758, -1.6498270632111274, 0.1390353307480732],
        ),
        (
            2.0,
            [-0.969892003789732, -1.2194551409464967, 0.7564645796095799],
        ),
        (
            5.0,
            [0.9999999830907256, -1.000183881295176, 0.9998161017986584],
        ),
    ] {
        let found = vector(run.at(t), "corner.");
        for k in 0..3 {
            close("corner", found[k], expected[k], 2e-7);
        }
    }
    run.follows("energy.total", 2e-9, |_| -29.43);
    let report = &answer("check", "bricard", &[])["mobility"]["mobility"];
    assert_eq!(report["count"], 0);
    assert_eq!(report["freedoms"], 1);
}

/// In space as in the plane.
#[test]
fn four_revolutes() {
    let space = Run::new("kinematics", "four-revolutes", &[]);
    let plane = Run::new("kinematics", "crank-rocker", &[]);
    for i in space.instants() {
        let flat = plane.at(i.time());
        for (found, expected) in [
            ("C.angle", "C.angle"),
            ("C.angle_rate", "C.angle_rate"),
            ("C.angle_acceleration", "C.angle_acceleration"),
            ("rocker end.x", "rocker end.x"),
            ("rocker end.vy", "rocker end.vy"),
        ] {
            close(found, i.get(found), flat.get(expected), 1e-10);
        }
    }
    let report = &answer("check", "four-revolutes", &[])["mobility"]["mobility"];
    assert_eq!(report["count"], -2);
    assert_eq!(report["freedoms"], 1);
}

const BASE: f64 = 0.45;
const TOP: f64 = 0.25;
const HEIGHT: f64 = 0.5;

/// Joints of the legs of a Stewart platform, on the ground and on the platform.
fn legs() -> [[[f64; 3]; 2]; 6] {
    let on = |radius: f64, degrees: f64| {
        let (s, c) = degrees.to_radians().sin_cos();
        [radius * c, radius * s, 0.0]
    };
    std::array::from_fn(|k| {
        let (pair, side) = (120.0 * (k / 2) as f64, if k % 2 == 0 { -1.0 } else { 1.0 });
        let foot = pair + 60.0 + side * 48.0;
        [on(BASE, foot), on(TOP, pair + 60.0 + side * 12.0)]
    })
}

/// The legs as vectors, by where a pose takes points of the platform.
fn stretched(platform: impl Fn([f64; 3]) -> [f64; 3]) -> [[f64; 3]; 6] {
    legs().map(|[foot, head]| minus(platform(head), foot))
}

#[test]
fn stewart_platform_forward() {
    let run = Run::new(
        "kinematics",
        "stewart-platform-forward",
        &["--set", "lag=60 deg"],
    );
    let [foot, head] = legs()[0];
    let home = length(minus(plus(head, [0.0, 0.0, HEIGHT]), foot));
    for k in 0..6 {
        let lag = k as f64 * 60.0_f64.to_radians();
        let wanted = |t: f64| home + 0.06 * ((TAU * t / 4.0 - lag).sin() + lag.sin());
        run.follows(&format!("leg {}.displacement", k + 1), 1e-12, wanted);
        // The pose that the program found has legs of these lengths. Axes by the angles of the results, about x, y', z''.
        run.always("leg by the pose", 1e-12, |i| {
            let [(sa, ca), (sb, cb), (sc, cc)] =
                ["x1", "y2", "z3"].map(|a| i.get(&format!("platform.{a}")).sin_cos());
            let turn = |v: [f64; 3]| {
                let v = [cc * v[0] - sc * v[1], sc * v[0] + cc * v[1], v[2]];
                let v = [cb * v[0] + sb * v[2], v[1], cb * v[2] - sb * v[0]];
                [v[0], ca * v[1] - sa * v[2], sa * v[1] + ca * v[2]]
            };
            let leg = stretched(|head| plus(vector(i, "platform."), turn(head)))[k];
            (length(leg), wanted(i.time()))
        });
    }
    let lift = Run::new(
        "kinematics",
        "stewart-platform-forward",
        &["--set", "lag=0 deg"],
    );
    let apart = home * home - HEIGHT * HEIGHT;
    lift.follows("platform.z", 1e-12, |t| {
        ((home + 0.06 * (TAU * t / 4.0).sin()).powi(2) - apart).sqrt()
    });
    lift.follows("platform.z3", 1e-11, |_| 0.0);
}

#[test]
fn stewart_platform_inverse() {
    let run = Run::new("inverse", "stewart-platform-inverse", &[]);
    let pose = |i: Instant<'_>| stretched(|head| point(i, "platform", head));
    let (radius, rate, roll) = (0.08, TAU / 2.0, 8.0_f64.to_radians());
    run.follows("platform.x", 1e-12, |t| radius * (rate * t).cos());
    for k in 0..6 {
        run.always("length", 1e-12, |i| {
            (
                i.get(&format!("leg {}.displacement", k + 1)),
                length(pose(i)[k]),
            )
        });
    }
    // The legs are the only ones who push. What they do together moves the platform.
    for k in 0..3 {
        run.always("force", 1e-9, |i| {
            let legs = pose(i);
            let sum = (0..6).fold([0.0; 3], |sum, n| {
                let push = i.get(&format!("actuator leg {}.force", n + 1));
                plus(sum, times(push / length(legs[n]), legs[n]))
            });
            let (s, c) = (rate * i.time()).sin_cos();
            let a = [-radius * rate * rate * c, -radius * rate * rate * s, G];
            (sum[k], 80.0 * a[k])
        });
        run.always("moment", 1e-9, |i| {
            let (legs, middle) = (pose(i), vector(i, "platform."));
            let sum = (0..6).fold([0.0; 3], |sum, n| {
                let push = i.get(&format!("actuator leg {}.force", n + 1));
                let arm = minus(point(i, "platform", self::legs()[n][1]), middle);
                plus(sum, cross(arm, times(push / length(legs[n]), legs[n])))
            });
            let alpha = -roll * rate * rate * (rate * i.time()).sin();
            (sum[k], [3.0 * alpha, 0.0, 0.0][k])
        });
    }
}

/// A bracket as two boxes: mass, distance of the centre from the pin, inertia about the pin.
#[test]
fn bracket_pendulum() {
    let run = Run::new("simulate", "bracket-pendulum", &[]);
    let part = |x: [f64; 2], z: [f64; 2]| {
        let (w, h) = (x[1] - x[0], z[1] - z[0]);
        let mass = 7800.0 * w * h * 0.05;
        let centre = [(x[0] + x[1]) / 2.0 - 0.015, (z[0] + z[1]) / 2.0 - 0.015];
        let inertia = mass * ((w * w + h * h) / 12.0 + centre[0].powi(2) + centre[1].powi(2));
        (mass, centre, inertia)
    };
    let parts = [
        part([0.0, 0.12], [0.0, 0.03]),
        part([0.0, 0.03], [0.03, 0.08]),
    ];
    let inertia: f64 = parts.iter().map(|p| p.2).sum();
    let [mx, mz] = [0, 1].map(|k| parts.iter().map(|p| p.0 * p.1[k]).sum::<f64>());
    // About y a positive angle turns x downwards.
    run.always("acceleration", 1e-9, |i| {
        let (s, c) = i.get("pin.angle").sin_cos();
        let expected = G * (mx * c + mz * s) / inertia;
        (i.get("pin.angle_acceleration"), expected)
    });
    run.always("energy", 1e-9, |i| {
        let (s, c) = i.get("pin.angle").sin_cos();
        let (s0, c0) = (-20.0_f64).to_radians().sin_cos();
        let height = |s: f64, c: f64| mz * c - mx * s;
        let kinetic = 0.5 * inertia * i.get("pin.angle_rate").powi(2);
        (kinetic, G * (height(s0, c0) - height(s, c)))
    });
    let weight = parts[0].0 + parts[1].0;
    // At rest at the start the pin carries the weight without what the centre falls.
    let i = run.instant(0);
    let (s, c) = i.get("pin.angle").sin_cos();
    let fall = i.get("pin.angle_acceleration") * (mx * c + mz * s);
    close(
        "force of the pin",
        i.get("pin.force_z"),
        weight * G - fall,
        1e-9,
    );
}
