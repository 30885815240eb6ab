//! The instructions of a compiled expression.

use crate::derive::bivariate::Bivariate;
use crate::derive::univariate::Univariate;

/// One step of a stack machine. "Top" is the uppermost value of the stack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Instruction {
    /// Pushes a number.
    Constant(f64),
    /// Pushes a value that the caller gives.
    Slot(u32),
    /// Replaces the two uppermost values (a below b) by a + b, and so on.
    Add,
    Subtract,
    Multiply,
    Divide,
    /// b - a and b / a: the operands were computed in the other order.
    SubtractFrom,
    DivideInto,
    /// top + value, and so on.
    AddSlot(u32),
    SubtractSlot(u32),
    MultiplySlot(u32),
    DivideSlot(u32),
    AddConstant(f64),
    MultiplyConstant(f64),
    DivideConstant(f64),
    /// number - top.
    FromConstant(f64),
    /// number / top.
    OverConstant(f64),
    Negate,
    Univariate(Univariate),
    Bivariate(Bivariate),
    Compare(Comparison),
    And,
    Or,
    Not,
    Min,
    Max,
    Mod,
    Blend,
    /// Calls a table of the program.
    Table(u32),
    /// Pops a condition; goes to another instruction where it is false.
    Unless(u32),
    /// Goes to another instruction.
    Jump(u32),
}

impl Instruction {
    /// Can its value jump while its operands pass steadily?
    pub(crate) fn can_jump(self) -> bool {
        matches!(
            self,
            Self::Univariate(Univariate::Sign | Univariate::Step | Univariate::Floor)
                | Self::Mod
                | Self::Compare(_)
        )
    }
}

/// A comparison of two values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Comparison {
    Less,
    LessEqual,
    Equal,
    NotEqual,
    Greater,
    GreaterEqual,
}

impl Comparison {
    #[inline]
    pub(crate) fn holds(self, a: f64, b: f64) -> bool {
        match self {
            Self::Less => a < b,
            Self::LessEqual => a <= b,
            Self::Equal => a == b,
            Self::NotEqual => a != b,
            Self::Greater => a > b,
            Self::GreaterEqual => a >= b,
        }
    }
}
