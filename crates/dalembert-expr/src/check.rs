//! The meaning of a syntax tree: names, units and constants.

use crate::builtin::{self, Builtin, Operation, Rule};
use crate::derive::bivariate::Bivariate;
use crate::derive::univariate::Univariate;
use crate::error::{ExprError, Fault};
use crate::scope::{Function, Resolved, Scope};
use crate::syntax::token::Path;
use crate::syntax::tree::{self, Binary, Id, Node, Tree};
use crate::{Dim, Quantity, Unit, suggest};
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
) -> Result<Vec<Meaning>, Vec<ExprError>> {
    let mut checker = Checker {
        text,
        tree,
        scope,
        known: Vec::with_capacity(tree.len()),
        faults: Vec::new(),
    };
    for id in 0..tree.len() {
        let meaning = checker.meaning(id);
        checker.known.push(meaning);
    }
    if let Some(given) = checker.known.last().and_then(|root| root.quantity)
        && given.join(expected).is_err()
    {
        let root = tree.len() - 1;
        checker.report(root, Fault::Expected { expected, given }, tree.span(root));
    }
    if checker.faults.is_empty() {
        return Ok(checker.known);
    }
    let errors = checker.faults.iter();
    Err(errors
        .map(|(_, f, span)| ExprError::new(f, span.clone()))
        .collect())
}

struct Checker<'a> {
    text: &'a str,
    tree: &'a Tree,
    scope: &'a dyn Scope,
    known: Vec<Meaning>,
    faults: Vec<(Id, Fault, Range<usize>)>,
}

