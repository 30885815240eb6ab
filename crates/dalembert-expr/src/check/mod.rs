//! The meaning of a syntax tree: names, units and constants.

pub(crate) mod fold;
mod rules;

use crate::builtin::{self, Builtin, Operation, Rule};
use crate::error::{ExprError, Fault, MOST_ERRORS, excerpt};
use crate::quantity::Clash;
use crate::scope::{Function, Resolved, Scope};
use crate::syntax::token::Path;
use crate::syntax::tree::{self, Binary, Id, Node, Tree};
use crate::{Quantity, Unit, suggest};
use fold::{apply, fold};
use std::ops::Range;
use std::sync::Arc;

/// What was found out about one node.
#[derive(Clone, Debug, Default)]
pub(crate) struct Meaning {
    /// Its quantity; none where it is wrong, which has been reported.
    pub quantity: Option<Quantity>,
    /// Its value, where it does not change.
    pub value: Option<f64>,
    /// The caller's number of a variable.
    pub slot: Option<usize>,
    /// The function that a call means.
    pub callee: Option<Callee>,
    /// The branch of an `if` whose condition does not change.
    pub taken: Option<Id>,
    /// Is it made of numbers without units only? As a divisor it is then taken as a plain number.
    pub bare: bool,
}

/// A text without mistakes.
#[derive(Debug)]
pub(crate) struct Checked {
    /// The meaning of every node.
    pub known: Vec<Meaning>,
    /// Dimensions that do not agree if bare divisors are plain numbers.
    pub doubts: Vec<ExprError>,
}

/// A function of the language or of the scope.
#[derive(Clone, Debug)]
pub(crate) enum Callee {
    Builtin(&'static Builtin),
    Table(Arc<dyn Function>),
}

/// Finds the meaning of every node, or all mistakes.
pub(crate) fn check(
    text: &str,
    tree: &Tree,
    scope: &dyn Scope,
    expected: Quantity,
) -> Result<Checked, Vec<ExprError>> {
    let mut checker = Checker {
        text,
        tree,
        scope,
        known: Vec::with_capacity(tree.len()),
        faults: Vec::new(),
        doubts: Vec::new(),
    };
    for id in 0..tree.len() {
        let meaning = checker.meaning(id);
        checker.known.push(meaning);
    }
    if let Some(given) = checker.known.last().and_then(|root| root.quantity) {
        let root = tree.len() - 1;
        match given.join(expected).1 {
            Some(Clash::Sure(..)) => {
                checker.report(root, Fault::Expected { expected, given }, tree.span(root));
            }
            Some(Clash::Doubtful(..)) => checker.doubt(
                root,
                "this must be".to_owned(),
                expected.describe(),
                ", but it seems to be ",
                given.describe(),
            ),
            None => {}
        }
    }
    let told = |faults: &[(Id, Fault, Range<usize>)]| -> Vec<ExprError> {
        let first = faults.iter().take(MOST_ERRORS);
        first
            .map(|(_, f, span)| ExprError::new(f, span.clone()))
            .collect()
    };
    if !checker.faults.is_empty() {
        return Err(told(&checker.faults));
    }
    let doubts = told(&checker.doubts);
    Ok(Checked {
        known: checker.known,
        doubts,
    })
}

struct Checker<'a> {
    text: &'a str,
    tree: &'a Tree,
    scope: &'a dyn Scope,
    known: Vec<Meaning>,
    faults: Vec<(Id, Fault, Range<usize>)>,
    doubts: Vec<(Id, Fault, Range<usize>)>,
}

