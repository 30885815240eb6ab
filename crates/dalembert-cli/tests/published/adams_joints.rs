//! Single joints of the tests of Project Chrono, against its tables of runs of ADAMS: a bar of 1 kg falls from rest.

use super::harness::{published, table};

/// A bar falls about a pin along y: motion and pin force (six digits of ADAMS).
#[test]
fn bar_on_pin() {
    published("simulate", "bar-on-pin.toml", "", |run| {
        for [
            t,
            x,
            z,
            vx,
            vz,
            ax,
            az,
            b0,
            b1,
            b2,
            b3,
            omega_y,
            force_x,
            force_z,
        ] in table("bar-on-pin.csv")
        {
            run.near(t, "bar.x", x, 5e-6);
            run.near(t, "bar.z", z, 5e-6);
            run.near(t, "bar.vx", vx, 5e-6);
            run.near(t, "bar.vz", vz, 5e-6);
            run.near(t, "bar.ax", ax, 5e-4);
            run.near(t, "bar.az", az, 5e-4);
            run.near(t, "bar.b0", b0, 5e-7);
            run.near(t, "bar.b1", b1, 5e-7);
            run.near(t, "bar.b2", b2, 5e-7);
            run.near(t, "bar.b3", b3, 5e-7);
            run.near(t, "bar.omega_y", omega_y, 5e-6);
            run.near(t, "pin.force_x", force_x, 5e-4);
            run.near(t, "pin.force_z", force_z, 5e-4);
        }
        run.zero("bar", &["y", "vy", "ay", "omega_x", "omega_z"], 1e-12);
        run.zero("pin", &["force_y"], 1e-12);
    });
}

/// A bar falls from a ball joint. The run of ADAMS is rougher here: its height at 5 s is 6e-4 m off the same motion
/// about a pin, which it computed to six digits.
#[test]
fn bar_on_ball() {
    published("simulate", "bar-on-ball.toml", "", |run| {
        for [t, x, z, vx, vz, ax, az, b0, b2, omega_y, force_x, force_z] in table("bar-on-ball.csv")
        {
            run.near(t, "bar.x", x, 1e-3);
            run.near(t, "bar.z", z, 1e-3);
            run.near(t, "bar.vx", vx, 3e-3);
            run.near(t, "bar.vz", vz, 3e-3);
            run.near(t, "bar.ax", ax, 1e-2);
            run.near(t, "bar.az", az, 1e-2);
            run.near(t, "bar.b0", b0, 3e-4);
            run.near(t, "bar.b2", b2, 3e-4);
            run.near(t, "bar.omega_y", omega_y, 3e-3);
            run.near(t, "ball.force_x", force_x, 1e-2);
            run.near(t, "ball.force_z", force_z, 1e-2);
        }
        run.zero(
            "bar",
            &["y", "vy", "ay", "b1", "b3", "omega_x", "omega_z"],
            1e-12,
        );
        run.zero("ball", &["force_y"], 1e-12);
        // The table of the pin is exact to its last digit.
        for [t, way, height, rest @ ..] in table::<14>("bar-on-pin.csv") {
            run.near(t, "bar.x", way, 5e-6);
            run.near(t, "bar.z", height, 5e-6);
            run.near(t, "bar.vx", rest[0], 5e-6);
            run.near(t, "bar.vz", rest[1], 5e-6);
            run.near(t, "ball.force_x", rest[9], 5e-4);
            run.near(t, "ball.force_z", rest[10], 5e-4);
        }
    });
}

