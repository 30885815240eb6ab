//! Other driven mechanisms and bodies in A. A. Shabana, Computational Dynamics (2nd ed., 2001).
//!
//! The numbers are recomputed from closed forms; where the book prints digits they agree with it to
//! what is printed, but for its misprints.

use super::harness::{published, table};

/// Equations 1.1 to 1.3: the tip of a two-link arm.
#[test]
fn section_1_4_manipulator() {
    let options = "first_length=0.5; second_length=0.3; first_start=0.7; second_start=1.2; first_speed=2; second_speed=-1.5; first_acceleration=0.4; second_acceleration=0.9";
    published("kinematics", "two-link-driven.toml", options, |run| {
        run.all(
            0.0,
            "tip",
            &[("x", 0.4911284199852463), ("y", 0.6017205694090133)],
            1e-14,
        );
        run.all(
            0.0,
            "tip",
            &[("vx", -0.2248000985524392), ("vy", 0.6017811977699854)],
            1e-13,
        );
        run.all(
            0.0,
            "tip",
            &[("ax", -2.154769949499421), ("ay", -1.6667567263376601)],
            1e-12,
        );
    });
}

/// Examples 3.10 to 3.12: two rods in a chain at constant rates, at 0.25 s.
#[test]
fn examples_3_10_to_3_12() {
    published("kinematics", "two-link-driven.toml", "", |run| {
        run.all(
            0.25,
            "first",
            &[
                ("x", 0.2042437204420787),
                ("y", 0.4563819701302605),
                ("angle", 1.15),
            ],
            1e-13,
        );
        run.all(
            0.25,
            "second",
            &[
                ("x", 0.617499453688307),
                ("y", 0.6975571129906641),
                ("angle", -0.8),
            ],
            1e-13,
        );
        run.all(
            0.25,
            "first",
            &[
                ("vx", -1.3691459103907815),
                ("vy", 0.6127311613262361),
                ("omega", 3.0),
            ],
            1e-12,
        );
        run.all(
            0.25,
            "second",
            &[
                ("vx", -3.1687054753212767),
                ("vy", 0.8074382970441729),
                ("omega", -2.0),
            ],
            1e-12,
        );
        run.all(
            0.25,
            "first",
            &[
                ("ax", -1.8381934839787082),
                ("ay", -4.107437731172345),
                ("alpha", 0.0),
            ],
            1e-11,
        );
        run.all(
            0.25,
            "second",
            &[
                ("ax", -4.512435019174015),
                ("ay", -7.354048153265262),
                ("alpha", 0.0),
            ],
            1e-11,
        );
    });
}

/// Example 3.5: a block that slides along a turning rod.
#[test]
fn example_3_5() {
    published("kinematics", "block-on-rod.toml", "", |run| {
        run.all(
            0.0,
            "point",
            &[("vx", -0.5119329447314163), ("vy", 1.771418826844352)],
            1e-13,
        );
        run.all(
            0.0,
            "point",
            &[("ax", -11.245276420380572), ("ay", 0.351792878314356)],
            1e-12,
        );
        // The Coriolis part is written along the axes of the rod.
        let (along, across) = (
            run.at(0.0, "point.relative.coriolis_x"),
            run.at(0.0, "point.relative.coriolis_y"),
        );
        let (sin, cos) = 0.5_f64.sin_cos();
        run.same(
            "coriolis, ground x",
            along * cos - across * sin,
            -2.301242585300175,
            1e-13,
        );
        run.same(
            "coriolis, ground y",
            along * sin + across * cos,
            4.21239629707379,
            1e-13,
        );
    });
}

/// Section 3.6: follower of the cam 0.05 + 0.004 cos(2 phi) + 0.002 sin(phi) m at 10 rad/s.
#[test]
fn section_3_6_knife_edge() {
    published("kinematics", "cam-knife-edge.toml", "", |run| {
        for [angle, y, velocity, acceleration, phi] in table("section-3-6-knife-edge.csv") {
            let t = angle / 10.0;
            run.near(t, "follower.y", y, 1e-13);
            run.near(t, "follower.vy", velocity, 1e-12);
            run.near(t, "follower.ay", acceleration, 1e-11);
            run.near(t, "contact.phi", phi, 1e-12);
        }
    });
}