impl Checker<'_> {
    fn report(&mut self, id: Id, fault: Fault, span: Range<usize>) {
        self.faults.push((id, fault, span));
    }

    fn quantity(&self, id: Id) -> Option<Quantity> {
        self.known[id].quantity
    }

    fn value(&self, id: Id) -> Option<f64> {
        self.known[id].value
    }

    fn source(&self, span: Range<usize>) -> String {
        let text = &self.text[span];
        match text.char_indices().nth(40) {
            None => format!("`{text}`"),
            Some((cut, _)) => format!("`{}...`", &text[..cut]),
        }
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
            ..Meaning::default()
        }
    }

    fn name(&mut self, id: Id, path: &Path) -> Meaning {
        if let Some(value) = path.word().and_then(builtin::constant) {
            return Meaning {
                quantity: Some(Quantity::Free),
                value: Some(value),
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
                            unknown.suggestions = suggest::nearest(&name, ["pi", "tau"]);
                        }
                        Fault::UnknownName { name, unknown }
                    }
                }
            }
        };
        self.report(id, fault, self.tree.span(id));
        Meaning::default()
    }

    /// The quantity of the truth of an operand: a plain number, 1 or 0.
    fn condition(&mut self, id: Id, operand: Id) -> Option<Quantity> {
        match self.quantity(operand)? {
            Quantity::Known(dim) if !dim.is_none() => {
                let span = self.tree.span(operand);
                let fault = Fault::WrongArgument {
                    what: self.source(span.clone()),
                    wanted: "the place of a condition".to_owned(),
                    given: dim.describe(),
                };
                self.report(id, fault, span);
                None
            }
            _ => Some(Quantity::Known(Dim::NONE)),
        }
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
            ..Meaning::default()
        }
    }

    fn binary_quantity(&mut self, id: Id, op: Binary, left: Id, right: Id) -> Option<Quantity> {
        use Quantity::{Free, Known};
        if matches!(op, Binary::And | Binary::Or) {
            let (a, b) = (self.condition(id, left), self.condition(id, right));
            return a.and(b);
        }
        let (a, b) = (self.quantity(left)?, self.quantity(right)?);
        let dim = match (op, a, b) {
            (Binary::Multiply, Known(a), Known(b)) => a.times(b),
            (Binary::Divide, Known(a), Known(b)) => a.over(b),
            (Binary::Multiply | Binary::Divide, ..) => return Some(Free),
            (Binary::Power, ..) => return self.power_quantity(id, a, right),
            (Binary::Add | Binary::Subtract, ..) => {
                let verb = if op == Binary::Add {
                    "adds"
                } else {
                    "subtracts"
                };
                return self.same(id, verb, &[left, right]);
            }
            _ => {
                self.same(id, "compares", &[left, right])?;
                return Some(Known(Dim::NONE));
            }
        };
        self.moderate(id, dim)
    }

    fn moderate(&mut self, id: Id, dim: Dim) -> Option<Quantity> {
        if !dim.is_moderate() {
            self.report(id, Fault::Dimension, self.tree.span(id));
            return None;
        }
        Some(Quantity::Known(dim))
    }

    fn power_quantity(&mut self, id: Id, base: Quantity, exponent: Id) -> Option<Quantity> {
        if let Some(Quantity::Known(dim)) = self.quantity(exponent)
            && !dim.is_none()
        {
            let fault = Fault::WrongArgument {
                what: "an exponent".to_owned(),
                wanted: "a plain number".to_owned(),
                given: dim.describe(),
            };
            self.report(id, fault, self.tree.span(exponent));
            return None;
        }
        let Quantity::Known(dim) = base else {
            return Some(Quantity::Free);
        };
        let result = match self.value(exponent) {
            _ if dim.is_none() => Some(dim),
            Some(power) => dim.power(power),
            None => None,
        };
        let Some(result) = result else {
            let base = dim.describe();
            self.report(id, Fault::Exponent { base }, self.tree.span(id));
            return None;
        };
        self.moderate(id, result)
    }

    /// The common quantity of some terms.
    fn same(&mut self, id: Id, verb: &str, terms: &[Id]) -> Option<Quantity> {
        let mut common = Quantity::Free;
        for &term in terms {
            match common.join(self.quantity(term)?) {
                Ok(joined) => common = joined,
                Err((left, right)) => {
                    let span = self.tree.span(id);
                    let fault = Fault::Mismatch {
                        what: format!("{} {verb}", self.source(span.clone())),
                        left: left.describe(),
                        right: right.describe(),
                    };
                    self.report(id, fault, span);
                    return None;
                }
            }
        }
        Some(common)
    }

    /// Does an argument have the dimension that a function asks for?
    fn takes(&mut self, id: Id, name: &str, wanted: Quantity, argument: Id) -> Option<()> {
        let given = self.quantity(argument)?;
        if given.join(wanted).is_ok() {
            return Some(());
        }
        let fault = Fault::WrongArgument {
            what: format!("`{name}`"),
            wanted: wanted.describe(),
            given: given.describe(),
        };
        self.report(id, fault, self.tree.span(argument));
        None
    }

    fn call(&mut self, id: Id, name: &str, name_span: &Range<usize>, arguments: &[Id]) -> Meaning {
        if let Some(builtin) = Builtin::named(name) {
            return self.call_builtin(id, builtin, arguments);
        }
        let Some(table) = self.scope.function(name) else {
            let fault = Fault::UnknownFunction {
                name: name.to_owned(),
                suggestions: suggest::nearest(name, Builtin::names()),
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

    fn builtin_quantity(
        &mut self,
        id: Id,
        function: &Builtin,
        arguments: &[Id],
    ) -> Option<Quantity> {
        let name = function.name;
        let plain = |quantity: Quantity| match quantity {
            // Nothing is known: the value may be meant in SI units of its place.
            Quantity::Free => Quantity::Free,
            Quantity::Known(_) => Quantity::Known(Dim::NONE),
        };
        match function.rule {
            Rule::Plain => {
                self.takes(id, name, Dim::NONE.into(), arguments[0])?;
                self.quantity(arguments[0])
            }
            Rule::Same => self.same(id, "mixes", arguments),
            Rule::Ratio => self.same(id, "mixes", arguments).map(plain),
            Rule::Choice => {
                let condition = self.condition(id, arguments[0]);
                let value = self.same(id, "chooses between", &arguments[1..]);
                condition.and(value)
            }
            Rule::Root => {
                let Quantity::Known(dim) = self.quantity(arguments[0])? else {
                    return Some(Quantity::Free);
                };
                let root = dim.sqrt();
                if root.is_none() {
                    let base = dim.describe();
                    self.report(id, Fault::Exponent { base }, self.tree.span(id));
                }
                root.map(Quantity::Known)
            }
        }
    }
}

/// The value of an operator on constants.
fn fold(operator: Binary, a: f64, b: f64) -> f64 {
    match operator {
        Binary::Add => a + b,
        Binary::Subtract => a - b,
        Binary::Multiply => a * b,
        Binary::Divide => a / b,
        Binary::Power => power(b).map_or_else(|| Bivariate::Power.value(a, b), |p| p.value(a)),
        Binary::Less => f64::from(a < b),
        Binary::LessEqual => f64::from(a <= b),
        Binary::Greater => f64::from(a > b),
        Binary::GreaterEqual => f64::from(a >= b),
        Binary::Equal => f64::from(a == b),
        Binary::NotEqual => f64::from(a != b),
        Binary::And => f64::from(a != 0.0 && b != 0.0),
        Binary::Or => f64::from(a != 0.0 || b != 0.0),
    }
}

/// A fixed power as a function of its base. Small whole powers are products.
pub(crate) fn power(exponent: f64) -> Option<Univariate> {
    if !exponent.is_finite() {
        return None;
    }
    Some(if exponent.fract() == 0.0 && exponent.abs() <= 16.0 {
        Univariate::PowInt(exponent as i32)
    } else {
        Univariate::PowReal(exponent)
    })
}

/// The value of a function on constants.
fn apply(operation: Operation, values: &[f64]) -> f64 {
    match (operation, values) {
        (Operation::Univariate(f), [x]) => f.value(*x),
        (Operation::Bivariate(f), [a, b]) => f.value(*a, *b),
        (Operation::Mod, [a, b]) => builtin::modulo(*a, *b),
        (Operation::Blend, [x, from, to]) => builtin::blend(*x, *from, *to),
        (Operation::Min, [first, rest @ ..]) => rest.iter().copied().fold(*first, builtin::min),
        (Operation::Max, [first, rest @ ..]) => rest.iter().copied().fold(*first, builtin::max),
        // The number of arguments has been checked, and `if` has its own rule.
        _ => f64::NAN,
    }
}
