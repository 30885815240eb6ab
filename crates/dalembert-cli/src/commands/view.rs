//! `dalembert view`: the animated page.

use crate::arguments::{RunArgs, ViewAnalysis, ViewArgs};
use crate::failure::Failure;
use crate::load::{Loaded, beside, in_its_space, load_run};
use crate::summary;
use dalembert::analysis::{AnalysisError, Dynamics, Kinematics};
use dalembert::space::Space;

/// Runs the machine, writes the page and prints the summary of the run.
pub fn run(args: &ViewArgs) -> Result<(), Failure> {
    let model = &args.run.model.model;
    let page = args
        .run
        .html
        .clone()
        .unwrap_or_else(|| beside(model, ".html"));
    let args_with_page = RunArgs {
        html: Some(page),
        ..args.run.clone()
    };
    in_its_space!(load_run(&args_with_page)?, loaded => view(args, &args_with_page, &loaded))
}

fn view<S: Space>(args: &ViewArgs, with_page: &RunArgs, loaded: &Loaded<S>) -> Result<(), Failure> {
    let system = &loaded.compiled.system;
    let options = &loaded.compiled.options;
    let kinematics = Kinematics::new(options);
    let dynamics = || {
        let run = Dynamics::new(options).run(system, &mut |_| true)?;
        Ok::<_, Failure>((run.results, run.assembly, run.stopped))
    };
    let driven = system.is_driven();
    let (results, assembly, stopped) = match args.analysis {
        ViewAnalysis::Simulate => dynamics()?,
        ViewAnalysis::Kinematics => {
            let run = kinematics.run(system)?;
            (run.results, run.assembly, run.stopped)
        }
        // A machine that its drivers do not move completely is simulated.
        ViewAnalysis::Auto if driven => match kinematics.run(system) {
            Ok(run) => (run.results, run.assembly, run.stopped),
            Err(AnalysisError::NotDriven { .. }) => dynamics()?,
            Err(error) => return Err(error.into()),
        },
        ViewAnalysis::Auto => dynamics()?,
    };
    summary::report(with_page, loaded, results, &assembly, stopped)
}
