//! `dalembert inverse`.

use crate::arguments::InverseArgs;
use crate::failure::Failure;
use crate::load::{EXACT, load_run, refuse};
use crate::summary;
use dalembert::analysis::{Inverse, NewtonOptions};

/// Runs the inverse dynamics and prints its summary.
pub fn run(args: &InverseArgs) -> Result<(), Failure> {
    refuse("inverse", &[(&args.run.tolerance, "--tolerance", EXACT)])?;
    let loaded = load_run(&args.run)?;
    let options = &loaded.compiled.options;
    let analysis = Inverse {
        instants: options.instants(),
        newton: NewtonOptions::of(options),
        actuators: if args.actuator.is_empty() {
            options.actuators.clone()
        } else {
            args.actuator.clone()
        },
    };
    let run = analysis.run(&loaded.compiled.system)?;
    summary::report(&args.run, &loaded, run.results, &run.assembly, run.stopped)
}
