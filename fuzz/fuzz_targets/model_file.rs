//! No model file may make the reader, the compiler of models or the assembly panic or hang.
//!
//! Run with `cargo fuzz run model_file`; on a stable toolchain with `RUSTC_BOOTSTRAP=1`.
#![no_main]

use dalembert::analysis::Assembly;
use dalembert::diagnostic::Diagnostic;
use dalembert::model::{Model, SpaceKind};
use dalembert::space::{Planar, Spatial};
use dalembert::system::compile::{ModelSpace, compile};
use dalembert_io::model_file::{parse_model, render, to_json, write_model};
use libfuzzer_sys::fuzz_target;

/// Systems with more rows and coordinates than this are only compiled: the search must stay fast.
const SMALL: usize = 40;

fuzz_target!(|text: &str| {
    let parsed = parse_model(text, None);
    // What is said must have a place that can be shown.
    let show = |diagnostics: &[Diagnostic]| {
        render(diagnostics, &parsed.source, "x.toml", text, false);
        to_json(diagnostics, &parsed.source, "x.toml", text);
    };
    show(&parsed.diagnostics);
    assert!(parsed.model.is_some() || !parsed.diagnostics.is_empty());
    if let Some(model) = &parsed.model {
        let written = write_model(model);
        let again = parse_model(&written, None).model;
        assert!(again.as_ref() == Some(model), "{written}");
    }
    let Some(model) = parsed.model.or(parsed.draft) else {
        return;
    };
    match model.info.space {
        SpaceKind::Planar => assemble::<Planar>(&model, &show),
        SpaceKind::Spatial => assemble::<Spatial>(&model, &show),
    }
});

/// Compiles and assembles a model.
fn assemble<S: ModelSpace>(model: &Model, show: &dyn Fn(&[Diagnostic])) {
    let compiled = match compile::<S>(model, &[]) {
        Ok(compiled) => compiled,
        Err(mistakes) => {
            assert!(!mistakes.0.is_empty());
            show(&mistakes.0);
            return;
        }
    };
    show(&compiled.warnings);
    let options = &compiled.options;
    if options.end - options.start < 1e4 * options.step {
        assert!(options.instants().iter().all(|t| t.is_finite()));
    }
    let system = &compiled.system;
    if system.estimate.q.len() + system.rows > SMALL {
        return;
    }
    // A machine that cannot be assembled is an answer; numbers that are none are not.
    if let Ok((state, _)) = Assembly::default().run(system) {
        assert!(state.q.iter().chain(&state.v).all(|x| x.is_finite()));
    }
}
