//! How the machines of the gallery can move, by counting and by rank.

use super::run::{answer, models};

/// Model, coordinates, independent rows, mobility by counting.
const MOBILITY: [(&str, i64, i64, i64); 52] = [
    ("ball-in-bowl", 6, 1, 5),
    // The curve parameter is a coordinate too; the bead may turn.
    ("bead-on-wire", 7, 3, 4),
    ("bicycle-wheel-gyroscope", 12, 9, 3),
    ("bracket-pendulum", 6, 5, 1),
    // Six hinges in a ring: counting says that it cannot move.
    ("bricard", 30, 29, 0),
    // The surface parameter of a cam and the angle of a rolling contact are coordinates too.
    ("cam-flat", 7, 6, 1),
    ("cam-knife-edge", 7, 6, 1),
    ("cam-roller", 7, 6, 1),
    ("cardan-gyroscope", 24, 21, 3),
    ("catenary", 30, 22, 8),
    ("constant-velocity-joint", 18, 16, 2),
    ("crank-rocker", 9, 8, 1),
    ("double-crank", 9, 8, 1),
    // Counting says that it cannot move.
    ("double-parallelogram", 12, 11, 0),
    ("double-pendulum", 6, 4, 2),
    ("double-rocker", 9, 8, 1),
    ("double-universal-joint", 18, 17, 1),
    ("ellipsoid-on-plane", 11, 6, 5),
    ("four-bar", 9, 8, 1),
    // The same linkage as crank-rocker, in space.
    ("four-revolutes", 18, 17, -2),
    ("heavy-top-cuspidal", 6, 3, 3),
    ("heavy-top-looping", 6, 3, 3),
    ("heavy-top-steady", 6, 3, 3),
    ("intermediate-axis-flip", 6, 0, 6),
    ("peaucellier", 21, 20, 1),
    ("pendulum", 3, 2, 1),
    ("pendulum-moving-base", 6, 4, 2),
    // Two planets more than the motion needs.
    ("planetary-gear", 15, 14, -1),
    ("quick-return", 12, 11, 1),
    ("rack-and-pinion", 6, 5, 1),
    ("robot-arm-forward", 6, 4, 2),
    ("robot-arm-inverse", 6, 4, 2),
    ("rod-and-disk", 6, 4, 2),
    // Two rows of no slip hold velocities only.
    ("rolling-coin", 6, 3, 3),
    ("rolling-cylinder", 4, 3, 1),
    ("rolling-disc", 6, 3, 3),
    ("rssr-four-bar", 18, 17, 1),
    ("screw-jack", 12, 11, 1),
    ("slider-crank", 9, 8, 1),
    ("slider-driven", 9, 8, 1),
    ("spatial-arm-2r", 12, 10, 2),
    ("spatial-arm-3r", 24, 21, 3),
    ("spatial-slider-crank", 18, 17, 1),
    ("spring-damper-four-bar", 9, 8, 1),
    // A bushing is no joint.
    ("springy-beam", 6, 0, 6),
    ("steering-rack", 24, 23, 1),
    ("stewart-platform-forward", 78, 72, 6),
    ("stewart-platform-inverse", 78, 72, 6),
    ("torque-free-top", 6, 0, 6),
    ("universal-joint", 12, 11, 1),
    ("watt", 9, 8, 1),
    ("worm-gear", 12, 11, 1),
];

#[test]
fn every_model_moves_as_it_should() {
    let named: Vec<&str> = MOBILITY.iter().map(|(name, ..)| *name).collect();
    assert_eq!(named, models());
    for (model, coordinates, rank, count) in MOBILITY {
        let report = &answer("check", model, &[])["mobility"];
        let joints = &report["mobility"];
        let number = |value: &serde_json::Value| value.as_i64().expect("a whole number");
        let found = [
            number(&report["coordinates"]) + number(&report["auxiliaries"]),
            number(&joints["rank"]),
            number(&joints["count"]),
            number(&joints["freedoms"]),
        ];
        let expected = [coordinates, rank, count, coordinates - rank];
        assert_eq!(found, expected, "{model}");
    }
}
