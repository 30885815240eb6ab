//! Equilibria with closed forms.

use super::harness::{answer, published, refused};

/// A chain of ten links between two points at the same height.
#[test]
fn hanging_chain() {
    published("statics", "catenary.toml", "", |run| {
        let points = [
            [0.0622110905191137, -0.13649095287389065],
            [0.13805049086770194, -0.2659065058602553],
            [0.2331915775417546, -0.381872766585004],
            [0.3542677572058749, -0.47041969605148337],
            [0.5, -0.5059459315710845],
            [0.6457322427941251, -0.47041969605148337],
            [0.7668084224582454, -0.381872766585004],
            [0.8619495091322981, -0.2659065058602553],
            [0.9377889094808863, -0.13649095287389065],
        ];
        for (k, [x, y]) in points.into_iter().enumerate() {
            run.first(&format!("point {}.x", k + 1), x, 1e-10);
            run.first(&format!("point {}.y", k + 1), y, 1e-10);
        }
        run.first("pin 0.force_x", -4.024162090074492, 1e-9);
        run.first("pin 0.force_y", 9.81, 1e-9);
    });
}

/// Shabana, Section 5.6, problem 5.19: a two-arm manipulator with moments on its links stands where
/// (m2 lO + m3 l2) g cos(first) = M2 and m3 lA g cos(second) = M3; only one of the four such poses is
/// stable, and beyond the limits there is none.
#[test]
fn two_arm_equilibria() {
    let options = "first_moment=10; second_moment=3";
    let first = (10.0_f64 / (9.81 * (2.0 * 0.4 + 1.5))).acos();
    let second = (3.0_f64 / (9.81 * 1.5 * 0.35)).acos();
    published("statics", "two-link-arm.toml", options, |run| {
        // Where the arms hang down the moments hold them on the stable side.
        run.first("first.angle", -first, 1e-10);
        run.first("second.angle", -second, 1e-10);
        run.first("O.force_y", 9.81 * 3.5, 1e-10);
    });
    let report = answer("statics", "two-link-arm.toml", options);
    let equilibria = report["equilibria"].as_array().expect("a list");
    let stable = equilibria
        .iter()
        .filter(|e| e["stability"] == "stable")
        .count();
    assert_eq!((equilibria.len(), stable), (4, 1), "{report:#}");
    let beyond = "first_moment=30; second_moment=3";
    let said = refused("statics", "two-link-arm.toml", beyond);
    assert!(said.contains("equilibrium"), "{said}");
}
