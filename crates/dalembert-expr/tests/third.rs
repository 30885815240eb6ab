//! Third derivatives against differences of second ones and against known functions.

mod common;

use common::random::Random;
use common::{Names, compile, free};
use dalembert_expr::{Function, Jet2, Program, Quantity, Spline};
use std::sync::Arc;

/// A table without knots, for differences that must not cross one.
#[derive(Debug)]
struct Wave;

impl Function for Wave {
    fn jet(&self, x: f64) -> [f64; 4] {
        let (s, c) = (2.0 * x).sin_cos();
        [s, 2.0 * c, -4.0 * s, -8.0 * c]
    }

    fn dims(&self) -> (Quantity, Quantity) {
        (Quantity::Free, Quantity::Free)
    }
}

fn scope() -> Names {
    let x: Vec<f64> = (0..9).map(|k| 0.25 * f64::from(k)).collect();
    let y: Vec<f64> = x.iter().map(|x| x.powi(5) - x.powi(2)).collect();
    let quintic = Spline::quintic(&x, &y, false).unwrap();
    Names {
        tables: vec![("wave", Arc::new(Wave)), ("lift", Arc::new(quintic))],
        ..free(&["t"])
    }
}

fn third(text: &str, t: f64) -> [f64; 4] {
    compile(text, &scope()).eval_third(&[t])
}

fn near(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!(
        (found - expected).abs() <= tolerance * (1.0 + expected.abs()),
        "{what}: {found:e} and {expected:e}"
    );
}

/// A random expression of t that is smooth everywhere: arguments are kept inside the domains.
fn smooth(random: &mut Random, depth: usize) -> String {
    if depth == 0 {
        return format!(
            "({:.3} + {:.3}*t)",
            random.between(-1.0, 1.0),
            random.between(-1.5, 1.5)
        );
    }
    let a = smooth(random, depth - 1);
    let other = random.below(depth);
    let b = smooth(random, other);
    let number = random.between(0.2, 1.5);
    match random.below(28) {
        0 => format!("sin({a})"),
        1 => format!("cos({a})"),
        2 => format!("tan(0.8*sin({a}))"),
        3 => format!("asin(0.8*sin({a}))"),
        4 => format!("acos(0.8*sin({a}))"),
        5 => format!("atan({a})"),
        6 => format!("sinh(sin({a}))"),
        7 => format!("cosh(sin({a}))"),
        8 => format!("tanh({a})"),
        9 => format!("exp(sin({a}))"),
        10 => format!("ln(2.5 + sin({a}))"),
        11 => format!("log10(2.5 + sin({a}))"),
        12 => format!("sqrt(2.5 + sin({a}))"),
        13 => format!("abs(-2 + sin({a}))"),
        14 => format!("({a} + {b})^{}", 2 + random.below(3)),
        15 => format!("(2.5 + sin({a}))^-{}", 1 + random.below(3)),
        16 => format!("(2.5 + sin({a}))^{number:.2}"),
        17 => format!("(2.5 + sin({a}))^cos({b})"),
        18 => format!("atan2({a}, 2 + cos({b}))"),
        19 => format!("hypot(1.5 + sin({a}), {b})"),
        20 => format!("mod(5 + 0.4*sin({a}), 3 + 0.4*cos({b}))"),
        21 => format!("min(sin({a}), 1.5 + {number:.2}) * max(sin({b}), -1.5)"),
        22 => format!("blend(sin({a}), -2 + 0.5*cos({b}), 2)"),
        23 => format!("if(sin({a}) < 2, {b}, 0)"),
        24 => format!("wave({a})"),
        25 => format!("{a} / (2 + cos({b}))"),
        26 => format!("{a} * {b}"),
        _ => format!("({a} - {b}/3)"),
    }
}

const SAMPLES: usize = 5000;

/// Derivative by central differences of eighth order.
fn difference(f: impl Fn(f64) -> f64, h: f64) -> f64 {
    let w = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let terms = w.iter().zip(1..).map(|(w, k)| {
        let s = h * f64::from(k);
        w * (f(s) - f(-s))
    });
    terms.sum::<f64>() / h
}

#[test]
fn random_expressions_agree_with_differences_of_second_derivatives() {
    let mut random = Random::new(30);
    let scope = scope();
    let mut compared = 0;
    for _ in 0..SAMPLES {
        let depth = 1 + random.below(3);
        let text = smooth(&mut random, depth);
        let program: Program = compile(&text, &scope);
        let t = random.between(-1.0, 1.0);
        let jet_at = |t: f64| program.eval_jet(&[Jet2::time(t)]);
        let jet = jet_at(t);
        let [v, d, dd, ddd] = program.eval_third(&[t]);
        assert_eq!([v, d, dd], [jet.v, jet.d, jet.dd], "{text}");
        // Where two steps disagree the function turns too fast for differences.
        let coarse = difference(|s| jet_at(t + s).dd, 8e-3);
        let fine = difference(|s| jet_at(t + s).dd, 4e-3);
        if (coarse - fine).abs() <= 1e-9 * (1.0 + fine.abs()) {
            compared += 1;
            near(ddd, fine, 1e-9, &format!("{text} at {t}"));
        }
    }
    println!("{compared} of {SAMPLES} compared");
    assert!(compared > SAMPLES / 10 * 8);
}

