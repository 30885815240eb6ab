//! From a model file to a compiled model, with every mistake rendered.

use crate::arguments::{ModelArgs, RunArgs};
use crate::failure::Failure;
use dalembert::diagnostic::Diagnostic;
use dalembert::model::{Method, Model, SpaceKind, Value};
use dalembert::space::{Planar, Space, Spatial};
use dalembert::system::compile::{Compiled, ModelSpace, compile};
use dalembert::words::counted;
use dalembert_io::model_file::{Parsed, parse_model, render, to_json};
use std::io::IsTerminal;
use std::path::Path;

/// A model file, read and compiled in its space.
pub enum Machine {
    /// Motion in one plane.
    Planar(Loaded<Planar>),
    /// Motion in space.
    Spatial(Loaded<Spatial>),
}

/// The same expression for a machine of either space.
macro_rules! in_its_space {
    ($machine:expr, $loaded:ident => $body:expr) => {
        match $machine {
            $crate::load::Machine::Planar($loaded) => $body,
            $crate::load::Machine::Spatial($loaded) => $body,
        }
    };
}
pub(crate) use in_its_space;

/// A model file, read and compiled.
pub struct Loaded<S: Space> {
    /// The model as written.
    pub model: Model,
    /// The compiled model.
    pub compiled: Compiled<S>,
    /// Text of the file.
    pub text: String,
    /// Warnings for programs: a JSON list.
    pub warnings: serde_json::Value,
}

impl<S: Space> Loaded<S> {
    /// An answer for programs, with the warnings of the model under "diagnostics".
    pub fn with_warnings(&self, mut answer: serde_json::Value) -> serde_json::Value {
        if let Some(object) = answer.as_object_mut() {
            object.insert("diagnostics".to_owned(), self.warnings.clone());
        }
        answer
    }
}

/// Most mistakes that are shown to people; a file of another kind has one in every line.
const MOST_SHOWN: usize = 30;

/// Reads and compiles a model file; prints warnings for people.
pub fn load(args: &ModelArgs, change: impl Fn(&mut Model)) -> Result<Machine, Failure> {
    load_given(args, change, &[])
}

/// Like `load`; `given` says which places of the model come from options of the command line.
fn load_given(
    args: &ModelArgs,
    change: impl Fn(&mut Model),
    given: &[(&str, &str)],
) -> Result<Machine, Failure> {
    let text = read(&args.model)?;
    let folder = args.model.parent();
    let mut parsed = parse_model(&text, folder);
    // The draft stands in for a model with mistakes, to find those inside expressions too.
    if let Some(draft) = &mut parsed.draft {
        change(draft);
    }
    let space = parsed.draft.as_ref().map(|draft| draft.info.space);
    Ok(match space.unwrap_or_default() {
        SpaceKind::Planar => Machine::Planar(compiled(args, text, parsed, given)?),
        SpaceKind::Spatial => Machine::Spatial(compiled(args, text, parsed, given)?),
    })
}

/// Compiles what was read.
fn compiled<S: ModelSpace>(
    args: &ModelArgs,
    text: String,
    mut parsed: Parsed,
    given: &[(&str, &str)],
) -> Result<Loaded<S>, Failure> {
    let overrides = overrides(&args.set)?;
    let name = args.model.display().to_string();
    let for_people = |parsed: &Parsed| {
        let color = std::io::stderr().is_terminal();
        let shown = &parsed.diagnostics[..parsed.diagnostics.len().min(MOST_SHOWN)];
        let mut out = render(shown, &parsed.source, &name, &text, color);
        if parsed.diagnostics.len() > shown.len() {
            let rest = parsed.diagnostics.len() - shown.len();
            out.push_str(&format!(
                "and {} more; --json lists all\n",
                counted(rest, "mistake")
            ));
            if text.trim_start().starts_with(['{', '[', '<']) && !text.contains("[model]") {
                out.push_str(
                    "this does not look like a model file: those are TOML (see 'dalembert new')\n",
                );
            }
        }
        out
    };
    let for_programs = |parsed: &Parsed| to_json(&parsed.diagnostics, &parsed.source, &name, &text);
    let mistakes = |parsed: &Parsed| Failure::Model {
        text: for_people(parsed),
        diagnostics: for_programs(parsed),
    };
    let Some(draft) = parsed.draft.clone() else {
        return Err(mistakes(&parsed));
    };
    let compiled = match compile(&draft, &overrides) {
        Ok(compiled) => {
            parsed.add(compiled.warnings.clone());
            Some(compiled)
        }
        Err(errors) => {
            if let Some(failure) = of_options(&errors.0, &overrides, given) {
                return Err(failure);
            }
            parsed.add(errors.0);
            None
        }
    };
    match (&parsed.model, compiled) {
        (Some(_), Some(compiled)) => {
            if !parsed.diagnostics.is_empty() && !args.json {
                eprint!("{}", for_people(&parsed));
            }
            let warnings = for_programs(&parsed);
            Ok(Loaded {
                model: draft,
                compiled,
                text,
                warnings,
            })
        }
        _ => Err(mistakes(&parsed)),
    }
}

