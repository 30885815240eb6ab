//! Where angles start that count turns by memory.

use super::context::{Context, GlobalMeasure};
use super::geometry::Geometry;
use crate::joint::MeasureKind;
use crate::system::TurnData;
use nalgebra::Vector3;

/// Part by which the cosine of two axes may miss one for both to be the same.
const SAME_AXIS: f64 = 1e-9;

impl<S: Geometry> Context<'_, S> {
    /// Makes an angle count turns, where poses do not: from the estimate on.
    pub fn count_turns(&mut self, m: GlobalMeasure<S>) {
        let value = self.estimate(m);
        self.turns.push(TurnData {
            kind: m.kind,
            first: m.first,
            second: m.second,
        });
        self.turn_start.push(value);
    }

    /// Starts an angle that counts turns by memory on the turn that is nearest to a value.
    pub fn start_near(&mut self, m: GlobalMeasure<S>, value: f64) {
        let same = |t: &TurnData<S>| (t.first, t.second, t.kind) == (m.first, m.second, m.kind);
        if let Some(k) = self.turns.iter().position(same) {
            self.turn_start[k] = value;
            self.turns_stated.insert(k);
        }
    }

    /// Two bodies that start some turns apart do so for every angle between them about the same axis: the spring on a
    /// hinge is wound up as often as the hinge's driver says. (In the plane the bodies themselves count.)
    pub fn wind_alike(&mut self) {
        for stated in 0..self.turns.len() {
            if !self.turns_stated.contains(&stated) {
                continue;
            }
            let turns = self.turns_at_start(stated);
            for other in 0..self.turns.len() {
                if turns != 0.0
                    && !self.turns_stated.contains(&other)
                    && let Some(sign) = self.turning_alike(stated, other)
                {
                    self.turn_start[other] += sign * turns;
                }
            }
        }
    }

    /// The whole turns with which an angle starts, beyond what the pose says [rad].
    fn turns_at_start(&self, k: usize) -> f64 {
        let TurnData {
            kind,
            first,
            second,
        } = self.turns[k];
        let (a, mut b) = (self.pose(first), self.pose(second));
        let remembered = kind.value(&a, &b);
        S::set_turn(&mut b, 0.0);
        remembered - kind.value(&a, &b)
    }

    /// The sign with which a second angle changes with a first, where both are between the same bodies about the same axis.
    fn turning_alike(&self, one: usize, other: usize) -> Option<f64> {
        let [one, other] = [one, other].map(|k| &self.turns[k]);
        let bodies = |t: &TurnData<S>| [t.first, t.second].map(|m| self.markers[m].body);
        // Angles that count turns are about the z axis of their first marker.
        let axis =
            |t: &TurnData<S>| -> Vector3<f64> { S::axes(&self.pose(t.first)).column(2).into() };
        let ([a, b], found) = (bodies(one), bodies(other));
        let order = if found == [a, b] {
            1.0
        } else if found == [b, a] {
            -1.0
        } else {
            return None;
        };
        let cosine = axis(one).dot(&axis(other));
        (cosine.abs() > 1.0 - SAME_AXIS).then(|| order * cosine.signum())
    }
}
