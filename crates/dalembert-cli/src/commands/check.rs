//! `dalembert check`: validation and mobility.

use crate::arguments::CheckArgs;
use crate::failure::Failure;
use crate::load::load;
use crate::summary;
use dalembert::analysis::{
    AnalysisError, Assembly, DriverSweep, Mobility, SweepOptions, conflicts, driver_singularities,
};
use dalembert::network::{Network, TerminalGraph};
use dalembert::system::Role;

/// Validates the model, assembles it and prints its mobility.
pub fn run(args: &CheckArgs) -> Result<(), Failure> {
    let loaded = load(&args.model, |_| {})?;
    let system = &loaded.compiled.system;
    let (state, assembly) = match Assembly::default().run(system) {
        Ok(done) => done,
        Err(error @ AnalysisError::NotAssembled { .. }) => {
            for conflict in conflicts(&system.start_positions(), &system.estimate)? {
                eprintln!("conflict: {conflict}");
            }
            return Err(error.into());
        }
        Err(error) => return Err(error.into()),
    };
    let report = Mobility::default().run(system, &state)?;
    let driven = system.elements.iter().any(|e| e.role == Role::Driver);
    let sweep = if driven && report.freedoms_left() == 0 {
        Some(driver_singularities(
            system,
            &state,
            &SweepOptions::until(loaded.compiled.options.end),
        )?)
    } else {
        None
    };
    let network = Network::new(&system.running(), TerminalGraph::default());
    let loops = network.loops();
    let notes = summary::assembly(&assembly);
    if args.model.json {
        say!(
            "{:#}",
            loaded.with_warnings(serde_json::json!({
                "mobility": report,
                "loops": loops.iter().map(|l| &l.joints).collect::<Vec<_>>(),
                "singular_poses": sweep.as_ref().map(|s| &s.poses),
                "assembly": notes,
            }))
        );
        return Ok(());
    }
    say_on!("{report}");
    for (k, l) in loops.iter().enumerate() {
        say!("  loop {}: {}", k + 1, l.joints.join(" - "));
    }
    if let Some(sweep) = &sweep {
        print_sweep(sweep);
    }
    for note in notes {
        say!("  note: {note}");
    }
    Ok(())
}

fn print_sweep(sweep: &DriverSweep) {
    for pose in &sweep.poses {
        say!("  {pose}");
    }
    if sweep.poses.is_empty() && sweep.stopped.is_none() {
        say!(
            "  the drivers hold the machine in every pose until t = {} s",
            summary::number(sweep.reached)
        );
    }
    if let Some(reason) = &sweep.stopped {
        say!(
            "  the sweep of the drivers ended at t = {} s: {reason}",
            summary::number(sweep.reached)
        );
    }
}
