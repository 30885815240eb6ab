//! Accelerations and reactions at markers.

use crate::space::{Planar, PlanarMarker, Space, Tuple};
use crate::system::{System, Workspace};
use nalgebra::Vector3;

/// Acceleration of a marker: (point, angular), ground axes.
pub(in crate::analysis) fn acceleration(
    system: &System<Planar>,
    ws: &Workspace<Planar>,
    marker: usize,
) -> Vector3<f64> {
    match system.markers[marker].body {
        None => Vector3::zeros(),
        Some(b) => {
            let a = Vector3::new(ws.a[3 * b], ws.a[3 * b + 1], ws.a[3 * b + 2]);
            let m = &ws.markers[marker];
            Planar::push(m, &a) + Planar::bias(m)
        }
    }
}

/// Wrench that an element exerts on the body of one of its markers, at that marker's point, ground
/// axes: the generalized force -C_q^T lambda carried to the point (Shabana 6.147).
pub(in crate::analysis) fn reaction(
    system: &System<Planar>,
    ws: &Workspace<Planar>,
    number: usize,
    local: usize,
    t: f64,
    scratch: &mut Vec<f64>,
) -> Vector3<f64> {
    let e = &system.elements[number];
    // The gradients of the rows by the marker's twist are evaluated again: the stored Jacobian has
    // them already carried to the bodies and summed.
    let markers: Vec<PlanarMarker> = e.markers.iter().map(|&m| ws.markers[m]).collect();
    let (nr, nm, na) = (e.rows.len(), markers.len(), e.aux.len());
    scratch.clear();
    scratch.resize(3 * nr + nr * na, 0.0);
    let (value, rest) = scratch.split_at_mut(nr);
    let (time, rest) = rest.split_at_mut(nr);
    let (bias, auxiliary) = rest.split_at_mut(nr);
    let mut gradient = vec![Vector3::zeros(); nr * nm];
    e.element.evaluate(
        &crate::joint::ConstraintInput {
            t,
            markers: &markers,
            s: &ws.s[e.aux.clone()],
            s_rate: &ws.s_rate[e.aux.clone()],
        },
        &mut crate::joint::ConstraintOutput {
            value,
            gradient: &mut gradient,
            auxiliary,
            time,
            bias,
        },
    );
    let mut wrench = Vector3::zeros();
    for (r, row) in e.rows.clone().enumerate() {
        wrench.add_scaled(-ws.lambda[row], &gradient[r * nm + local]);
    }
    wrench
}
