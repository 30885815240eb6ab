//! `dalembert view`: the animated page.

use crate::arguments::{ViewAnalysis, ViewArgs};
use crate::failure::Failure;
use crate::load::{apply, beside, load};
use crate::output::write_text;
use crate::{scene, summary, viewer};
use dalembert::analysis::{Dynamics, Kinematics, NewtonOptions};
use dalembert::system::Role;
use dalembert_io::animation::html;

/// Runs the machine and writes the page.
pub fn run(args: &ViewArgs) -> Result<(), Failure> {
    let template = viewer::page().map_err(|e| Failure::Usage(e.to_string()))?;
    let loaded = load(&args.run.model, apply(&args.run))?;
    let system = &loaded.compiled.system;
    let options = &loaded.compiled.options;
    let newton = NewtonOptions {
        max_iterations: options.max_iterations,
        ..NewtonOptions::default()
    };
    let kinematics = Kinematics {
        instants: options.instants(),
        newton,
    };
    let dynamics = || {
        let run = Dynamics::new(options).run(system, &mut |_| true)?;
        Ok::<_, Failure>((run.results, run.assembly, run.stopped))
    };
    let driven = system.elements.iter().any(|e| e.role == Role::Driver);
    let (mut results, assembly, stopped) = match args.analysis {
        ViewAnalysis::Simulate => dynamics()?,
        ViewAnalysis::Kinematics => {
            let run = kinematics.run(system)?;
            (run.results, run.assembly, run.stopped)
        }
        // A machine that its drivers do not move completely is simulated.
        ViewAnalysis::Auto if driven => match kinematics.run(system) {
            Ok(run) => (run.results, run.assembly, run.stopped),
            Err(_) => dynamics()?,
        },
        ViewAnalysis::Auto => dynamics()?,
    };
    results.notes.extend(summary::assembly(&assembly));
    if let Some(error) = &stopped {
        results.notes.push(format!("error: {error}"));
    }
    let facts = vec![
        ("Analysis".to_owned(), results.analysis.clone()),
        ("Bodies".to_owned(), system.bodies.len().to_string()),
        ("Instants".to_owned(), results.len().to_string()),
    ];
    let animation = scene::animation(&loaded, &results, facts);
    let path = args
        .page
        .clone()
        .unwrap_or_else(|| beside(&args.run.model.model, ".html"));
    let page = html(template, &animation).map_err(|e| Failure::File {
        path: path.clone(),
        cause: e.to_string(),
    })?;
    write_text(&path, &page)?;
    let mut written = crate::output::write_all(&args.run, &loaded, &results)?;
    written.insert(0, path);
    println!("{}", summary::files(&written));
    match stopped {
        Some(error) => Err(error.into()),
        None => Ok(()),
    }
}
