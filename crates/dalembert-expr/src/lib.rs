//! Expressions with units and exact derivatives.
//!
//! A number of a model may be an expression: `0.5 * crank^2 / 12`, `30 deg + 150 * t`. This crate
//! compiles such a text to a small program that evaluates quickly, without allocation, with exact
//! derivatives up to the third, and that knows its physical dimension. Every mistake is reported
//! with its place in the text and what to do.
//!
//! ```
//! use dalembert_expr::{Dim, EmptyScope, compile, parse_quantity};
//!
//! assert_eq!(parse_quantity("2 * 150 mm", Dim::LENGTH.into()), Ok(0.3));
//! let errors = compile("30 deg + 2 mm", &EmptyScope, Dim::NONE.into()).unwrap_err();
//! assert_eq!((errors[0].code, errors[0].span.clone()), ("unit-mismatch", 0..13));
//! ```
//!
//! # The language
//!
//! - Numbers: `1`, `1.5e-3`, `.5`. All values are in SI.
//! - Units stand directly after a number: `30 deg`, `9.81 m/s^2`, `0.1 kg m^2`. A unit expression
//!   is one or more unit names, side by side or joined by `*` and `/`, each with an optional whole
//!   power; each name multiplies or divides from left to right, so that `1 N/m s` is 1 (N/m) s.
//!   The unit belongs to its number alone: `10 / 2 s` is 10 / (2 s), and `-2 mm^2` is -2 square
//!   millimetres. A unit name that also names a variable is refused after `*` and `/`, where it
//!   could be either: `5 N*m` with a parameter `m`. `1 Hz` is 1/s and `1 rpm` is 2 pi/60 rad/s.
//! - Names: `t`, `crank.angle`; names with other characters in backticks:
//!   `` `return spring`.length ``. A name in backticks is always a variable.
//! - Operators, weak to strong: `or`, `and`, `not`, comparisons (`<` `<=` `>` `>=` `==` `!=`, not
//!   chained), `+` `-`, `*` `/`, the sign, `^` (from the right; `-2^2` is -4).
//! - Truth is 1 and falsehood 0; every number but 0 is true.
//! - Functions: `sin cos tan asin acos atan atan2(y, x) sinh cosh tanh exp ln log10 sqrt abs sign
//!   floor hypot(x, y) min max mod(a, b)`; `step(x)` is 0 below 0 and 1 from there on;
//!   `blend(x, x0, x1)` leads from 0 at x0 to 1 at x1 with two continuous derivatives;
//!   `if(condition, value, otherwise)` evaluates one branch only. Tables are functions too.
//! - Constants: `pi`, `tau`.
//! - Derivatives are those of the branch taken; at a kink (`abs`, `min`) one side's or zero.
//!
//! # Dimensions
//!
//! A number without a unit takes whatever dimension its place asks for, and so does a product or
//! quotient with it: `150 * t` may be an angle. Where both sides of `+`, `-` or a comparison are
//! known they must agree; functions such as `sin` refuse a length; the whole must fit its place.
//!
//! A constant of a known dimension that is divided by a number without a unit, `length / 2`, is
//! likely of its own dimension: where another one is asked for, [`Program::doubts`] has a warning.
//! Factors, variables that are divided (`exp(-t/0.1)`) and divided angles stay free.
#![forbid(unsafe_code)]

mod builtin;
mod check;
mod compile;
mod derive;
mod dimension;
mod emit;
mod error;
mod instruction;
mod program;
mod quantity;
mod scope;
mod spline;
mod suggest;
mod syntax;
mod unit;

pub use builtin::is_reserved;
pub use compile::{NamePlace, compile, names, parse_quantity, parse_unit};
pub use derive::jet2::Jet2;
pub use dimension::Dim;
pub use error::ExprError;
pub use program::Program;
pub use quantity::Quantity;
pub use scope::{EmptyScope, Function, Resolved, Scope, UnknownName};
pub use spline::{Spline, SplineError};
pub use suggest::{matches, nearest, nearest_to_pattern};
pub use syntax::is_identifier;
pub use unit::Unit;
