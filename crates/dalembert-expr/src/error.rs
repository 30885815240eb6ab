//! What can be wrong with an expression.

use crate::{Dim, Quantity, UnknownName};
use std::ops::Range;

/// One mistake in an expression: what, where, and what to do.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct ExprError {
    /// Stable kebab-case code, for example `unknown-name`.
    pub code: &'static str,
    /// One sentence.
    pub message: String,
    /// Byte range in the text of the expression.
    pub span: Range<usize>,
    /// What to do.
    pub help: String,
}

impl ExprError {
    pub(crate) fn new(fault: &Fault, span: Range<usize>) -> Self {
        Self {
            code: fault.code(),
            message: fault.to_string(),
            span,
            help: fault.help(),
        }
    }
}

/// How many mistakes of a text are told.
pub(crate) const MOST_ERRORS: usize = 20;

/// A part of a text as a message quotes it: its beginning, if it is long.
pub(crate) fn excerpt(text: &str) -> String {
    match text.char_indices().nth(40) {
        None => text.to_owned(),
        Some((cut, _)) => format!("{}...", &text[..cut]),
    }
}

/// Every mistake that is recognised.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(crate) enum Fault {
    #[error("the expression is empty")]
    Empty,
    #[error("the expression is longer than {limit} bytes")]
    TooLong { limit: usize },
    #[error("the expression is nested too deeply")]
    TooDeep,
    #[error("unexpected character `{}`", found.escape_debug())]
    UnexpectedCharacter { found: char },
    #[error("`**` is not an operator")]
    DoubleStar,
    #[error("a name in backticks is not closed")]
    OpenBacktick,
    #[error("a name in backticks is empty")]
    EmptyName,
    #[error("a name with a space stands in backticks")]
    SpacedName { written: String },
    #[error("after the point there must be the name of a property")]
    MissingProperty,
    #[error("the expression ends where a value is expected")]
    UnexpectedEnd,
    #[error("unexpected `{found}` where a value is expected")]
    UnexpectedWord { found: String },
    #[error("this parenthesis is not closed")]
    MissingParenthesis,
    #[error("unexpected `{found}` after a complete expression")]
    Trailing { found: String },
    #[error("an operator is missing between `{left}` and `{right}`")]
    MissingOperator { left: String, right: String },
    #[error("`{name}` is not a unit")]
    UnknownUnit {
        name: String,
        suggestions: Vec<String>,
    },
    #[error("the exponent of a unit must be a whole number from -12 to 12, written once")]
    UnitExponent,
    #[error("`{name}` is a unit and also a name in this model")]
    AmbiguousName { name: String },
    #[error("`{text}` divides by `{denominator}`: the unit belongs to the number before it")]
    AmbiguousFraction { text: String, denominator: String },
    #[error("comparisons cannot be chained")]
    ComparisonChain,
    #[error("`{name}` is not known here")]
    UnknownName { name: String, unknown: UnknownName },
    #[error("`{name}` is a unit, and a unit stands only directly after a number")]
    LooseUnit { name: String },
    #[error("`{name}` is a function and needs arguments in parentheses")]
    FunctionWithoutArguments { name: String },
    #[error("there is no function `{name}`")]
    UnknownFunction {
        name: String,
        suggestions: Vec<String>,
        variable: bool,
    },
    #[error("`{name}` takes {wanted}, not {given}")]
    ArgumentCount {
        name: String,
        wanted: String,
        given: usize,
        usage: String,
    },
    #[error("{what} {left} and {right}")]
    Mismatch {
        what: String,
        left: String,
        right: String,
    },
    #[error("{what} takes {wanted}, but this is {given}")]
    WrongArgument {
        what: String,
        wanted: String,
        given: String,
    },
    #[error("{base} can only be raised to a fixed power that leaves whole or half exponents")]
    Exponent { base: String },
    #[error("this has an unreasonable dimension")]
    Dimension,
    #[error("this must be {}, but it is {}", expected.describe(), given.describe())]
    Expected { expected: Quantity, given: Quantity },
    #[error("{what} {left}{link}{right}")]
    Doubtful {
        what: String,
        left: String,
        link: &'static str,
        right: String,
    },
    #[error("division by zero")]
    DivisionByZero,
    #[error("this has no finite value")]
    NotFinite,
}

