//! One named time history.

use serde::{Deserialize, Serialize};

/// A named time history with its unit.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Channel {
    /// Name, element first: "crank.angle", "A.force_x", "energy.kinetic".
    pub name: String,
    /// SI unit as text: "m", "rad", "m/s^2", "N m"; empty for plain numbers.
    pub unit: String,
    /// What it is, in a short sentence with frame and sign.
    pub meaning: String,
    /// One value per instant.
    pub values: Vec<f64>,
    /// May it have no value at an instant? NaN then stands there.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub gaps: bool,
}