impl Checker<'_> {
    fn report(&mut self, id: Id, fault: Fault, span: Range<usize>) {
        self.faults.push((id, fault, span));
    }

    /// Notes two dimensions that agree only if a bare divisor has a unit.
    fn doubt(&mut self, id: Id, what: String, left: String, link: &'static str, right: String) {
        let fault = Fault::Doubtful {
            what,
            left,
            link,
            right,
        };
        self.doubts.push((id, fault, self.tree.span(id)));
    }

    fn bare(&self, id: Id) -> bool {
        self.known[id].bare
    }

    fn quantity(&self, id: Id) -> Option<Quantity> {
        self.known[id].quantity
    }

    fn value(&self, id: Id) -> Option<f64> {
        self.known[id].value
    }

    fn source(&self, span: Range<usize>) -> String {
        format!("`{}`", excerpt(&self.text[span]))
    }

    fn meaning(&mut self, id: Id) -> Meaning {
        let tree = self.tree;
        match tree.node(id) {
            Node::Invalid => Meaning::default(),
            Node::Number { value, unit } => self.number(id, *value, *unit),
            Node::Name(path) => self.name(id, path),
            Node::Negate(operand) => Meaning {
                quantity: self.quantity(*operand),
                value: self.value(*operand).map(|v| -v),
                bare: self.bare(*operand),
                ..Meaning::default()
            },
            Node::Not(operand) => Meaning {
                quantity: self.condition(id, *operand),
                value: self.value(*operand).map(|v| f64::from(v == 0.0)),
                ..Meaning::default()
            },
            Node::Binary(operator, left, right) => self.binary(id, *operator, *left, *right),
            Node::Call {
                name,
                name_span,
                arguments,
            } => self.call(id, name, name_span, arguments),
        }
    }

    /// A folded value, checked.
    fn finite(&mut self, id: Id, value: Option<f64>) -> Option<f64> {
        let value = value?;
        if !value.is_finite() {
            self.report(id, Fault::NotFinite, self.tree.span(id));
            return None;
        }
        Some(value)
    }

    fn number(&mut self, id: Id, value: f64, unit: Option<Unit>) -> Meaning {
        let (si, quantity) = tree::number(value, unit);
        let lost = si == 0.0 && value != 0.0;
        Meaning {
            quantity: Some(quantity),
            value: self.finite(id, Some(if lost { f64::NAN } else { si })),
            bare: unit.is_none(),
            ..Meaning::default()
        }
    }

    fn name(&mut self, id: Id, path: &Path) -> Meaning {
        if let Some(value) = path.word().and_then(builtin::constant) {
            return Meaning {
                quantity: Some(Quantity::Free),
                value: Some(value),
                bare: true,
                ..Meaning::default()
            };
        }
        let parts: Vec<&str> = path.parts.iter().map(String::as_str).collect();
        let fault = match self.scope.variable(&parts) {
            Ok(Resolved::Constant { value, dim }) => {
                return Meaning {
                    quantity: Some(dim),
                    value: self.finite(id, Some(value)),
                    ..Meaning::default()
                };
            }
            Ok(Resolved::Slot { index, dim }) => {
                return Meaning {
                    quantity: Some(dim),
                    slot: Some(index),
                    ..Meaning::default()
                };
            }
            Err(mut unknown) => {
                let name = path.parts.join(".");
                let is_function =
                    |n: &str| Builtin::named(n).is_some() || self.scope.function(n).is_some();
                match path.word() {
                    Some(word) if is_function(word) => Fault::FunctionWithoutArguments { name },
                    Some(word) if Unit::named(word).is_some() => Fault::LooseUnit { name },
                    _ => {
                        if unknown.suggestions.is_empty() && parts.len() == 1 {
                            unknown.suggestions =
                                suggest::owned(suggest::nearest(&name, ["pi", "tau"]));
                        }
                        Fault::UnknownName { name, unknown }
                    }
                }
            }
        };
        self.report(id, fault, self.tree.span(id));
        Meaning::default()
    }

    fn binary(&mut self, id: Id, operator: Binary, left: Id, right: Id) -> Meaning {
        let quantity = self.binary_quantity(id, operator, left, right);
        let values = self.value(left).zip(self.value(right));
        let mut value = None;
        if operator == Binary::Divide && self.value(right) == Some(0.0) {
            self.report(id, Fault::DivisionByZero, self.tree.span(id));
        } else {
            let folded = values.map(|(a, b)| fold(operator, a, b));
            value = self.finite(id, folded);
        }
        Meaning {
            quantity,
            value,
            bare: self.bare(left) && self.bare(right),
            ..Meaning::default()
        }
    }

    fn call(&mut self, id: Id, name: &str, name_span: &Range<usize>, arguments: &[Id]) -> Meaning {
        if let Some(builtin) = Builtin::named(name) {
            return self.call_builtin(id, builtin, arguments);
        }
        let Some(table) = self.scope.function(name) else {
            let fault = Fault::UnknownFunction {
                name: name.to_owned(),
                suggestions: suggest::owned(suggest::nearest(name, Builtin::names())),
                variable: self.scope.variable(&[name]).is_ok(),
            };
            self.report(id, fault, name_span.clone());
            return Meaning::default();
        };
        let &[argument] = arguments else {
            let usage = format!("{name}(x)");
            self.wrong_count(id, name, "1 argument".to_owned(), arguments.len(), usage);
            return Meaning::default();
        };
        let (x, y) = table.dims();
        let quantity = self.takes(id, name, x, argument).map(|()| y);
        let folded = self.value(argument).map(|x| table.jet(x)[0]);
        Meaning {
            quantity,
            value: self.finite(id, folded),
            callee: Some(Callee::Table(table)),
            ..Meaning::default()
        }
    }

    fn wrong_count(&mut self, id: Id, name: &str, wanted: String, given: usize, usage: String) {
        let fault = Fault::ArgumentCount {
            name: name.to_owned(),
            wanted,
            given,
            usage,
        };
        self.report(id, fault, self.tree.span(id));
    }

    fn call_builtin(&mut self, id: Id, function: &'static Builtin, arguments: &[Id]) -> Meaning {
        let count = arguments.len();
        if count < function.least || count > function.most {
            let usage = function.usage.to_owned();
            self.wrong_count(id, function.name, function.arity(), count, usage);
            return Meaning::default();
        }
        let quantity = self.builtin_quantity(id, function, arguments);
        let mut meaning = Meaning {
            quantity,
            callee: Some(Callee::Builtin(function)),
            // The value of a sine is a plain number, like a literal.
            bare: matches!(function.rule, Rule::Plain) || arguments.iter().all(|a| self.bare(*a)),
            ..Meaning::default()
        };
        if matches!(function.operation, Operation::If) {
            if let Some(condition) = self.value(arguments[0]) {
                let (taken, dead) = match condition != 0.0 {
                    true => (arguments[1], arguments[2]),
                    false => (arguments[2], arguments[1]),
                };
                self.forgive(dead);
                meaning.taken = Some(taken);
                meaning.value = self.value(taken);
            }
            return meaning;
        }
        if matches!(function.operation, Operation::Mod) && self.value(arguments[1]) == Some(0.0) {
            self.report(id, Fault::DivisionByZero, self.tree.span(id));
            return meaning;
        }
        let values: Option<Vec<f64>> = arguments.iter().map(|a| self.value(*a)).collect();
        let folded = values.map(|values| apply(function.operation, &values));
        meaning.value = self.finite(id, folded);
        meaning
    }

    /// Takes back what was said of the values of a branch that is never taken.
    fn forgive(&mut self, dead: Id) {
        let first = self.tree.first(dead);
        self.faults.retain(|(id, fault, _)| {
            let numeric = matches!(fault, Fault::DivisionByZero | Fault::NotFinite);
            !(numeric && (first..=dead).contains(id))
        });
    }
}
