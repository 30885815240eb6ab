//! Physical dimensions.

use std::fmt;
use std::ops::{Div, Mul};

/// A physical dimension: powers of length, mass and time.
///
/// Angles are plain numbers. Twice the exponents are stored, so that square roots have one too.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Dim {
    length: i16,
    mass: i16,
    time: i16,
}

/// Largest magnitude of twice an exponent that an expression may have.
const LIMIT: i16 = 128;

impl Dim {
    /// A plain number or an angle.
    pub const NONE: Self = Self::new(0, 0, 0);
    /// Length, m.
    pub const LENGTH: Self = Self::new(1, 0, 0);
    /// Area, m^2.
    pub const AREA: Self = Self::new(2, 0, 0);
    /// Volume, m^3.
    pub const VOLUME: Self = Self::new(3, 0, 0);
    /// Mass, kg.
    pub const MASS: Self = Self::new(0, 1, 0);
    /// Time, s.
    pub const TIME: Self = Self::new(0, 0, 1);
    /// Velocity, m/s.
    pub const VELOCITY: Self = Self::new(1, 0, -1);
    /// Acceleration, m/s^2.
    pub const ACCELERATION: Self = Self::new(1, 0, -2);
    /// Angular velocity, rad/s; the same as a frequency.
    pub const ANGULAR_VELOCITY: Self = Self::new(0, 0, -1);
    /// Angular acceleration, rad/s^2.
    pub const ANGULAR_ACCELERATION: Self = Self::new(0, 0, -2);
    /// Frequency, 1/s.
    pub const FREQUENCY: Self = Self::ANGULAR_VELOCITY;
    /// Force, N.
    pub const FORCE: Self = Self::new(1, 1, -2);
    /// Moment of a force, N m; the same as an energy.
    pub const MOMENT: Self = Self::new(2, 1, -2);
    /// Energy, J.
    pub const ENERGY: Self = Self::MOMENT;
    /// Power, W.
    pub const POWER: Self = Self::new(2, 1, -3);
    /// Pressure or stress, Pa.
    pub const PRESSURE: Self = Self::new(-1, 1, -2);
    /// Moment of inertia, kg m^2.
    pub const INERTIA: Self = Self::new(2, 1, 0);
    /// Density, kg/m^3.
    pub const DENSITY: Self = Self::new(-3, 1, 0);
    /// Mass per area, kg/m^2.
    pub const AREA_DENSITY: Self = Self::new(-2, 1, 0);
    /// Stiffness of a spring, N/m.
    pub const STIFFNESS: Self = Self::new(0, 1, -2);
    /// Coefficient of a damper, N s/m.
    pub const DAMPING: Self = Self::new(0, 1, -1);
    /// Stiffness of a torsion spring, N m/rad; the same as a moment.
    pub const ANGULAR_STIFFNESS: Self = Self::MOMENT;
    /// Coefficient of a rotary damper, N m s/rad.
    pub const ANGULAR_DAMPING: Self = Self::new(2, 1, -1);
    /// Momentum, N s.
    pub const MOMENTUM: Self = Self::new(1, 1, -1);

    /// The dimension m^length kg^mass s^time.
    pub const fn new(length: i8, mass: i8, time: i8) -> Self {
        Self {
            length: 2 * length as i16,
            mass: 2 * mass as i16,
            time: 2 * time as i16,
        }
    }

    /// Is it a plain number or an angle?
    pub const fn is_none(self) -> bool {
        self.length == 0 && self.mass == 0 && self.time == 0
    }

    /// The dimension of a product.
    #[must_use]
    pub const fn times(self, other: Self) -> Self {
        Self {
            length: self.length.saturating_add(other.length),
            mass: self.mass.saturating_add(other.mass),
            time: self.time.saturating_add(other.time),
        }
    }

    /// The dimension of a quotient.
    #[must_use]
    pub const fn over(self, other: Self) -> Self {
        Self {
            length: self.length.saturating_sub(other.length),
            mass: self.mass.saturating_sub(other.mass),
            time: self.time.saturating_sub(other.time),
        }
    }

    /// The dimension of an integer power.
    #[must_use]
    pub const fn pow(self, exponent: i8) -> Self {
        let n = exponent as i16;
        Self {
            length: self.length.saturating_mul(n),
            mass: self.mass.saturating_mul(n),
            time: self.time.saturating_mul(n),
        }
    }

    /// The dimension of any power, where all its exponents are whole or half numbers.
    pub fn power(self, exponent: f64) -> Option<Self> {
        let scale = |twice: i16| -> Option<i16> {
            let scaled = f64::from(twice) * exponent;
            (scaled.fract() == 0.0 && scaled.abs() <= f64::from(LIMIT)).then_some(scaled as i16)
        };
        Some(Self {
            length: scale(self.length)?,
            mass: scale(self.mass)?,
            time: scale(self.time)?,
        })
    }

