//! `dalembert statics`: equilibrium.

use crate::arguments::{StaticsArgs, StaticsRoute};
use crate::failure::Failure;
use crate::load::{Loaded, load_run};
use crate::{output, summary};
use dalembert::analysis::{
    Assembly, HoldingLoads, Route, Stability, Statics, StaticsReport, Unknown, holding_loads,
};
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
    let loaded = load_run(&args.run)?;
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
        let written = output::write_all(&args.run, &loaded, &loads.results)?;
        print_loads(args, &loaded, &loads);
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
        ..Statics::default()
    };
    let report = analysis.run(system)?;
    let written = output::write_all(&args.run, &loaded, &report.results)?;
    if args.run.model.json {
        say!("{:#}", loaded.with_warnings(serde_json::json!(report)));
    } else {
        print_report(&report, &system.coordinate_names());
        if !written.is_empty() {
            say!("{}", summary::files(&written));
        }
    }
    Ok(())
}

fn print_loads(args: &StaticsArgs, loaded: &Loaded, loads: &HoldingLoads) {
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
}

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
        if k < 6 {
            let rounded = |x: f64| if x.abs() < 1e-12 { 0.0 } else { x };
            let pose: Vec<String> = names
                .iter()
                .zip(&e.q)
                .take(24)
                .map(|(n, x)| format!("{n} {}", summary::number(rounded(*x))))
                .collect();
            say!("     centre of mass: {}", pose.join(", "));
        }
    }
    for note in &report.results.notes {
        summary::tell(note);
    }
}
