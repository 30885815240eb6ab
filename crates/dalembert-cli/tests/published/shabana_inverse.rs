//! Forces and moments that a given motion or rest takes, in A. A. Shabana, Computational Dynamics
//! (2nd ed., 2001).
//!
//! Rest is a motion with zero speed: so most statics of the book are here too. Where a figure with
//! the dimensions is missing from the problems, the dimensions are those of the model file.

use super::harness::published;

/// Equation 1.7: force on a block that follows 0.05 sin(20 t).
#[test]
fn section_1_7_block() {
    published("inverse", "block-driven.toml", "", |run| {
        run.near(1.5, "piston.force", 39.52126496371447, 1e-11);
        run.near(1.5, "floor.force_y", 19.62, 1e-12);
    });
}

/// Section 4.7: two-arm manipulator, moments from outside, and of motors in the joints.
#[test]
fn section_4_7_open_chain() {
    published("inverse", "two-link-inverse.toml", "", |run| {
        run.near(0.0, "first motor.moment", 25.047063489410068, 1e-11);
        run.near(0.0, "second motor.moment", 4.967968605136775, 1e-11);
        run.near(0.0, "O.force_x", -18.44496243721392, 1e-11);
        run.near(0.0, "O.force_y", 31.090048953836416, 1e-11);
        run.near(0.0, "A.force_x", -13.323864313741083, 1e-11);
        run.near(0.0, "A.force_y", 11.350240733070985, 1e-11);
        run.near(0.0, "first centre.ax", -2.560549061736419, 1e-12);
        run.near(0.0, "first centre.ay", 0.059904110382713864, 1e-12);
        run.near(0.0, "second centre.ax", -8.882576209160723, 1e-12);
        run.near(0.0, "second centre.ay", -2.2431728446193433, 1e-12);
    });
    let options = "--actuator O; --actuator A";
    published("inverse", "two-link-inverse.toml", options, |run| {
        run.near(0.0, "actuator O.moment", 30.015032094546843, 1e-11);
        run.near(0.0, "actuator A.moment", 4.967968605136775, 1e-11);
        run.near(0.0, "O.force_x", -18.44496243721392, 1e-11);
    });
}

/// Section 4.7: four-bar linkage with loads on crank and coupler, the moment on the rocker that
/// gives the crank its motion.
#[test]
fn section_4_7_closed_chain() {
    let options = "g=9.81; speed=10; acceleration=20; crank_moment=2; force_x=3; force_y=-1; \
                   --actuator C";
    published("inverse", "four-bar-loaded.toml", options, |run| {
        run.near(0.0, "coupler.angle", 0.2322764189254855, 1e-13);
        run.near(0.0, "rocker.angle", 4.345328481925324, 1e-13);
        run.near(0.0, "coupler.omega", 0.10895883828571111, 1e-12);
        run.near(0.0, "rocker.omega", 6.747538197918897, 1e-12);
        run.near(0.0, "coupler.alpha", 19.41551888902335, 1e-10);
        run.near(0.0, "rocker.alpha", 26.74759834852717, 1e-10);
        run.near(0.0, "actuator C.moment", 2.235826121049856, 1e-11);
        let forces = [
            ("O", -12.688189357193629, -2.195368284302055),
            ("A", -10.038396019779377, -2.743925323698182),
            ("B", 4.456952845539567, 0.09357045255547725),
            // The book has the force of the rocker on the ground.
            ("C", -9.103774488407396, 3.562972156160086),
        ];
        for (joint, x, y) in forces {
            run.all(
                0.0,
                joint,
                &[("force_x", x), ("force_y", y), ("moment", 0.0)],
                1e-11,
            );
        }
        let accelerations = [
            ("crank", -5.299586674828506, -8.712885921207747),
            ("coupler", -11.495348865318944, -13.64749577625366),
            ("rocker", -6.19576219049044, -4.934609855045916),
        ];
        for (body, x, y) in accelerations {
            run.all(0.0, body, &[("ax", x), ("ay", y)], 1e-11);
        }
    });
}

/// Sections 4.7 and 5.4 combined: inertia of the four-bar linkage as its crank feels it.
#[test]
fn four_bar_effective_inertia() {
    published("inverse", "four-bar-loaded.toml", "acceleration=1", |run| {
        run.near(0.0, "motor.moment", 0.057395759212, 1e-12);
    });
}

/// Section 5.3: generalized force of the crank angle of a slider crank (the motor holds it).
#[test]
fn section_5_3_slider_crank() {
    let options = "g=0; crank_moment=2; rod_force_x=3; rod_force_y=-1";
    published("inverse", "slider-crank-inverse.toml", options, |run| {
        run.near(0.0, "motor.moment", -7.271055019189521, 1e-12);
    });
}

/// Example 5.4: generalized force of the crank angle of a four-bar linkage.
#[test]
fn example_5_4_four_bar() {
    let options = "crank_moment=2; force_x=3; force_y=-1; rocker_moment=-0.5";
    published("inverse", "four-bar-loaded.toml", options, |run| {
        run.near(0.0, "motor.moment", -1.0267779378611956, 1e-12);
    });
}

