//! Tables: what they reproduce, how smooth they are, what they refuse.

mod common;

use common::random::Random;
use common::{Names, compile, errors};
use dalembert_expr::{Dim, Function, Jet2, Quantity, Spline, SplineError};
use std::sync::Arc;

/// Unevenly spaced arguments.
fn uneven(random: &mut Random, count: usize) -> Vec<f64> {
    let mut at = -1.0;
    let mut step = || {
        at += random.between(0.1, 0.6);
        at
    };
    (0..count).map(|_| step()).collect()
}

/// Value and three derivatives of a polynomial.
fn polynomial(c: &[f64], x: f64) -> [f64; 4] {
    let mut jet = [0.0; 4];
    for (order, out) in jet.iter_mut().enumerate() {
        for (power, c) in c.iter().enumerate().skip(order) {
            let factor: usize = (power - order + 1..=power).product();
            *out += c * factor as f64 * x.powi((power - order) as i32);
        }
    }
    jet
}

fn assert_near(a: f64, b: f64, tolerance: f64, what: &str) {
    assert!((a - b).abs() <= tolerance, "{what}: {a} and {b}");
}

#[test]
fn polynomials_are_reproduced() {
    let mut random = Random::new(1);
    type Fit = fn(&[f64], &[f64], bool) -> Result<Spline, SplineError>;
    let fits: [(Fit, usize, usize); 3] = [
        (Spline::linear, 1, 2),
        (Spline::cubic, 3, 4),
        (Spline::quintic, 5, 6),
    ];
    for (fit, degree, least) in fits {
        for count in [least, least + 1, least + 2, least + 3, 30] {
            let x = uneven(&mut random, count);
            let c: Vec<f64> = (0..=degree).map(|_| random.between(-1.0, 1.0)).collect();
            // The largest argument is about 12: scale so that values are of order one.
            let size = x[count - 1].abs().max(1.0);
            let c: Vec<f64> = c
                .iter()
                .enumerate()
                .map(|(k, c)| c / size.powi(k as i32))
                .collect();
            let y: Vec<f64> = x.iter().map(|x| polynomial(&c, *x)[0]).collect();
            let spline = fit(&x, &y, false).unwrap();
            for _ in 0..50 {
                let at = random.between(x[0], x[count - 1]);
                let (found, exact) = (spline.jet(at), polynomial(&c, at));
                for order in 0..4 {
                    // Every derivative of rounded values loses a factor of the spacing.
                    let tolerance = [2e-14, 1e-12, 5e-11, 2e-9][order];
                    let what = format!("degree {degree}, {count} points, derivative {order}");
                    assert_near(found[order], exact[order], tolerance, &what);
                }
            }
        }
    }
}

#[test]
fn three_points_make_a_parabola() {
    let spline = Spline::cubic(&[0.0, 1.0, 3.0], &[1.0, 2.0, 10.0], false).unwrap();
    for x in [0.0, 0.5, 1.0, 2.5, 3.0] {
        let jet = spline.jet(x);
        assert_near(jet[0], 1.0 + x * x, 1e-14, "value");
        assert_near(jet[1], 2.0 * x, 1e-14, "slope");
    }
}

/// Fourth and fifth derivative on one side of a point. The third one is a parabola there, at most:
/// three of its values give them without error of truncation.
fn one_sided(spline: &Spline, at: f64, step: f64) -> [f64; 2] {
    let third = |k: f64| spline.jet(at + step * k)[3];
    let (a, b, c) = (third(0.0), third(1.0), third(2.0));
    let bend = (c - 2.0 * b + a) / (step * step);
    [(b - a) / step - bend * step / 2.0, bend]
}