impl Fault {
    fn code(&self) -> &'static str {
        match self {
            Self::Empty => "empty-expression",
            Self::TooLong { .. } => "expression-too-long",
            Self::TooDeep => "expression-too-deep",
            Self::UnexpectedCharacter { .. } | Self::DoubleStar => "unexpected-character",
            Self::OpenBacktick | Self::EmptyName | Self::SpacedName { .. } => "bad-name",
            Self::MissingProperty => "missing-property",
            Self::UnexpectedEnd => "unexpected-end",
            Self::UnexpectedWord { .. } | Self::Trailing { .. } => "unexpected-word",
            Self::MissingParenthesis => "missing-parenthesis",
            Self::MissingOperator { .. } => "missing-operator",
            Self::UnknownUnit { .. } => "unknown-unit",
            Self::UnitExponent => "unit-exponent",
            Self::AmbiguousName { .. } => "ambiguous-name",
            Self::AmbiguousFraction { .. } => "ambiguous-fraction",
            Self::ComparisonChain => "comparison-chain",
            Self::UnknownName { .. } => "unknown-name",
            Self::LooseUnit { .. } => "loose-unit",
            Self::FunctionWithoutArguments { .. } => "function-without-arguments",
            Self::UnknownFunction { .. } => "unknown-function",
            Self::ArgumentCount { .. } => "argument-count",
            Self::Mismatch { .. }
            | Self::WrongArgument { .. }
            | Self::Exponent { .. }
            | Self::Dimension
            | Self::Expected { .. } => "unit-mismatch",
            Self::Doubtful { .. } => "doubtful-unit",
            Self::DivisionByZero => "division-by-zero",
            Self::NotFinite => "not-finite",
        }
    }

    /// What to do: every mistake has a remedy.
    fn help(&self) -> String {
        match self {
            Self::Empty => "write a number, such as `30 deg`, or an expression".to_owned(),
            Self::TooLong { .. } => "use a table for long data, or parameters for parts".to_owned(),
            Self::TooDeep => "give a name to a part of it with a parameter".to_owned(),
            Self::UnexpectedCharacter { found } => character_help(*found),
            Self::DoubleStar => "write `^` for a power".to_owned(),
            Self::OpenBacktick => "add the closing backtick".to_owned(),
            Self::EmptyName => "write the name between the backticks".to_owned(),
            Self::SpacedName { written } => format!("write {written}"),
            Self::MissingProperty => {
                "write for example `crank.angle`; other characters need backticks".to_owned()
            }
            Self::MissingParenthesis => "add `)`".to_owned(),
            Self::Trailing { found } if found == ")" => {
                "remove it, or add the opening parenthesis".to_owned()
            }
            Self::Trailing { found } if found == "," => {
                "numbers have a decimal point, as in `0.5 kg`; in a list every entry has quotes of \
                 its own"
                    .to_owned()
            }
            Self::MissingOperator { left, right } => {
                format!("for a product write `{left}*{right}`")
            }
            Self::UnknownUnit { name, suggestions } => match name.as_str() {
                "t" => "for a product write `*`; a metric ton is `tonne`".to_owned(),
                "Nm" | "nm" => "write `N m`".to_owned(),
                name if unit_word(name).is_some() => {
                    format!("write `{}`", unit_word(name).unwrap_or_default())
                }
                _ => did_you_mean(suggestions).unwrap_or_else(|| {
                    "units are for example `mm`, `kg`, `s`, `deg`, `N`, `kg m^2`; for a product \
                     write `*`"
                        .to_owned()
                }),
            },
            Self::AmbiguousName { name } => format!(
                "put the number and its unit in parentheses to use the name, as in `(5 N)*{name}`; \
                 for the unit write `5 N {name}` or `5 N {name}^-1`"
            ),
            Self::AmbiguousFraction { .. } => {
                "write a decimal number, as in `0.5 in`, or put the denominator in parentheses"
                    .to_owned()
            }
            Self::ComparisonChain => "write `a < b and b < c`".to_owned(),
            Self::UnknownName { unknown, .. } => {
                let parts = [did_you_mean(&unknown.suggestions), unknown.note.clone()];
                let parts: Vec<String> = parts.into_iter().flatten().collect();
                if parts.is_empty() {
                    "only numbers with units can be used here".to_owned()
                } else {
                    parts.join("; ")
                }
            }
            Self::LooseUnit { name } => format!("write `1 {name}`, or `2 {name}` for a product"),
            Self::FunctionWithoutArguments { name } => format!("write `{name}(...)`"),
            Self::UnknownFunction {
                name,
                suggestions,
                variable,
            } => match did_you_mean(suggestions) {
                _ if name == "log" => "write `ln` or `log10`".to_owned(),
                _ if name == "pow" => "write `a^b`".to_owned(),
                _ if *variable => {
                    format!("`{name}` is a value; for a product write `{name}*(...)`")
                }
                Some(help) => help,
                None => "the functions are those of the language, such as `sin`, `sqrt`, `min`, \
                         `if`, and the tables of the model"
                    .to_owned(),
            },
            Self::ArgumentCount { usage, .. } => format!("write `{usage}`"),
            Self::Expected { expected, given } if rate_unit(*expected, *given).is_some() => {
                let unit = rate_unit(*expected, *given).unwrap_or_default();
                format!("a rate that is multiplied with the time is per second: write `{unit}`")
            }
            Self::Mismatch { .. } | Self::WrongArgument { .. } | Self::Expected { .. } => {
                "check the terms; a number without a unit takes any dimension, in SI".to_owned()
            }
            Self::Doubtful { .. } => "check the terms; a number without a unit that divides a \
                                      constant is taken as a plain number: where it is not, give \
                                      it its unit"
                .to_owned(),
            Self::DivisionByZero => {
                "change the divisor; `if(x == 0, a, b/x)` evaluates one branch only".to_owned()
            }
            Self::NotFinite => {
                "it is too large, or the function has no value there: correct the numbers"
                    .to_owned()
            }
            Self::UnexpectedEnd => "complete it, or remove the last operator".to_owned(),
            Self::UnexpectedWord { .. } | Self::Trailing { .. } => {
                "remove it, or write the value or operator that is missing".to_owned()
            }
            Self::UnitExponent => "write for example `m^2` or `s^-1`".to_owned(),
            Self::Exponent { .. } => {
                "divide by a quantity of its kind first, so that a plain number is raised"
                    .to_owned()
            }
            Self::Dimension => "check the exponents".to_owned(),
        }
    }
}

