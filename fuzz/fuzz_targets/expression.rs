//! No text may make the expression engine panic, and what it accepts must be consistent.
//!
//! Run with `cargo fuzz run expression`; on a stable toolchain with `RUSTC_BOOTSTRAP=1`.
#![no_main]

use dalembert_expr::{
    Dim, Function, Jet2, Quantity, Resolved, Scope, Spline, UnknownName, compile, names, parse_unit,
};
use libfuzzer_sys::fuzz_target;
use std::sync::{Arc, LazyLock};

/// Some variables of every kind, and a table.
struct Names;

static TABLE: LazyLock<Arc<Spline>> = LazyLock::new(|| {
    let x: Vec<f64> = (0..8).map(f64::from).collect();
    let y: Vec<f64> = x.iter().map(|x| x.sin()).collect();
    Arc::new(Spline::quintic(&x, &y, false).expect("eight increasing points make a spline"))
});

impl Scope for Names {
    fn variable(&self, path: &[&str]) -> Result<Resolved, UnknownName> {
        let slot = |index, dim| Ok(Resolved::Slot { index, dim });
        match path {
            ["t"] => slot(7, Dim::TIME.into()),
            ["x"] => slot(2, Quantity::Free),
            ["m"] => slot(3, Dim::LENGTH.into()),
            ["a", "b"] => slot(5, Dim::LENGTH.into()),
            ["k"] => Ok(Resolved::Constant {
                value: 2.5,
                dim: Dim::STIFFNESS.into(),
            }),
            ["zero"] => Ok(Resolved::Constant {
                value: 0.0,
                dim: Quantity::Free,
            }),
            _ => Err(UnknownName::default()),
        }
    }

    fn function(&self, name: &str) -> Option<Arc<dyn Function>> {
        (name == "lift").then(|| TABLE.clone() as Arc<dyn Function>)
    }
}

fuzz_target!(|text: &str| {
    // Neither may panic, whatever they answer.
    let _ = (names(text), parse_unit(text));
    let program = match compile(text, &Names, Quantity::Free) {
        Ok(program) => program,
        Err(errors) => {
            assert!(!errors.is_empty());
            for error in errors {
                // A place that cannot be shown is as bad as none.
                assert!(text.get(error.span.clone()).is_some(), "{error:?}");
            }
            return;
        }
    };
    let count = program.slots().len();
    let values: Vec<f64> = (0..count).map(|k| 0.3 + k as f64).collect();
    let value = program.eval(&values);
    let same = |other: f64| other == value || (other.is_nan() && value.is_nan());
    if let Some(constant) = program.constant() {
        assert!(constant.is_finite() && same(constant));
    }
    let mut gradient = vec![0.0; count];
    assert!(same(program.gradient(&values, &mut gradient)));
    if count <= 4 {
        let mut hessian = vec![0.0; count * count];
        assert!(same(program.hessian(&values, &mut gradient, &mut hessian)));
    }
    let jets: Vec<Jet2> = values.iter().map(|v| Jet2::new(*v, 1.0, -0.5)).collect();
    assert!(same(program.eval_jet(&jets).v));
    let first = |k: usize, v: &f64| Jet2::new(*v, f64::from(k == 0), 0.0);
    let jets: Vec<Jet2> = values
        .iter()
        .enumerate()
        .map(|(k, v)| first(k, v))
        .collect();
    let (jet, third) = (program.eval_jet(&jets), program.eval_third(&values));
    for (a, b) in [jet.v, jet.d, jet.dd].into_iter().zip(third) {
        assert!(a == b || (a.is_nan() && b.is_nan()), "{jet:?} {third:?}");
    }
    assert!(value.is_finite() || program.first_non_finite(&values).is_some());
});
