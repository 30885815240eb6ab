//! The program `dalembert`: multibody dynamics from a model file.
//!
//! Exit codes: 0 done; 1 the analysis failed or stopped early; 2 the command line is wrong; 3 the
//! model file has mistakes; 4 a file cannot be read or written. With `--json` the output is one JSON
//! object in each of these cases: the results, or `"completed": false` with `"diagnostics"` (a list
//! of mistakes with their places) or `"error"` (a sentence).
#![forbid(unsafe_code)]

#[macro_use]
mod say;
mod arguments;
mod commands;
mod failure;
mod load;
mod output;
mod page;
mod places;
mod scene;
mod summary;
mod viewer;

use arguments::{Arguments, Command};
use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let asked = arguments.command.model().cloned();
    let json = asked.as_ref().is_some_and(|asked| asked.json);
    let done = match arguments.command {
        Command::New(a) => commands::new::run(&a),
        Command::Check(a) => commands::check::run(&a),
        Command::Statics(a) => commands::statics::run(&a),
        Command::Equations(a) => commands::equations::run(&a),
        Command::Network(a) => commands::network::run(&a),
        Command::Kinematics(a) => commands::kinematics::run(&a),
        Command::Simulate(a) => commands::simulate::run(&a),
        Command::Inverse(a) => commands::inverse::run(&a),
        Command::View(a) => commands::view::run(&a),
        Command::Plot(a) => commands::plot::run(&a),
        Command::Schema => commands::schema::run(),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            failure.tell(json);
            if let Some(asked) = asked.filter(|_| failure.is_of_analysis() && !json) {
                for line in places::of_elements(&failure.to_string(), &asked.model) {
                    eprintln!("{line}");
                }
            }
            ExitCode::from(failure.code())
        }
    }
}
