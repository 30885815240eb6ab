//! Accelerations and reactions at markers.

use crate::joint::{ConstraintInput, ConstraintOutput};
use crate::space::{Space, Tuple};
use crate::system::{System, Workspace};

/// Acceleration of a marker: (point, angular), ground axes.
pub(in crate::analysis) fn acceleration<S: Space>(
    system: &System<S>,
    ws: &Workspace<S>,
    marker: usize,
) -> S::Twist {
    match system.markers[marker].body {
        None => S::Twist::zero(),
        Some(b) => {
            let a = S::Twist::of(&ws.a[b * S::NV..(b + 1) * S::NV]);
            let m = &ws.markers[marker];
            let mut acceleration = S::push(m, &a);
            acceleration.add_scaled(1.0, &S::bias(m));
            acceleration
        }
    }
}

/// Wrench that an element exerts on the body of one of its markers, at that marker's point, ground
/// axes: the generalized force -C_q^T lambda carried to the point (Shabana 6.147).
pub(in crate::analysis) fn reaction<S: Space>(
    system: &System<S>,
    ws: &Workspace<S>,
    number: usize,
    local: usize,
    t: f64,
    scratch: &mut Vec<f64>,
) -> S::Twist {
    let e = &system.elements[number];
    // The gradients of the rows by the marker's twist are evaluated again: the stored Jacobian has
    // them already carried to the bodies and summed.
    let markers = ws.seen(&e.markers);
    let (nr, nm, na) = (e.rows.len(), markers.len(), e.aux.len());
    scratch.clear();
    scratch.resize(3 * nr + nr * na, 0.0);
    let (value, rest) = scratch.split_at_mut(nr);
    let (time, rest) = rest.split_at_mut(nr);
    let (bias, auxiliary) = rest.split_at_mut(nr);
    let mut gradient = vec![S::Twist::zero(); nr * nm];
    e.element.evaluate(
        &ConstraintInput {
            t,
            markers: &markers,
            s: &ws.s[e.aux.clone()],
            s_rate: &ws.s_rate[e.aux.clone()],
        },
        &mut ConstraintOutput {
            value,
            gradient: &mut gradient,
            auxiliary,
            time,
            bias,
        },
    );
    let mut wrench = S::Twist::zero();
    for (r, row) in e.rows.clone().enumerate() {
        wrench.add_scaled(-ws.lambda[row], &gradient[r * nm + local]);
    }
    wrench
}