fn did_you_mean(suggestions: &[String]) -> Option<String> {
    let quoted: Vec<String> = suggestions.iter().map(|s| format!("`{s}`")).collect();
    (!quoted.is_empty()).then(|| format!("did you mean {}?", quoted.join(" or ")))
}

/// The unit of the rate, where something is too large by the time that a rate was multiplied with.
fn rate_unit(expected: Quantity, given: Quantity) -> Option<&'static str> {
    let expected = expected.known()?;
    let times_time = given.known()? == expected.times(Dim::TIME);
    match expected {
        Dim::NONE if times_time => Some("deg/s"),
        Dim::LENGTH if times_time => Some("mm/s"),
        _ => None,
    }
}

/// The symbol of a unit that is written as a word.
fn unit_word(name: &str) -> Option<&'static str> {
    let word = name.to_lowercase();
    let singular = word.strip_suffix('s').unwrap_or(&word);
    let of = |word: &str| UNIT_WORDS.iter().find(|(words, _)| words.contains(&word));
    of(&word).or_else(|| of(singular)).map(|(_, unit)| *unit)
}

/// Words for units, in lower case and singular, and the symbol that is known.
const UNIT_WORDS: &[(&[&str], &str)] = &[
    (&["meter", "metre"], "m"),
    (&["millimeter", "millimetre"], "mm"),
    (&["centimeter", "centimetre"], "cm"),
    (&["kilometer", "kilometre"], "km"),
    (&["inch", "inches"], "in"),
    (&["foot", "feet"], "ft"),
    (&["kilogram", "kilogramme", "kilo"], "kg"),
    (&["gram", "gramme"], "g"),
    (&["ton", "tonne"], "tonne"),
    (&["pound", "lbs"], "lb"),
    (&["second", "sec"], "s"),
    (&["millisecond", "msec"], "ms"),
    (&["minute"], "min"),
    (&["hour", "hr"], "h"),
    (&["degree"], "deg"),
    (&["radian"], "rad"),
    (&["revolution", "turn"], "rev"),
    (&["hertz"], "Hz"),
    (&["newton"], "N"),
    (&["kilonewton"], "kN"),
    (&["newtonmeter", "newtonmetre"], "N m"),
    (&["pascal"], "Pa"),
    (&["megapascal"], "MPa"),
    (&["joule"], "J"),
    (&["watt"], "W"),
    (&["kilowatt"], "kW"),
];

fn character_help(found: char) -> String {
    let text = match found {
        '°' => "write `deg`",
        '²' | '³' => "write `^2` or `^3`",
        '×' | '·' | '⋅' => "write `*`",
        '−' | '–' => "write the plain minus `-`",
        'π' => "write `pi`",
        'µ' | 'μ' => "write `um` or `us`",
        '%' => "write per cent as a decimal number; the remainder is `mod(a, b)`",
        '=' => "write `==` to compare",
        '&' => "write `and`",
        '|' => "write `or`",
        '!' => "write `not`",
        '?' => "write `if(condition, a, b)` for a choice",
        '[' | '{' => "write `(`",
        ']' | '}' => "write `)`",
        '"' | '\'' => "put unusual names in backticks",
        c if c.is_alphabetic() => "put a name with this character in backticks",
        _ => "remove it",
    };
    text.to_owned()
}
