//! The force element that sets the fastest motion of a machine.

use crate::formulation::column_scale;
use crate::space::{Space, Tuple};
use crate::system::{ForceData, Metric, State, System, Workspace};
use smallvec::SmallVec;

/// A force element and the rate of the motion that it makes on its own.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Stiffest {
    /// "bumper (spring-damper)".
    pub element: String,
    /// Rate of decay or circular frequency [1/s].
    pub rate: f64,
    /// Is it the damping, not the stiffness?
    pub damping: bool,
}

/// Power iterations: an element along one measure needs one, a bushing a few.
const ITERATIONS: usize = 4;
/// Parts of a push along which no usual element is blind.
const PUSH: [f64; 6] = [1.0, 0.61, 0.37, 0.83, 0.47, 0.29];
/// Displacements of the differences, relative to size and radians: forces of curved laws are
/// differentiated to some six digits.
const DIFFERENCE: f64 = 1e-6;

/// Finds the element with the fastest motion of the constrained machine: the largest eigenvalue of
/// (inverse mass on the free motions) * (its stiffness), whose root is a frequency, or * (its
/// damping), by power iteration. `None` where no element has either, or masses are missing.
pub(super) fn stiffest<S: Space>(
    system: &System<S>,
    ws: &mut Workspace<S>,
    state: &State,
    metric: &mut Metric,
) -> Option<Stiffest> {
    system.update_markers(&state.q, &state.v, ws);
    system.evaluate_constraints(state.t, ws);
    metric.factor(system, ws);
    ws.rhs.fill(0.0);
    let mut probe = Probe {
        system,
        ws,
        state,
        scale: column_scale(system),
    };
    let mut best: Option<Stiffest> = None;
    for force in &system.forces {
        for damping in [false, true] {
            let Some(value) = probe.eigenvalue(force, damping) else {
                continue;
            };
            let rate = if damping { value } else { value.sqrt() };
            if rate.is_finite() && rate > best.as_ref().map_or(0.0, |b| b.rate) {
                best = Some(Stiffest {
                    element: format!("'{}' ({})", force.name, force.kind),
                    rate,
                    damping,
                });
            }
        }
    }
    best
}

/// Distance on both sides of a state at which a jump is looked for, relative to size and radians
/// (per second): a run that hangs at a jump stays much nearer to it.
const ASIDE: f64 = 1e-4;

/// Finds a force element that jumps at a state, and says so with the remedy. Its force differs on
/// the two sides of the state, and hardly less so a tenth as far away.
pub(super) fn jumping<S: Space>(
    system: &System<S>,
    ws: &mut Workspace<S>,
    state: &State,
) -> Option<String> {
    system.update_markers(&state.q, &state.v, ws);
    let probe = Probe {
        system,
        ws,
        state,
        scale: column_scale(system),
    };
    system.forces.iter().find_map(|force| {
        let place = force.element.jump()?;
        probe.jumps(force).then(|| {
            let remedy = if place.starts_with("sign") {
                "replace sign(x) by tanh(x / eps) with a small eps"
            } else {
                "let it change steadily, as blend(x, x0, x1) or tanh(x / eps) do"
            };
            format!(
                "the force '{}' jumps ({place}): the machine is driven back to the jump from both sides, and the run cannot go on; {remedy}",
                force.name
            )
        })
    })
}

struct Probe<'a, S: Space> {
    system: &'a System<S>,
    ws: &'a mut Workspace<S>,
    state: &'a State,
    scale: Vec<f64>,
}

