//! From text to a program.

use crate::check;
use crate::emit;
use crate::error::{ExprError, Fault, MOST_ERRORS};
use crate::program::{DEEPEST, Program};
use crate::scope::Scope;
use crate::syntax::parser;
use crate::syntax::tree::Node;
use crate::{EmptyScope, Quantity, Unit, builtin};
use std::ops::Range;

/// Compiles an expression for a place that asks for a quantity, or tells all its mistakes.
pub fn compile(
    text: &str,
    scope: &dyn Scope,
    expected: Quantity,
) -> Result<Program, Vec<ExprError>> {
    let (tree, mut errors) = parser::parse(text, Some(scope));
    if !errors.is_empty() {
        // What can be understood is checked as well; a mistake in it is not said twice.
        if tree.len() > 0
            && let Err(more) = check::check(text, &tree, scope, Quantity::Free)
        {
            let apart = |e: &ExprError| errors.iter().all(|f| !overlap(&f.span, &e.span));
            let more: Vec<ExprError> = more.into_iter().filter(apart).collect();
            errors.extend(more);
        }
        errors.sort_by_key(|error| (error.span.start, error.span.end));
        errors.truncate(MOST_ERRORS);
        return Err(errors);
    }
    let check::Checked { known, doubts } = check::check(text, &tree, scope, expected)?;
    let code = emit::emit(&tree, &known);
    if code.depth > DEEPEST {
        return Err(vec![ExprError::new(&Fault::TooDeep, 0..text.len())]);
    }
    let found = known.last().and_then(|root| root.quantity);
    let quantity = match (found, expected) {
        (Some(known @ Quantity::Known(_)), _) => known,
        (Some(likely @ Quantity::Likely(_)), Quantity::Free) => likely,
        _ => expected,
    };
    Ok(Program::new(text, quantity, code, doubts))
}

fn overlap(a: &Range<usize>, b: &Range<usize>) -> bool {
    a.start < b.end.max(b.start + 1) && b.start < a.end.max(a.start + 1)
}

/// The value in SI of a text without names, such as `30 deg` or `2*150 mm`.
pub fn parse_quantity(text: &str, expected: Quantity) -> Result<f64, Vec<ExprError>> {
    let program = compile(text, &EmptyScope, expected)?;
    // Without names every part is folded: there is always a constant.
    Ok(program.constant().unwrap_or_else(|| program.eval(&[])))
}

/// The unit that a text such as `mm` or `kg m^2` names; an empty text is a plain number.
pub fn parse_unit(text: &str) -> Result<Unit, Vec<ExprError>> {
    parser::parse_unit(text)
}

/// A name, part by part, and its place in the text.
pub type NamePlace = (Vec<String>, Range<usize>);

/// The variables in a text with their places, in order; constants of the language left out.
///
/// It is meant for the order in which parameters depend on each other. Where the text is wrong,
/// [`compile`] says it better, because it knows the names.
pub fn names(text: &str) -> Result<Vec<NamePlace>, Vec<ExprError>> {
    let (tree, errors) = parser::parse(text, None);
    if !errors.is_empty() {
        return Err(errors);
    }
    let names = (0..tree.len()).filter_map(|id| match tree.node(id) {
        Node::Name(path) if path.word().and_then(builtin::constant).is_none() => {
            Some((path.parts.clone(), tree.span(id)))
        }
        _ => None,
    });
    let mut names: Vec<NamePlace> = names.collect();
    names.sort_by_key(|(_, span)| span.start);
    Ok(names)
}