/// Example 3.8: a flat face on an eccentric disc lies at e sin(angle) + radius.
#[test]
fn example_3_8() {
    published("kinematics", "cam-flat-face.toml", "", |run| {
        for t in run.channel("time").to_vec() {
            let (sin, cos) = (5.0 * t).sin_cos();
            run.near(t, "follower.y", 0.015 * sin + 0.04, 1e-13);
            run.near(t, "follower.vy", 5.0 * 0.015 * cos, 1e-12);
            run.near(t, "follower.ay", -25.0 * 0.015 * sin, 1e-11);
        }
    });
}

/// Equations 3.103 to 3.105, problems 3.17 and 3.18: gears with radii 0.3, 0.1, 0.1 m on an arm.
#[test]
fn section_3_6_gears() {
    let options = "arm_speed=0; gear_speed=2";
    published("kinematics", "gear-chain.toml", options, |run| {
        run.near(0.5, "gear j.omega", -6.0, 1e-12);
        run.near(1.0, "gear j.angle", -6.0, 1e-12);
    });
    published("kinematics", "gear-chain.toml", "", |run| {
        run.near(0.5, "gear j.omega", 60.0, 1e-11);
        run.near(0.5, "gear k.omega", -30.0, 1e-11);
        run.near(0.5, "gear j.alpha", 0.0, 1e-9);
        run.near(0.5, "gear k.alpha", 0.0, 1e-9);
        run.near(1.0, "gear j.angle", 60.0, 1e-11);
    });
    published(
        "kinematics",
        "gear-chain.toml",
        "arm_acceleration=120",
        |run| {
            run.near(0.0, "gear j.omega", 60.0, 1e-11);
            run.near(0.0, "gear k.omega", -30.0, 1e-11);
            run.near(0.0, "gear j.alpha", 480.0, 1e-10);
            run.near(0.0, "gear k.alpha", -240.0, 1e-10);
        },
    );
}

/// Example 3.9: x = radius * angle.
#[test]
fn example_3_9() {
    published("kinematics", "rack-and-pinion.toml", "", |run| {
        run.near(0.0, "rack.vx", 0.4, 1e-14);
        run.near(0.0, "rack.ax", -0.16, 1e-13);
        run.near(2.0, "rack.x", 0.08 * (5.0 * 2.0 - 4.0), 1e-14);
    });
}

/// Section 1.3: Peaucellier's linkage with arms 0.5 m, sides 0.2 m, crank 0.18 m.
#[test]
fn section_1_3_peaucellier() {
    let geometry = "side=0.2; crank_length=0.18; speed=0.3; --step 0.5";
    published(
        "kinematics",
        "peaucellier.toml",
        &format!("{geometry}; start=-0.6; --end 4"),
        |run| {
            let lines = [
                (0.0, -0.18044614560561362),
                (1.0, -0.08816221053400546),
                (3.0, 0.0881622105340055),
                (4.0, 0.18044614560561356),
            ];
            for (t, y) in lines {
                run.near(t, "P.x", 0.5833333333333334, 1e-12);
                run.near(t, "P.y", y, 1e-12);
            }
            for t in run.channel("time").to_vec() {
                let near = run.at(t, "C.x").hypot(run.at(t, "C.y"));
                let far = run.at(t, "P.x").hypot(run.at(t, "P.y"));
                run.same("inversion AC * AP", near * far, 0.21, 1e-12);
            }
        },
    );
    published(
        "kinematics",
        "peaucellier.toml",
        &format!("{geometry}; start=0.0001; --end 1"),
        |run| {
            run.near(0.0, "P.y", 2.916666669090795e-5, 1e-12);
        },
    );
}