impl<S: Space> Probe<'_, S> {
    /// Does a force differ on two sides of the state, however near these are?
    fn jumps(&self, force: &ForceData<S>) -> bool {
        let bodies = force.markers.iter();
        let bodies = bodies.filter_map(|&m| self.system.markers[m].body);
        bodies.flat_map(|b| b * S::NV..(b + 1) * S::NV).any(|k| {
            let mut direction = vec![0.0; self.system.nv()];
            direction[k] = self.scale[k];
            [true, false].into_iter().any(|damping| {
                let difference = |step: f64| {
                    let ahead = self.wrenches(force, &direction, step, damping);
                    let behind = self.wrenches(force, &direction, -step, damping);
                    let pairs = ahead.iter().zip(&behind);
                    let most = ahead
                        .iter()
                        .chain(&behind)
                        .fold(0.0_f64, |m, x| m.max(x.abs()));
                    (pairs.fold(0.0_f64, |m, (a, b)| m.max((a - b).abs())), most)
                };
                let (far, most) = difference(ASIDE);
                let (near, _) = difference(0.1 * ASIDE);
                far > 1e-3 * most && near > 0.5 * far
            })
        })
    }

    /// Largest eigenvalue, in size, that a force element gives the machine.
    fn eigenvalue(&mut self, force: &ForceData<S>, damping: bool) -> Option<f64> {
        // A first push with parts along everything that the element can feel.
        let mut push = vec![0.0; self.system.nv()];
        for (k, &m) in force.markers.iter().enumerate() {
            if let Some(b) = self.system.markers[m].body {
                for (i, part) in PUSH.into_iter().take(S::NV).enumerate() {
                    let at = b * S::NV + i;
                    push[at] = part * (1.0 + k as f64) / self.scale[at];
                }
            }
        }
        let mut value = 0.0;
        for iteration in 0..=ITERATIONS {
            if !self.ws.solve(&self.system.mass, &push).converged {
                return None;
            }
            let size = self.ws.a.iter().zip(&self.scale);
            let size = size.fold(0.0_f64, |m, (x, s)| m.max((x / s).abs()));
            if size.is_nan() || size <= 0.0 {
                return None;
            }
            if iteration > 0 {
                value = size;
            }
            let direction: Vec<f64> = self.ws.a.iter().map(|x| x / size).collect();
            let ahead = self.wrenches(force, &direction, DIFFERENCE, damping);
            let behind = self.wrenches(force, &direction, -DIFFERENCE, damping);
            push.fill(0.0);
            for (x, (a, b)) in push.iter_mut().zip(ahead.iter().zip(&behind)) {
                *x = (a - b) / (2.0 * DIFFERENCE);
            }
        }
        Some(value)
    }

    /// Generalized force of an element at a state moved along a direction.
    fn wrenches(
        &self,
        force: &ForceData<S>,
        direction: &[f64],
        step: f64,
        damping: bool,
    ) -> Vec<f64> {
        let system = self.system;
        let moved: Vec<S::Marker> = force
            .markers
            .iter()
            .map(|&m| {
                let data = &system.markers[m];
                let Some(b) = data.body else {
                    return self.ws.markers[m];
                };
                let own = b * S::NV..(b + 1) * S::NV;
                let mut move_by = S::Twist::zero();
                for (x, d) in move_by
                    .as_mut_slice()
                    .iter_mut()
                    .zip(&direction[own.clone()])
                {
                    *x = step * d;
                }
                let mut v = S::Twist::of(&self.state.v[own]);
                let mut q: SmallVec<[f64; 7]> =
                    SmallVec::from_slice(&self.state.q[b * S::NQ..(b + 1) * S::NQ]);
                if damping {
                    v.add_scaled(1.0, &move_by);
                } else {
                    S::advance(&mut q, move_by.as_slice());
                }
                let mut marker = S::marker(&data.frame, &S::pose(&q), v.as_slice());
                S::set_turn(&mut marker, S::turn(&self.ws.markers[m]));
                marker
            })
            .collect();
        let mut wrenches = vec![S::Twist::zero(); moved.len()];
        force.element.wrenches(self.state.t, &moved, &mut wrenches);
        let mut out = vec![0.0; system.nv()];
        for ((&m, marker), wrench) in force.markers.iter().zip(&moved).zip(&wrenches) {
            if let Some(b) = system.markers[m].body {
                let pulled = S::pull(marker, wrench);
                for (x, p) in out[b * S::NV..].iter_mut().zip(pulled.as_slice()) {
                    *x += p;
                }
            }
        }
        out
    }
}
