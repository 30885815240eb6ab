//! Examples of the Modelica Standard Library in space.
//!
//! The published results were computed by DASSL with a tolerance of 1e-6: four to five digits. They hold no reactions:
//! those are held against the balances of force and moment of each body.

use super::harness::{Run, published, table};
use nalgebra::{Matrix3, Vector3};

const G: f64 = 9.80665;

/// A body as its model says it, and what acts on it.
struct Part<'a> {
    body: &'a str,
    mass: f64,
    /// About the centre of mass, in body axes.
    inertia: Matrix3<f64>,
    /// Joints, +1 where this body is the second and -1 where it is the first, and the point in body axes.
    joints: &'a [(&'a str, f64, [f64; 3])],
}

/// Forces and moments of one joint in the axes of the ground, on its second body.
fn reaction(run: &Run, t: f64, joint: &str) -> [Vector3<f64>; 2] {
    ["force", "moment"].map(|what| run.vector(t, &format!("{joint}.{what}_")).into())
}

/// Newton's and Euler's equations of a body: m (a - g) is the sum of the forces, J alpha + w x J w the sum of the moments
/// about the centre of mass, with the moment that `other` elements exert.
fn balanced(run: &mut Run, t: f64, part: &Part, other: Vector3<f64>, tolerance: f64) {
    let of = |what: &str| Vector3::from(run.vector(t, &format!("{}.{what}", part.body)));
    let axes = run.matrix(t, part.body);
    let axes = Matrix3::from_fn(|row, column| axes[row][column]);
    let inertia = axes * part.inertia * axes.transpose();
    let (omega, alpha) = (of("omega_"), of("alpha_"));
    let mut force = part.mass * (of("a") + Vector3::new(0.0, G, 0.0));
    let mut moment = inertia * alpha + omega.cross(&(inertia * omega)) - other;
    for (joint, sign, at) in part.joints {
        let [f, m] = reaction(run, t, joint);
        force -= *sign * f;
        moment -= *sign * (m + (axes * Vector3::from(*at)).cross(&f));
    }
    for (what, rest) in [("forces", force), ("moments", moment)] {
        for value in rest.iter() {
            let what = format!("{what} of {} at {t} s", part.body);
            run.same(&what, *value, 0.0, tolerance);
        }
    }
}

/// Elementary.Pendulum and Elementary.DoublePendulum as machines in space.
#[test]
fn modelica_pendulums_in_space() {
    published("simulate", "damped-pendulum-space.toml", "", |run| {
        for [t, angle, rate] in table("damped-pendulum.csv") {
            run.near(t, "pin.angle", angle, 1e-5);
            run.near(t, "pin.angle_rate", rate, 5e-5);
        }
        let bob = Part {
            body: "bob",
            mass: 1.0,
            inertia: Matrix3::identity() * 0.001,
            joints: &[("pin", 1.0, [-0.5, 0.0, 0.0])],
        };
        for t in run.channel("time").to_vec() {
            let damper = Vector3::new(0.0, 0.0, -0.1 * run.at(t, "pin.angle_rate"));
            balanced(run, t, &bob, damper, 5e-14);
            run.zero_at(
                t,
                "pin",
                &["force_z", "moment_x", "moment_y", "moment_z"],
                1e-12,
            );
        }
    });
    published("simulate", "steel-double-pendulum-space.toml", "", |run| {
        for [t, first, first_rate, second, second_rate] in table("steel-double-pendulum.csv") {
            run.near(t, "first pin.angle", first, 1e-4);
            run.near(t, "first pin.angle_rate", first_rate, 1e-4);
            run.near(t, "second pin.angle", second, 1e-4);
            run.near(t, "second pin.angle_rate", second_rate, 1e-4);
        }
        let inertia = Matrix3::from_diagonal(&Vector3::new(0.008_316, 0.292_908, 0.292_908));
        let [end, start] = [[0.25, 0.0, 0.0], [-0.25, 0.0, 0.0]];
        let first = Part {
            body: "first",
            mass: 13.86,
            inertia,
            joints: &[("first pin", 1.0, start), ("second pin", -1.0, end)],
        };
        let second = Part {
            body: "second",
            mass: 13.86,
            inertia,
            joints: &[("second pin", 1.0, start)],
        };
        for t in run.channel("time").to_vec() {
            let damper = Vector3::new(0.0, 0.0, -0.1 * run.at(t, "first pin.angle_rate"));
            balanced(run, t, &first, damper, 1e-12);
            balanced(run, t, &second, Vector3::zeros(), 1e-12);
            for pin in ["first pin", "second pin"] {
                // A pin turns freely.
                run.near(t, &format!("{pin}.moment_z"), 0.0, 1e-12);
            }
        }
    });
}