/// The text of a model file; where it is not text, the place of the first byte that is none.
fn read(path: &Path) -> Result<String, Failure> {
    let failure = |cause: String| Failure::File {
        path: path.to_owned(),
        cause,
    };
    let bytes = std::fs::read(path).map_err(|e| failure(format!("cannot be read: {e}")))?;
    String::from_utf8(bytes).map_err(|e| {
        let good = e.utf8_error().valid_up_to();
        let before = String::from_utf8_lossy(&e.as_bytes()[..good]);
        let line = before.matches('\n').count() + 1;
        let column = before
            .rsplit('\n')
            .next()
            .map_or(1, |l| l.chars().count() + 1);
        let byte = e.as_bytes().get(good).copied().unwrap_or_default();
        failure(format!(
            "it is not UTF-8 text: line {line}, column {column} holds the byte 0x{byte:02x}; \
             save the file as UTF-8"
        ))
    })
}

/// Refuses options that an analysis has no use for.
pub fn refuse(analysis: &str, options: &[(&Option<String>, &str, &str)]) -> Result<(), Failure> {
    let given = options.iter().find(|(value, ..)| value.is_some());
    given.map_or(Ok(()), |(_, option, reason)| {
        Err(Failure::Usage(format!(
            "{analysis} has no use for {option}: {reason}; leave it out"
        )))
    })
}

/// Refuses the options of the integration for analyses that solve for each pose.
pub fn refuse_integration(analysis: &str, args: &RunArgs) -> Result<(), Failure> {
    let exact = "its poses are exact to rounding";
    refuse(
        analysis,
        &[
            (&args.tolerance, "--tolerance", exact),
            (&args.integrator, "--integrator", exact),
            (&args.fixed_step, "--fixed-step", exact),
        ],
    )
}

/// Refuses to write two things to one file.
fn check_files(args: &RunArgs) -> Result<(), Failure> {
    let mut files: Vec<&std::path::PathBuf> = args.out.iter().collect();
    files.extend(args.plot_file.iter().chain(&args.html));
    for (k, file) in files.iter().enumerate() {
        if files[..k].contains(file) {
            return Err(Failure::Usage(format!(
                "{} is named twice as a file to write; name each file once",
                file.display()
            )));
        }
    }
    Ok(())
}

/// Reads and compiles the model of a run, with the options of the command line.
pub fn load_run(args: &RunArgs) -> Result<Machine, Failure> {
    check_files(args)?;
    if args.html.is_some() {
        crate::page::check()?;
    }
    let options = [
        (&args.start, "analysis.start", "--start"),
        (&args.end, "analysis.end", "--end"),
        (&args.step, "analysis.step", "--step"),
        (&args.tolerance, "analysis.tolerance", "--tolerance"),
        (&args.integrator, "analysis.integrator", "--integrator"),
        (&args.fixed_step, "analysis.fixed_step", "--fixed-step"),
    ];
    let given: Vec<(&str, &str)> = options
        .iter()
        .filter(|(value, ..)| value.is_some())
        .map(|&(_, path, option)| (path, option))
        .collect();
    load_given(&args.model, apply(args), &given)
}