/// Problems 3.1 and 3.2: a point of a body whose reference point and angle are given.
#[test]
fn problems_3_1_and_3_2() {
    published("kinematics", "driven-body.toml", "", |run| {
        run.all(
            0.0,
            "P",
            &[("x", 4.080761184457488), ("y", 4.202081528017131)],
            1e-13,
        );
        run.all(
            0.0,
            "P",
            &[("vx", -148.31222920256963), ("vy", -147.88582233137674)],
            1e-11,
        );
    });
    let options = "x=0; y=0; x_speed=5; y_speed=3; start=0; speed=50";
    published("kinematics", "driven-body.toml", options, |run| {
        let rows = [
            (0.0, [0.2, 1.5, -70.0, 13.0]),
            (
                0.25,
                [
                    1.5490425018625171,
                    2.2334330392976307,
                    -69.17165196488155,
                    17.952125093125858,
                ],
            ),
            (
                1.0,
                [
                    5.586555486254316,
                    4.394974071997384,
                    -64.7487035998692,
                    32.32777431271579,
                ],
            ),
        ];
        for (t, [x, y, vx, vy]) in rows {
            run.all(t, "P", &[("x", x), ("y", y)], 1e-12);
            run.all(t, "P", &[("vx", vx), ("vy", vy)], 1e-11);
        }
    });
}

/// Problem 3.19: one point of a body follows (5 t, 0), its angle is 7.5 t^2.
#[test]
fn problem_3_19() {
    published("kinematics", "driven-point.toml", "", |run| {
        run.all(
            0.0,
            "plate",
            &[
                ("x", -0.3),
                ("y", -1.2),
                ("vx", 5.0),
                ("vy", 0.0),
                ("omega", 0.0),
            ],
            1e-13,
        );
        run.all(
            2.0,
            "plate",
            &[("x", 8.768086616122291), ("y", 0.1113077473627577)],
            1e-12,
        );
        run.all(
            2.0,
            "plate",
            &[
                ("vx", 1.6607675791172696),
                ("vy", -36.95740151633128),
                ("omega", 30.0),
            ],
            1e-11,
        );
    });
}

/// Problems 3.13 and 3.14: a point moves on a body that moves and turns.
#[test]
fn problems_3_13_and_3_14() {
    // Time, position, velocity, acceleration.
    let cases = [
        (
            "",
            [
                [0.0, 0.0, 0.0, 1.0, 0.0, 3.0, 0.0],
                [
                    1.0,
                    4.193505498605057,
                    6.974562225008621,
                    -144.28402596260912,
                    -459.17445276017634,
                    -73083.49658128637,
                    20550.415966249013,
                ],
                [
                    1.5,
                    12.156913505885397,
                    26.41996161499654,
                    -65.51839931614116,
                    -1547.7898161283267,
                    -240730.17643626724,
                    6969.528793969805,
                ],
            ],
        ),
        (
            "steady=0; growing=-50",
            [
                [0.0, 0.0, 0.0, 1.0, 0.0, 3.0, 0.0],
                [
                    1.0,
                    3.2345736038499564,
                    5.498664195079553,
                    -368.94409896925526,
                    -319.0836102728107,
                    -53389.96009124318,
                    54064.21973495983,
                ],
                [
                    1.5,
                    11.514450273323154,
                    23.309873210425174,
                    -1225.794546310994,
                    -3335.0141024277405,
                    -1148513.6429619254,
                    403308.78615620703,
                ],
            ],
        ),
    ];
    for (options, rows) in cases {
        published("kinematics", "moving-point.toml", options, |run| {
            for [t, x, y, vx, vy, ax, ay] in rows {
                run.all(t, "point", &[("x", x), ("y", y)], 1e-11);
                run.all(t, "point", &[("vx", vx), ("vy", vy)], 1e-9);
                run.all(t, "point", &[("ax", ax), ("ay", ay)], 1e-6);
                run.near(t, "point.relative.x", 1.5 * t * t, 1e-12);
                run.near(t, "point.relative.vy", -9.0 * t * t, 1e-10);
                run.near(t, "point.relative.ay", -18.0 * t, 1e-8);
            }
        });
    }
}
