//! A scope for tests.
#![allow(dead_code)]

use dalembert_expr::{Dim, ExprError, Function, Program, Quantity, Resolved, Scope, UnknownName};
use std::sync::Arc;

pub mod random;

/// Variables in slots by position, constants by value, and tables.
#[derive(Default)]
pub struct Names {
    pub slots: Vec<(&'static str, Quantity)>,
    pub constants: Vec<(&'static str, f64, Quantity)>,
    pub tables: Vec<(&'static str, Arc<dyn Function>)>,
}

impl Scope for Names {
    fn variable(&self, path: &[&str]) -> Result<Resolved, UnknownName> {
        let name = path.join(".");
        if let Some(index) = self.slots.iter().position(|(n, _)| *n == name) {
            let dim = self.slots[index].1;
            return Ok(Resolved::Slot { index, dim });
        }
        if let Some(&(_, value, dim)) = self.constants.iter().find(|(n, ..)| *n == name) {
            return Ok(Resolved::Constant { value, dim });
        }
        let known = self.slots.iter().map(|(n, _)| *n);
        Err(UnknownName {
            suggestions: dalembert_expr::nearest(&name, known)
                .into_iter()
                .map(str::to_owned)
                .collect(),
            note: None,
        })
    }

    fn function(&self, name: &str) -> Option<Arc<dyn Function>> {
        let table = self.tables.iter().find(|(n, _)| *n == name)?;
        Some(Arc::clone(&table.1))
    }
}

/// Variables without a dimension, in slots by position.
pub fn free(names: &[&'static str]) -> Names {
    Names {
        slots: names.iter().map(|n| (*n, Quantity::Free)).collect(),
        ..Names::default()
    }
}

/// The names of a small machine.
pub fn machine() -> Names {
    let known = Quantity::Known;
    Names {
        slots: vec![
            ("t", known(Dim::TIME)),
            ("crank.angle", known(Dim::NONE)),
            ("crank.velocity", known(Dim::ANGULAR_VELOCITY)),
            ("slider.x", known(Dim::LENGTH)),
            ("return spring.length", known(Dim::LENGTH)),
        ],
        constants: vec![
            ("crank", 0.15, known(Dim::LENGTH)),
            ("load", 40.0, known(Dim::FORCE)),
            ("ratio", 0.0, Quantity::Free),
            ("g", 9.81, known(Dim::ACCELERATION)),
        ],
        tables: Vec::new(),
    }
}

pub fn compile(text: &str, scope: &Names) -> Program {
    compile_for(text, scope, Quantity::Free)
}

pub fn compile_for(text: &str, scope: &Names, expected: Quantity) -> Program {
    dalembert_expr::compile(text, scope, expected).unwrap_or_else(|e| panic!("{text}: {e:?}"))
}

pub fn errors(text: &str, scope: &Names) -> Vec<ExprError> {
    dalembert_expr::compile(text, scope, Quantity::Free).expect_err(text)
}

/// A value of an expression of constants only.
pub fn value(text: &str) -> f64 {
    let program = compile(text, &Names::default());
    program
        .constant()
        .unwrap_or_else(|| panic!("{text} is not folded"))
}