/// Example 5.5: spring and damper between crank and rocker. (From the length on, the book's numbers
/// miss a term of 0.03 sin 70 deg.)
#[test]
fn example_5_5_spring() {
    // Without masses nothing but the spring loads the motor.
    let options =
        "crank_mass=0; coupler_mass=0; rocker_mass=0; speed=150; stiffness=250; damping=10";
    published("inverse", "four-bar-loaded.toml", options, |run| {
        run.near(
            0.0,
            "coupler.angle",
            13.308458484842959_f64.to_radians(),
            1e-13,
        );
        run.near(
            0.0,
            "rocker.angle",
            248.96898261231007_f64.to_radians(),
            1e-13,
        );
        run.near(0.0, "coupler.omega", 1.634382574285668, 1e-11);
        run.near(0.0, "rocker.omega", 101.21307296878346, 1e-11);
        run.all(
            0.0,
            "crank",
            &[("vx", -14.095389311788626), ("vy", 5.130302149885033)],
            1e-12,
        );
        run.all(
            0.0,
            "rocker",
            &[("vx", -14.170634129277804), ("vy", 5.448400363344597)],
            1e-12,
        );
        run.near(0.0, "spring.length", 0.3827882536778371, 1e-14);
        run.near(0.0, "spring.rate", -0.46170746828308906, 1e-12);
        run.near(0.0, "spring.force", 3.579988736628387, 1e-11);
        run.near(0.0, "motor.moment", -0.011019383573804584, 1e-12);
    });
}

/// Sections 5.6 and 5.11: slider crank held against a load and its weight.
#[test]
fn section_5_6_slider_crank() {
    published("inverse", "slider-crank-inverse.toml", "", |run| {
        run.near(0.0, "rod.angle", -0.3613671239067078, 1e-13);
        run.near(0.0, "motor.moment", -4.944434860546627, 1e-12);
        run.all(
            0.0,
            "O",
            &[("force_x", 30.0), ("force_y", -2.509934190276815)],
            1e-12,
        );
        run.all(
            0.0,
            "A",
            &[("force_x", 30.0), ("force_y", -7.414934190276815)],
            1e-12,
        );
        run.all(
            0.0,
            "B",
            &[("force_x", 30.0), ("force_y", -15.262934190276816)],
            1e-12,
        );
        run.near(0.0, "guide.force_y", 9.81 + 15.262934190276816, 1e-12);
    });
}

/// Example 5.7: moment on the rocker that balances 10 N m on the crank, clockwise.
#[test]
fn example_5_7_four_bar() {
    let options = "crank_moment=-10; --actuator C";
    published("inverse", "four-bar-loaded.toml", options, |run| {
        run.near(0.0, "actuator C.moment", 14.82021991825736, 1e-11);
    });
}

/// Example 5.8: a moment and a force of known direction hold a two-link arm.
#[test]
fn example_5_8_two_arm() {
    published("inverse", "two-link-hold.toml", "", |run| {
        run.near(0.0, "push.force", 7.385155103292437, 1e-12);
        run.near(0.0, "moment.moment", 11.382115424918481, 1e-12);
    });
}

/// Problems 5.16, 5.17, 5.29, 5.30: pinned rod, the force at its free end.
#[test]
fn problems_5_16_to_5_30_pinned_rod() {
    published("inverse", "pinned-rod-driven.toml", "", |run| {
        run.near(0.0, "motor.moment", 2.1742635362074125, 1e-13);
    });
    published("inverse", "held-rod.toml", "", |run| {
        run.near(0.0, "weight.force", -12.145535412082955, 1e-12);
    });
    published(
        "inverse",
        "pinned-rod-driven.toml",
        "force=10; speed=150",
        |run| {
            run.near(0.0, "motor.moment", 0.8801683106948093, 1e-10);
            run.near(0.0, "pin.force_x", -7959.9512883486605, 1e-9);
            run.near(0.0, "pin.force_y", -7953.801542386503, 1e-9);
        },
    );
    let options = "force=10; speed=150; acceleration=500";
    published("inverse", "pinned-rod-driven.toml", options, |run| {
        run.near(0.0, "motor.moment", 167.54683497736147, 1e-10);
        run.near(0.0, "pin.force_x", -8136.727983645297, 1e-9);
        run.near(0.0, "pin.force_y", -7777.024847089866, 1e-9);
    });
}

/// Problem 5.28: force on a free rod with the acceleration (50, 120) m/s^2.
#[test]
fn problem_5_28_free_rod() {
    let options = "g=9.81; ax=50; ay=120; acceleration=500";
    published("inverse", "free-rod-driven.toml", options, |run| {
        let (x, y) = (run.at(0.0, "path.force_x"), run.at(0.0, "path.force_y"));
        run.same("force", x.hypot(y), 139.10656382787982, 1e-10);
        run.same(
            "direction",
            y.atan2(x).to_degrees(),
            68.9343959973466,
            1e-10,
        );
        run.near(0.0, "turn.moment", 500.0 / 12.0, 1e-11);
    });
}

