//! Driven four-bar linkages in A. A. Shabana, Computational Dynamics (2nd ed., 2001).
//!
//! The numbers are recomputed from closed forms; where the book prints digits they agree with it to
//! what is printed, but for its misprints.

use super::harness::published;
use std::f64::consts::FRAC_PI_2;

/// Four-bar O-A-B-C by triangles: angles of the coupler and of the direction from B to C, their
/// rates and accelerations. `branch` is the side of the diagonal A-C on which B lies.
fn four_bar_closed_form(
    [base, crank, coupler, rocker]: [f64; 4],
    angle: f64,
    speed: f64,
    branch: f64,
) -> [[f64; 2]; 3] {
    let (ax, ay) = (crank * angle.cos(), crank * angle.sin());
    let diagonal = (base - ax).hypot(-ay);
    let direction = (-ay).atan2(base - ax);
    let corner =
        ((diagonal.powi(2) + coupler.powi(2) - rocker.powi(2)) / (2.0 * diagonal * coupler)).acos();
    let third = direction + branch * corner;
    let (bx, by) = (ax + coupler * third.cos(), ay + coupler * third.sin());
    let fourth = (-by).atan2(base - bx);
    // crank e(2) + coupler e(3) + rocker e(4) = constant, differentiated once and twice.
    let solve = |x: f64, y: f64| {
        let (a, b) = (-coupler * third.sin(), -rocker * fourth.sin());
        let (c, d) = (coupler * third.cos(), rocker * fourth.cos());
        let determinant = a * d - b * c;
        [(d * x - b * y) / determinant, (a * y - c * x) / determinant]
    };
    let rates = solve(crank * angle.sin() * speed, -crank * angle.cos() * speed);
    let squares = [
        (crank, angle, speed),
        (coupler, third, rates[0]),
        (rocker, fourth, rates[1]),
    ];
    let seconds = solve(
        squares.iter().map(|(l, a, w)| l * a.cos() * w * w).sum(),
        squares.iter().map(|(l, a, w)| l * a.sin() * w * w).sum(),
    );
    [[third, fourth], rates, seconds]
}

/// Example 3.4 and Table 3.2: 0.4, 0.2, 0.4, 0.5 m, 50 rad/s from 90 degrees, every 0.2 rad.
#[test]
fn table_3_2() {
    let options = "base=0.4; coupler_length=0.4; rocker_length=0.5; start=pi/2; speed=50; coupler_start=0.8; rocker_start=4.95; --end 0.124; --step 0.004";
    published("kinematics", "four-bar.toml", options, |run| {
        for k in 0..32 {
            let (t, angle) = (0.004 * f64::from(k), FRAC_PI_2 + 0.2 * f64::from(k));
            let [angles, rates, seconds] =
                four_bar_closed_form([0.4, 0.2, 0.4, 0.5], angle, 50.0, 1.0);
            for (i, body) in ["coupler", "rocker"].into_iter().enumerate() {
                let found = run.at(t, &format!("{body}.angle"));
                // The closed form knows the angle up to whole turns only.
                run.same(
                    &format!("{body} turned at {t}"),
                    (found - angles[i]).sin(),
                    0.0,
                    1e-12,
                );
                run.same(
                    &format!("{body} sense at {t}"),
                    (found - angles[i]).cos(),
                    1.0,
                    1e-12,
                );
                run.near(t, &format!("{body}.omega"), rates[i], 1e-9);
                run.near(t, &format!("{body}.alpha"), seconds[i], 1e-7);
            }
        }
        // Entries of the table, to the digits that hold.
        run.near(0.0, "coupler.angle", 0.7946, 5e-5);
        run.near(0.0, "rocker.angle", 4.9543, 5e-5);
        run.near(0.08, "coupler.angle", 2.1042, 5e-5);
        run.near(0.08, "coupler.omega", 11.917, 5e-4);
        run.near(0.084, "coupler.angle", 2.1308, 5e-5);
        run.near(0.084, "rocker.angle", 5.7806, 5e-5);
        run.near(0.084, "coupler.omega", 0.50426, 5e-6);
        run.near(0.072, "rocker.omega", -2.0406, 5e-5);
        run.near(0.1, "rocker.alpha", 2894.956, 5e-4);
        run.near(0.096, "rocker.alpha", -187.91, 5e-3);
    });
}

/// Example 3.13: the converged answer; the book stops after one Newton step, up to 2 % away.
#[test]
fn example_3_13() {
    published("kinematics", "four-bar.toml", "", |run| {
        run.near(0.02, "crank.angle", 1.0995500626171526, 1e-12);
        run.near(0.02, "coupler.angle", 0.16203060131882652, 1e-12);
        run.near(0.02, "rocker.angle", 4.360299262262077, 1e-12);
    });
    published("kinematics", "four-bar.toml", "start=63 deg", |run| {
        run.near(0.0, "coupler.angle", 0.16203002666534397, 1e-12);
        run.near(0.0, "rocker.angle", 4.360304717755604, 1e-12);
        run.near(0.0, "coupler.omega", -0.3900604489967335, 1e-11);
        run.near(0.0, "rocker.omega", 3.703093258639361, 1e-11);
        run.near(0.0, "coupler.alpha", 5.127100640852201, 1e-10);
        run.near(0.0, "rocker.alpha", 6.0927797170790265, 1e-10);
    });
}

