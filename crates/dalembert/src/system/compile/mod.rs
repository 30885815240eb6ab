//! From a model to a compiled planar system: every number resolved, every mistake collected.

mod bodies;
mod built;
mod constraints;
mod context;
mod drawing;
mod drivers;
mod forces;
mod joints;
mod mass;
mod names;
mod options;
mod outlines;
mod place;
mod quantities;
mod tables;
mod wrong_space;

pub use drawing::{Drawing, DrawnBody, DrawnElement, DrawnEnd, DrawnForm, DrawnShape};
pub use options::Options;

use super::System;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::{Model, SpaceKind, Value};
use crate::space::Planar;
use context::Context;
use indexmap::IndexMap;

/// A compiled model.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The system with the rows of all phases (see [`System::running`], [`System::start_positions`]).
    pub system: System<Planar>,
    /// Options of the analyses, resolved.
    pub options: Options,
    /// Values of the parameters.
    pub parameters: IndexMap<String, f64>,
    /// What a picture needs beside the poses.
    pub drawing: Drawing,
    /// What is unusual in the model.
    pub warnings: Vec<Diagnostic>,
}

/// Compiles a model; `overrides` replace parameters by name.
///
/// # Errors
/// All mistakes of the model at once, each with its place and a remedy.
pub fn compile(model: &Model, overrides: &[(String, Value)]) -> Result<Compiled, Diagnostics> {
    let mut context = Context::new(model, overrides);
    context.diagnostics = wrong_space::check(model);
    context.stand_ins = !context.diagnostics.is_empty();
    if model.info.space == SpaceKind::Spatial {
        context.report(
            Diagnostic::error(
                "space-not-supported",
                "model.space",
                "spatial models cannot be computed by this version",
            )
            .help("use space = \"planar\""),
        );
        return Err(Diagnostics(context.diagnostics));
    }
    context.parameters();
    context.tables();
    context.options();
    context.bodies();
    context.traces();
    context.joints();
    context.springs();
    context.constraints();
    context.drivers();
    context.forces();
    context.initial();
    context.finish()
}
