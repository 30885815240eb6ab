//! The syntax tree.

use super::token::Path;
use crate::{Quantity, Unit};
use std::ops::Range;

/// Number of a node. Children come before their parent, and the nodes of a subtree are
/// contiguous: every pass is a loop, so that no text can overflow the stack.
pub(crate) type Id = usize;

/// What a node is.
#[derive(Clone, Debug)]
pub(crate) enum Node {
    /// A number, with the unit that directly follows it.
    Number {
        value: f64,
        unit: Option<Unit>,
    },
    /// A variable or a named constant.
    Name(Path),
    Negate(Id),
    Not(Id),
    Binary(Binary, Id, Id),
    Call {
        name: String,
        name_span: Range<usize>,
        arguments: Vec<Id>,
    },
    /// Something that was reported already.
    Invalid,
}

/// Operators with two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
}

/// A syntax tree in one list; the root is the last node.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tree {
    nodes: Vec<Node>,
    spans: Vec<Range<usize>>,
    first: Vec<Id>,
}

impl Tree {
    /// Adds a node whose subtree starts at node `first`.
    pub(crate) fn push(&mut self, node: Node, first: Id, span: Range<usize>) -> Id {
        self.nodes.push(node);
        self.spans.push(span);
        self.first.push(first);
        self.nodes.len() - 1
    }

    /// Adds a node without children.
    pub(crate) fn leaf(&mut self, node: Node, span: Range<usize>) -> Id {
        self.push(node, self.nodes.len(), span)
    }

    pub(crate) fn len(&self) -> usize {
        self.nodes.len()
    }

    pub(crate) fn node(&self, id: Id) -> &Node {
        &self.nodes[id]
    }

    pub(crate) fn span(&self, id: Id) -> Range<usize> {
        self.spans[id].clone()
    }

    /// Widens the place of a node, to include its parentheses.
    pub(crate) fn widen(&mut self, id: Id, span: Range<usize>) {
        self.spans[id] = span;
    }

    /// The first node of a subtree.
    pub(crate) fn first(&self, id: Id) -> Id {
        self.first[id]
    }

    /// All nodes of a subtree, the root last.
    pub(crate) fn subtree(&self, id: Id) -> &[Node] {
        &self.nodes[self.first[id]..=id]
    }
}

/// The value of a number in SI and its quantity.
pub(crate) fn number(value: f64, unit: Option<Unit>) -> (f64, Quantity) {
    match unit {
        None => (value, Quantity::Free),
        Some(unit) => (unit.to_si(value), Quantity::Known(unit.dim())),
    }
}
