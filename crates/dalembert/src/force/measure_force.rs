//! Force elements along a scalar measure: springs, dampers, actuators.

use super::{ForceChannel, ForceElement, ForceReport};
use crate::joint::{Guarded, Measure, MeasureKind};
use crate::signal::Coefficient;
use crate::space::{Planar, Space, Tuple};
use smallvec::smallvec;

/// Spring-damper-actuator along a measure x (a distance, an angle, a displacement):
/// f = k (x - x0) + c x' + f_a, positive where it reduces x (tension); Q = -f dx/dq
/// (Shabana 5.61 to 5.73). An actuator alone is f_a = -(its value).
#[derive(Clone, Debug)]
pub struct MeasureForce<S: Space = Planar> {
    /// The measure.
    pub measure: Measure<S>,
    /// k.
    pub stiffness: Coefficient<S>,
    /// c.
    pub damping: Coefficient<S>,
    /// x0.
    pub free: Coefficient<S>,
    /// f_a.
    pub actuator: Coefficient<S>,
    /// Does it report its force as an actuator does (positive where it increases x)?
    pub pushes: bool,
}

impl<S: Space> MeasureForce<S> {
    fn force(&self, t: f64, markers: &[S::Marker], x: f64, rate: f64) -> f64 {
        self.stiffness.value(t, markers) * (x - self.free.value(t, markers))
            + self.damping.value(t, markers) * rate
            + self.actuator.value(t, markers)
    }

    /// Stiffness and free value where both are constant: only then is there a potential.
    fn spring(&self) -> Option<(f64, f64)> {
        Some((self.stiffness.constant()?, self.free.constant()?))
    }
}

impl<S: Space> ForceElement<S> for MeasureForce<S> {
    fn wrenches(&self, t: f64, markers: &[S::Marker], out: &mut [S::Twist]) {
        let m = self.measure.evaluate(markers);
        let f = self.force(t, markers, m.value, m.rate);
        out[self.measure.first].add_scaled(-f, &m.first);
        out[self.measure.second].add_scaled(-f, &m.second);
    }

    fn distances(&self) -> Vec<Measure<S>> {
        let distance = self.measure.kind == S::Measure::DISTANCE;
        distance.then_some(self.measure).into_iter().collect()
    }

    fn guarded(&self, markers: &[S::Marker], see: &mut dyn FnMut(Guarded)) {
        self.measure
            .guarded(markers)
            .into_iter()
            .for_each(&mut *see);
        for c in [&self.stiffness, &self.damping, &self.free, &self.actuator] {
            c.guarded(markers, see);
        }
    }

    fn pulls_at_zero(&self, t: f64, markers: &[S::Marker]) -> bool {
        self.force(t, markers, 0.0, 0.0) != 0.0
    }

    fn jump(&self) -> Option<&str> {
        [&self.stiffness, &self.damping, &self.free, &self.actuator]
            .into_iter()
            .find_map(Coefficient::jump)
    }

    fn report(&self, t: f64, markers: &[S::Marker]) -> ForceReport {
        let m = self.measure.evaluate(markers);
        let f = self.force(t, markers, m.value, m.rate);
        let (potential, potential_rate) = match self.spring() {
            Some((k, x0)) => {
                let stretch = m.value - x0;
                (0.5 * k * stretch * stretch, k * stretch * m.rate)
            }
            None => (0.0, 0.0),
        };
        let sign = if self.pushes { -1.0 } else { 1.0 };
        ForceReport {
            potential,
            potential_rate,
            values: smallvec![m.value, m.rate, sign * f, -f * m.rate],
        }
    }

    fn channels(&self) -> Vec<ForceChannel> {
        let angle = self.measure.kind.is_angle();
        let length = self.measure.kind == S::Measure::DISTANCE;
        let (name, unit, rate_unit, force_unit) = match (angle, length) {
            (true, _) => ("angle", "rad", "rad/s", "N m"),
            (false, true) => ("length", "m", "m/s", "N"),
            (false, false) => ("displacement", "m", "m/s", "N"),
        };
        let force = match (angle, self.pushes) {
            (true, false) => ("moment", "moment, positive where it reduces the angle"),
            (false, false) => ("force", "force, positive in tension"),
            (true, true) => (
                "moment",
                "moment of the actuator, positive where it increases the angle",
            ),
            (false, true) => (
                "force",
                "force of the actuator, positive where it increases the displacement",
            ),
        };
        vec![
            ForceChannel {
                suffix: name,
                unit,
                meaning: "what the element acts along",
            },
            ForceChannel {
                suffix: "rate",
                unit: rate_unit,
                meaning: "its rate of change",
            },
            ForceChannel {
                suffix: force.0,
                unit: force_unit,
                meaning: force.1,
            },
            ForceChannel {
                suffix: "power",
                unit: "W",
                meaning: "power into the machine",
            },
        ]
    }
}
