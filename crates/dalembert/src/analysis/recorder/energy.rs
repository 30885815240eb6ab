//! Energy, momentum and power of a machine.

use crate::space::{Space, Tuple, spread};
use crate::system::{System, Workspace};
use nalgebra::Vector3;

/// Kinetic energy and potential energy of gravity (zero at the ground's origin).
pub(in crate::analysis) fn energies<S: Space>(
    system: &System<S>,
    ws: &Workspace<S>,
    v: &[f64],
) -> (f64, f64) {
    let (mut kinetic, mut gravity) = (0.0, 0.0);
    for (b, body) in system.bodies.iter().enumerate() {
        let own = b * S::NV..(b + 1) * S::NV;
        kinetic += 0.5 * body_momentum(system, b, v).dot(&S::Twist::of(&v[own.clone()]));
        let point = S::point(&ws.markers[body.center_marker]);
        let weight = &system.weight[own];
        for (w, x) in weight[..S::LINEAR].iter().zip(point) {
            gravity -= w * x;
        }
    }
    (kinetic, gravity)
}

/// M v of a body, in its velocity coordinates.
fn body_momentum<S: Space>(system: &System<S>, body: usize, v: &[f64]) -> S::Twist {
    let n = S::NV;
    let mut momentum = S::Twist::zero();
    let v = &v[body * n..(body + 1) * n];
    for (h, row) in momentum
        .as_mut_slice()
        .iter_mut()
        .zip(system.mass_block(body).chunks_exact(n))
    {
        *h = row.iter().zip(v).map(|(m, v)| m * v).sum();
    }
    momentum
}

/// Linear momentum of a body and angular momentum about a point, in ground axes.
pub(super) fn momentum<S: Space>(
    system: &System<S>,
    ws: &Workspace<S>,
    v: &[f64],
    body: usize,
    about: &Vector3<f64>,
) -> [Vector3<f64>; 2] {
    let own = body_momentum(system, body, v);
    let center = &ws.markers[system.bodies[body].center_marker];
    let [linear, angular] = spread::<S>(&S::at_origin(center, &own));
    [linear, angular - about.cross(&linear)]
}

/// Power that the constraint of a driver gives to the machine: lambda . C_t, since C_q v = -C_t.
pub(in crate::analysis) fn driver_power<S: Space>(
    ws: &Workspace<S>,
    rows: std::ops::Range<usize>,
) -> f64 {
    rows.map(|r| ws.lambda[r] * ws.time[r]).sum()
}

/// Power of drivers and of forces without potential.
pub(in crate::analysis) fn outside_power<S: Space>(
    system: &System<S>,
    ws: &mut Workspace<S>,
    t: f64,
) -> f64 {
    let mut power = system.force_power(t, ws);
    for e in system.drivers() {
        power += driver_power(ws, e.rows.clone());
    }
    power
}
