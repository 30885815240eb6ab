//! `dalembert equations`: the labelled equations at a state.

use crate::arguments::{EquationsArgs, EquationsBasis, EquationsFrame};
use crate::failure::Failure;
use crate::load::{Loaded, in_its_space, load, move_to};
use crate::output::write_text;
use dalembert::analysis::{Assembly, EquationBasis, Equations, ReferenceFrame};
use dalembert::system::compile::ModelSpace;

/// Prints the equations at the assembled start.
pub fn run(args: &EquationsArgs) -> Result<(), Failure> {
    in_its_space!(load(&args.model, |_| {})?, loaded => equations(args, loaded))
}

fn equations<S: ModelSpace>(args: &EquationsArgs, mut loaded: Loaded<S>) -> Result<(), Failure> {
    if let Some(time) = &args.time {
        move_to(&mut loaded, &args.model, time)?;
    }
    let system = &loaded.compiled.system;
    let (state, _) = Assembly::default().run(system)?;
    let analysis = Equations {
        basis: match args.basis {
            EquationsBasis::Absolute => EquationBasis::Absolute,
            EquationsBasis::Lu => EquationBasis::Partition,
            EquationsBasis::Qr => EquationBasis::Qr,
            EquationsBasis::Svd => EquationBasis::Svd,
        },
        independent: if args.independent.is_empty() {
            loaded.compiled.options.independent.clone()
        } else {
            args.independent.clone()
        },
        frame: match args.frame {
            EquationsFrame::User => ReferenceFrame::User,
            EquationsFrame::Center => ReferenceFrame::Center,
        },
        orientation: args.orientation,
    };
    let report = analysis.run(&system.running(), &state)?;
    let text = if args.model.json {
        format!("{:#}\n", loaded.with_warnings(serde_json::json!(report)))
    } else {
        report.to_text()
    };
    match &args.out {
        Some(path) => {
            write_text(path, &text)?;
            say!("written: {}", path.display());
        }
        None => say_on!("{text}"),
    }
    Ok(())
}
