//! `dalembert simulate`.

use crate::arguments::RunArgs;
use crate::failure::Failure;
use crate::load::{Loaded, in_its_space, load_run};
use crate::summary;
use dalembert::analysis::Dynamics;
use dalembert::space::Space;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Runs the simulation and prints its summary.
pub fn run(args: &RunArgs) -> Result<(), Failure> {
    in_its_space!(load_run(args)?, loaded => simulate(args, &loaded))
}

fn simulate<S: Space>(args: &RunArgs, loaded: &Loaded<S>) -> Result<(), Failure> {
    let options = &loaded.compiled.options;
    let (start, end) = (options.start, options.end);
    let bar = ProgressBar::with_draw_target(Some(1000), ProgressDrawTarget::stderr_with_hz(4));
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {msg} s of the run, {eta} left") {
        bar.set_style(style);
    }
    let run = Dynamics::new(options).run(&loaded.compiled.system, &mut |t| {
        bar.set_position((1000.0 * (t - start) / (end - start)) as u64);
        bar.set_message(summary::number(t));
        true
    })?;
    bar.finish_and_clear();
    summary::report(args, loaded, run.results, &run.assembly, run.stopped)
}
