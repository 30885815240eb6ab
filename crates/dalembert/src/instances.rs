//! The analyses of both spaces, compiled once with this library.
//!
//! They are generic over the space: without this, each program and each test would compile its own copies. Unoptimized
//! builds share what is found here, which takes minutes off a build of all tests; optimized programs drop what they do
//! not call.

use crate::analysis::{
    Assembly, Dynamics, Equations, Inverse, Kinematics, Mobility, Motion, Recorder, Statics,
    conflicts, driver_singularities, holding_loads, missing_mass,
};
use crate::formulation::{Formulation, Terms};
use crate::integrate::{Integrator, Ode};
use crate::space::{Planar, Spatial};
use crate::system::compile::{ModelSpace, compile};
use crate::system::{System, Workspace};

/// Addresses of what one space's machines are run with.
fn entries<S: ModelSpace>() -> Vec<*const ()> {
    vec![
        compile::<S> as *const (),
        missing_mass::<S> as *const (),
        Assembly::run::<S> as *const (),
        Mobility::run::<S> as *const (),
        conflicts::<S> as *const (),
        driver_singularities::<S> as *const (),
        Kinematics::run::<S> as *const (),
        Inverse::run::<S> as *const (),
        Dynamics::run::<S> as *const (),
        Statics::run::<S> as *const (),
        holding_loads::<S> as *const (),
        Equations::run::<S> as *const (),
        Recorder::record::<S> as *const (),
        System::<S>::evaluate_constraints as *const (),
        System::<S>::evaluate_positions as *const (),
        Workspace::<S>::new as *const (),
        Workspace::<S>::solve as *const (),
        Motion::<S>::new as *const (),
        Motion::<S>::evaluate as *const (),
        <Motion<'_, S> as Ode>::project as *const (),
        Integrator::start::<Motion<'_, S>> as *const (),
        Integrator::step::<Motion<'_, S>> as *const (),
        Integrator::interpolate::<Motion<'_, S>> as *const (),
        Terms::of::<S> as *const (),
        Formulation::solve::<S> as *const (),
    ]
}

/// The number of functions compiled here; calling it is of no use.
#[doc(hidden)]
pub fn count() -> usize {
    entries::<Planar>().len() + entries::<Spatial>().len()
}
