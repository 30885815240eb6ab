//! The command line.

use clap::builder::PossibleValuesParser;
use clap::{Args, Parser, Subcommand, ValueEnum};
use dalembert::model::Method;
use dalembert::space::orientation::OrientationSet;
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
    /// Validate a model and report its mobility: redundant constraints, free motions, singular poses
    Check(CheckArgs),
    /// Positions, velocities, accelerations and forces of a driven machine
    Kinematics(RunArgs),
    /// Forward dynamics: how the machine moves under its forces
    Simulate(RunArgs),
    /// Driving forces and reactions of a driven machine; also with the actuators at other joints
    Inverse(InverseArgs),
    /// Equilibrium and its stability; or the loads that hold a pose
    Statics(StaticsArgs),
    /// The labelled equations of motion at the start: M, C_q, Q_e, Q_d, multipliers, energies
    Equations(EquationsArgs),
    /// The machine as a linear graph: trees, cut-sets, circuits, sizes of formulations
    Network(NetworkArgs),
    /// Write an animated page that opens in any browser
    View(ViewArgs),
    /// Draw channels of a result file as SVG
    Plot(PlotArgs),
    /// Print the JSON Schema of model files (for completion in editors)
    Schema,
}

impl Command {
    /// The model that it works on.
    pub fn model(&self) -> Option<&ModelArgs> {
        match self {
            Self::Kinematics(a) | Self::Simulate(a) => Some(&a.model),
            Self::Inverse(a) => Some(&a.run.model),
            Self::View(a) => Some(&a.run.model),
            Self::Statics(a) => Some(&a.run.model),
            Self::Check(a) => Some(&a.model),
            Self::Equations(a) => Some(&a.model),
            Self::Network(a) => Some(&a.model),
            Self::New(_) | Self::Plot(_) | Self::Schema => None,
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
    /// Set a parameter of the model, like crank="120 mm", in its dimension; a bare number is in SI;
    /// can be repeated
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
    /// Start time, for statics the time of the forces [s]
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub start: Option<String>,
    /// End time [s]; not for statics
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub end: Option<String>,
    /// Time between results [s]; not for statics
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub step: Option<String>,
    /// Relative error tolerance of the integration; for simulate and view
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub tolerance: Option<String>,
    /// Method of the integration, like dop853, adams or rk4; for simulate and view
    #[arg(long, value_name = "METHOD", value_parser = PossibleValuesParser::new(Method::NAMES.map(|(name, _)| name)))]
    pub integrator: Option<String>,
    /// Step of methods with steps of one size [s]; for simulate and view
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub fixed_step: Option<String>,
    /// Channels to write, like "crank.*"; default as the model says, or all; can be repeated
    #[arg(long, value_name = "PATTERN")]
    pub channels: Vec<String>,
    /// Draw these channels over time as SVG, like "crank.angle,rod.angle"
    #[arg(long, value_name = "PATTERNS")]
    pub plot: Option<String>,
    /// File of the plot; default MODEL-COMMAND.svg beside the model
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

/// Arguments of `check`.
#[derive(Args, Debug)]
pub struct CheckArgs {
    /// Model.
    #[command(flatten)]
    pub model: ModelArgs,
}

/// Route of the static analysis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum StaticsRoute {
    /// Newton on the free motions.
    Reduced,
    /// Newton on coordinates and multipliers together.
    Multipliers,
}

/// Arguments of `statics`.
#[derive(Args, Debug)]
pub struct StaticsArgs {
    /// Run.
    #[command(flatten)]
    pub run: RunArgs,
    /// Route
    #[arg(long, value_enum, default_value_t = StaticsRoute::Reduced)]
    pub route: StaticsRoute,
    /// Further starts of the search for other equilibria [default: 24, fewer above 50 freedoms]
    #[arg(long)]
    pub starts: Option<usize>,
    /// Find the effort at this joint or driver that holds the machine in its pose; can be repeated
    #[arg(long, value_name = "JOINT")]
    pub hold: Vec<String>,
    /// Find the size of this force element that holds the machine in its pose; can be repeated
    #[arg(long, value_name = "FORCE")]
    pub hold_force: Vec<String>,
}

/// Coordinates of the equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum EquationsBasis {
    /// Absolute coordinates and multipliers only.
    Absolute,
    /// Also independent coordinates by pivoted elimination (embedding technique).
    Lu,
    /// Also orthonormal quasi-velocities by QR.
    Qr,
    /// Also orthonormal quasi-velocities by singular values.
    Svd,
}

/// Reference points of the equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum EquationsFrame {
    /// The body frames of the file.
    User,
    /// The centres of mass.
    Center,
}

/// A set of orientation coordinates by its name.
fn orientation_set(text: &str) -> Result<OrientationSet, String> {
    text.parse().map_err(|_| {
        "use euler-parameters, rodriguez, axis-angle, direction-cosines, or Euler angles like euler-zxz or \
         euler-xyz-space"
            .to_owned()
    })
}

/// Arguments of `equations`.
#[derive(Args, Debug)]
pub struct EquationsArgs {
    /// Model.
    #[command(flatten)]
    pub model: ModelArgs,
    /// Coordinates beside the absolute ones
    #[arg(long, value_enum, default_value_t = EquationsBasis::Lu)]
    pub basis: EquationsBasis,
    /// Independent coordinate, like crank.angle; can be repeated
    #[arg(long, value_name = "COORDINATE")]
    pub independent: Vec<String>,
    /// Reference points of the bodies
    #[arg(long, value_enum, default_value_t = EquationsFrame::User)]
    pub frame: EquationsFrame,
    /// Generalized coordinates of the orientations of spatial machines: euler-parameters, rodriguez, axis-angle,
    /// direction-cosines, or Euler angles like euler-zxz or euler-xyz-space; default turns about the axes of the bodies
    #[arg(long, value_name = "SET", value_parser = orientation_set)]
    pub orientation: Option<OrientationSet>,
    /// Time at which drivers and forces are evaluated [s]; default the start of the analysis
    #[arg(long, value_name = "TIME")]
    pub time: Option<String>,
    /// Write to this file
    #[arg(long, short, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// Arguments of `network`.
#[derive(Args, Debug)]
pub struct NetworkArgs {
    /// Model.
    #[command(flatten)]
    pub model: ModelArgs,
    /// Write the graph in the DOT language to this file
    #[arg(long, value_name = "FILE")]
    pub dot: Option<PathBuf>,
}
