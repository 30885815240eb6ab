//! From text to a syntax tree.

pub(crate) mod lexer;
pub(crate) mod parser;
pub(crate) mod token;
pub(crate) mod tree;
pub(crate) mod units;

pub use lexer::is_identifier;
