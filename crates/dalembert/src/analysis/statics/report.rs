//! What the static analysis found.

use super::stability::Stability;
use crate::results::Results;
use crate::system::State;
use serde::{Deserialize, Serialize};

/// One pose at which all forces balance.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Equilibrium {
    /// Positions: centre of mass and angle (in space: Euler parameters) of each body, then auxiliary coordinates.
    pub q: Vec<f64>,
    /// Multipliers of the constraint rows: C_q^T lambda = Q_e, the least ones where they are not unique.
    pub multipliers: Vec<f64>,
    /// Does it return after a push?
    pub stability: Stability,
    /// Eigenvalues of the symmetric part of the reduced stiffness, ascending [J]: lengths count in
    /// units of the machine's size, angles in radians.
    pub stiffness: Vec<f64>,
    /// Is the reduced stiffness symmetric? Otherwise some forces have no potential, and an
    /// equilibrium that the stiffness calls stable may still flutter.
    pub conservative: bool,
    /// Neutral and unstable motions in words.
    pub motions: Vec<String>,
    /// Potential energy of weights and force elements [J].
    pub potential: f64,
    /// Distance from the assembled estimate: largest displacement relative to the machine's size, or
    /// turn [rad].
    pub distance: f64,
    /// Newton iterations that led here.
    pub iterations: usize,
    /// Largest unbalanced force in the free motions relative to the largest force.
    pub residual: f64,
}

/// What the static analysis found.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct StaticsReport {
    /// Time at which the drivers are frozen [s].
    pub time: f64,
    /// The equilibria: the estimate itself first where it is one, then the stable, the neutral and
    /// the unstable ones, each kind by its distance from the estimate.
    pub equilibria: Vec<Equilibrium>,
    /// Number of velocity coordinates.
    pub velocities: usize,
    /// Number of independent free motions at the estimate.
    pub freedoms: usize,
    /// Poses from which the search was started.
    pub starts: usize,
    /// All coordinates, reactions and forces: one instant for each equilibrium.
    pub results: Results,
}

impl StaticsReport {
    /// The first equilibrium: the analysis fails where there is none.
    pub fn first(&self) -> Option<&Equilibrium> {
        self.equilibria.first()
    }

    /// The state of an equilibrium: at rest.
    pub fn state(&self, number: usize) -> Option<State> {
        self.equilibria.get(number).map(|e| State {
            t: self.time,
            q: e.q.clone(),
            v: vec![0.0; self.velocities],
        })
    }
}
