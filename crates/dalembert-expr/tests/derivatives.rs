//! Derivatives against differences of higher order and against each other.

mod common;

use common::random::Random;
use common::{compile, free};
use dalembert_expr::{Jet2, Program};

const NAMES: [&str; 5] = ["a", "b", "c", "d", "e"];

/// Expressions that are smooth for values in (0.2, 0.9).
const SMOOTH: &[&str] = &[
    "a + 2*b - c*d/e",
    "a*sin(b*c) + cos(d)/e",
    "tan(a) - asin(b) + acos(c) + atan(d*e)",
    "sinh(a*b) + cosh(c - d) + tanh(2*e)",
    "exp(-a*b)*ln(c + d) + log10(e)",
    "sqrt(a*b + c)^3 + (d - 2)^-2",
    "a^b + c^1.7 + d^e^a",
    "2^a - 3/b^2 + (c - 1.5)^3",
    "atan2(a - 0.5*b, c) + hypot(d, e*a)",
    "abs(a - 2)*sign(b - 3) + min(a, b + 2, c + 3) + max(c, d - 2)",
    "mod(a + 5.1 + b*0.01, 2.4 + 0.1*c) + floor(d)",
    "blend(a + b, -0.5 + 0.1*c, 2.5 - d)",
    "if(a < 2, a*b*c, d) + step(e - 5)*a",
    "-(a - b)/(c + d) - (1 - e)/(a + b*c)",
    "(a - b*c) - (d - (e - sin(a*b)))",
    "1/(a/(b/(c/(d/e))))",
    "a*b*c*d*e + (a < b)*c",
];

fn values(random: &mut Random) -> Vec<f64> {
    NAMES.iter().map(|_| random.between(0.2, 0.9)).collect()
}

/// Derivative by central differences of eighth order.
fn difference(f: impl Fn(f64) -> f64, h: f64) -> f64 {
    let w = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let terms = w.iter().zip(1..).map(|(w, k)| {
        let s = h * f64::from(k);
        w * (f(s) - f(-s))
    });
    terms.sum::<f64>() / h
}

fn near(a: f64, b: f64, tolerance: f64, what: &str) {
    assert!(
        (a - b).abs() <= tolerance * (1.0 + a.abs().max(b.abs())),
        "{what}: {a} and {b}"
    );
}

fn moved(values: &[f64], k: usize, step: f64) -> Vec<f64> {
    let mut moved = values.to_vec();
    moved[k] += step;
    moved
}

fn programs() -> impl Iterator<Item = (&'static str, Program)> {
    SMOOTH.iter().map(|text| {
        (
            *text,
            compile(&format!("{text} + 0*(a+b+c+d+e)"), &free(&NAMES)),
        )
    })
}

#[test]
fn gradients_agree_with_differences() {
    let mut random = Random::new(10);
    for (text, program) in programs() {
        assert_eq!(program.slots().len(), 5);
        for _ in 0..20 {
            let x = values(&mut random);
            let mut gradient = [0.0; 5];
            let value = program.gradient(&x, &mut gradient);
            assert_eq!(value, program.eval(&x), "{text}");
            for (k, found) in gradient.iter().enumerate() {
                let expected = difference(|s| program.eval(&moved(&x, k, s)), 2e-3);
                near(*found, expected, 1e-9, text);
            }
        }
    }
}

#[test]
fn hessians_agree_with_differences_of_gradients() {
    let mut random = Random::new(11);
    for (text, program) in programs() {
        for _ in 0..10 {
            let x = values(&mut random);
            let (mut gradient, mut again, mut hessian) = ([0.0; 5], [0.0; 5], [0.0; 25]);
            program.hessian(&x, &mut gradient, &mut hessian);
            program.gradient(&x, &mut again);
            assert_eq!(gradient, again);
            for i in 0..5 {
                for j in 0..5 {
                    let slope = |s: f64| {
                        let mut g = [0.0; 5];
                        program.gradient(&moved(&x, j, s), &mut g);
                        g[i]
                    };
                    near(hessian[5 * i + j], difference(slope, 2e-3), 1e-8, text);
                    assert_eq!(hessian[5 * i + j], hessian[5 * j + i]);
                }
            }
        }
    }
}

#[test]
fn time_jets_agree_with_gradient_and_hessian() {
    let mut random = Random::new(12);
    for (text, program) in programs() {
        for _ in 0..20 {
            let x = values(&mut random);
            let rate: Vec<f64> = x.iter().map(|_| random.between(-2.0, 2.0)).collect();
            let second: Vec<f64> = x.iter().map(|_| random.between(-2.0, 2.0)).collect();
            let (mut g, mut h) = ([0.0; 5], [0.0; 25]);
            let v = program.hessian(&x, &mut g, &mut h);
            let mut expected = Jet2::new(v, 0.0, 0.0);
            for i in 0..5 {
                expected.d += g[i] * rate[i];
                expected.dd += g[i] * second[i];
                for j in 0..5 {
                    expected.dd += h[5 * i + j] * rate[i] * rate[j];
                }
            }
            let jets: Vec<Jet2> = (0..5)
                .map(|k| Jet2::new(x[k], rate[k], second[k]))
                .collect();
            let found = program.eval_jet(&jets);
            assert_eq!(found.v, v);
            near(found.d, expected.d, 1e-13, text);
            near(found.dd, expected.dd, 1e-12, text);
        }
    }
}

#[test]
fn time_jets_of_known_motions_are_exact() {
    let scope = free(&["t"]);
    let jet = |text: &str, t: f64| compile(text, &scope).eval_jet(&[Jet2::time(t)]);
    let found = jet("0.3*sin(2*t)", 0.7);
    let (s, c) = 1.4_f64.sin_cos();
    assert_eq!(found, Jet2::new(0.3 * s, 0.3 * c * 2.0, 0.3 * (-s * 4.0)));
    assert_eq!(jet("30 deg + 150*t", 2.0).d, 150.0);
    assert_eq!(jet("t^3", 2.0), Jet2::new(8.0, 12.0, 12.0));
    // Where functions are steep or have kinks, what does not move contributes nothing.
    assert_eq!(jet("sqrt(0*t)", 1.0), Jet2::new(0.0, 0.0, 0.0));
    assert_eq!(jet("abs(t)", 0.0), Jet2::new(0.0, 0.0, 0.0));
    assert_eq!(jet("hypot(t, t)", 0.0), Jet2::new(0.0, 0.0, 0.0));
    assert_eq!(jet("t^2", 0.0), Jet2::new(0.0, 0.0, 2.0));
    assert_eq!(jet("t^1", 0.0), Jet2::new(0.0, 1.0, 0.0));
    assert_eq!(jet("t^0", 0.0), Jet2::new(1.0, 0.0, 0.0));
    assert_eq!(jet("blend(t, 0, 2)", 0.0), Jet2::new(0.0, 0.0, 0.0));
    assert_eq!(jet("blend(t, 0, 2)", 1.0), Jet2::new(0.5, 0.9375, 0.0));
    assert_eq!(jet("step(t - 1)", 1.0), Jet2::new(1.0, 0.0, 0.0));
    assert_eq!(jet("if(t < 1, t, 1)", 0.5).d, 1.0);
    assert_eq!(jet("if(t < 1, t, 1)", 1.5).d, 0.0);
}
