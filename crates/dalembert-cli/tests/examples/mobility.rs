//! How the machines of the gallery can move, by counting and by rank.

use super::run::{answer, models};

/// Model, coordinates, independent rows, mobility by counting.
const MOBILITY: [(&str, i64, i64, i64); 24] = [
    // The surface parameter of a cam and the angle of a rolling contact are coordinates too.
    ("cam-flat", 7, 6, 1),
    ("cam-knife-edge", 7, 6, 1),
    ("cam-roller", 7, 6, 1),
    ("catenary", 30, 22, 8),
    ("crank-rocker", 9, 8, 1),
    ("double-crank", 9, 8, 1),
    // Counting says that it cannot move.
    ("double-parallelogram", 12, 11, 0),
    ("double-pendulum", 6, 4, 2),
    ("double-rocker", 9, 8, 1),
    ("four-bar", 9, 8, 1),
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
    ("rolling-cylinder", 4, 3, 1),
    ("slider-crank", 9, 8, 1),
    ("slider-driven", 9, 8, 1),
    ("spring-damper-four-bar", 9, 8, 1),
    ("watt", 9, 8, 1),
];

#[test]
fn every_model_moves_as_it_should() {
    let named: Vec<&str> = MOBILITY.iter().map(|(name, ..)| *name).collect();
    assert_eq!(named, models());
    for (model, coordinates, rank, count) in MOBILITY {
        let report = &answer("check", model, &[])["mobility"];
        let joints = &report["mobility"];
        let found = [
            &report["coordinates"],
            &joints["rank"],
            &joints["count"],
            &joints["freedoms"],
        ];
        let expected = [coordinates, rank, count, coordinates - rank];
        assert_eq!(
            found.map(serde_json::Value::as_i64),
            expected.map(Some),
            "{model}"
        );
    }
}