/// Moves the estimate to an instant given on the command line. The start stays: rates are integrated from there.
pub fn move_to<S: ModelSpace>(
    loaded: &mut Loaded<S>,
    args: &ModelArgs,
    time: &str,
) -> Result<(), Failure> {
    let overrides = overrides(&args.set)?;
    let compiled = |model: &Model| {
        compile::<S>(model, &overrides).map_err(|errors| {
            of_options(&errors.0, &overrides, &[("analysis.start", "--time")])
                .unwrap_or_else(|| Failure::Usage(format!("--time: {errors}")))
        })
    };
    let mut model = loaded.model.clone();
    model.analysis.start = Some(number_or_text(time));
    // The end only matters to runs; it must stay behind the start.
    model.analysis.end = None;
    let t = compiled(&model)?.options.start;
    if t > loaded.compiled.options.end {
        model
            .analysis
            .start
            .clone_from(&loaded.model.analysis.start);
        model.analysis.end = Some(Value::Number(t));
        loaded.compiled = compiled(&model)?;
    }
    loaded.compiled.system.estimate.t = t;
    Ok(())
}

/// Mistakes of values that stand on the command line, not in the file.
fn of_options(
    errors: &[Diagnostic],
    overrides: &[(String, Value)],
    given: &[(&str, &str)],
) -> Option<Failure> {
    let lines: Vec<String> = errors
        .iter()
        .filter_map(|d| {
            let option = given.iter().find(|(path, _)| d.path == *path);
            let set = overrides
                .iter()
                .find(|(name, _)| d.path == format!("parameters.{name}"));
            let origin = match (option, set) {
                (Some((_, option)), _) => (*option).to_owned(),
                (None, Some((name, _))) => format!("--set {name}"),
                (None, None) => return None,
            };
            let help = d
                .help
                .as_ref()
                .map_or_else(String::new, |h| format!("; {h}"));
            Some(format!("{origin}: {}{help}", d.message))
        })
        .collect();
    (!lines.is_empty()).then(|| Failure::Usage(lines.join("\n")))
}

fn overrides(set: &[String]) -> Result<Vec<(String, Value)>, Failure> {
    set.iter()
        .map(|text| match text.split_once('=') {
            Some((name, value)) if !name.trim().is_empty() && !value.trim().is_empty() => {
                Ok((name.trim().to_owned(), number_or_text(value.trim())))
            }
            _ => Err(Failure::Usage(format!(
                "--set {text}: write --set NAME=VALUE"
            ))),
        })
        .collect()
}

/// A number, or a text with a unit or an expression.
pub fn number_or_text(text: &str) -> Value {
    text.parse::<f64>()
        .map_or_else(|_| Value::Text(text.to_owned()), Value::Number)
}

/// Puts the options of the command line into the model.
fn apply(args: &RunArgs) -> impl Fn(&mut Model) + '_ {
    |model| {
        let a = &mut model.analysis;
        for (option, slot) in [
            (&args.start, &mut a.start),
            (&args.end, &mut a.end),
            (&args.step, &mut a.step),
            (&args.tolerance, &mut a.tolerance),
            (&args.fixed_step, &mut a.fixed_step),
        ] {
            if let Some(text) = option {
                *slot = Some(number_or_text(text));
            }
        }
        let asked = args.integrator.as_ref();
        let named = asked.and_then(|name| Method::NAMES.iter().find(|(known, _)| known == name));
        if let Some((_, method)) = named.copied() {
            // What the model says of steps belongs to its own method.
            if method.has_fixed_steps() {
                a.max_step = None;
            } else if args.fixed_step.is_none() {
                a.fixed_step = None;
            }
            a.integrator = Some(method);
        }
    }
}

/// A file of another extension beside a file.
pub fn beside(path: &Path, suffix: &str) -> std::path::PathBuf {
    let stem = path
        .file_stem()
        .map_or_else(|| "model".into(), |s| s.to_string_lossy().into_owned());
    path.with_file_name(format!("{stem}{suffix}"))
}
