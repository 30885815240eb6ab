//! Benchmarks of multibody dynamics and systems with closed forms.

use super::harness::{published, table};
use std::f64::consts::TAU;

const G: f64 = 9.81;

/// Atwood's machine with a pulley that has inertia.
#[test]
fn atwood_machine() {
    published("simulate", "atwood.toml", "", |run| {
        let acceleration = 1.4014285714285715;
        run.near(0.0, "heavy.ay", -acceleration, 1e-13);
        run.near(1.0, "heavy.x", 0.1, 1e-12);
        run.near(1.0, "heavy.y", -1.7007142857142856, 1e-12);
        run.near(1.0, "light.y", -1.0 + acceleration / 2.0, 1e-12);
        // The heavy mass lies to the right: it turns the pulley clockwise.
        run.near(1.0, "pulley.omega", -14.014285714285714, 1e-11);
    });
}

/// Two and five uniform rods released from the horizontal (minimal equations in extended precision).
#[test]
fn chains_of_rods() {
    for (model, expected) in [
        ("chain-2.toml", "chain-2.csv"),
        ("chain-5.toml", "chain-5.csv"),
    ] {
        published("simulate", model, "", |run| {
            for [t, x, y, rate] in table(expected) {
                run.near(t, "tip.x", x, 1e-8);
                run.near(t, "tip.y", y, 1e-8);
                run.near(t, "rod 1.omega", rate, 1e-7);
                run.near(t, "energy.total", 0.0, 1e-11);
            }
        });
    }
}

/// Slider crank spun up by a torque (test model sliderCrankFloatingTest of Exudyn), against the
/// minimal equation and against the published table of a run with tolerance 1e-6.
#[test]
fn slider_crank_with_torque() {
    // Angle and rate of the published table.
    let table_of_peer = [
        [0.87539246, 5.4409558],
        [4.0627317, 15.196761],
        [14.105539, 20.408051],
        [55.051301, 39.949817],
        [121.89082, 101.69399],
    ];
    let rows: Vec<[f64; 3]> = table("slider-crank-torque.csv");
    for ([t, angle, rate], [peer_angle, peer_rate]) in rows.into_iter().zip(table_of_peer) {
        let options = format!("--end {t}; --step {t}");
        published("simulate", "slider-crank-torque.toml", &options, |run| {
            // The reference knows the angle up to whole turns. At 3 s its rate is good to 1e-6: the
            // runs with tolerances from 1e-12 to 1e-14 agree to 1e-7 there.
            let found = run.at(t, "crank.angle");
            let turns = ((found - angle) / TAU).round();
            run.same("crank angle", found - turns * TAU, angle, 1e-7);
            run.near(t, "crank.omega", rate, 1e-5);
            // Errors of the table: 5e-3 rad and 0.4 % at its end.
            run.same("angle of the table", found, peer_angle, 5e-3);
            run.near(t, "crank.omega", peer_rate, 4e-3 * peer_rate);
        });
    }
}

/// A01 of the IFToMM library: the pendulum by elliptic functions, up to 100 s.
#[test]
fn iftomm_a01_pendulum() {
    published("simulate", "point-pendulum.toml", "--end 100", |run| {
        for [t, x, y] in table("point-pendulum.csv") {
            if t <= 100.0 {
                run.near(t, "mass.x", x, 1e-8);
                run.near(t, "mass.y", y, 1e-8);
            }
        }
    });
}

/// A01 over its whole 2000 s.
#[test]
fn iftomm_a01_pendulum_2000_s() {
    let options = "--end 2000; --step 1000";
    published("simulate", "point-pendulum.toml", options, |run| {
        for [t, x, y] in table("point-pendulum.csv") {
            if t >= 1000.0 {
                run.near(t, "mass.x", x, 1e-6);
                run.near(t, "mass.y", y, 1e-6);
            }
        }
    });
}

/// A02 of the IFToMM library with two windows: ten passages through the pose where all links lie
/// on one line; exact on the branch of parallel uprights.
#[test]
fn iftomm_a02_two_windows() {
    published("simulate", "windows.toml", "", |run| {
        for [t, x, y, vx, vy] in table("windows.csv") {
            run.near(t, "B0.x", x, 1e-5);
            run.near(t, "B0.y", y, 1e-5);
            run.near(t, "B0.vx", vx, 1e-4);
            run.near(t, "B0.vy", vy, 1e-4);
            run.near(t, "bar 1.angle", 0.0, 1e-9);
        }
    });
}

