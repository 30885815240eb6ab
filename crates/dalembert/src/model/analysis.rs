//! Options of the analyses and of what is written.

use super::{Point, Value};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How constraints are kept during a simulation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Stabilization {
    /// Positions and velocities are projected after every step.
    #[default]
    Projection,
    /// Baumgarte: violations decay in the acceleration equation; no projection.
    Baumgarte,
}

/// How a simulation is integrated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// Explicit Euler: fixed steps, order 1.
    Euler,
    /// The explicit midpoint rule: fixed steps, order 2.
    Midpoint,
    /// Heun's method: fixed steps, order 2.
    Heun,
    /// The classical method of Runge and Kutta: fixed steps, order 4.
    Rk4,
    /// Dormand and Prince: controlled steps, order 5(4).
    #[default]
    Dopri5,
    /// Dormand and Prince: controlled steps, order 8(5,3).
    Dop853,
    /// Adams, Bashforth and Moulton: controlled steps, orders 1 to 12.
    Adams,
}

impl Method {
    /// Every method with its name in model files and on the command line.
    pub const NAMES: [(&'static str, Self); 7] = [
        ("dopri5", Self::Dopri5),
        ("dop853", Self::Dop853),
        ("adams", Self::Adams),
        ("rk4", Self::Rk4),
        ("heun", Self::Heun),
        ("midpoint", Self::Midpoint),
        ("euler", Self::Euler),
    ];

    /// Does it make steps of one size that the user chooses?
    pub fn has_fixed_steps(self) -> bool {
        matches!(self, Self::Euler | Self::Midpoint | Self::Heun | Self::Rk4)
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        let found = Self::NAMES.iter().find(|(_, method)| *method == self);
        found.map_or("", |(name, _)| name)
    }
}

/// Section `[analysis]`: options of the analyses; `start`, `end`, `step`, `tolerance`, `integrator`, `fixed_step`,
/// `actuators` and `independent` also stand on the command line.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AnalysisOptions {
    /// Start time [s]; default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start: Option<Value>,
    /// End time [s]; default 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub end: Option<Value>,
    /// Time between written results [s]; default a hundredth of the run.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub step: Option<Value>,
    /// Relative error tolerance of the integration; default 1e-8.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<Value>,
    /// Method of `simulate`: "dopri5", "dop853" or "adams" choose their steps by the tolerance; "rk4", "heun", "midpoint" and
    /// "euler" make steps of one size, `fixed_step`; default "dopri5".
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub integrator: Option<Method>,
    /// Step of the methods with steps of one size [s].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fixed_step: Option<Value>,
    /// Largest integration step [s]; default no limit.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_step: Option<Value>,
    /// Most steps of a simulation: it ends there with what it has; default 1000000.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_steps: Option<u32>,
    /// How constraints are kept in `simulate`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stabilization: Option<Stabilization>,
    /// Baumgarte's alpha and beta [1/s]; default 50 and 50.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub baumgarte: Option<[Value; 2]>,
    /// Most Newton iterations of a position analysis; default 50.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_iterations: Option<u32>,
    /// `inverse`: joints whose actuators shall produce the driven motion; default the drivers themselves.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub actuators: Vec<String>,
    /// `equations`: independent coordinates, like "crank.angle"; default chosen by pivoting.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub independent: Vec<String>,
}

/// Section `[output]`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OutputOptions {
    /// Patterns of channel names that are written, like "crank.*"; default all.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub channels: Vec<String>,
    /// Point in ground axes [m] about which the angular momentum of each body and of the machine is written; default: that of
    /// the machine only, about the origin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub momentum_about: Option<Point>,
    /// Coordinates in which orientations are written: "euler-parameters", "axis-angle", "rodriguez",
    /// "direction-cosines", or Euler angles like "euler-zxz" (about body axes) and "euler-xyz-space" (about
    /// ground axes); default "euler-parameters" (spatial).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientation: Option<String>,
}
