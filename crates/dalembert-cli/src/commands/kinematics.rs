//! `dalembert kinematics`.

use crate::arguments::RunArgs;
use crate::failure::Failure;
use crate::load::load_run;
use crate::summary;
use dalembert::analysis::{Kinematics, NewtonOptions};

/// Runs the kinematic analysis and prints its summary.
pub fn run(args: &RunArgs) -> Result<(), Failure> {
    let loaded = load_run(args)?;
    let options = &loaded.compiled.options;
    let analysis = Kinematics {
        instants: options.instants(),
        newton: NewtonOptions {
            max_iterations: options.max_iterations,
            ..NewtonOptions::default()
        },
    };
    let run = analysis.run(&loaded.compiled.system)?;
    summary::report(args, &loaded, run.results, &run.assembly, run.stopped)
}
