//! Driven slider cranks in A. A. Shabana, Computational Dynamics (2nd ed., 2001).
//!
//! The numbers are recomputed from closed forms; where the book prints digits they agree with it to
//! what is printed, but for its misprints.

use super::harness::{Run, published, table};
use std::f64::consts::{FRAC_PI_2, PI};

/// Crank angle, rod angle, slider position, then their rates and accelerations (rod, slider).
type Row = [f64; 7];

fn slider_crank_row(run: &mut Run, t: f64, row: &Row, scale: f64) {
    let [crank, rod, x, rod_rate, x_rate, rod_second, x_second] = *row;
    run.near(t, "crank.angle", crank, 1e-12);
    run.near(t, "rod.angle", rod, 1e-12);
    run.near(t, "slider.x", x, 1e-12);
    run.near(t, "rod.omega", rod_rate, 1e-11 * scale);
    run.near(t, "slider.vx", x_rate, 1e-11 * scale);
    run.near(t, "rod.alpha", rod_second, 1e-11 * scale * scale);
    run.near(t, "slider.ax", x_second, 1e-11 * scale * scale);
}

/// Table 3.1: slider crank in line, 0.2 m and 0.4 m, 50 rad/s, every 0.2 rad. (The table prints
/// x_B'' at 1.2 rad with a wrong exponent.)
#[test]
fn table_3_1() {
    published("kinematics", "slider-crank.toml", "", |run| {
        for (k, row) in table("table-3-1.csv").iter().enumerate() {
            slider_crank_row(run, 0.004 * k as f64, row, 50.0);
        }
    });
}

/// Example 3.3 with an offset and an accelerated crank.
#[test]
fn example_3_3() {
    let options = "offset=50 mm; start=0.7; speed=20; acceleration=30";
    published("kinematics", "slider-crank.toml", options, |run| {
        let row = [
            0.7,
            -0.1984080305153773,
            0.5451210819752774,
            -7.801474226688698,
            -3.1919665742886987,
            107.4829105864034,
            -80.44593466673233,
        ];
        slider_crank_row(run, 0.0, &row, 20.0);
    });
}

/// Section 3.9: 0.15 m and 0.35 m, 150 rad/s from 30 degrees, every 30 degrees.
#[test]
fn section_3_9_driven_crank() {
    let step = (PI / 6.0 / 150.0).to_string();
    let end = (12.0 * PI / 6.0 / 150.0).to_string();
    let options = &format!(
        "crank_length=150 mm; rod_length=350 mm; start=30 deg; speed=150; --step {step}; --end {end}"
    );
    published("kinematics", "slider-crank.toml", options, |run| {
        let times = run.channel("time").to_vec();
        let rows = table("section-3-9.csv");
        assert_eq!(times.len(), rows.len());
        for (t, row) in times.iter().zip(&rows) {
            slider_crank_row(run, *t, row, 150.0);
        }
        let first = [
            ("crank.x", 0.0649519052838329),
            ("crank.y", 0.0375),
            ("rod.x", 0.3008387397073826),
            ("rod.y", 0.0375),
        ];
        for (channel, value) in first {
            run.near(0.0, channel, value, 1e-14);
        }
        let rates = [
            ("crank.vx", -5.625),
            ("crank.vy", 9.742785792574935),
            ("rod.vx", -13.387389175286291),
            ("rod.vy", 9.742785792574935),
        ];
        for (channel, value) in rates {
            run.near(0.0, channel, value, 1e-11);
        }
        let seconds = [
            ("crank.ax", -1461.4178688862403),
            ("crank.ay", -843.75),
            ("rod.ax", -3319.768552078519),
            ("rod.ay", -843.75),
        ];
        for (channel, value) in seconds {
            run.near(0.0, channel, value, 1e-9);
        }
    });
}

/// Section 3.9, second case: the slider follows 0.35 m - 0.12 m sin(150 t).
#[test]
fn section_3_9_driven_slider() {
    published("kinematics", "slider-driven.toml", "", |run| {
        run.near(0.0, "crank.angle", 77.62637488_f64.to_radians(), 1e-10);
        run.near(0.0, "rod.angle", -0.4319209974, 1e-10);
        run.near(0.0, "crank.omega", 111.5712784240, 1e-9);
        run.near(0.0, "rod.omega", -11.2824888294, 1e-9);
        run.near(0.0, "crank.alpha", 2426.8124941, 1e-6);
        run.near(0.0, "rod.alpha", 5433.8672709, 1e-6);
        // The whole motion by the law of cosines.
        for t in run.channel("time").to_vec() {
            let x = 0.35 - 0.12 * (150.0 * t).sin();
            let crank = ((x * x + 0.15_f64.powi(2) - 0.35_f64.powi(2)) / (0.3 * x)).acos();
            run.near(t, "slider.x", x, 1e-13);
            run.near(t, "crank.angle", crank, 1e-12);
            run.near(t, "rod.angle", -(0.15 * crank.sin() / 0.35).asin(), 1e-12);
        }
    });
}

