//! From a model to a compiled system: every number resolved, every mistake collected.

mod bodies;
mod built;
mod constraints;
mod context;
mod drawing;
mod drivers;
mod elements;
mod forces;
mod free_names;
mod geometry;
mod names;
mod options;
mod outlines;
mod place;
mod placement;
mod planar;
mod quantities;
mod spatial;
mod tables;
mod turns;
mod wrong_space;

pub use drawing::{Drawing, DrawnBody, DrawnElement, DrawnEnd, DrawnForm, DrawnShape};
pub use options::Options;

use super::System;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::{Model, SpaceKind, Value};
use crate::space::{Planar, Space, Spatial};
use context::Context;
use indexmap::IndexMap;

/// A compiled model.
#[derive(Clone, Debug)]
pub struct Compiled<S: Space = Planar> {
    /// The system with the rows of all phases (see [`System::running`], [`System::start_positions`]).
    pub system: System<S>,
    /// Options of the analyses, resolved.
    pub options: Options,
    /// Values of the parameters.
    pub parameters: IndexMap<String, f64>,
    /// What a picture needs beside the poses.
    pub drawing: Drawing,
    /// What is unusual in the model.
    pub warnings: Vec<Diagnostic>,
}

/// A space in which models can be compiled.
pub trait ModelSpace: Space {
    /// Which models.
    const KIND: SpaceKind;
    /// Compiles a model of this space; `overrides` replace parameters by name.
    ///
    /// # Errors
    /// All mistakes of the model at once.
    fn compile(model: &Model, overrides: &[(String, Value)])
    -> Result<Compiled<Self>, Diagnostics>;
}

impl ModelSpace for Planar {
    const KIND: SpaceKind = SpaceKind::Planar;

    fn compile(model: &Model, overrides: &[(String, Value)]) -> Result<Compiled, Diagnostics> {
        Context::new(model, overrides).compile()
    }
}

impl ModelSpace for Spatial {
    const KIND: SpaceKind = SpaceKind::Spatial;

    fn compile(
        model: &Model,
        overrides: &[(String, Value)],
    ) -> Result<Compiled<Self>, Diagnostics> {
        Context::new(model, overrides).compile()
    }
}

/// Compiles a model; `overrides` replace parameters by name.
///
/// # Errors
/// All mistakes of the model at once, each with its place and a remedy; or the model is of the other space.
pub fn compile<S: ModelSpace>(
    model: &Model,
    overrides: &[(String, Value)],
) -> Result<Compiled<S>, Diagnostics> {
    if model.info.space != S::KIND {
        let (own, other) = match S::KIND {
            SpaceKind::Planar => ("planar", "spatial"),
            SpaceKind::Spatial => ("spatial", "planar"),
        };
        return Err(Diagnostics(vec![
            Diagnostic::error(
                "other-space",
                "model.space",
                format!("the model is {other}, a {own} one is needed here"),
            )
            .help(format!("use space = \"{own}\"")),
        ]));
    }
    S::compile(model, overrides)
}
