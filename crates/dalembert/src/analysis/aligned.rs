//! Bodies of unknown orientation, turned so that the axes of their joints stand alike.

use crate::joint::{SumOfMeasures, sum_of};
use crate::space::{Space, Tuple, norm};
use crate::system::{ElementData, System, Workspace};

/// Turns of one body: the second axis of a joint turns about the first one.
const SWEEPS: usize = 4;
/// Cosine above which axes stand alike.
const ALIKE: f64 = 0.999;
/// Gradient below which axes are opposite: no turn is better than another.
const OPPOSITE: f64 = 1e-3;

/// Turns the bodies whose orientation nobody stated, from the ground and the stated ones outwards; false where nothing
/// had to turn.
///
/// Newton's method cannot do this from far: where axes are square, the equations of a joint have no slope.
pub(super) fn align<S: Space>(system: &System<S>, ws: &mut Workspace<S>, q: &mut [f64]) -> bool {
    let unknown = |b: usize| system.position_weight[b * S::NV + S::LINEAR] < 1.0;
    let mut placed: Vec<bool> = (0..system.bodies.len()).map(|b| !unknown(b)).collect();
    let mut turned = false;
    loop {
        let mut found = false;
        for e in &system.elements {
            let sums = e.element.alike();
            let Some(body) = sums
                .iter()
                .find_map(|sum| open_end(system, e, sum, &placed))
            else {
                continue;
            };
            for sum in sums {
                turned |= turn(system, ws, q, e, sum, body);
            }
            placed[body] = true;
            found = true;
        }
        if !found {
            return turned;
        }
    }
}

/// The body of a sum that is not placed yet, where all others are.
fn open_end<S: Space>(
    system: &System<S>,
    e: &ElementData<S>,
    sum: &SumOfMeasures<S>,
    placed: &[bool],
) -> Option<usize> {
    let markers = sum
        .iter()
        .flat_map(|term| [term.measure.first, term.measure.second]);
    let mut open = markers
        .filter_map(|m| system.markers[e.markers[m]].body)
        .filter(|b| !placed[*b]);
    let first = open.next()?;
    open.all(|b| b == first).then_some(first)
}

/// Turns a body until a sum of cosines is one; false where it is so already.
fn turn<S: Space>(
    system: &System<S>,
    ws: &mut Workspace<S>,
    q: &mut [f64],
    e: &ElementData<S>,
    sum: &SumOfMeasures<S>,
    body: usize,
) -> bool {
    let rest = vec![0.0; system.nv()];
    let mut turned = false;
    for _ in 0..SWEEPS {
        system.update_markers(q, &rest, ws);
        let markers = ws.seen(&e.markers);
        let value = sum_of(sum, &markers);
        if value > ALIKE {
            break;
        }
        let mut pulled = S::Twist::zero();
        for term in sum {
            let m = term.measure.evaluate(&markers);
            for (marker, gradient) in [
                (term.measure.first, m.first),
                (term.measure.second, m.second),
            ] {
                if system.markers[e.markers[marker]].body == Some(body) {
                    pulled.add_scaled(term.factor, &S::pull(&markers[marker], &gradient));
                }
            }
        }
        let slope = &pulled.as_slice()[S::LINEAR..];
        let (steep, angle) = (norm(slope), value.clamp(-1.0, 1.0).acos());
        let mut step = S::Twist::zero();
        for (k, (step, slope)) in step.as_mut_slice()[S::LINEAR..]
            .iter_mut()
            .zip(slope)
            .enumerate()
        {
            *step = if steep > OPPOSITE {
                angle * slope / steep
            } else {
                // Off the pose without a slope, about no special axis.
                0.3 + 0.1 * k as f64
            };
        }
        S::advance(&mut q[body * S::NQ..(body + 1) * S::NQ], step.as_slice());
        turned = true;
    }
    turned
}
