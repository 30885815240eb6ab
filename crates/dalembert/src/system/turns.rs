//! Angles of joints that count turns, where poses do not.

use super::{System, Workspace};
use crate::joint::MeasureKind;
use crate::space::{Space, Tuple};

/// An angle between two markers that counts turns in a space whose poses do not.
///
/// A machine remembers the angle itself, last among its positions: the measure is then taken on the turn that is nearest
/// to what is remembered, and whatever moves the positions brings the memory up to date. No angle changes by half a turn
/// in one step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TurnData<S: Space> {
    /// The angle.
    pub kind: S::Measure,
    /// First marker, number in the system.
    pub first: usize,
    /// Second marker, number in the system: it carries the memory, for no other angle.
    pub second: usize,
}

impl<S: Space> System<S> {
    /// Place of the remembered angles among the positions.
    pub(super) fn turns_at(&self) -> usize {
        self.bodies.len() * S::NQ + self.aux
    }

    /// Hands the remembered angles to their markers.
    pub(super) fn set_turns(&self, q: &[f64], ws: &mut Workspace<S>) {
        for (turn, remembered) in self.turns.iter().zip(&q[self.turns_at()..]) {
            S::set_turn(&mut ws.markers[turn.second], *remembered);
        }
    }

    /// Brings the remembered angles up to date with the poses.
    pub(super) fn count_turns(&self, q: &mut [f64]) {
        let (poses, remembered) = q.split_at_mut(self.turns_at());
        let still = S::Twist::default();
        let at = |m: usize| {
            let data = &self.markers[m];
            match data.body {
                None => S::ground_marker(&data.frame),
                Some(b) => {
                    let pose = S::pose(&poses[b * S::NQ..(b + 1) * S::NQ]);
                    S::marker(&data.frame, &pose, still.as_slice())
                }
            }
        };
        for (turn, remembered) in self.turns.iter().zip(remembered) {
            let (first, mut second) = (at(turn.first), at(turn.second));
            S::set_turn(&mut second, *remembered);
            *remembered = turn.kind.value(&first, &second);
        }
    }
}