#[test]
fn splines_are_as_smooth_as_promised() {
    let mut random = Random::new(2);
    for periodic in [false, true] {
        let x = uneven(&mut random, 20);
        let mut y: Vec<f64> = x.iter().map(|_| random.between(-1.0, 1.0)).collect();
        if periodic {
            y[19] = y[0];
        }
        let cubic = Spline::cubic(&x, &y, periodic).unwrap();
        let quintic = Spline::quintic(&x, &y, periodic).unwrap();
        let inner = if periodic { 0..20 } else { 1..19 };
        for i in inner {
            for spline in [&cubic, &quintic] {
                assert_near(spline.jet(x[i])[0], y[i], 1e-14, "interpolation");
            }
            // Just left and right of the point.
            let step = 1e-10;
            for (spline, orders) in [(&cubic, 3), (&quintic, 4)] {
                let (left, right) = (spline.jet(x[i] - step), spline.jet(x[i] + step));
                for order in 0..orders {
                    let scale = 1.0 + left[order].abs();
                    // The next derivative times the distance is what may differ.
                    assert_near(left[order] / scale, right[order] / scale, 1e-6, "smooth");
                }
            }
            // The cubic's third derivative does jump, except next to the ends.
            let (left, right) = (cubic.jet(x[i] - step)[3], cubic.jet(x[i] + step)[3]);
            let knot = periodic || (2..18).contains(&i);
            assert_eq!(
                (left - right).abs() > 1e-3 * (left.abs() + right.abs()),
                knot
            );
        }
        // Fourth derivative of the quintic from both sides, and the jump of the fifth.
        for at in &x[3..17] {
            let step = 0.02;
            let left = one_sided(&quintic, at - 1e-12, -step);
            let right = one_sided(&quintic, *at, step);
            let scale = left[0].abs() + right[0].abs();
            assert_near(left[0] / scale, right[0] / scale, 1e-7, "fourth derivative");
            assert!((left[1] - right[1]).abs() > 1e-3 * (left[1].abs() + right[1].abs()));
        }
    }
}

#[test]
fn periodic_tables_repeat_and_follow_a_sine() {
    let tau = std::f64::consts::TAU;
    for (quintic, tolerance) in [(false, [1e-5, 2e-4, 1e-2]), (true, [5e-9, 2e-7, 5e-6])] {
        let x: Vec<f64> = (0..=36).map(|k| f64::from(k) * tau / 36.0).collect();
        let y: Vec<f64> = x.iter().map(|x| x.sin()).collect();
        let spline = match quintic {
            true => Spline::quintic(&x, &y, true).unwrap(),
            false => Spline::cubic(&x, &y, true).unwrap(),
        };
        for k in -200..200 {
            let at = f64::from(k) * 0.0917;
            let jet = spline.jet(at);
            let exact = [at.sin(), at.cos(), -at.sin()];
            for order in 0..3 {
                assert_near(jet[order], exact[order], tolerance[order], "sine");
            }
            assert_near(spline.jet(at + 3.0 * tau)[0], jet[0], 1e-13, "period");
        }
    }
}

#[test]
fn the_smallest_periodic_tables_work() {
    let x = [0.0, 1.0, 2.5, 3.0];
    let cubic = Spline::cubic(&x, &[1.0, -1.0, 0.5, 1.0], true).unwrap();
    let x = [0.0, 1.0, 2.5, 3.0, 3.7, 5.0];
    let quintic = Spline::quintic(&x, &[1.0, -1.0, 0.5, 2.0, 0.0, 1.0], true).unwrap();
    for (spline, period) in [(&cubic, 3.0), (&quintic, 5.0)] {
        let (a, b) = (spline.jet(-1e-9), spline.jet(1e-9));
        for order in 0..3 {
            assert_near(a[order], b[order], 1e-6, "closing");
        }
        assert_near(spline.jet(1.0)[0], -1.0, 1e-14, "point");
        assert_near(
            spline.jet(1.0 + period)[0],
            -1.0,
            1e-14,
            "point of the next period",
        );
    }
}

#[test]
fn beside_the_points_the_end_values_hold() {
    let spline = Spline::cubic(&[0.0, 1.0, 2.0, 3.0], &[0.0, 1.0, 8.0, 27.0], false).unwrap();
    assert_eq!(spline.jet(-0.1), [0.0; 4]);
    assert_eq!(spline.jet(3.1), [27.0, 0.0, 0.0, 0.0]);
    assert_near(spline.jet(3.0)[1], 27.0, 1e-12, "slope at the end itself");
    assert!(spline.jet(f64::NAN)[0].is_nan());
}

