//! The command line.

use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

/// Multibody dynamics: describe a machine in a file, get its mobility, motion, forces and equilibrium.
#[derive(Debug, Parser)]
#[command(name = "dalembert", version, about, propagate_version = true)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Print a model to start from
    New(NewArgs),
    /// Positions, velocities, accelerations and forces of a driven machine
    Kinematics(RunArgs),
    /// Forward dynamics: how the machine moves under its forces
    Simulate(RunArgs),
    /// Driving forces and reactions of a driven machine; also with the actuators at other joints
    Inverse(InverseArgs),
    /// Write an animated page that opens in any browser
    View(ViewArgs),
    /// Draw channels of a result file as SVG
    Plot(PlotArgs),
    /// Print the JSON Schema of model files (for completion in editors)
    Schema,
}

impl Command {
    /// Is the answer wanted as JSON?
    pub fn json(&self) -> bool {
        match self {
            Self::Kinematics(a) | Self::Simulate(a) => a.model.json,
            Self::Inverse(a) => a.run.model.json,
            Self::View(a) => a.run.model.json,
            Self::New(_) | Self::Plot(_) | Self::Schema => false,
        }
    }
}

/// Arguments of `new`.
#[derive(Args, Debug)]
pub struct NewArgs {
    /// Template; without it they are listed
    pub template: Option<String>,
}

/// What every command on a model takes.
#[derive(Args, Clone, Debug)]
pub struct ModelArgs {
    /// Model file (TOML)
    pub model: PathBuf,
    /// Set a parameter of the model, like crank="120 mm"; can be repeated
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Print the answer as JSON
    #[arg(long)]
    pub json: bool,
}

/// Arguments of analyses over time.
#[derive(Args, Clone, Debug)]
pub struct RunArgs {
    /// Model.
    #[command(flatten)]
    pub model: ModelArgs,
    /// Write all channels to this file: .csv, .npz or .json; can be repeated
    #[arg(long, short, value_name = "FILE")]
    pub out: Vec<PathBuf>,
    /// Start time [s]
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub start: Option<String>,
    /// End time [s]
    #[arg(long, value_name = "TIME")]
    pub end: Option<String>,
    /// Time between results [s]
    #[arg(long, value_name = "TIME")]
    pub step: Option<String>,
    /// Relative error tolerance of the integration
    #[arg(long, value_name = "NUMBER")]
    pub tolerance: Option<String>,
    /// Channels to write, like "crank.*"; default as the model says, or all; can be repeated
    #[arg(long, value_name = "PATTERN")]
    pub channels: Vec<String>,
    /// Draw these channels over time as SVG, like "crank.angle,rod.angle"
    #[arg(long, value_name = "PATTERNS")]
    pub plot: Option<String>,
    /// File of the plot; default beside the model
    #[arg(long, value_name = "FILE")]
    pub plot_file: Option<PathBuf>,
    /// Write the animated page of the run to this file
    #[arg(long, value_name = "FILE")]
    pub html: Option<PathBuf>,
}

/// Arguments of `plot`.
#[derive(Args, Debug)]
pub struct PlotArgs {
    /// Result file: .csv, .npz or .json
    pub results: PathBuf,
    /// Channels to draw, like "crank.angle" or "*.omega"
    #[arg(required = true, value_name = "CHANNEL")]
    pub channels: Vec<String>,
    /// Channel of the horizontal axis; default the time
    #[arg(long, value_name = "CHANNEL")]
    pub against: Option<String>,
    /// SVG file; default beside the results
    #[arg(long, short, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Title
    #[arg(long)]
    pub title: Option<String>,
    /// Same scale on both axes (for paths of points)
    #[arg(long)]
    pub equal: bool,
}

/// Arguments of `inverse`.
#[derive(Args, Debug)]
pub struct InverseArgs {
    /// Run.
    #[command(flatten)]
    pub run: RunArgs,
    /// Joint that has an actuator instead of the driver; one for each driver
    #[arg(long, value_name = "JOINT")]
    pub actuator: Vec<String>,
}

/// What the page shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ViewAnalysis {
    /// Kinematics where the drivers give the whole motion, else a simulation.
    Auto,
    /// Kinematics.
    Kinematics,
    /// Forward dynamics.
    Simulate,
}

/// Arguments of `view`; its page goes beside the model where `--html` names no file.
#[derive(Args, Debug)]
pub struct ViewArgs {
    /// Run.
    #[command(flatten)]
    pub run: RunArgs,
    /// Which motion
    #[arg(long, value_enum, default_value_t = ViewAnalysis::Auto)]
    pub analysis: ViewAnalysis,
}