/// A03, Andrews' squeezer: accelerations at the start, the test set's published end values, and two
/// tolerances against each other.
#[test]
fn iftomm_a03_andrews() {
    published("simulate", "squeezer.toml", "", |run| {
        run.near(0.0, "K1.alpha", 14222.443919954114, 1e-6);
        let relative = run.at(0.0, "K2.alpha") - run.at(0.0, "K1.alpha");
        run.same("Theta'' at the start", relative, -10666.832939965585, 1e-6);
        // The published run lies about 1e-12 s further along the same path, that is 1.1e-9 rad of
        // the crank; every angle differs by its own rate times that.
        let end = [
            ("K1", "ground", 15.81077119629904),
            ("K2", "K1", -15.75637105984298),
            ("K3", "ground", 0.04082224013073101),
            ("K4", "K5", -0.5347301163226948),
            ("K5", "ground", 0.5244099658805304),
            ("K6", "K7", 0.5347301163226948),
            ("K7", "ground", 1.048080741042263),
        ];
        for (body, from, angle) in end {
            let mut found = run.at(0.03, &format!("{body}.angle"));
            if from != "ground" {
                found -= run.at(0.03, &format!("{from}.angle"));
            }
            run.same(&format!("angle of {body} from {from}"), found, angle, 2e-9);
        }
    });
    let mut coarse = Vec::new();
    let bodies = ["K1", "K2", "K3", "K4", "K5", "K6", "K7"];
    published("simulate", "squeezer.toml", "--tolerance 1e-10", |run| {
        for body in bodies {
            coarse.push(run.at(0.03, &format!("{body}.angle")));
        }
        run.near(0.03, "violation.position", 0.0, 1e-12);
    });
    published("simulate", "squeezer.toml", "--tolerance 1e-13", |run| {
        for (body, angle) in bodies.iter().zip(&coarse) {
            run.near(0.03, &format!("{body}.angle"), *angle, 1e-9);
        }
        run.near(0.03, "energy.balance", 0.0, 1e-11);
    });
}

/// Uniform rod that falls about its end: pin force 5/2 m g sin(a) along it, 1/4 m g cos(a) across.
#[test]
fn falling_rod_reactions() {
    published("simulate", "rod-pendulum.toml", "", |run| {
        run.near(0.0, "pin.force_x", 0.0, 1e-12);
        run.near(0.0, "pin.force_y", 4.905, 1e-12);
        for t in run.channel("time").to_vec() {
            run.near(t, "energy.total", 0.0, 1e-10);
            let (sin, cos) = (-run.at(t, "rod.angle")).sin_cos();
            let (fx, fy) = (run.at(t, "pin.force_x"), run.at(t, "pin.force_y"));
            // Against the falling tip: up the rod, and across it against the weight.
            run.same(
                "force along the rod",
                -fx * cos + fy * sin,
                2.5 * 2.0 * G * sin,
                1e-8,
            );
            run.same(
                "force across the rod",
                fx * sin + fy * cos,
                0.25 * 2.0 * G * cos,
                1e-8,
            );
            let rate = run.at(t, "rod.omega");
            run.same("square of the rate", rate * rate, 3.0 * G * sin, 1e-8);
        }
    });
}

/// Planetary gear with three planets in a fixed ring (Willis): two meshes are redundant.
#[test]
fn planetary_gear_with_redundant_mesh() {
    published("simulate", "planetary-gear.toml", "", |run| {
        run.near(1.0, "sun.omega", 210.54139215124607, 1e-9);
        run.near(1.0, "carrier.omega", 60.15468347178459, 1e-9);
        for planet in ["planet 1", "planet 2", "planet 3"] {
            run.near(1.0, &format!("{planet}.omega"), -140.3609281008307, 1e-9);
        }
    });
}