/// Loops.Fourbar1: crank, rod and slider in space.
#[test]
fn modelica_four_bar_in_space() {
    published("simulate", "four-bar-space.toml", "", |run| {
        for [t, angle, rate] in table("four-bar-space.csv") {
            run.near(t, "pin.angle", angle, 2e-3);
            run.near(t, "pin.angle_rate", rate, 2e-3);
        }
        let crank = Part {
            body: "crank",
            mass: 7.709164080124284,
            inertia: Matrix3::new(
                0.16823644529021223,
                0.0,
                0.0, //
                0.0,
                0.00878708806408397,
                -0.03188987144522565, //
                0.0,
                -0.03188987144522565,
                0.1618584710011671,
            ),
            joints: &[
                ("pin", 1.0, [0.0, -0.25, -0.05]),
                ("ball", -1.0, [0.0, 0.25, 0.05]),
            ],
        };
        let slider = Part {
            body: "slider",
            mass: 3.0237829290801765,
            inertia: Matrix3::from_diagonal(&Vector3::new(
                0.010551742512936035,
                0.0009449321653375552,
                0.010551742512936035,
            )),
            joints: &[
                ("guide", 1.0, [0.0, -0.1, 0.0]),
                ("cross", -1.0, [0.0, 0.1, 0.0]),
            ],
        };
        let rod = Part {
            body: "rod",
            mass: 15.856851454825733,
            inertia: Matrix3::new(
                0.1368704555025915,
                0.39574556826887536,
                0.13191518942295843, //
                0.39574556826887536,
                1.3372986792515131,
                -0.03957455682688752, //
                0.13191518942295843,
                -0.03957455682688752,
                1.4428308307898803,
            ),
            joints: &[
                ("cross", 1.0, [0.5, -0.15, -0.05]),
                ("ball", 1.0, [-0.5, 0.15, 0.05]),
            ],
        };
        for t in run.channel("time").to_vec() {
            run.near(t, "energy.balance", 0.0, 1e-7);
            for part in [&crank, &slider, &rod] {
                balanced(run, t, part, Vector3::zeros(), 1e-12);
            }
            // What the joints leave free they do not push.
            run.zero_at(t, "pin", &["moment_x"], 1e-10);
            run.zero_at(t, "guide", &["force_x"], 1e-10);
            run.zero_at(t, "ball", &["moment_x", "moment_y", "moment_z"], 1e-10);
        }
    });
}

/// Elementary.RollingWheel: a thin wheel rolls on the floor and leans over, against the matrix of its orientation.
#[test]
fn modelica_rolling_wheel() {
    published("simulate", "rolling-wheel-space.toml", "", |run| {
        for [t, expected @ ..] in table::<10>("rolling-wheel-space.csv") {
            let axes = run.matrix(t, "wheel");
            for (k, value) in expected.into_iter().enumerate() {
                let [row, column] = [k / 3, k % 3];
                let what = format!("A[{row}][{column}] of the wheel at {t} s");
                run.same(&what, axes[row][column], value, 5e-4);
            }
            // Between the errors of the two programs: those of this one are far below.
            run.near(t, "energy.balance", 0.0, 1e-9);
        }
        for t in run.channel("time").to_vec() {
            // The lowest point of the rim touches the floor and stands still.
            let axle = Vector3::from(run.matrix(t, "wheel").map(|row| row[1]));
            let across = Vector3::z() - axle * axle.z;
            let down = -0.3 * across.normalize();
            let [center, velocity, omega] =
                ["", "v", "omega_"].map(|c| Vector3::from(run.vector(t, &format!("wheel.{c}"))));
            run.same("height of the contact", (center + down).z, 0.0, 1e-12);
            let slip = (velocity + omega.cross(&down)).norm();
            run.same("slip", slip, 0.0, 1e-12);
            // The floor's force, at the contact, moves and turns the wheel.
            let force = Vector3::from(run.vector(t, "floor.force_"));
            let acceleration = Vector3::from(run.vector(t, "wheel.a"));
            let moved = 2.0 * (acceleration + Vector3::new(0.0, 0.0, 9.80665));
            run.same("force", (force - moved).norm(), 0.0, 1e-10);
        }
    });
}