/// A bar falls from a universal joint, about its first axis; as rough as the run with the ball.
#[test]
fn bar_on_cross() {
    published("simulate", "bar-on-cross.toml", "", |run| {
        for [t, y, z, vy, vz, ay, az, b0, b1, omega_x, force_y, force_z] in
            table("bar-on-cross.csv")
        {
            run.near(t, "bar.y", y, 1e-3);
            run.near(t, "bar.z", z, 1e-3);
            run.near(t, "bar.vy", vy, 3e-3);
            run.near(t, "bar.vz", vz, 3e-3);
            run.near(t, "bar.ay", ay, 1e-2);
            run.near(t, "bar.az", az, 1e-2);
            run.near(t, "bar.b0", b0, 3e-4);
            run.near(t, "bar.b1", b1, 3e-4);
            run.near(t, "bar.omega_x", omega_x, 3e-3);
            run.near(t, "cross.force_y", force_y, 1e-2);
            run.near(t, "cross.force_z", force_z, 1e-2);
        }
        run.zero(
            "bar",
            &["x", "vx", "ax", "b2", "b3", "omega_y", "omega_z"],
            1e-12,
        );
        run.zero("cross", &["force_x"], 1e-12);
        // The table of the pin is exact to its last digit.
        for [t, way, height, rest @ ..] in table::<14>("bar-on-pin.csv") {
            run.near(t, "bar.y", way, 5e-6);
            run.near(t, "bar.z", height, 5e-6);
            run.near(t, "bar.vy", rest[0], 5e-6);
            run.near(t, "bar.vz", rest[1], 5e-6);
            run.near(t, "cross.force_y", rest[9], 5e-4);
            run.near(t, "cross.force_z", rest[10], 5e-4);
        }
    });
}

/// A body falls on a massless rod.
#[test]
fn bar_on_rod() {
    published("simulate", "bar-on-rod.toml", "", |run| {
        for [t, y, z, vy, vz, ay, az] in table("bar-on-rod.csv") {
            run.near(t, "bar.y", y, 1e-6);
            run.near(t, "bar.z", z, 1e-6);
            run.near(t, "bar.vy", vy, 1e-6);
            run.near(t, "bar.vz", vz, 1e-6);
            run.near(t, "bar.ay", ay, 2e-4);
            run.near(t, "bar.az", az, 2e-4);
        }
        run.zero(
            "bar",
            &[
                "x", "vx", "ax", "b1", "b2", "b3", "omega_x", "omega_y", "omega_z",
            ],
            1e-12,
        );
        // The rod carries the weight along it and the centripetal force m v^2/r.
        for t in run.channel("time").to_vec() {
            let [_, y, z] = run.vector(t, "bar.");
            let [_, vy, vz] = run.vector(t, "bar.v");
            let pull = -9.80665 * z / 2.0 + (vy * vy + vz * vz) / 2.0;
            run.near_vector(
                t,
                "rod.force_",
                [0.0, -pull * y / 2.0, -pull * z / 2.0],
                1e-9,
            );
        }
    });
}

/// A bar slides down a sleeve without friction. ADAMS prints six digits, the last cut off.
#[test]
fn bar_on_sleeve() {
    published("simulate", "bar-on-sleeve.toml", "", |run| {
        for [t, z, vz, az] in table("bar-on-sleeve.csv") {
            run.near(t, "bar.z", z, 2e-4);
            run.near(t, "bar.vz", vz, 1e-4);
            run.near(t, "bar.az", az, 1e-12);
        }
        run.zero(
            "bar",
            &[
                "y", "vx", "vy", "ax", "ay", "b1", "b2", "b3", "omega_x", "omega_y", "omega_z",
            ],
            1e-12,
        );
        run.zero("sleeve", &["force_x", "force_y", "force_z"], 1e-12);
        // The weight acts along the axis: nothing bears on the sleeve.
        run.zero("sleeve", &["moment_x", "moment_y", "moment_z"], 1e-12);
    });
}

/// A bar slides down a guide without friction. ADAMS prints six digits, the last cut off.
#[test]
fn bar_on_slide() {
    published("simulate", "bar-on-slide.toml", "", |run| {
        for [t, z, vz, az] in table("bar-on-slide.csv") {
            run.near(t, "bar.z", z, 2e-4);
            run.near(t, "bar.vz", vz, 1e-4);
            run.near(t, "bar.az", az, 1e-12);
        }
        run.zero(
            "bar",
            &[
                "y", "vx", "vy", "ax", "ay", "b1", "b2", "b3", "omega_x", "omega_y", "omega_z",
            ],
            1e-12,
        );
        run.zero("slide", &["force_x", "force_y", "force_z"], 1e-12);
        // The weight acts along the axis: nothing bears on the guide.
        run.zero("slide", &["moment_x", "moment_y", "moment_z"], 1e-12);
    });
}