/// Hoop, solid cylinder and sphere roll down a slope: a = g sin(slope)/(1 + f).
#[test]
fn rolling_down_a_slope() {
    for f in [1.0_f64, 0.5, 0.4] {
        published(
            "simulate",
            "rolling-incline.toml",
            &format!("f={f}"),
            |run| {
                let (sin, cos) = 30_f64.to_radians().sin_cos();
                let acceleration = G * sin / (1.0 + f);
                for t in [0.5, 1.0, 1.5, 2.0] {
                    let way = acceleration * t * t / 2.0;
                    run.near(t, "wheel.x", 0.2 * sin + way * cos, 1e-12);
                    run.near(t, "wheel.y", 0.2 * cos - way * sin, 1e-12);
                    run.near(t, "wheel.omega", -acceleration * t / 0.2, 1e-11);
                    // Friction points up the slope.
                    let friction =
                        -run.at(t, "contact.force_x") * cos + run.at(t, "contact.force_y") * sin;
                    run.same("friction", friction, 3.0 * G * sin * f / (1.0 + f), 1e-11);
                }
            },
        );
    }
}

/// Oscillator with less and with more than critical damping.
#[test]
fn spring_mass_damper() {
    let cases = [
        (
            "damping=2",
            [
                1.05689718909461,
                1.0098550667618587,
                0.9663148319409587,
                1.0079116023618961,
            ],
        ),
        (
            "damping=50",
            [
                1.0848216138215283,
                1.0368239129101857,
                1.0129693214344802,
                1.0016087623451588,
            ],
        ),
    ];
    for (damping, positions) in cases {
        published("simulate", "spring-mass-damper.toml", damping, |run| {
            for (t, x) in [0.1, 0.5, 1.0, 2.0].into_iter().zip(positions) {
                run.near(t, "mass.x", x, 1e-11);
            }
        });
    }
}

/// The car axis of the test set of initial value problems: positions, velocities, multipliers.
#[test]
fn car_axis() {
    published("simulate", "car-axis.toml", "", |run| {
        for [t, state @ .., first, second] in table::<11>("car-axis.csv") {
            let channels = [
                "left.x", "left.y", "right.x", "right.y", "left.vx", "left.vy", "right.vx",
                "right.vy",
            ];
            for (channel, value) in channels.into_iter().zip::<[f64; 8]>(state) {
                run.near(t, channel, value, 2e-11);
            }
            // The slot pushes with the first multiplier along the road, the axle with twice the
            // second times its length.
            let push = -run.at(t, "slot.force_2");
            run.same("first multiplier", push, first, 1e-12);
            let reach = run.at(t, "right.x") - run.at(t, "left.x");
            let pull = run.at(t, "axle.force_x") / (2.0 * reach);
            run.same("second multiplier", pull, second, 1e-12);
        }
    });
}

/// Two pendulums of the Modelica Standard Library, against its published results (DASSL with a
/// tolerance of 1e-6: four to five digits).
#[test]
fn modelica_pendulums() {
    published("simulate", "damped-pendulum.toml", "", |run| {
        for [t, angle, rate] in table("damped-pendulum.csv") {
            run.near(t, "pin.angle", angle, 2e-3);
            run.near(t, "pin.angle_rate", rate, 5e-3);
        }
    });
    published("simulate", "steel-double-pendulum.toml", "", |run| {
        for [t, first, first_rate, second, second_rate] in table("steel-double-pendulum.csv") {
            run.near(t, "first pin.angle", first, 5e-3);
            run.near(t, "first pin.angle_rate", first_rate, 3e-2);
            run.near(t, "second pin.angle", second, 5e-3);
            run.near(t, "second pin.angle_rate", second_rate, 3e-2);
        }
    });
}

/// A chain of two unit bodies at rest (test of the Rigid Body Dynamics Library).
#[test]
fn rbdl_chain() {
    published("simulate", "unit-chain.toml", "", |run| {
        run.near(0.0, "first pin.angle_acceleration", -5.886, 1e-13);
        run.near(0.0, "second pin.angle_acceleration", 3.924, 1e-13);
    });
}

/// Kepler's ellipse of eccentricity 0.6 over three turns.
#[test]
fn kepler_ellipse() {
    published("simulate", "kepler.toml", "", |run| {
        for [t, x, y] in table("kepler.csv") {
            run.near(t, "satellite.x", x, 1e-9);
            run.near(t, "satellite.y", y, 1e-9);
        }
        run.near(20.0, "momentum.angular", 0.8, 1e-11);
    });
}