/// Problems 3.3 and 3.4: 0.3 m and 0.5 m, 100 rad/s, at 45 degrees, without and with an offset.
#[test]
fn problems_3_3_and_3_4() {
    let cases = [
        (
            "offset=0 mm",
            [
                FRAC_PI_2 / 2.0,
                -0.43814903058417026,
                0.6649012912628351,
                -46.85212856658182,
                -31.152040782332612,
                3656.7514978795566,
                -2339.4899438538523,
            ],
            [
                -26.182622108964516,
                10.606601717798213,
                -2230.4051437067474,
                -1060.6601717798212,
            ],
        ),
        (
            "offset=50 mm",
            [
                FRAC_PI_2 / 2.0,
                -0.3302336567345259,
                0.6851153357901655,
                -44.849793578912404,
                -28.484791708990553,
                3795.4640366025956,
                -2457.3618332143396,
            ],
            [
                -24.848997572293488,
                10.606601717798213,
                -2289.341088386991,
                -1060.6601717798212,
            ],
        ),
    ];
    for (offset, row, [vx, vy, ax, ay]) in cases {
        let options =
            &format!("crank_length=0.3; rod_length=0.5; {offset}; start=45 deg; speed=100");
        published("kinematics", "slider-crank.toml", options, |run| {
            slider_crank_row(run, 0.0, &row, 100.0);
            run.all(0.0, "rod", &[("vx", vx), ("vy", vy)], 1e-11);
            run.all(0.0, "rod", &[("ax", ax), ("ay", ay)], 1e-9);
        });
    }
}

/// Problem 3.5: the same lengths, the crank at 150 t + 3.
#[test]
fn problem_3_5() {
    let options = "crank_length=0.3; rod_length=0.5; start=3; speed=150; --end 30 ms; --step 1 ms";
    published("kinematics", "slider-crank.toml", options, |run| {
        run.near(0.0, "rod.angle", -0.08477350649389083, 1e-12);
        run.near(0.0, "slider.x", 0.20120668987932344, 1e-12);
        run.near(0.01, "rod.angle", 0.6267530975911145, 1e-12);
        run.near(0.01, "slider.x", 0.34172933078274603, 1e-12);
        run.near(0.03, "rod.angle", -0.5977692904854702, 1e-12);
        run.near(0.03, "slider.x", 0.5172871522214222, 1e-12);
    });
}

/// Problem 3.10: the slider of problem 3.3 moves at +5 m/s.
#[test]
fn problem_3_10() {
    let options = "crank_length=0.3; rod_length=0.5; slider_start=0.6649012912628351; speed=5; amplitude=0; --end 1 ms";
    published("kinematics", "slider-driven.toml", options, |run| {
        run.near(0.0, "crank.angle", FRAC_PI_2 / 2.0, 1e-12);
        run.near(0.0, "crank.omega", -16.050312834835758, 1e-11);
        run.near(0.0, "rod.omega", 7.519913204715831, 1e-11);
        run.near(0.0, "crank.alpha", -193.46467727605162, 1e-9);
        run.near(0.0, "rod.alpha", 184.8448242465433, 1e-9);
        run.all(
            0.0,
            "rod",
            &[("vx", 4.202392756851676), ("vy", -1.7023927568516763)],
            1e-11,
        );
        run.all(
            0.0,
            "rod",
            &[("ax", -6.803908531933434), ("ay", -47.84396409852234)],
            1e-9,
        );
    });
}

/// Problem 3.29: 0.2 m and 0.4 m, 30 rad/s from 30 degrees; after many turns.
#[test]
fn problem_3_29() {
    let options = "start=30 deg; speed=30; --end 2 s; --step 10 ms";
    published("kinematics", "slider-crank.toml", options, |run| {
        run.near(0.0, "slider.x", 0.5605034154, 1e-10);
        run.near(1.0, "slider.x", 0.4939702192, 1e-10);
        run.near(2.0, "slider.x", 0.2371166386, 1e-10);
        run.near(2.0, "crank.angle", PI / 6.0 + 60.0, 1e-12);
    });
}

/// Section 5.2: how the rod and the slider follow the crank, and the other way round.
#[test]
fn section_5_2_slider_crank_ratios() {
    let options = "start=45 deg; speed=1; --end 0.1 s";
    published("kinematics", "slider-crank.toml", options, |run| {
        run.near(0.0, "rod.angle", -0.3613671239067078, 1e-13);
        run.near(0.0, "slider.x", 0.5155870949147037, 1e-13);
        run.near(0.0, "rod.omega", -0.37796447300922725, 1e-13);
        run.near(0.0, "slider.vx", -0.1948736046197944, 1e-13);
    });
    let options = "crank_length=0.2; rod_length=0.4; slider_start=0.5155870949147037; speed=1; amplitude=0; --end 1 ms";
    published("kinematics", "slider-driven.toml", options, |run| {
        run.near(0.0, "crank.omega", -5.131531291531436, 1e-12);
        run.near(0.0, "rod.omega", 1.9395365203340387, 1e-12);
    });
}