    /// The dimension of a square root, where all its exponents are whole or half numbers.
    pub fn sqrt(self) -> Option<Self> {
        self.power(0.5)
    }

    /// Are all exponents small enough to be meant?
    pub(crate) fn is_moderate(self) -> bool {
        [self.length, self.mass, self.time]
            .iter()
            .all(|twice| twice.unsigned_abs() <= LIMIT.unsigned_abs())
    }

    /// The dimension in words, for messages: "a length (m)", "an angle or plain number".
    pub fn describe(self) -> String {
        const NAMES: &[(Dim, &str)] = &[
            (Dim::LENGTH, "a length"),
            (Dim::AREA, "an area"),
            (Dim::VOLUME, "a volume"),
            (Dim::MASS, "a mass"),
            (Dim::TIME, "a time"),
            (Dim::VELOCITY, "a velocity"),
            (Dim::ACCELERATION, "an acceleration"),
            (Dim::ANGULAR_VELOCITY, "an angular velocity or frequency"),
            (Dim::ANGULAR_ACCELERATION, "an angular acceleration"),
            (Dim::FORCE, "a force"),
            (Dim::MOMENT, "a moment or energy"),
            (Dim::POWER, "a power"),
            (Dim::PRESSURE, "a pressure"),
            (Dim::INERTIA, "a moment of inertia"),
            (Dim::DENSITY, "a density"),
            (Dim::STIFFNESS, "a stiffness"),
            (Dim::DAMPING, "a damping coefficient"),
        ];
        if self.is_none() {
            return "an angle or plain number".to_owned();
        }
        let name = NAMES.iter().find(|(dim, _)| *dim == self);
        format!("{} ({self})", name.map_or("a quantity", |(_, name)| name))
    }
}

impl Mul for Dim {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.times(other)
    }
}

impl Div for Dim {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self.over(other)
    }
}

impl fmt::Display for Dim {
    /// Prints the SI unit: "N m", "kg m^2", "m/s"; "1" for a plain number.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const DERIVED: &[(Dim, &str)] = &[
            (Dim::FORCE, "N"),
            (Dim::MOMENT, "N m"),
            (Dim::POWER, "W"),
            (Dim::PRESSURE, "Pa"),
            (Dim::STIFFNESS, "N/m"),
            (Dim::DAMPING, "N s/m"),
            (Dim::ANGULAR_DAMPING, "N m s"),
            (Dim::MOMENTUM, "N s"),
        ];
        if let Some((_, unit)) = DERIVED.iter().find(|(dim, _)| dim == self) {
            return f.pad(unit);
        }
        let factors = [("kg", self.mass), ("m", self.length), ("s", self.time)];
        let side = |sign: i16| -> Vec<String> {
            factors
                .iter()
                .filter(|(_, twice)| twice.signum() == sign)
                .map(|(unit, twice)| match twice.unsigned_abs() {
                    2 => (*unit).to_owned(),
                    n if n % 2 == 0 => format!("{unit}^{}", n / 2),
                    n => format!("{unit}^({n}/2)"),
                })
                .collect()
        };
        let (above, below) = (side(1), side(-1));
        let numerator = if above.is_empty() {
            "1".to_owned()
        } else {
            above.join(" ")
        };
        f.pad(&match below.as_slice() {
            [] => numerator,
            [one] => format!("{numerator}/{one}"),
            many => format!("{numerator}/({})", many.join(" ")),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_and_powers_are_exact() {
        assert_eq!(Dim::MASS * Dim::ACCELERATION, Dim::FORCE);
        assert_eq!(Dim::FORCE / Dim::LENGTH, Dim::STIFFNESS);
        assert_eq!(Dim::LENGTH.pow(2), Dim::AREA);
        assert_eq!(Dim::STIFFNESS.over(Dim::MASS).sqrt(), Some(Dim::FREQUENCY));
        let half = Dim::LENGTH.sqrt().unwrap();
        assert_eq!(half * half, Dim::LENGTH);
        assert_eq!(half.sqrt(), None);
        assert_eq!(Dim::LENGTH.power(1e300), None);
    }

    #[test]
    fn units_read_as_an_engineer_writes_them() {
        let shown = |dim: Dim| dim.to_string();
        assert_eq!(shown(Dim::NONE), "1");
        assert_eq!(shown(Dim::MOMENT), "N m");
        assert_eq!(shown(Dim::INERTIA), "kg m^2");
        assert_eq!(shown(Dim::VELOCITY), "m/s");
        assert_eq!(shown(Dim::FREQUENCY), "1/s");
        assert_eq!(shown(Dim::LENGTH.sqrt().unwrap()), "m^(1/2)");
        assert_eq!(shown(Dim::new(-1, 1, -1)), "kg/(m s)");
        assert_eq!(Dim::LENGTH.describe(), "a length (m)");
        assert_eq!(Dim::NONE.describe(), "an angle or plain number");
    }
}