/// Problem 3.6: both assemblies of 0.32, 0.3, 0.35, 0.4 m at 60 degrees, 100 rad/s.
#[test]
fn problem_3_6() {
    let cases = [
        (
            ["coupler_start=0.3", "rocker_start=-2"],
            [
                0.30497547157415295,
                -1.9928365718047782,
                -11.630770436568216,
                67.84953232796012,
                4491.6173239592945,
                3460.9745803857027,
            ],
        ),
        (
            ["coupler_start=-2.3", "rocker_start=0"],
            [
                -2.287741423400701,
                0.010070619978230291,
                98.7676998971491,
                19.287397132620804,
                -2272.9127547692883,
                -1242.2700111956942,
            ],
        ),
    ];
    for ([coupler, rocker], [a3, a4, w3, w4, e3, e4]) in cases {
        let options = &format!(
            "base=0.32; crank_length=0.3; coupler_length=0.35; rocker_length=0.4; start=60 deg; speed=100; {coupler}; {rocker}; --end 1 ms; --step 1 ms"
        );
        published("kinematics", "four-bar.toml", options, |run| {
            run.near(0.0, "coupler.angle", a3, 1e-12);
            run.near(0.0, "rocker.angle", a4, 1e-12);
            run.near(0.0, "coupler.omega", w3, 1e-10);
            run.near(0.0, "rocker.omega", w4, 1e-10);
            run.near(0.0, "coupler.alpha", e3, 1e-8);
            run.near(0.0, "rocker.alpha", e4, 1e-8);
        });
    }
}

/// Example 5.2: how coupler and rocker of the linkage of Example 5.5 follow the crank at 70 degrees.
#[test]
fn example_5_2() {
    let options = "coupler_length=0.4; rocker_length=0.3; start=70 deg; coupler_start=13 deg; rocker_start=249 deg; speed=1";
    published("kinematics", "four-bar.toml", options, |run| {
        run.near(0.0, "coupler.angle", 0.2322764189254855, 1e-13);
        run.near(0.0, "rocker.angle", 4.345328481925324, 1e-13);
        run.near(0.0, "coupler.omega", 0.010895883828571136, 1e-13);
        run.near(0.0, "rocker.omega", 0.6747538197918895, 1e-13);
        let (coupler, rocker) = (run.at(0.0, "coupler.omega"), run.at(0.0, "rocker.omega"));
        run.same("crank by coupler", 1.0 / coupler, 91.77777734540494, 1e-9);
        run.same(
            "rocker by coupler",
            rocker / coupler,
            61.927405835821524,
            1e-9,
        );
        run.same("crank by rocker", 1.0 / rocker, 1.4820219918257362, 1e-12);
        run.same(
            "coupler by rocker",
            coupler / rocker,
            0.016147939454320824,
            1e-13,
        );
    });
}

/// Example 3.13 in the book's own coordinates: the loop equations as constraints of the user.
#[test]
fn example_3_13_by_its_loop_equations() {
    published("kinematics", "loop-equations.toml", "", |run| {
        run.near(0.0, "coupler.angle", 0.16203002666534397, 1e-13);
        run.near(0.0, "rocker.angle", 4.360304717755604, 1e-13);
        run.near(0.0, "coupler.omega", -0.3900604489967335, 1e-12);
        run.near(0.0, "rocker.omega", 3.703093258639361, 1e-12);
        run.near(0.0, "coupler.alpha", 5.127100640852201, 1e-11);
        run.near(0.0, "rocker.alpha", 6.0927797170790265, 1e-11);
        // Where the crank is not rounded to 63 degrees.
        let (t, start) = (0.02, 57.27_f64.to_radians());
        let [angles, ..] = four_bar_closed_form([0.35, 0.2, 0.35, 0.25], start + 5.0 * t, 5.0, 1.0);
        run.same("coupler", angles[0], 0.16203060131882652, 1e-13);
    });
    let options = "start=1.0995500626171526";
    published("kinematics", "loop-equations.toml", options, |run| {
        run.near(0.0, "coupler.angle", 0.16203060131882652, 1e-13);
        run.near(0.0, "rocker.angle", 4.360299262262077, 1e-13);
        // The whole motion by triangles.
        for k in 0..=10 {
            let t = 0.1 * f64::from(k);
            let angle = 1.0995500626171526 + 5.0 * t;
            let [angles, rates, seconds] =
                four_bar_closed_form([0.35, 0.2, 0.35, 0.25], angle, 5.0, 1.0);
            let sense = (run.at(t, "coupler.angle") - angles[0]).cos();
            run.same(&format!("coupler at {t}"), sense, 1.0, 1e-12);
            run.near(t, "coupler.omega", rates[0], 1e-10);
            run.near(t, "rocker.omega", rates[1], 1e-10);
            run.near(t, "coupler.alpha", seconds[0], 1e-9);
            run.near(t, "rocker.alpha", seconds[1], 1e-9);
        }
    });
}
