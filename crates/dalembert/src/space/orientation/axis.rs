//! The three coordinate axes.

use nalgebra::Vector3;

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// First.
    X,
    /// Second.
    Y,
    /// Third.
    Z,
}

impl Axis {
    /// All, in order.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// Its number: 0, 1, 2.
    pub fn number(self) -> usize {
        match self {
            Self::X => 0,
            Self::Y => 1,
            Self::Z => 2,
        }
    }

    /// Its unit vector.
    pub fn unit(self) -> Vector3<f64> {
        let mut unit = Vector3::zeros();
        unit[self.number()] = 1.0;
        unit
    }

    /// Its small letter.
    pub fn letter(self) -> char {
        ['x', 'y', 'z'][self.number()]
    }

    /// The axis of a letter.
    pub fn from_letter(letter: char) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|a| a.letter() == letter.to_ascii_lowercase())
    }

    /// The axes that follow it in turn: (k, i, j) is right-handed.
    pub fn next_two(self) -> (Self, Self) {
        let k = self.number();
        (Self::ALL[(k + 1) % 3], Self::ALL[(k + 2) % 3])
    }

    /// The axis that is neither of two different ones, and whether (first, second, third) is a right-handed order (+1)
    /// or not (-1).
    pub(super) fn third(first: Self, second: Self) -> (Self, f64) {
        let (i, j) = (first.number(), second.number());
        let sign = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
        (Self::ALL[3 - i - j], sign)
    }
}
