//! Unit expressions: `N`, `m/s^2`, `kg m^2`.

use super::parser::Parser;
use super::token::Token;
use crate::error::Fault;
use crate::{Unit, suggest};

/// Largest exponent of a unit.
const LARGEST: f64 = 12.0;

impl Parser<'_> {
    /// The unit that directly follows a number: names side by side or joined by `*` and `/`, each
    /// with an optional whole power. `None` where no name follows.
    ///
    /// Reports what is wrong with it; an unknown name is taken as no unit.
    pub(super) fn unit(&mut self) -> Option<Unit> {
        let mut unit = self.first_unit()?;
        loop {
            let joined = match self.peek() {
                Token::Star => Some(1),
                Token::Slash => Some(-1),
                _ => None,
            };
            let ahead = usize::from(joined.is_some());
            let Some((name, factor)) = self.unit_name(ahead) else {
                return Some(unit);
            };
            if joined.is_some() && self.is_variable(&name) {
                let span = self.span_ahead(ahead);
                self.report(Fault::AmbiguousName { name }, span);
            }
            self.skip(ahead + 1);
            let exponent = self.unit_exponent();
            unit = unit.times_power(factor, exponent * joined.unwrap_or(1));
        }
    }

    fn first_unit(&mut self) -> Option<Unit> {
        if let Some((_, factor)) = self.unit_name(0) {
            self.skip(1);
            let exponent = self.unit_exponent();
            return Some(Unit::ONE.times_power(factor, exponent));
        }
        let Token::Name(path) = self.peek() else {
            return None;
        };
        let name = path.word()?.to_owned();
        // A known name here is a forgotten operator, which the caller reports.
        if self.is_variable(&name) || self.peek_ahead(1) == &Token::Open {
            return None;
        }
        let span = self.span_ahead(0);
        let suggestions = suggest::owned(suggest::nearest(&name, Unit::names()));
        self.report(Fault::UnknownUnit { name, suggestions }, span);
        self.skip(1);
        Some(Unit::ONE)
    }

    /// The unit that is named by a word ahead, unless that word is the name of a function call.
    fn unit_name(&self, ahead: usize) -> Option<(String, Unit)> {
        let Token::Name(path) = self.peek_ahead(ahead) else {
            return None;
        };
        let name = path.word()?;
        let unit = Unit::named(name)?;
        (self.peek_ahead(ahead + 1) != &Token::Open).then(|| (name.to_owned(), unit))
    }

    /// The power of a unit, 1 where none is written.
    fn unit_exponent(&mut self) -> i8 {
        if self.peek() != &Token::Caret {
            return 1;
        }
        let start = self.span_ahead(0).start;
        let negative = self.peek_ahead(1) == &Token::Minus;
        let length = 1 + usize::from(negative);
        let exponent = match self.peek_ahead(length) {
            Token::Number(n) if n.fract() == 0.0 && n.abs() <= LARGEST => Some(*n as i8),
            _ => None,
        };
        let Some(exponent) = exponent else {
            let end = self.span_ahead(length).end;
            self.report(Fault::UnitExponent, start..end);
            self.skip(length);
            if matches!(self.peek(), Token::Number(_)) {
                self.skip(1);
            }
            return 1;
        };
        self.skip(length + 1);
        if self.peek() == &Token::Caret {
            let end = self.span_ahead(0).end;
            self.report(Fault::UnitExponent, start..end);
        }
        if negative { -exponent } else { exponent }
    }
}