#[test]
fn derivatives_of_known_functions_are_exact() {
    assert_eq!(
        third("2 + 3*t - t^2 + 5*t^3", 0.5),
        [3.875, 5.75, 13.0, 30.0]
    );
    assert_eq!(third("tan(t)", 0.0), [0.0, 1.0, 0.0, 2.0]);
    assert_eq!(third("asin(t)", 0.0), [0.0, 1.0, 0.0, 1.0]);
    assert_eq!(third("atan(t)", 0.0), [0.0, 1.0, 0.0, -2.0]);
    assert_eq!(third("tanh(t)", 0.0), [0.0, 1.0, 0.0, -2.0]);
    assert_eq!(third("ln(t)", 0.5)[1..], [2.0, -4.0, 16.0]);
    assert_eq!(third("1/t", 0.5), [2.0, -4.0, 16.0, -96.0]);
    assert_eq!(third("t^-1", 0.5), [2.0, -4.0, 16.0, -96.0]);
    assert_eq!(third("sqrt(t)", 4.0), [2.0, 0.25, -0.03125, 0.01171875]);
    assert_eq!(third("t^1.5", 4.0), [8.0, 3.0, 0.375, -0.046875]);
    assert_eq!(third("blend(t, 0, 2)", 1.0), [0.5, 0.9375, 0.0, -3.75]);
    assert_eq!(third("mod(t^3, 5)", 2.0), [3.0, 12.0, 12.0, 6.0]);
    assert_eq!(third("exp(2*t)", 0.0), [1.0, 2.0, 4.0, 8.0]);
    let [s, c] = [0.7_f64.sin(), 0.7_f64.cos()];
    assert_eq!(third("sin(t)", 0.7), [s, c, -s, -c]);
    assert_eq!(third("cos(t)", 0.7), [c, -s, -c, s]);
    assert_eq!(third("4", 0.7), [4.0, 0.0, 0.0, 0.0]);
}

#[test]
fn functions_of_two_numbers_obey_their_identities() {
    let mut random = Random::new(31);
    for _ in 0..200 {
        let t = random.between(0.2, 1.2);
        // The angle and the length of a turning vector.
        let angle = third("atan2((1 + t^2)*sin(t^3), (1 + t^2)*cos(t^3))", t);
        let length = third("hypot((1 + t^2)*sin(t^3), (1 + t^2)*cos(t^3))", t);
        let known = [
            [t.powi(3), 3.0 * t * t, 6.0 * t, 6.0],
            [1.0 + t * t, 2.0 * t, 2.0, 0.0],
        ];
        for (found, known) in [angle, length].iter().zip(known) {
            for (found, known) in found.iter().zip(known) {
                near(*found, known, 1e-12, &format!("vector at {t}"));
            }
        }
        // f = t^t has f' = f g with g = 1 + ln t.
        let (f, g) = (t.powf(t), 1.0 + t.ln());
        let power = third("t^t", t);
        let known = [
            f,
            f * g,
            f * (g * g + 1.0 / t),
            f * (g * g * g + 3.0 * g / t - 1.0 / (t * t)),
        ];
        for (found, known) in power.iter().zip(known) {
            near(*found, known, 1e-13, &format!("t^t at {t}"));
        }
    }
}

#[test]
fn tables_give_their_own_third_derivative() {
    // A quintic spline reproduces the quintic that it was made of.
    let t = 1.1_f64;
    let found = third("lift(t)", t);
    near(found[3], 60.0 * t * t, 1e-10, "lift(t)");
    let found = third("lift(t^2/2)", t);
    // (t^2/2)^5 - (t^2/2)^2 = t^10/32 - t^4/4.
    near(found[3], 22.5 * t.powi(7) - 6.0 * t, 1e-10, "lift(t^2/2)");
}

#[test]
fn what_does_not_move_contributes_nothing() {
    assert_eq!(third("sqrt(0*t)", 1.0), [0.0; 4]);
    assert_eq!(third("abs(t)", 0.0), [0.0; 4]);
    assert_eq!(third("hypot(t, t)", 0.0), [0.0; 4]);
    assert_eq!(third("atan2(t, t)", 0.0), [0.0; 4]);
    assert_eq!(third("t^3", 0.0), [0.0, 0.0, 0.0, 6.0]);
    assert_eq!(third("t^2", 0.0), [0.0, 0.0, 2.0, 0.0]);
    assert_eq!(third("t^1", 0.0), [0.0, 1.0, 0.0, 0.0]);
    assert_eq!(third("atan(t)", 1e200)[3], 0.0);
    assert_eq!(third("tanh(t)", 1e3), [1.0, 0.0, 0.0, 0.0]);
    let program = compile("a*b^3", &free(&["a", "b"]));
    assert_eq!(program.eval_third(&[2.0, 3.0]), [54.0, 27.0, 0.0, 0.0]);
}
