//! The rules of dimensions.

use super::Checker;
use crate::builtin::{Builtin, Rule};
use crate::error::Fault;
use crate::quantity::Clash;
use crate::syntax::tree::{Binary, Id};
use crate::{Dim, Quantity};

impl Checker<'_> {
    /// The quantity of the truth of an operand: a plain number, 1 or 0.
    pub(super) fn condition(&mut self, id: Id, operand: Id) -> Option<Quantity> {
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

    pub(super) fn binary_quantity(
        &mut self,
        id: Id,
        op: Binary,
        left: Id,
        right: Id,
    ) -> Option<Quantity> {
        use Quantity::{Known, Likely};
        if matches!(op, Binary::And | Binary::Or) {
            let (a, b) = (self.condition(id, left), self.condition(id, right));
            return a.and(b);
        }
        let (a, b) = (self.quantity(left)?, self.quantity(right)?);
        let quantity = match (op, a, b) {
            (Binary::Multiply, ..) => a.combine(b, Dim::times),
            // Half a constant length is likely a length. A variable is often divided by a bare
            // scale of its own kind, as in `exp(-t/0.1)`, and an angle by a bare time.
            (Binary::Divide, Known(dim) | Likely(dim), _)
                if self.bare(right) && self.value(left).is_some() && !dim.is_none() =>
            {
                Likely(dim)
            }
            (Binary::Divide, ..) => a.combine(b, Dim::over),
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
        self.moderate(id, quantity)
    }

    fn moderate(&mut self, id: Id, quantity: Quantity) -> Option<Quantity> {
        match quantity {
            Quantity::Known(dim) if !dim.is_moderate() => {
                self.report(id, Fault::Dimension, self.tree.span(id));
                None
            }
            Quantity::Likely(dim) if !dim.is_moderate() => Some(Quantity::Free),
            _ => Some(quantity),
        }
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
        let Some(dim) = base.likely() else {
            return Some(Quantity::Free);
        };
        let result = match self.value(exponent) {
            _ if dim.is_none() => Some(dim),
            Some(power) => dim.power(power),
            None => None,
        };
        let result = match (base, result) {
            (Quantity::Known(_), Some(dim)) => Some(Quantity::Known(dim)),
            (Quantity::Known(_), None) => None,
            (_, dim) => Some(dim.map_or(Quantity::Free, Quantity::Likely)),
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
            let (joined, clash) = common.join(self.quantity(term)?);
            common = joined;
            let Some(Clash::Sure(left, right) | Clash::Doubtful(left, right)) = clash else {
                continue;
            };
            let span = self.tree.span(id);
            let what = format!("{} {verb}", self.source(span.clone()));
            let (left, right) = (left.describe(), right.describe());
            if matches!(clash, Some(Clash::Doubtful(..))) {
                let what = format!("it seems that {what}");
                self.doubt(id, what, left, " and ", right);
                continue;
            }
            self.report(id, Fault::Mismatch { what, left, right }, span);
            return None;
        }
        Some(common)
    }

    /// Does an argument have the dimension that a function asks for?
    pub(super) fn takes(
        &mut self,
        id: Id,
        name: &str,
        wanted: Quantity,
        argument: Id,
    ) -> Option<()> {
        let given = self.quantity(argument)?;
        match given.join(wanted).1 {
            None => return Some(()),
            Some(Clash::Doubtful(..)) => {
                let what = format!("`{name}` takes");
                let (wanted, given) = (wanted.describe(), given.describe());
                self.doubt(argument, what, wanted, ", but this seems to be ", given);
                return Some(());
            }
            Some(Clash::Sure(..)) => {}
        }
        let fault = Fault::WrongArgument {
            what: format!("`{name}`"),
            wanted: wanted.describe(),
            given: given.describe(),
        };
        self.report(id, fault, self.tree.span(argument));
        None
    }

    pub(super) fn builtin_quantity(
        &mut self,
        id: Id,
        function: &Builtin,
        arguments: &[Id],
    ) -> Option<Quantity> {
        let name = function.name;
        let plain = |quantity: Quantity| match quantity {
            // Nothing is known: the value may be meant in SI units of its place.
            Quantity::Free => Quantity::Free,
            Quantity::Likely(_) | Quantity::Known(_) => Quantity::Known(Dim::NONE),
        };
        match function.rule {
            Rule::Plain => {
                self.takes(id, name, Dim::NONE.into(), arguments[0])?;
                // A pure number, like a literal: `cos(35 deg)` may be a coordinate in metres.
                Some(Quantity::Free)
            }
            Rule::Same => self.same(id, "mixes", arguments),
            Rule::Ratio => self.same(id, "mixes", arguments).map(plain),
            Rule::Choice => {
                let condition = self.condition(id, arguments[0]);
                let value = self.same(id, "chooses between", &arguments[1..]);
                condition.and(value)
            }
            Rule::Root => {
                let dim = match self.quantity(arguments[0])? {
                    Quantity::Free => return Some(Quantity::Free),
                    Quantity::Likely(dim) => {
                        return Some(dim.sqrt().map_or(Quantity::Free, Quantity::Likely));
                    }
                    Quantity::Known(dim) => dim,
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
