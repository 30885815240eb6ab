//! Energies, Lagrangian and Hamiltonian.

use super::coordinates::CoordinateTerms;
use super::report::Scalars;
use crate::space::Space;
use crate::system::{System, Workspace};
use nalgebra::{DMatrix, DVector};

/// v = B u + g with its momenta.
pub(super) struct Velocities<'a> {
    pub b: &'a DMatrix<f64>,
    pub u: &'a DVector<f64>,
    pub g: &'a DVector<f64>,
    /// dT/du.
    pub p: &'a DVector<f64>,
}

/// T, V, L and H = p . u - L; T split by degree in u: T2 = u.Mbar u/2, T1 = u.B^T M g, T0 = g.M g/2.
///
/// H = T2 - T0 + V: it is T + V only where the kinematics does not depend on time (Shabana 5.165 to 5.182).
pub(super) fn scalars<S: Space>(
    system: &System<S>,
    ws: &Workspace<S>,
    t: f64,
    at: &CoordinateTerms,
    independent: Option<&Velocities<'_>>,
    acceleration: Option<&[f64]>,
) -> Scalars {
    let mass = &at.terms.mass;
    let v = &at.velocities;
    let kinetic = 0.5 * v.dot(&(mass * v));
    let potential = potential(system, ws, t);
    let lagrangian = kinetic - potential;
    let mut found = Scalars {
        kinetic,
        potential,
        lagrangian,
        hamiltonian: 2.0 * kinetic - lagrangian,
        energy: kinetic + potential,
        gibbs_appel: acceleration.map(|a| at.gibbs_appel(system, a)),
        ..Scalars::default()
    };
    if let Some(x) = independent {
        let moving = x.b * x.u;
        found.kinetic_2 = Some(0.5 * moving.dot(&(mass * &moving)));
        found.kinetic_1 = Some(moving.dot(&(mass * x.g)));
        found.kinetic_0 = Some(0.5 * x.g.dot(&(mass * x.g)));
        found.hamiltonian = x.p.dot(x.u) - lagrangian;
    }
    found
}

/// Potential energy of gravity (zero at the height of the ground's origin) and of the force elements.
fn potential<S: Space>(system: &System<S>, ws: &Workspace<S>, t: f64) -> f64 {
    let mut sum = 0.0;
    for (b, body) in system.bodies.iter().enumerate() {
        let point = S::point(&ws.markers[body.center_marker]);
        let weight = &system.weight[S::NV * b..][..S::LINEAR];
        sum -= weight.iter().zip(point).map(|(w, x)| w * x).sum::<f64>();
    }
    for f in &system.forces {
        let markers: Vec<S::Marker> = f.markers.iter().map(|&m| ws.markers[m]).collect();
        sum += f.element.report(t, &markers).potential;
    }
    sum
}