#[test]
fn many_unevenly_spaced_points_keep_their_digits() {
    let mut random = Random::new(3);
    // Spacings over four orders of magnitude, in random order.
    let mut at = 0.0;
    let x: Vec<f64> = (0..2000)
        .map(|_| {
            at += 10_f64.powf(random.between(-4.0, 0.0));
            at
        })
        .collect();
    let y: Vec<f64> = x.iter().map(|x| (0.05 * x).sin()).collect();
    let cubic = Spline::cubic(&x, &y, false).unwrap();
    let quintic = Spline::quintic(&x, &y, false).unwrap();
    for _ in 0..1000 {
        let at = random.between(x[0], x[1999]);
        let exact = (0.05 * at).sin();
        assert_near(cubic.jet(at)[0], exact, 1e-7, "cubic");
        assert_near(quintic.jet(at)[0], exact, 1e-9, "quintic");
    }
}

#[test]
fn bad_points_are_refused() {
    let fit = |x: &[f64], y: &[f64]| Spline::cubic(x, y, false).unwrap_err();
    let refused = fit(&[0.0, 1.0], &[0.0]);
    assert_eq!(refused, SplineError::Lengths { x: 2, y: 1 });
    let refused = fit(&[0.0, 1.0], &[0.0, 1.0]);
    assert_eq!(refused, SplineError::TooFew { given: 2, least: 3 });
    let refused = fit(&[0.0, 1.0, 1.0], &[0.0; 3]);
    assert_eq!(refused, SplineError::NotIncreasing { point: 3 });
    let refused = fit(&[0.0, f64::NAN, 1.0], &[0.0; 3]);
    assert_eq!(refused, SplineError::NotFinite { point: 2 });
    let x = [0.0, 1.0, 2.0, 3.0];
    let refused = Spline::cubic(&x, &[0.0, 1.0, 2.0, 0.5], true).unwrap_err();
    let (first, last) = (0.0, 0.5);
    assert_eq!(refused, SplineError::NotPeriodic { first, last });
    assert!(Spline::quintic(&x, &[0.0; 4], false).is_err());
    assert!(Spline::linear(&[0.0], &[0.0], false).is_err());
    let huge = Spline::cubic(&x, &[1e308, -1e308, 1e308, -1e308], false);
    assert_eq!(huge.unwrap_err(), SplineError::Unsolvable);
}

#[test]
fn expressions_call_tables() {
    let x: Vec<f64> = (0..10).map(f64::from).collect();
    let y: Vec<f64> = x.iter().map(|x| x * x * x / 100.0).collect();
    let lift = Spline::cubic(&x, &y, false)
        .unwrap()
        .with_dims(Dim::TIME.into(), Dim::LENGTH.into());
    let scope = Names {
        slots: vec![("t", Dim::TIME.into()), ("angle", Dim::NONE.into())],
        tables: vec![("lift", Arc::new(lift))],
        ..Names::default()
    };
    let program = compile("lift(t)", &scope);
    assert_eq!(program.quantity(), Quantity::Known(Dim::LENGTH));
    let jet = program.eval_jet(&[Jet2::new(2.5, 3.0, -1.0)]);
    let (slope, bend) = (3.0 * 2.5 * 2.5 / 100.0, 6.0 * 2.5 / 100.0);
    assert_near(jet.v, 2.5_f64.powi(3) / 100.0, 1e-15, "value");
    assert_near(jet.d, 3.0 * slope, 1e-14, "rate");
    assert_near(jet.dd, 9.0 * bend - slope, 1e-13, "second rate");
    assert_near(
        compile("lift(2)", &scope).constant().unwrap(),
        0.08,
        1e-16,
        "folded",
    );
    let found = errors("lift(angle)", &scope);
    assert_eq!(
        (found[0].code, found[0].span.clone()),
        ("unit-mismatch", 5..10)
    );
    assert_eq!(errors("lift(t, 1)", &scope)[0].code, "argument-count");
    assert_eq!(errors("lift", &scope)[0].code, "function-without-arguments");
}
