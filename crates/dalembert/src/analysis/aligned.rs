//! Bodies of unknown orientation, turned so that the axes of their joints stand alike.

use crate::joint::{Measure, Measured};
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
            for m in e.element.alike() {
                let Some((body, second)) = open_end(system, e, m, &placed) else {
                    continue;
                };
                for m in e.element.alike() {
                    turned |= turn(system, ws, q, e, m, (body, second));
                }
                placed[body] = true;
                found = true;
            }
        }
        if !found {
            return turned;
        }
    }
}

/// The body of a measure that is not placed yet, where the other one is; and whether it is the second one.
fn open_end<S: Space>(
    system: &System<S>,
    e: &ElementData<S>,
    m: &Measure<S>,
    placed: &[bool],
) -> Option<(usize, bool)> {
    let body = |marker: usize| system.markers[e.markers[marker]].body;
    let open = |b: Option<usize>| b.filter(|b| !placed[*b]);
    match (open(body(m.first)), open(body(m.second))) {
        (None, Some(b)) => Some((b, true)),
        (Some(b), None) => Some((b, false)),
        _ => None,
    }
}

/// Turns a body until a cosine is one; false where it is so already.
fn turn<S: Space>(
    system: &System<S>,
    ws: &mut Workspace<S>,
    q: &mut [f64],
    e: &ElementData<S>,
    m: &Measure<S>,
    (body, second): (usize, bool),
) -> bool {
    let rest = vec![0.0; system.nv()];
    let mut turned = false;
    for _ in 0..SWEEPS {
        system.update_markers(q, &rest, ws);
        let markers = ws.seen(&e.markers);
        let Measured {
            value,
            first,
            second: last,
            ..
        } = m.evaluate(&markers);
        if value > ALIKE {
            break;
        }
        let pulled = if second {
            S::pull(&markers[m.second], &last)
        } else {
            S::pull(&markers[m.first], &first)
        };
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
