//! `dalembert equations`: the labelled equations at a state.

use crate::arguments::{EquationsArgs, EquationsBasis, EquationsFrame};
use crate::failure::Failure;
use crate::load::load;
use crate::output::write_text;
use dalembert::analysis::{Assembly, EquationBasis, Equations, ReferenceFrame};

/// Prints the equations at the assembled start.
pub fn run(args: &EquationsArgs) -> Result<(), Failure> {
    let loaded = load(&args.model, |model| {
        if let Some(time) = &args.time {
            model.analysis.start = Some(crate::load::number_or_text(time));
            // The end only matters to runs; it must stay behind the start.
            model.analysis.end = None;
        }
    })?;
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
