//! Expressions of parameters and of names of their own: profiles, curves, surfaces.

use super::context::{Context, text_of};
use super::geometry::Geometry;
use super::names::ConstantScope;
use super::place::Place;
use crate::model::Value;
use dalembert_expr::{Dim, Function, Program, Quantity, Resolved, Scope, UnknownName};
use std::sync::Arc;

/// Pure numbers that an expression is a function of, beside constants.
struct FreeNames<'a> {
    constants: ConstantScope<'a>,
    /// Their names; the place of a name is its slot.
    names: &'a [&'a str],
    /// What the expression is: "a curve".
    what: &'a str,
}

impl Scope for FreeNames<'_> {
    fn variable(&self, path: &[&str]) -> Result<Resolved, UnknownName> {
        if let [name] = path
            && let Some(index) = self.names.iter().position(|n| n == name)
        {
            return Ok(Resolved::Slot {
                index,
                dim: Quantity::Known(Dim::NONE),
            });
        }
        self.constants.variable(path).map_err(|mut e| {
            e.note = Some(format!(
                "{} is a function of {} and parameters",
                self.what,
                self.names.join(", ")
            ));
            e
        })
    }

    fn function(&self, name: &str) -> Option<Arc<dyn Function>> {
        self.constants.function(name)
    }
}

impl<S: Geometry> Context<'_, S> {
    /// A length as a function of pure numbers; `what` it is, in words.
    pub fn length_program(
        &mut self,
        value: &Value,
        names: &[&str],
        what: &str,
        place: &Place,
        key: &str,
    ) -> Option<Program> {
        let scope = FreeNames {
            constants: ConstantScope {
                parameters: &self.parameters,
                functions: &self.functions,
            },
            names,
            what,
        };
        let dim = Quantity::Known(Dim::LENGTH);
        let text = text_of(value);
        let simple = text.chars().all(char::is_alphanumeric);
        let product = if simple {
            text.clone()
        } else {
            format!("({text})")
        };
        let mut compiled = dalembert_expr::compile(&text, &scope, dim);
        if let Err(errors) = &mut compiled
            && dalembert_expr::compile(&text, &scope, Quantity::Known(Dim::NONE)).is_ok()
        {
            // The names are plain numbers: without a unit the whole is one too.
            for error in errors {
                error.help = format!(
                    "{} are plain numbers: make the whole a length, \"{product} * 1 m\"",
                    names.join(" and ")
                );
            }
        }
        self.accept(compiled, &place.owner, &place.key(key))
    }
}
