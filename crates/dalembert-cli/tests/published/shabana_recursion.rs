//! Shabana, section 7.13: kinematics of a body from that of the body before it.
//!
//! The book gives formulas; the numbers are those formulas for data of our own, checked by differences.

use super::harness::published;

/// Equations 7.190 to 7.200, cylindrical joint: velocities and accelerations of the outboard body.
#[test]
fn sleeve_on_a_moving_body() {
    published("kinematics", "sleeve-on-moving-body.toml", "", |run| {
        run.near_vector(
            0.0,
            "second.",
            [
                0.6760795490782924,
                -0.20839877830458917,
                -0.022367153219547076,
            ],
            1e-15,
        );
        let axes = [
            [
                0.9671947417794057,
                -0.25094776123088364,
                0.03949117125986538,
            ],
            [
                0.05834667353488311,
                0.06814429258035669,
                -0.9959678815484646,
            ],
            [0.24724481220377983, 0.9655990764918586, 0.08055076856484644],
        ];
        for (found, expected) in run.matrix(0.0, "second").into_iter().zip(axes) {
            for (found, expected) in found.into_iter().zip(expected) {
                run.same("entry of A", found, expected, 1e-14);
            }
        }
        run.near(0.0, "second.vx", 2.047717175700998, 1e-14);
        run.near(0.0, "second.vy", 0.4159362883934613, 1e-14);
        run.near(0.0, "second.vz", 0.8735831159158058, 1e-14);
        run.near(0.0, "second.omega_x", -0.32182770025005103, 1e-14);
        run.near(0.0, "second.omega_y", -0.750167463663902, 1e-14);
        run.near(0.0, "second.omega_z", 2.7858157302011683, 1e-14);
        run.near(0.0, "second.ax", 0.28084033982346035, 5e-14);
        run.near(0.0, "second.ay", 6.401079821459363, 5e-14);
        run.near(0.0, "second.az", 1.0141978063726973, 5e-14);
        run.near(0.0, "second.alpha_x", 0.7113083297687668, 5e-14);
        run.near(0.0, "second.alpha_y", -1.9482031356595662, 5e-14);
        run.near(0.0, "second.alpha_z", -0.11152209845001015, 5e-14);
    });
}

/// Problem 7.35, spherical joint with relative Euler angles: accelerations of the outboard body.
#[test]
fn ball_on_a_moving_body() {
    published("kinematics", "ball-on-moving-body.toml", "", |run| {
        run.near(0.0, "second.ax", -1.8779953120011252, 5e-13);
        run.near(0.0, "second.ay", 6.380334114119558, 5e-13);
        run.near(0.0, "second.az", 2.303044470207417, 5e-13);
        run.near(0.0, "second.alpha_x", 7.079936472014511, 5e-13);
        run.near(0.0, "second.alpha_y", 0.24505980698300212, 5e-13);
        run.near(0.0, "second.alpha_z", -0.16652520599781084, 5e-13);
    });
}
