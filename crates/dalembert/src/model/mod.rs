//! What a user describes: plain data with names, not indices. Knows nothing of solving.
//!
//! The serde form of [`Model`] is the model file: sections `model`, `parameters`, and the lists
//! `table`, `body`, `joint`, `constraint`, `driver`, `force`, `initial`, `trace`, then `analysis`
//! and `output`. Every number may be a [`Value`]: a number in SI or a text with units.

mod analysis;
mod axial_vector;
mod body;
mod constraint;
mod driver;
mod force;
mod inertia;
mod initial;
mod joint;
mod orientation;
mod placement;
mod quantity;
mod shape;
mod surface;
mod table;
mod trace;
mod value;

pub use analysis::{AnalysisOptions, Method, OutputOptions, Stabilization};
pub use axial_vector::AxialVector;
pub use body::{Body, HeldCoordinate};
pub use constraint::{Constraint, ConstraintKind, Term};
pub use driver::{Driver, DriverKind, Motion, PathTag};
pub use force::{Axes, Force, ForceKind, Matrix};
pub use inertia::Inertia;
pub use initial::Initial;
pub use joint::{CamFollower, CamProfile, Joint, JointKind, Side, SpaceCurve};
pub use orientation::{EulerAxes, Orientation};
pub use placement::Placement;
pub use quantity::{CoordinateName, Quantity};
pub use shape::{Shape, ShapeKind};
pub use surface::{Surface, SurfaceForm};
pub use table::{Interpolation, Table};
pub use trace::Trace;
pub use value::{Point, Value};

use indexmap::IndexMap;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The name of the fixed body that always exists.
pub const GROUND: &str = "ground";

/// Planar or spatial.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SpaceKind {
    /// Motion in one plane: three coordinates a body.
    #[default]
    Planar,
    /// Motion in space: six degrees of freedom a body.
    Spatial,
}

/// Section `[model]`: what the model is called and where it lives.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Info {
    /// Name of the model.
    pub name: String,
    /// A sentence for people.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub description: Option<String>,
    /// Planar or spatial.
    #[serde(default)]
    pub space: SpaceKind,
    /// Acceleration of gravity [m/s^2]; default (0, -9.81) planar, (0, 0, -9.81) spatial.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gravity: Option<Point>,
}

/// A machine as its user describes it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Model {
    /// Name, space and gravity.
    #[serde(rename = "model")]
    pub info: Info,
    /// Named numbers, usable in every value of the model.
    #[serde(default, skip_serializing_if = "IndexMap::is_empty")]
    pub parameters: IndexMap<String, Value>,
    /// Functions of one variable given by points.
    #[serde(default, rename = "table", skip_serializing_if = "Vec::is_empty")]
    pub tables: Vec<Table>,
    /// The rigid bodies.
    #[serde(default, rename = "body", skip_serializing_if = "Vec::is_empty")]
    pub bodies: Vec<Body>,
    /// The joints.
    #[serde(default, rename = "joint", skip_serializing_if = "Vec::is_empty")]
    pub joints: Vec<Joint>,
    /// Coordinate constraints, couplers and user constraints.
    #[serde(default, rename = "constraint", skip_serializing_if = "Vec::is_empty")]
    pub constraints: Vec<Constraint>,
    /// Prescribed motions.
    #[serde(default, rename = "driver", skip_serializing_if = "Vec::is_empty")]
    pub drivers: Vec<Driver>,
    /// Force elements.
    #[serde(default, rename = "force", skip_serializing_if = "Vec::is_empty")]
    pub forces: Vec<Force>,
    /// Values and rates that hold exactly at the start.
    #[serde(default, rename = "initial", skip_serializing_if = "Vec::is_empty")]
    pub initial: Vec<Initial>,
    /// Points whose motion is wanted.
    #[serde(default, rename = "trace", skip_serializing_if = "Vec::is_empty")]
    pub traces: Vec<Trace>,
    /// Options of the analyses.
    #[serde(default)]
    pub analysis: AnalysisOptions,
    /// What is written.
    #[serde(default)]
    pub output: OutputOptions,
}
