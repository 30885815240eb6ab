//! The methods against published digits, converged solutions and their orders.

use super::*;
use crate::model::Method;
use std::convert::Infallible;
use std::f64::consts::PI;

/// A pendulum driven by a moment (Shabana, Example 6.12): y' = [y2, 30 sin 5t - 14.715 cos y1].
struct Driven;

impl Ode for Driven {
    type Error = Infallible;
    fn dim(&self) -> usize {
        2
    }
    fn rhs(&mut self, t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Infallible> {
        dydt[0] = y[1];
        dydt[1] = 30.0 * (5.0 * t).sin() - 14.715 * y[0].cos();
        Ok(())
    }
    fn scales(&mut self, _: &[f64], scales: &mut [f64]) {
        scales.fill(1.0);
    }
    fn project(&mut self, _: f64, _: &mut [f64]) -> Result<bool, Infallible> {
        Ok(false)
    }
}

/// A planet on an ellipse of eccentricity 1/2, back at its start after 2 pi.
struct Planet;

const PLANET: [f64; 4] = [0.5, 0.0, 0.0, 1.732_050_807_568_877_2];

impl Ode for Planet {
    type Error = Infallible;
    fn dim(&self) -> usize {
        4
    }
    fn rhs(&mut self, _: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Infallible> {
        let r = y[0].hypot(y[1]);
        dydt[..2].copy_from_slice(&y[2..]);
        dydt[2] = -y[0] / (r * r * r);
        dydt[3] = -y[1] / (r * r * r);
        Ok(())
    }
    fn scales(&mut self, _: &[f64], scales: &mut [f64]) {
        scales.fill(1.0);
    }
    fn project(&mut self, _: f64, _: &mut [f64]) -> Result<bool, Infallible> {
        Ok(false)
    }
}

/// The state at `end`; `step` is the tolerance, or the step of methods of fixed step.
fn at<O: Ode<Error = Infallible>>(
    method: Method,
    ode: &mut O,
    y: &[f64],
    end: f64,
    step: f64,
) -> Vec<f64> {
    let fixed = method.has_fixed_steps();
    let (tolerance, largest) = if fixed {
        (1.0, step)
    } else {
        (step, f64::INFINITY)
    };
    let Ok(mut integrator) = Integrator::start(method, ode, 0.0, y, tolerance, largest);
    while integrator.t() < end {
        integrator.step(ode, end).expect("a step");
    }
    integrator.y().to_vec()
}

fn far(a: &[f64], b: &[f64]) -> f64 {
    let distance = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    distance.fold(0.0, f64::max)
}

/// Shabana, Example 6.12 (explicit Euler), section 6.11 (Runge-Kutta, Heun); recomputed digits. The sums round.
#[test]
fn steps_of_example_6_12() {
    let steps = [
        (Method::Euler, 0.01, [0.0, -0.147_15]),
        (
            Method::Euler,
            0.02,
            [-0.001_471_500_000_000_000_2, -0.279_306_249_218_796_54],
        ),
        (
            Method::Euler,
            0.03,
            [-0.004_264_562_492_187_965, -0.396_506_064_911_928_1],
        ),
        (
            Method::Euler,
            1.0,
            [0.453_865_522_755_901_3, -7.477_361_536_285_391],
        ),
        (
            Method::Rk4,
            0.01,
            [-0.000_710_752_587_490_199_4, -0.139_651_553_055_819_9],
        ),
        (
            Method::Rk4,
            1.0,
            [0.588_207_229_748_014_2, -7.024_114_527_987_169_5],
        ),
        (
            Method::Heun,
            1.0,
            [0.586_099_199_062_794_5, -7.029_900_068_650_123],
        ),
    ];
    for (method, end, expected) in steps {
        let found = at(method, &mut Driven, &[0.0, 0.0], end, 0.01);
        let off = far(&found, &expected);
        assert!(
            off < 2e-14,
            "{method:?} at {end}: {found:?}, off by {off:e}"
        );
    }
}

/// The converged solution of Example 6.12 (1e-13 by two methods): every method that controls its error keeps the tolerance.
#[test]
fn controlled_methods_keep_the_tolerance() {
    let expected = [
        (1.0, [0.588_207_107_907_586_5, -7.024_115_163_689_044]),
        (5.0, [-39.472_610_771_563_2, -15.434_281_012_698_662]),
    ];
    for method in [Method::Dopri5, Method::Dop853, Method::Adams] {
        for (end, expected) in expected {
            for tolerance in [1e-5, 1e-7, 1e-9, 1e-11] {
                let found = at(method, &mut Driven, &[0.0, 0.0], end, tolerance);
                let off = far(&found, &expected);
                // The pendulum multiplies errors on its way; 6e-12 is what the reference leaves.
                let allowed = 200.0 * tolerance + 2e-10;
                assert!(off < allowed, "{method:?} at {end}, {tolerance:e}: {off:e}");
            }
        }
    }
}

/// Halved steps divide the error by two to the order.
#[test]
fn orders_of_fixed_steps() {
    let exact = at(Method::Dop853, &mut Planet, &PLANET, 2.0, 1e-14);
    let fixed = [
        (Method::Euler, 1.0, 1e-4),
        (Method::Midpoint, 2.0, 1e-3),
        (Method::Heun, 2.0, 1e-3),
        (Method::Rk4, 4.0, 1e-2),
    ];
    for (method, order, step) in fixed {
        let error = |h: f64| far(&at(method, &mut Planet, &PLANET, 2.0, h), &exact);
        let found = (error(step) / error(0.5 * step)).log2();
        assert!((found - order).abs() < 0.05, "{method:?}: order {found}");
    }
}

/// One step of a controlled method, its size given: the error falls by two to the order plus one.
#[test]
fn orders_of_controlled_methods() {
    for (table, order, h) in [(&DOPRI5, 5.0, 0.02), (&DOP853, 8.0, 0.08)] {
        let error = |h: f64| {
            let exact = at(Method::Dop853, &mut Planet, &PLANET, h, 1e-16);
            let start = |h| RungeKutta::start(table, &mut Planet, 0.0, &PLANET, 1.0, h, Some(h));
            let Ok(mut one) = start(h);
            one.step(&mut Planet, h).expect("a step");
            far(&one.y, &exact)
        };
        let found = (error(h) / error(0.5 * h)).log2() - 1.0;
        assert!((found - order).abs() < 0.4, "{}: order {found}", table.name);
    }
}

/// A full turn of the planet: the error follows the tolerance, and the inside of the steps is as good as their ends.
#[test]
fn ellipses_close_and_their_inside_is_as_good() {
    for method in [Method::Dopri5, Method::Dop853, Method::Adams] {
        for tolerance in [1e-6, 1e-9, 1e-12] {
            let Ok(mut integrator) =
                Integrator::start(method, &mut Planet, 0.0, &PLANET, tolerance, f64::INFINITY);
            let (mut inside, mut out) = (0.0_f64, [0.0; 4]);
            while integrator.t() < 2.0 * PI {
                let from = integrator.t();
                integrator.step(&mut Planet, 2.0 * PI).expect("a step");
                for part in [0.0, 0.3, 0.7, 1.0] {
                    let t = from + part * (integrator.t() - from);
                    let Ok(()) = integrator.interpolate(&mut Planet, t, &mut out);
                    let energy =
                        0.5 * (out[2] * out[2] + out[3] * out[3]) - 1.0 / out[0].hypot(out[1]);
                    inside = inside.max((energy + 0.5).abs());
                }
            }
            let off = far(integrator.y(), &PLANET);
            assert!(
                off < 100.0 * tolerance + 1e-12,
                "{method:?}, {tolerance:e}: {off:e}"
            );
            assert!(
                inside < 10.0 * tolerance + 1e-13,
                "{method:?}, {tolerance:e}: {inside:e}"
            );
        }
    }
}

/// What is changed from outside is taken up.
#[test]
fn restarts_take_up_a_changed_state() {
    let half = at(Method::Dop853, &mut Driven, &[0.0, 0.0], 0.5, 1e-13);
    for method in [Method::Dopri5, Method::Dop853, Method::Adams, Method::Rk4] {
        let fixed = method.has_fixed_steps();
        let largest = if fixed { 1e-3 } else { f64::INFINITY };
        let Ok(mut integrator) =
            Integrator::start(method, &mut Driven, 0.0, &[0.3, -0.2], 1e-11, largest);
        while integrator.t() < 0.5 {
            integrator.step(&mut Driven, 0.5).expect("a step");
        }
        let Ok(()) = integrator.restart(&mut Driven, &half);
        while integrator.t() < 1.0 {
            integrator.step(&mut Driven, 1.0).expect("a step");
        }
        let expected = [0.588_207_107_907_586_5, -7.024_115_163_689_044];
        let off = far(integrator.y(), &expected);
        // Runge-Kutta of order 4 at 1 ms leaves 1e-10.
        assert!(off < 2e-10, "{method:?}: {off:e}");
    }
}

/// No step leaves the times at which a fixed-step method shall stand.
#[test]
fn fixed_steps_are_of_one_size() {
    let Ok(mut integrator) =
        Integrator::start(Method::Rk4, &mut Driven, 0.0, &[0.0, 0.0], 1.0, 0.01);
    for step in 1..=100 {
        integrator.step(&mut Driven, 1.0).expect("a step");
        assert!((integrator.t() - 0.01 * f64::from(step)).abs() < 1e-14);
    }
    assert_eq!(integrator.t(), 1.0);
}
