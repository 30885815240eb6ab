//! Colours and line patterns that stay distinct for colour-blind readers.

/// The palette of Okabe and Ito (2008) without its yellow, which is too faint for thin lines on white.
const COLORS: [&str; 7] = [
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#333333",
];

/// Line patterns; the next one begins when the colours are used up.
const DASHES: [Option<&str>; 4] = [None, Some("7 3"), Some("2 2.5"), Some("9 3 2 3")];

/// Look of one curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Look {
    pub color: &'static str,
    pub dash: Option<&'static str>,
}

/// Look of the k-th curve of a panel; 28 are distinct.
pub(super) fn look(k: usize) -> Look {
    Look {
        color: COLORS[k % COLORS.len()],
        dash: DASHES[k / COLORS.len() % DASHES.len()],
    }
}
