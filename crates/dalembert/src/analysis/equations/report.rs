//! The equations of motion at a state, with names on everything.

use super::{EquationBasis, LabelledMatrix, LabelledVector, ReferenceFrame};
use serde::Serialize;

/// The equations of motion M a + C_q^T lambda = Q_e + Q_v, C_q a = Q_d at a state.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct EquationsReport {
    /// Name of the model.
    pub model: String,
    /// Time [s].
    pub time: f64,
    /// Whose reference points the coordinates are.
    pub frame: ReferenceFrame,
    /// The set of the orientation coordinates, where one was asked for: q then has its numbers, v the rates of q, and
    /// conditions among them are further rows.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub orientation: Option<String>,
    /// q: positions of the reference points, angles (in space: Euler parameters), auxiliary coordinates.
    pub positions: LabelledVector,
    /// v: velocities of the reference points in ground axes, angular velocities (in space: in the axes of the body frame),
    /// rates of the auxiliaries. In space they are not the rates of q.
    pub velocities: LabelledVector,
    /// M.
    pub mass: LabelledMatrix,
    /// C.
    pub residual: LabelledVector,
    /// C_q.
    pub jacobian: LabelledMatrix,
    /// C_t.
    pub time_derivative: LabelledVector,
    /// Q_e: applied forces.
    pub applied: LabelledVector,
    /// Q_v: centrifugal and gyroscopic forces; in the plane zero where the reference points are centres of mass.
    pub centrifugal: LabelledVector,
    /// Q_d: right side of the accelerations, C_q a = Q_d.
    pub qd: LabelledVector,
    /// Accelerations; none where the masses do not determine them (see `notes`).
    pub accelerations: Option<LabelledVector>,
    /// Multipliers; none where there are no accelerations.
    pub multipliers: Option<LabelledVector>,
    /// Rows whose multipliers are not unique, since constraints are redundant.
    pub not_unique: Vec<String>,
    /// Generalized momenta p = M v.
    pub momenta: LabelledVector,
    /// The equations in independent coordinates, where they were asked for.
    pub independent: Option<IndependentEquations>,
    /// Energies and other scalars.
    pub scalars: Scalars,
    /// What a reader should know about these numbers.
    pub notes: Vec<String>,
}

/// The equations of motion in independent velocities: v = B u + g, a = B u' + gamma, Mbar u' = Qbar.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct IndependentEquations {
    /// Which basis.
    pub basis: EquationBasis,
    /// Dependent coordinates, where the basis is one of coordinates.
    pub dependent: Vec<String>,
    /// Condition number of the block of dependent coordinates: large where other independent ones would be better.
    pub condition: Option<f64>,
    /// B.
    pub motions: LabelledMatrix,
    /// g: velocities at u = 0; not zero only where drivers move.
    pub velocity_offset: LabelledVector,
    /// gamma: accelerations at u' = 0.
    pub acceleration_offset: LabelledVector,
    /// Mbar = B^T M B.
    pub mass: LabelledMatrix,
    /// Qbar = B^T (Q_e + Q_v - M gamma).
    pub force: LabelledVector,
    /// u.
    pub velocities: LabelledVector,
    /// u'.
    pub accelerations: Option<LabelledVector>,
    /// Generalized momenta dT/du = B^T M v.
    pub momenta: LabelledVector,
}

/// Scalar functions of the state.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Scalars {
    /// T [J].
    pub kinetic: f64,
    /// Part of T of second degree in the independent velocities [J].
    pub kinetic_2: Option<f64>,
    /// Part of first degree [J]; not zero only where drivers move.
    pub kinetic_1: Option<f64>,
    /// Part of degree zero [J]; not zero only where drivers move.
    pub kinetic_0: Option<f64>,
    /// V of gravity and springs [J]; the height of the ground's origin is zero.
    pub potential: f64,
    /// L = T - V [J].
    pub lagrangian: f64,
    /// H = p . u - L in the independent velocities, or in all velocities where none were asked for [J].
    pub hamiltonian: f64,
    /// T + V [J].
    pub energy: f64,
    /// Gibbs-Appel function, half the integral of |acceleration|^2 dm; in the plane the sum of
    /// m |a_c|^2 / 2 + J (theta''^2 + theta'^4) / 2 [N m/s^2].
    pub gibbs_appel: Option<f64>,
}
