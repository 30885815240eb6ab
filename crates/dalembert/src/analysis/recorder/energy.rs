//! Energy, momentum and power of a machine.

use crate::space::{Planar, PlanarMarker, Space};
use crate::system::{Role, System, Workspace};
use nalgebra::Vector3;

/// Kinetic energy and potential energy of gravity (zero at the ground's origin).
pub(in crate::analysis) fn energies(
    system: &System<Planar>,
    ws: &Workspace<Planar>,
    v: &[f64],
) -> (f64, f64) {
    let (mut kinetic, mut gravity) = (0.0, 0.0);
    for (b, body) in system.bodies.iter().enumerate() {
        let m = &system.mass[9 * b..9 * b + 9];
        let v = &v[3 * b..3 * b + 3];
        kinetic += 0.5 * (m[0] * (v[0] * v[0] + v[1] * v[1]) + m[8] * v[2] * v[2]);
        let p = ws.markers[body.center_marker].point;
        gravity -= system.weight[3 * b] * p.x + system.weight[3 * b + 1] * p.y;
    }
    (kinetic, gravity)
}

/// Linear momentum and angular momentum about the origin.
pub(super) fn momentum(system: &System<Planar>, ws: &Workspace<Planar>, v: &[f64]) -> Vector3<f64> {
    let mut sum = Vector3::zeros();
    for (b, body) in system.bodies.iter().enumerate() {
        let (m, j) = (system.mass[9 * b], system.mass[9 * b + 8]);
        let p = ws.markers[body.center_marker].point;
        let (px, py) = (m * v[3 * b], m * v[3 * b + 1]);
        sum += Vector3::new(px, py, p.x * py - p.y * px + j * v[3 * b + 2]);
    }
    sum
}

/// Power that the constraint of a driver gives to the machine: lambda . C_t, since C_q v = -C_t.
pub(in crate::analysis) fn driver_power(
    ws: &Workspace<Planar>,
    rows: std::ops::Range<usize>,
) -> f64 {
    rows.map(|r| ws.lambda[r] * ws.time[r]).sum()
}

/// Power of drivers and of forces without potential.
pub(in crate::analysis) fn outside_power(
    system: &System<Planar>,
    ws: &Workspace<Planar>,
    t: f64,
) -> f64 {
    let mut power = 0.0;
    for e in &system.elements {
        if e.role == Role::Driver {
            power += driver_power(ws, e.rows.clone());
        }
    }
    let mut markers = [PlanarMarker::default(); MOST_MARKERS];
    let mut wrenches = [Vector3::zeros(); MOST_MARKERS];
    for f in &system.forces {
        let n = f.markers.len();
        for (slot, &m) in markers.iter_mut().zip(&f.markers) {
            *slot = ws.markers[m];
        }
        wrenches[..n].fill(Vector3::zeros());
        f.element.wrenches(t, &markers[..n], &mut wrenches[..n]);
        power += f.element.report(t, &markers[..n]).potential_rate;
        for (w, m) in wrenches[..n].iter().zip(&markers[..n]) {
            power += w.dot(&Planar::twist(m));
        }
    }
    power
}

/// Most markers of one force element: two of its own and two for each input of its expressions.
const MOST_MARKERS: usize = 2 + 8 * crate::signal::MAX_INPUTS;
