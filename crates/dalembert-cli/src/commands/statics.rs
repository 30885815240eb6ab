//! `dalembert statics`: equilibrium.

use crate::arguments::{StaticsArgs, StaticsRoute};
use crate::failure::Failure;
use crate::load::{Loaded, in_its_space, load_run, refuse, refuse_integration};
use crate::{output, summary};
use dalembert::analysis::{
    Assembly, HoldingLoads, Route, Stability, Statics, StaticsReport, Unknown, holding_loads,
};
use dalembert::space::Space;
use dalembert::words::counted;

/// Finds the equilibria, or the loads that hold the machine in its pose.
pub fn run(args: &StaticsArgs) -> Result<(), Failure> {
    if args.run.plot.is_some() {
        return Err(Failure::Usage(
            "statics has no time over which --plot could draw: write the poses with --out FILE; \
             for a motion use simulate or kinematics"
                .to_owned(),
        ));
    }
    let whole = "an equilibrium has no duration";
    refuse(
        "statics",
        &[
            (&args.run.end, "--end", whole),
            (&args.run.step, "--step", whole),
        ],
    )?;
    refuse_integration("statics", &args.run)?;
    in_its_space!(load_run(&args.run)?, loaded => statics(args, &loaded))
}

fn statics<S: Space>(args: &StaticsArgs, loaded: &Loaded<S>) -> Result<(), Failure> {
    let system = &loaded.compiled.system;
    if !args.hold.is_empty() || !args.hold_force.is_empty() {
        let (mut state, _) = Assembly::default().run(system)?;
        state.v.fill(0.0);
        let unknowns: Vec<Unknown> = args
            .hold
            .iter()
            .map(|n| Unknown::Effort(n.clone()))
            .chain(args.hold_force.iter().map(|n| Unknown::Force(n.clone())))
            .collect();
        let loads = holding_loads(system, &state, &unknowns)?;
        let written = output::write_all(&args.run, loaded, &loads.results)?;
        print_loads(args, loaded, &loads);
        if !written.is_empty() && !args.run.model.json {
            say!("{}", summary::files(&written));
        }
        return Ok(());
    }
    let analysis = Statics {
        route: match args.route {
            StaticsRoute::Reduced => Route::Reduced,
            StaticsRoute::Multipliers => Route::Multipliers,
        },
        starts: args.starts,
        recording: loaded.compiled.options.recording,
        ..Statics::default()
    };
    let report = analysis.run(system)?;
    let written = output::write_all(&args.run, loaded, &report.results)?;
    if args.run.model.json {
        say!("{:#}", loaded.with_warnings(serde_json::json!(report)));
    } else {
        print_report(&report, &system.position_names());
        if !written.is_empty() {
            say!("{}", summary::files(&written));
        }
    }
    Ok(())
}

fn print_loads<S: Space>(args: &StaticsArgs, loaded: &Loaded<S>, loads: &HoldingLoads) {
    if args.run.model.json {
        say!("{:#}", loaded.with_warnings(serde_json::json!(loads)));
        return;
    }
    say!(
        "{}: loads that hold the machine in its pose",
        loads.results.model
    );
    for load in &loads.loads {
        let (Unknown::Effort(name) | Unknown::Force(name)) = &load.unknown;
        let unique = if load.unique { "" } else { " (not unique)" };
        say!(
            "  {name}: {} {}{unique}",
            summary::number(load.value),
            load.unit
        );
    }
    for note in &loads.results.notes {
        summary::tell(note);
    }
}

/// Equilibria whose coordinates are printed.
const POSES: usize = 6;
/// Coordinates of one equilibrium that are printed.
const COORDINATES: usize = 24;

fn print_report(report: &StaticsReport, names: &[String]) {
    say!(
        "{}: {} equilibri{} found",
        report.results.model,
        report.equilibria.len(),
        if report.equilibria.len() == 1 {
            "um"
        } else {
            "a"
        }
    );
    if report.equilibria.len() > 1 {
        say!(
            "{}, each kind by distance from the estimate:",
            if report.equilibria[0].distance < 1e-6 {
                "The estimate itself first, then stable, neutral and unstable ones"
            } else {
                "Stable ones first, then neutral and unstable ones"
            }
        );
    }
    for (k, e) in report.equilibria.iter().enumerate() {
        let stability = match e.stability {
            Stability::Stable => "stable",
            Stability::Neutral => "neutral",
            Stability::Unstable => "unstable",
        };
        say!(
            "  {}: {stability}, residual {}, {}",
            k + 1,
            summary::number(e.residual),
            counted(e.iterations, "iteration")
        );
        let mut motions = e.motions.clone();
        motions.dedup();
        for motion in &motions {
            say!("     {motion}");
        }
        if k < POSES {
            let rounded = |x: f64| if x.abs() < 1e-12 { 0.0 } else { x };
            let pose: Vec<String> = names
                .iter()
                .zip(&e.q)
                .take(COORDINATES)
                .map(|(n, x)| format!("{n} {}", summary::number(rounded(*x))))
                .collect();
            say!("     centre of mass: {}", pose.join(", "));
        }
    }
    let last = report.equilibria.len();
    if last > POSES || names.len() > COORDINATES {
        let poses = match last.saturating_sub(POSES) {
            0 => "all coordinates".to_owned(),
            1 => format!("the coordinates of equilibrium {last}"),
            2 => format!("the coordinates of equilibria {} and {last}", POSES + 1),
            _ => format!("the coordinates of equilibria {} to {last}", POSES + 1),
        };
        say!("  ({poses}: with --json, or in a file with -o FILE --channels all)");
    }
    for note in &report.results.notes {
        summary::tell(note);
    }
}
