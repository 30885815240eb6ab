//! The robot PUMA 560 with the parameters of Corke and Armstrong-Helouvry (1994), as in the Robotics Toolbox, without
//! motors: joint torques of two other programs that agree to 6e-14.

use super::harness::published;

/// Torques at rest in three poses (the toolbox prints 31.6399, 6.0351 and 0.0283 N m for the first), for unit rates, for
/// unit accelerations and in general motion.
#[test]
fn torques_of_given_motions() {
    published(
        "inverse",
        "puma.toml",
        "q2=45 deg; q3=180 deg; q5=45 deg",
        |run| {
            run.near(0.0, "motor 1.moment", 0.0, 2e-12);
            run.near(0.0, "motor 2.moment", 31.63988037835712, 2e-12);
            run.near(0.0, "motor 3.moment", 6.0351380230105125, 2e-12);
            run.near(0.0, "motor 4.moment", 0.0, 2e-12);
            run.near(0.0, "motor 5.moment", 0.0282528, 2e-12);
            run.near(0.0, "motor 6.moment", 0.0, 2e-12);
        },
    );
    published("inverse", "puma.toml", "", |run| {
        run.near(0.0, "motor 1.moment", 0.0, 2e-12);
        run.near(0.0, "motor 2.moment", 37.48366665, 2e-12);
        run.near(0.0, "motor 3.moment", 0.2489287499999998, 2e-12);
        run.near(0.0, "motor 4.moment", 0.0, 2e-12);
        run.near(0.0, "motor 5.moment", 0.0, 2e-12);
        run.near(0.0, "motor 6.moment", 0.0, 2e-12);
    });
    published("inverse", "puma.toml", "q2=90 deg; q3=-90 deg", |run| {
        run.near(0.0, "motor 1.moment", 0.0, 2e-12);
        run.near(0.0, "motor 2.moment", -0.7752352499999957, 2e-12);
        run.near(0.0, "motor 3.moment", 0.24892874999999998, 2e-12);
        run.near(0.0, "motor 4.moment", 0.0, 2e-12);
        run.near(0.0, "motor 5.moment", 0.0, 2e-12);
        run.near(0.0, "motor 6.moment", 0.0, 2e-12);
    });
    published(
        "inverse",
        "puma.toml",
        "q2=45 deg; q3=180 deg; q5=45 deg; r1=1; r2=1; r3=1; r4=1; r5=1; r6=1",
        |run| {
            run.near(0.0, "motor 1.moment", -1.3910743710831226, 2e-12);
            run.near(0.0, "motor 2.moment", 33.42279896769273, 2e-12);
            run.near(0.0, "motor 3.moment", 5.2831112680523615, 2e-12);
            run.near(0.0, "motor 4.moment", 0.0012230818156597546, 2e-12);
            run.near(0.0, "motor 5.moment", 0.030632278489071813, 2e-12);
            run.near(0.0, "motor 6.moment", 0.00014828427124746193, 2e-12);
        },
    );
    published(
        "inverse",
        "puma.toml",
        "q2=45 deg; q3=180 deg; q5=45 deg; a1=1; a2=1; a3=1; a4=1; a5=1; a6=1",
        |run| {
            run.near(0.0, "motor 1.moment", 2.569080889421025, 2e-12);
            run.near(0.0, "motor 2.moment", 33.6776963989757, 2e-12);
            run.near(0.0, "motor 3.moment", 6.849090745412271, 2e-12);
            run.near(0.0, "motor 4.moment", -0.0007475915567832133, 2e-12);
            run.near(0.0, "motor 5.moment", 0.032734639456414694, 2e-12);
            run.near(0.0, "motor 6.moment", 6.828427124746191e-05, 2e-12);
        },
    );
    let general = "q1=0.3; q2=-0.6; q3=1.1; q4=0.7; q5=-0.4; q6=0.9; \
        r1=0.5; r2=-0.3; r3=0.8; r4=-1.2; r5=0.6; r6=1.5; \
        a1=1.0; a2=-2.0; a3=0.5; a4=3.0; a5=-1.0; a6=2.0";
    published("inverse", "puma.toml", general, |run| {
        run.near(0.0, "motor 1.moment", 1.5705481744071612, 2e-12);
        run.near(0.0, "motor 2.moment", 24.571227915982853, 2e-12);
        run.near(0.0, "motor 3.moment", -3.9109760701513054, 2e-12);
        run.near(0.0, "motor 4.moment", 0.0029538657144289543, 2e-12);
        run.near(0.0, "motor 5.moment", -0.0012396629414907839, 2e-12);
        run.near(0.0, "motor 6.moment", 0.0002478096073677468, 2e-12);
    });
}

