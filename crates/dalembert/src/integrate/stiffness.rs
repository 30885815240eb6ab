//! Is the step of an explicit method held down by stability instead of accuracy?

/// Boundary of the stability region of the method of Dormand and Prince on the negative real axis.
const BOUNDARY: f64 = 3.25;
/// Steps at the boundary after which the equation counts as stiff.
const MANY: usize = 15;
/// Steps away from the boundary, one after another, after which it does not any more.
const FEW: usize = 6;

/// Counts accepted steps at the boundary of stability (Hairer, Wanner, *Solving Ordinary
/// Differential Equations II*, IV.2): there h times the largest rate of the equation, estimated from
/// the last two stages, stays at the edge of the stability region.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stiffness {
    /// Estimate of the largest rate of the equation at the last step [1/s].
    pub rate: f64,
    /// Time from which on the equation was found stiff for the first time [s].
    pub since: Option<f64>,
    /// Steps at the boundary since the equation last was not stiff.
    pub streak: usize,
    /// All steps at the boundary while the equation was stiff.
    pub steps: usize,
    away: usize,
}

impl Stiffness {
    /// Takes up an accepted step from time `t` of length `h` with the estimate of the largest rate.
    pub fn step(&mut self, t: f64, h: f64, rate: f64) {
        self.rate = rate;
        if h * rate > BOUNDARY {
            self.away = 0;
            self.streak += 1;
            if self.streak == MANY {
                self.since.get_or_insert(t);
                self.steps += MANY;
            } else if self.streak > MANY {
                self.steps += 1;
            }
        } else {
            self.away += 1;
            if self.away == FEW {
                self.streak = 0;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_few_steps_at_the_boundary_are_no_stiffness() {
        let mut test = Stiffness::default();
        for round in 0..10 {
            for k in 0..10 {
                test.step(f64::from(round * 20 + k), 1.0, 3.3);
            }
            for k in 10..16 {
                test.step(f64::from(round * 20 + k), 1.0, 1.0);
            }
        }
        assert_eq!((test.since, test.steps), (None, 0));
    }

    #[test]
    fn many_steps_are() {
        let mut test = Stiffness::default();
        for k in 0..100 {
            // Every third step is a little shorter.
            test.step(f64::from(k), if k % 3 == 0 { 0.9 } else { 1.0 }, 3.4);
        }
        assert_eq!(test.since, Some(22.0));
        assert_eq!(test.streak, 66);
        assert_eq!(test.steps, 66);
    }
}
