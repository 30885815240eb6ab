//! `dalembert kinematics`.

use crate::arguments::RunArgs;
use crate::failure::Failure;
use crate::load::{Loaded, in_its_space, load_run, refuse_integration};
use crate::summary;
use dalembert::analysis::Kinematics;
use dalembert::space::Space;

/// Runs the kinematic analysis and prints its summary.
pub fn run(args: &RunArgs) -> Result<(), Failure> {
    refuse_integration("kinematics", args)?;
    in_its_space!(load_run(args)?, loaded => kinematics(args, &loaded))
}

fn kinematics<S: Space>(args: &RunArgs, loaded: &Loaded<S>) -> Result<(), Failure> {
    let analysis = Kinematics::new(&loaded.compiled.options);
    let run = analysis.run(&loaded.compiled.system)?;
    summary::report(args, loaded, run.results, &run.assembly, run.stopped)
}