/// The mass matrix in a general pose, column by column: torques for one unit acceleration without the weight.
#[test]
fn mass_matrix() {
    let columns: [[f64; 6]; 6] = [
        [
            2.4269649939733102,
            0.24663272026914318,
            -0.12341285323309344,
            0.0014878146823642906,
            -0.000435199279736499,
            3.804403535814272e-05,
        ],
        [
            0.24663272026914315,
            1.4319029434456152,
            0.0226763034377828,
            8.065337852490668e-05,
            0.0008288922208061053,
            -1.0034807354000564e-05,
        ],
        [
            -0.12341285323309342,
            0.022676303437782756,
            0.3615636654299504,
            0.000358690599053804,
            0.0013899810387311814,
            -1.0034807354000564e-05,
        ],
        [
            0.0014878146823642828,
            8.065337852490786e-05,
            0.0003586905990538048,
            0.0016706568858191884,
            0.0,
            3.6842439760115405e-05,
        ],
        [
            -0.0004351992797364991,
            0.0008288922208061054,
            0.0013899810387311814,
            0.0,
            0.0006421600000000002,
            0.0,
        ],
        [
            3.804403535814272e-05,
            -1.0034807354000564e-05,
            -1.003480735400061e-05,
            3.684243976011541e-05,
            0.0,
            4e-05,
        ],
    ];
    let pose = "q1=0.3; q2=-0.6; q3=1.1; q4=0.7; q5=-0.4; q6=0.9";
    let mut weight = [0.0; 6];
    published("inverse", "puma.toml", pose, |run| {
        weight = MOTORS.map(|motor| run.at(0.0, motor));
        // Joint 1 stands upright.
        run.near(0.0, MOTORS[0], 0.0, 1e-12);
    });
    for (k, column) in columns.into_iter().enumerate() {
        published(
            "inverse",
            "puma.toml",
            &format!("{pose}; a{}=1", k + 1),
            |run| {
                for ((motor, weight), entry) in MOTORS.into_iter().zip(weight).zip(column) {
                    let found = run.at(0.0, motor) - weight;
                    run.same(&format!("column {k}, {motor}"), found, entry, 1e-12);
                }
            },
        );
    }
}

const MOTORS: [&str; 6] = [
    "motor 1.moment",
    "motor 2.moment",
    "motor 3.moment",
    "motor 4.moment",
    "motor 5.moment",
    "motor 6.moment",
];

/// Accelerations without torques in general motion. Link 1 has moments of inertia alone; no torque is needed for the same
/// accelerations in inverse dynamics.
#[test]
fn let_go() {
    published("simulate", "puma-let-go.toml", "", |run| {
        run.near(0.0, "joint 1.angle_acceleration", 2.7890008828772284, 1e-12);
        run.near(
            0.0,
            "joint 2.angle_acceleration",
            -19.665694596740007,
            1e-12,
        );
        run.near(0.0, "joint 3.angle_acceleration", 13.045010137867573, 1e-12);
        run.near(0.0, "joint 4.angle_acceleration", -2.103052436155147, 1e-12);
        run.near(
            0.0,
            "joint 5.angle_acceleration",
            -2.2086311180783884,
            1e-12,
        );
        run.near(
            0.0,
            "joint 6.angle_acceleration",
            -2.4811650076332343,
            1e-12,
        );
        run.near(0.5, "energy.balance", 0.0, 1e-9);
    });
    let options = "q1=0.3; q2=-0.6; q3=1.1; q4=0.7; q5=-0.4; q6=0.9; \
        r1=0.5; r2=-0.3; r3=0.8; r4=-1.2; r5=0.6; r6=1.5; \
        a1=2.7890008828772284; a2=-19.665694596740007; a3=13.045010137867573; \
        a4=-2.103052436155147; a5=-2.2086311180783884; a6=-2.4811650076332343";
    published("inverse", "puma.toml", options, |run| {
        for motor in MOTORS {
            run.near(0.0, motor, 0.0, 1e-12);
        }
    });
}
