//! What a numeric factorization found out about the rows.

/// Report of one numeric factorization: which rows carry new information.
///
/// The pivot ratio of a row is its pivot over its own initial diagonal: the square of the sine of the angle between
/// its gradient and the span of the rows eliminated before it, in the metric of the inverse mass. It does not depend
/// on the units of rows and coordinates. In an element with auxiliaries, the rows are its turned rows.
#[derive(Clone, Copy, Debug)]
pub struct Factored<'a> {
    /// Pivot ratio of each row; zero for a row without gradient.
    pub pivot_ratio: &'a [f64],
    /// Smallest ratio among the rows that were kept; one if there is none.
    pub smallest: f64,
    /// Largest ratio among the rows that were kept; one if there is none.
    pub largest: f64,
    /// Rows whose pivot vanished: they depend on the others. Ascending.
    pub vanished: &'a [usize],
    /// Rows whose gradient is zero at this pose. Ascending.
    pub zero: &'a [usize],
    /// The least pivot ratio of a kept row.
    pub tolerance: f64,
}

impl Factored<'_> {
    /// Rank of the constraint rows after the auxiliaries are eliminated, plus the determined auxiliaries.
    pub fn rank(&self) -> usize {
        self.pivot_ratio.len() - self.vanished.len() - self.zero.len()
    }
}
