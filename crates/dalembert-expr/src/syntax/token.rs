//! The words of an expression.

use std::ops::Range;

/// One word.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Token {
    Number(f64),
    Name(Path),
    And,
    Or,
    Not,
    Plus,
    Minus,
    Star,
    Slash,
    Caret,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    Open,
    Close,
    Comma,
    End,
}

/// A name of one or more parts: `t`, `crank.angle`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Path {
    pub parts: Vec<String>,
    /// Was any part in backticks? Then it is never a unit, a constant or a word of the language.
    pub quoted: bool,
}

impl Path {
    /// The name, where it is a plain word that may be a unit, a constant or a function.
    pub(crate) fn word(&self) -> Option<&str> {
        match self.parts.as_slice() {
            [one] if !self.quoted => Some(one),
            _ => None,
        }
    }
}

/// A word and where it stands, in bytes.
pub(crate) type Spanned = (Token, Range<usize>);
