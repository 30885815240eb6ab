//! `dalembert inverse`.

use crate::arguments::InverseArgs;
use crate::failure::Failure;
use crate::load::{Loaded, in_its_space, load_run, refuse_integration};
use crate::summary;
use dalembert::analysis::{Inverse, NewtonOptions};
use dalembert::space::Space;

/// Runs the inverse dynamics and prints its summary.
pub fn run(args: &InverseArgs) -> Result<(), Failure> {
    refuse_integration("inverse", &args.run)?;
    in_its_space!(load_run(&args.run)?, loaded => inverse(args, &loaded))
}

fn inverse<S: Space>(args: &InverseArgs, loaded: &Loaded<S>) -> Result<(), Failure> {
    let options = &loaded.compiled.options;
    let analysis = Inverse {
        instants: options.instants(),
        newton: NewtonOptions::of(options),
        recording: options.recording,
        actuators: if args.actuator.is_empty() {
            options.actuators.clone()
        } else {
            args.actuator.clone()
        },
    };
    let run = analysis.run(&loaded.compiled.system)?;
    summary::report(&args.run, loaded, run.results, &run.assembly, run.stopped)
}
