//! `dalembert check`: validation and mobility.

use crate::arguments::CheckArgs;
use crate::failure::Failure;
use crate::load::{Loaded, in_its_space, load};
use crate::summary;
use dalembert::analysis::{
    AnalysisError, Assembly, Conflict, DriverSweep, Mobility, SweepOptions, conflicts,
    driver_singularities, missing_mass,
};
use dalembert::network::{Network, TerminalGraph};
use dalembert::space::{Space, norm};
use dalembert::system::State;

/// Validates the model, assembles it and prints its mobility.
pub fn run(args: &CheckArgs) -> Result<(), Failure> {
    in_its_space!(load(&args.model, |_| {})?, loaded => check(args, &loaded))
}

fn check<S: Space>(args: &CheckArgs, loaded: &Loaded<S>) -> Result<(), Failure> {
    let system = &loaded.compiled.system;
    let (state, assembly) = match Assembly::default().run(system) {
        Ok(done) => done,
        Err(error @ AnalysisError::NotAssembled { .. }) => {
            let found = conflicts(&system.start_positions(), &system.estimate)?;
            return Err(Failure::NotAssembled {
                error: without_guess(error, &found),
                conflicts: found,
            });
        }
        Err(error) => return Err(error.into()),
    };
    let report = Mobility::default().run(system, &state)?;
    let driven = system.is_driven();
    // Where the machine is depends on its way where rows hold velocities only: nothing can be swept.
    let sweep = if driven && report.freedoms_left() == 0 && report.velocity_rows == 0 {
        Some(driver_singularities(
            system,
            &state,
            &SweepOptions {
                // A hundred poses a turn of the fastest body, within reason.
                steps: turns::<S>(&state, loaded.compiled.options.end).clamp(400, 20_000),
                ..SweepOptions::until(loaded.compiled.options.end)
            },
        )?)
    } else {
        None
    };
    let network = Network::new(&system.running(), TerminalGraph::default());
    let loops = network.loops();
    let mut notes = summary::assembly(&assembly);
    // A machine without any mass is a matter of geometry: nothing is missing there.
    if system.mass.iter().any(|m| *m > 0.0) {
        notes.extend(missing_mass(system));
    }
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
        summary::tell(&note);
    }
    Ok(())
}

/// The error without the elements that Newton's method suspects, where the conflicts were found.
fn without_guess(error: AnalysisError, found: &[Conflict]) -> AnalysisError {
    match error {
        AnalysisError::NotAssembled {
            time,
            iterations,
            worst,
            residual,
            ..
        } if !found.is_empty() => AnalysisError::NotAssembled {
            time,
            iterations,
            worst,
            residual,
            conflict: "; see the conflict".to_owned(),
        },
        other => other,
    }
}

/// A hundred times the turns of the fastest body until the end, at its speed at the start.
fn turns<S: Space>(state: &State, end: f64) -> usize {
    let bodies = state.v.chunks_exact(S::NV);
    let omega = bodies.fold(0.0_f64, |a, v| a.max(norm(&v[S::LINEAR..])));
    (100.0 * omega * (end - state.t) / std::f64::consts::TAU) as usize
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