/// Problems 5.20, 5.32, 5.34: chain of three rods, at rest and moving.
#[test]
fn problems_5_20_to_5_34_three_links() {
    let model = "three-link-inverse.toml";
    published("inverse", model, "motion=0", |run| {
        run.near(0.0, "first motor.moment", 19.412346169420246, 1e-12);
        run.near(0.0, "second motor.moment", 12.743563816688017, 1e-12);
        run.near(0.0, "third motor.moment", 5.538911122540182, 1e-12);
    });
    published("inverse", model, "", |run| {
        run.near(0.0, "first motor.moment", 1123.1478260243296, 1e-10);
        run.near(0.0, "second motor.moment", 836.4426924828107, 1e-10);
        run.near(0.0, "third motor.moment", 401.228515518621, 1e-10);
        run.all(
            0.0,
            "O",
            &[
                ("force_x", -990.3302774296213),
                ("force_y", 650.086062762946),
            ],
            1e-10,
        );
        run.all(
            0.0,
            "A",
            &[
                ("force_x", -884.2642602516393),
                ("force_y", 604.9207237036186),
            ],
            1e-10,
        );
        run.all(
            0.0,
            "B",
            &[
                ("force_x", -581.919412974573),
                ("force_y", 432.146870111909),
            ],
            1e-10,
        );
    });
    let options = "--actuator O; --actuator A; --actuator B";
    published("inverse", model, options, |run| {
        run.near(0.0, "actuator O.moment", 2360.819034025761, 1e-9);
        run.near(0.0, "actuator A.moment", 1237.6712080014318, 1e-9);
        run.near(0.0, "actuator B.moment", 401.228515518621, 1e-9);
    });
}

/// Problems 5.35 to 5.38: slider crank at 45 degrees and 150 rad/s, 10 N on the slider.
#[test]
fn problems_5_35_to_5_38_slider_crank() {
    for (acceleration, moment) in [(0, 976.617582952), (500, 1013.010112006)] {
        let options = format!("speed=150; slider_force=10; acceleration={acceleration}");
        published("inverse", "slider-crank-inverse.toml", &options, |run| {
            run.near(0.0, "motor.moment", moment, 1e-9);
        });
    }
}

/// Problems 5.39 to 5.43: four-bar linkage at 60 degrees and 150 rad/s with loads.
#[test]
fn problems_5_39_to_5_43_four_bar() {
    for (acceleration, moment) in [(0, 246.841963022), (700, 284.978211324)] {
        let options = format!(
            "g=9.81; start=60 deg; speed=150; acceleration={acceleration}; \
             force_x=8.660254037844387; force_y=5; rocker_moment=5"
        );
        published("inverse", "four-bar-loaded.toml", &options, |run| {
            run.near(0.0, "motor.moment", moment, 1e-9);
        });
    }
}

/// Example 6.1: mass properties of a body of parts, and its inertia forces about its end. (The book
/// adds the masses to 36.227 kg instead of 36.197 kg.)
#[test]
fn example_6_1_parts() {
    published("inverse", "composite-body.toml", "", |run| {
        run.all(0.0, "centre", &[("ax", 100.0), ("ay", -45.0)], 1e-11);
        run.near(0.0, "path.force_x", 3619.7, 1e-9);
        run.near(0.0, "path.force_y", -1628.865, 1e-9);
        run.near(0.0, "turn.moment", -4656.581449691964, 1e-9);
    });
}

/// Problems 6.1 and 6.2: inertia forces and kinetic energy of a free rod.
#[test]
fn problems_6_1_and_6_2_free_rod() {
    for (acceleration, moment) in [(0, 0.0), (450, 37.5)] {
        let options = format!("acceleration={acceleration}");
        published("inverse", "free-rod-driven.toml", &options, |run| {
            run.near(0.0, "path.force_x", 100.0, 1e-12);
            run.near(0.0, "path.force_y", 250.0, 1e-12);
            run.near(0.0, "turn.moment", moment, 1e-12);
            run.near(0.0, "energy.kinetic", 1062.5, 1e-11);
        });
    }
}

/// Section 6.13: slider crank whose slider follows 0.4 - 0.16 sin(20 t); force on the slider, and
/// the moment on the crank that does the same.
#[test]
fn section_6_13_slider_driven() {
    let geometry = "crank_length=0.2; rod_length=0.4; slider_start=0.4; amplitude=-0.16; \
                    frequency=20; g=9.81; --end 0.05; --step 0.01";
    let angles = [(0.01, 1.4648117731), (0.05, 2.0568138101)];
    published("inverse", "slider-driven.toml", geometry, |run| {
        for (t, angle) in angles {
            run.near(t, "crank.angle", angle, 1e-10);
        }
        run.near(0.01, "piston.force", 2.7691003812, 1e-9);
        run.near(0.05, "piston.force", 87.2953605084, 1e-9);
    });
    let options = format!("{geometry}; --actuator O");
    published("inverse", "slider-driven.toml", &options, |run| {
        run.near(0.01, "actuator O.moment", -0.5842851376, 1e-9);
        run.near(0.05, "actuator O.moment", -11.4177083566, 1e-9);
    });
}
