//! Functions of one variable given by points.

use super::Value;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How a table is read between its points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Interpolation {
    /// Cubic spline: second derivative continuous.
    #[default]
    Cubic,
    /// Quintic spline: fourth derivative continuous; for cams and drivers.
    Quintic,
    /// Straight lines: the first derivative jumps; for force characteristics only.
    Linear,
}

/// A function of one variable given by points; used in expressions by its name: `lift(t)`.
///
/// Either `x` and `y`, or `file` (a CSV beside the model file) with `columns`; a reader of model
/// files fills `x` and `y` from the file.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Table {
    /// Name, used as a function in expressions.
    pub name: String,
    /// How it is read between the points.
    #[serde(default)]
    pub interpolation: Interpolation,
    /// Does it repeat? Then the first and the last `y` must be equal.
    #[serde(default)]
    pub periodic: bool,
    /// Arguments, strictly increasing.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub x: Vec<Value>,
    /// Values.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub y: Vec<Value>,
    /// CSV file beside the model file, instead of `x` and `y`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Columns of x and y in the CSV file, counted from 1; default 1 and 2.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub columns: Option<[usize; 2]>,
    /// Unit of the arguments in the CSV file, for example "deg"; default SI.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub x_unit: Option<String>,
    /// Unit of the values in the CSV file, for example "mm"; default SI.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub y_unit: Option<String>,
}
