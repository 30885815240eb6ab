//! Units of measure.

use crate::Dim;
use std::f64::consts::PI;

/// A unit: its dimension and the number of SI units in it, as a fraction.
///
/// The fraction keeps decimal units exact to the last digit: 350 mm is 350 / 1000.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    numerator: f64,
    denominator: f64,
    dim: Dim,
}

impl Unit {
    /// The unit of a plain number.
    pub(crate) const ONE: Self = Self::new(1.0, 1.0, Dim::NONE);

    const fn new(numerator: f64, denominator: f64, dim: Dim) -> Self {
        Self {
            numerator,
            denominator,
            dim,
        }
    }

    /// Its dimension.
    pub fn dim(self) -> Dim {
        self.dim
    }

    /// A value in this unit, converted to SI.
    pub fn to_si(self, value: f64) -> f64 {
        value * self.numerator / self.denominator
    }

    /// A value in SI, converted to this unit.
    pub fn from_si(self, value: f64) -> f64 {
        value * self.denominator / self.numerator
    }

    /// Is a value in this unit also its value in SI?
    pub(crate) fn is_si(self) -> bool {
        self.numerator == self.denominator
    }

    /// Multiplies by a whole power of another unit.
    pub(crate) fn times_power(self, other: Self, exponent: i8) -> Self {
        let n = i32::from(exponent.unsigned_abs());
        let (mut above, mut below) = (other.numerator.powi(n), other.denominator.powi(n));
        if exponent < 0 {
            std::mem::swap(&mut above, &mut below);
        }
        Self {
            numerator: self.numerator * above,
            denominator: self.denominator * below,
            dim: self.dim.times(other.dim.pow(exponent)),
        }
    }

    /// The unit of this name: `mm`, `kN`, `rpm`.
    pub fn named(name: &str) -> Option<Self> {
        UNITS
            .iter()
            .find(|(known, ..)| *known == name)
            .map(|&(_, numerator, denominator, dim)| Self::new(numerator, denominator, dim))
    }

    /// The names of all units.
    pub fn names() -> impl Iterator<Item = &'static str> {
        UNITS.iter().map(|(name, ..)| *name)
    }
}

/// Pound-force: 0.45359237 kg times 9.80665 m/s^2, exact, in units of 1e-13 N.
const LBF: f64 = 44_482_216_152_605.0;

/// Name, numerator, denominator, dimension. Inch, pound and standard gravity as defined in 1959
/// and 1901; horsepower is 550 ft lbf/s.
const UNITS: &[(&str, f64, f64, Dim)] = &[
    ("m", 1.0, 1.0, Dim::LENGTH),
    ("mm", 1.0, 1e3, Dim::LENGTH),
    ("cm", 1.0, 1e2, Dim::LENGTH),
    ("km", 1e3, 1.0, Dim::LENGTH),
    ("um", 1.0, 1e6, Dim::LENGTH),
    ("in", 254.0, 1e4, Dim::LENGTH),
    ("ft", 3048.0, 1e4, Dim::LENGTH),
    ("yd", 9144.0, 1e4, Dim::LENGTH),
    ("mi", 1_609_344.0, 1e3, Dim::LENGTH),
    ("kg", 1.0, 1.0, Dim::MASS),
    ("g", 1.0, 1e3, Dim::MASS),
    ("mg", 1.0, 1e6, Dim::MASS),
    ("tonne", 1e3, 1.0, Dim::MASS),
    ("lb", 45_359_237.0, 1e8, Dim::MASS),
    ("slug", LBF, 3048e9, Dim::MASS),
    ("s", 1.0, 1.0, Dim::TIME),
    ("ms", 1.0, 1e3, Dim::TIME),
    ("us", 1.0, 1e6, Dim::TIME),
    ("min", 60.0, 1.0, Dim::TIME),
    ("h", 3600.0, 1.0, Dim::TIME),
    ("rad", 1.0, 1.0, Dim::NONE),
    ("mrad", 1.0, 1e3, Dim::NONE),
    ("deg", PI, 180.0, Dim::NONE),
    ("arcmin", PI, 10_800.0, Dim::NONE),
    ("arcsec", PI, 648_000.0, Dim::NONE),
    ("rev", 2.0 * PI, 1.0, Dim::NONE),
    ("Hz", 1.0, 1.0, Dim::FREQUENCY),
    ("kHz", 1e3, 1.0, Dim::FREQUENCY),
    ("rpm", PI, 30.0, Dim::ANGULAR_VELOCITY),
    ("N", 1.0, 1.0, Dim::FORCE),
    ("mN", 1.0, 1e3, Dim::FORCE),
    ("kN", 1e3, 1.0, Dim::FORCE),
    ("MN", 1e6, 1.0, Dim::FORCE),
    ("lbf", LBF, 1e13, Dim::FORCE),
    ("kgf", 980_665.0, 1e5, Dim::FORCE),
    ("Pa", 1.0, 1.0, Dim::PRESSURE),
    ("kPa", 1e3, 1.0, Dim::PRESSURE),
    ("MPa", 1e6, 1.0, Dim::PRESSURE),
    ("GPa", 1e9, 1.0, Dim::PRESSURE),
    ("bar", 1e5, 1.0, Dim::PRESSURE),
    ("psi", LBF, 6_451_600_000.0, Dim::PRESSURE),
    ("J", 1.0, 1.0, Dim::ENERGY),
    ("mJ", 1.0, 1e3, Dim::ENERGY),
    ("kJ", 1e3, 1.0, Dim::ENERGY),
    ("W", 1.0, 1.0, Dim::POWER),
    ("kW", 1e3, 1.0, Dim::POWER),
    ("hp", LBF * 550.0 * 0.3048, 1e13, Dim::POWER),
];

#[cfg(test)]
mod tests {
    use super::*;

    fn si(value: f64, unit: &str) -> f64 {
        Unit::named(unit).unwrap().to_si(value)
    }

    #[test]
    fn conversions_agree_with_the_published_factors() {
        assert_eq!(si(350.0, "mm"), 0.35);
        assert_eq!(si(1.0, "in"), 0.0254);
        assert_eq!(si(1.0, "mi"), 1609.344);
        assert_eq!(si(1.0, "lbf"), 4.448_221_615_260_5);
        assert_eq!(si(180.0, "deg"), PI);
        // NIST SP 811, appendix B: the printed digits.
        assert!((si(1.0, "slug") / 14.593_90 - 1.0).abs() < 1e-6);
        assert!((si(1.0, "psi") / 6_894.757 - 1.0).abs() < 1e-7);
        assert!((si(1.0, "hp") / 745.699_9 - 1.0).abs() < 1e-7);
        assert!((si(1200.0, "rpm") - 40.0 * PI).abs() < 1e-13);
    }

    #[test]
    fn names_are_unique_and_factors_go_both_ways() {
        let mut names: Vec<_> = Unit::names().collect();
        names.sort_unstable();
        let count = names.len();
        names.dedup();
        assert_eq!(names.len(), count);
        for name in names {
            let unit = Unit::named(name).unwrap();
            assert!((unit.from_si(unit.to_si(3.0)) - 3.0).abs() < 1e-14);
        }
    }
}
