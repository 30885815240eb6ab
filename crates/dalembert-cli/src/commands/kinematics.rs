//! `dalembert kinematics`.

use crate::arguments::RunArgs;
use crate::failure::Failure;
use crate::load::{EXACT, load_run, refuse};
use crate::summary;
use dalembert::analysis::Kinematics;

/// Runs the kinematic analysis and prints its summary.
pub fn run(args: &RunArgs) -> Result<(), Failure> {
    refuse("kinematics", &[(&args.tolerance, "--tolerance", EXACT)])?;
    let loaded = load_run(args)?;
    let analysis = Kinematics::new(&loaded.compiled.options);
    let run = analysis.run(&loaded.compiled.system)?;
    summary::report(args, &loaded, run.results, &run.assembly, run.stopped)
}
