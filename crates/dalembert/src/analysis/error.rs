//! Why an analysis could not be done.

use crate::joint::Lost;
use crate::solve::RankError;
use crate::words::{counted, readable};
use thiserror::Error;

/// Why an analysis could not be done: what, where, when, and what to do.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum AnalysisError {
    /// The constraints cannot be met at the same time near the estimate.
    #[error(
        "the machine cannot be assembled at t = {} s: after {} {worst} is still off by {}{conflict}",
        readable(*time),
        counted(*iterations, "iteration"),
        readable(*residual)
    )]
    NotAssembled {
        /// Time [s].
        time: f64,
        /// Newton iterations.
        iterations: usize,
        /// The row with the largest residual, in words.
        worst: String,
        /// Its residual in SI units.
        residual: f64,
        /// Constraints that contradict each other, in words; empty where none was found.
        conflict: String,
    },
    /// The rows of joints hold, but with axes that point against each other, or are exchanged.
    #[error(
        "the machine came together wrongly at t = {} s: the axes of {elements} do not point the same way; turn the estimates \
         of their bodies nearer to the pose that is meant, or reverse an axis",
        readable(*time)
    )]
    WrongSide {
        /// Time [s].
        time: f64,
        /// The joints, in words.
        elements: String,
    },
    /// Surfaces whose rows hold, but whose bodies lie on the same side, or behind a pole.
    #[error(
        "the machine came together wrongly at t = {} s: in {elements} the bodies would lie on the same side of their surfaces; \
         turn or move the estimates of the bodies nearer to the pose that is meant, give `parameters` of the contact, or \
         reverse the z axis of a surface's frame (axes)",
        readable(*time)
    )]
    WrongSurface {
        /// Time [s].
        time: f64,
        /// The contacts, in words.
        elements: String,
    },
    /// Surfaces that touch, but run into each other beside the contact.
    #[error(
        "the machine came together wrongly at t = {} s: the surfaces of {element} cross where they touch, the bodies would \
         pass through each other: there, along the same line, the first surface is {} and the second {}; take other sizes, \
         or move the estimates of the bodies, or `parameters`, to a place where the surfaces fit",
        readable(*time),
        bend(curvatures[0], curvatures[1]),
        bend(curvatures[1], curvatures[0])
    )]
    CrossingSurfaces {
        /// Time [s].
        time: f64,
        /// The contact, in words.
        element: String,
        /// Curvatures of the first and the second surface in the direction in which they cross, hollow positive [1/m].
        curvatures: [f64; 2],
    },
    /// A contact came to a pole of a surface's parameters.
    #[error(
        "at t = {time:.6} s the contact {element} came to a pole of the {surface} surface, where its parameters a and b do \
         not determine the tangents; {remedy}"
    )]
    SurfacePole {
        /// The contact, in words.
        element: String,
        /// "first" or "second".
        surface: &'static str,
        /// Time [s].
        time: f64,
        /// What to do.
        remedy: &'static str,
    },
    /// Surfaces that touched in a point touch along a line.
    #[error(
        "at t = {time:.6} s the surfaces of {element} touch along a line, or fit into each other: their point of contact is \
         not determined there; end the motion before, or use a joint that holds the line (start the machine with the line \
         in contact)"
    )]
    LineContact {
        /// The contact, in words.
        element: String,
        /// Time [s].
        time: f64,
    },
    /// Rows that hold for velocities only leave the positions to the way that a machine takes.
    #[error(
        "velocities alone are held by {elements} (rolling, a blade): where the machine is depends on its way, which only \
         simulate follows; use simulate"
    )]
    Nonholonomic {
        /// The elements, in words.
        elements: String,
    },
    /// Orientation coordinates in the plane.
    #[error(
        "a planar machine has no orientation coordinates: its bodies have angles already; leave the set out"
    )]
    PlanarOrientation,
    /// Orientation coordinates whose rates are not determined at a pose.
    #[error(
        "body '{body}' stands at a singular pose of {set}: their rates are not determined there; use another set, \
         euler-parameters or {better}"
    )]
    SingularOrientation {
        /// Body.
        body: String,
        /// The set.
        set: String,
        /// A set that is regular at this pose.
        better: String,
    },
    /// The machine can still move although its motion should be given by drivers.
    #[error(
        "the machine is not driven in every freedom: {} free ({}{names}); add drivers or use simulate",
        if *freedoms == 1 { "1 remains".to_owned() } else { format!("{freedoms} remain") },
        // More names than freedoms: they depend on each other.
        if names.split(", ").count() > *freedoms { "of " } else { "" }
    )]
    NotDriven {
        /// Number of free motions.
        freedoms: usize,
        /// Coordinates that can move, in words.
        names: String,
    },
    /// The driven machine came to a singular pose.
    #[error(
        "singular pose at t = {time:.6} s ({kind}): {detail}; results are kept until t = {last:.6} s"
    )]
    Singular {
        /// Time at which the pose was found [s].
        time: f64,
        /// Last good time [s].
        last: f64,
        /// "dead centre or bifurcation", ...
        kind: &'static str,
        /// What depends on what, and what to do.
        detail: String,
    },
    /// Initial rates that the constraints, the drivers or each other do not allow.
    #[error(
        "the initial rates contradict the constraints, the drivers or each other at t = {} s: {conflicts}; leave one out, or change it",
        readable(*time)
    )]
    InitialRates {
        /// Time [s].
        time: f64,
        /// What was stated and what would be nearest, in words.
        conflicts: String,
    },
    /// Drivers and constraints that agree up to a time ask for different motions afterwards.
    #[error(
        "{elements} contradict each other after t = {} s: they ask for different motions; leave one of the drivers out, or change one; results are kept until then",
        readable(*time)
    )]
    Contradiction {
        /// Last good time [s].
        time: f64,
        /// The elements, in words.
        elements: String,
    },
    /// Masses are missing where the motion depends on them.
    #[error(
        "masses are missing: {names}; give mass and inertia of these bodies, or hold them by joints"
    )]
    Massless {
        /// The coordinates that no mass and no constraint hold.
        names: String,
    },
    /// A force element or constraint gave a number that is not finite.
    #[error(
        "{element} gives a value that is not finite at t = {} s; check its expression and the pose",
        readable(*time)
    )]
    NotFinite {
        /// The element in words.
        element: String,
        /// Time [s].
        time: f64,
    },
    /// A step of fixed size failed.
    #[error(
        "at t = {} s the step of {} s failed: {detail}; give a smaller fixed_step, or a method that chooses its steps \
         (integrator = \"dopri5\")",
        readable(*time),
        readable(*step)
    )]
    StepFailed {
        /// Time at the start of the step [s].
        time: f64,
        /// The step [s].
        step: f64,
        /// Why.
        detail: String,
    },
    /// The step size became too small.
    #[error(
        "the integration stopped at t = {} s: the step shrank to {step:.3e} s; {detail}",
        readable(*time)
    )]
    StepTooSmall {
        /// Time [s].
        time: f64,
        /// Step [s].
        step: f64,
        /// What was seen and what to try.
        detail: String,
    },
    /// The simulation used up its steps, or would do so long before its end.
    #[error("the simulation stopped at t = {time:.6} s after {steps} step{}: {detail}", if *steps == 1 { "" } else { "s" })]
    OutOfSteps {
        /// Time [s].
        time: f64,
        /// Steps made.
        steps: usize,
        /// What held it up and what to do.
        detail: String,
    },
    /// Two points met between which an element has its direction.
    #[error(
        "at t = {time:.6} s the two points of {element} meet: their distance has no direction there; {remedy}"
    )]
    NoDirection {
        /// The element in words.
        element: String,
        /// Time [s].
        time: f64,
        /// What to do.
        remedy: &'static str,
    },
    /// A vector vanished from which an element takes a direction or an angle.
    #[error("at t = {time:.6} s {element} {lost}; {}", lost.remedy())]
    Lost {
        /// The element in words.
        element: String,
        /// Time [s].
        time: f64,
        /// What it lost.
        lost: Lost,
    },
    /// No static equilibrium was found.
    #[error(
        "no static equilibrium was found: {reason}; what remains at {coordinate} is {residual:.3e} N or N m"
    )]
    NoEquilibrium {
        /// Coordinate with the largest unbalanced force.
        coordinate: String,
        /// That force [N] or moment [N m].
        residual: f64,
        /// Why, and what to do.
        reason: String,
    },
    /// A name that the analysis was given does not exist or does not fit.
    #[error("{what} '{name}': {detail}")]
    BadName {
        /// "joint", "coordinate", ...
        what: &'static str,
        /// The name.
        name: String,
        /// What to do.
        detail: String,
    },
    /// The actuators named for `inverse` cannot produce the motion.
    #[error(
        "{} named, but the driven motion has {}; name exactly {}",
        if *given == 1 { "1 actuator is".to_owned() } else { format!("{given} actuators are") },
        counted(*needed, "driver"),
        counted(*needed, "joint")
    )]
    ActuatorCount {
        /// Given.
        given: usize,
        /// Needed.
        needed: usize,
    },
    /// The rank of the constraints could not be decided.
    #[error("the rank of the constraints could not be decided: {0}")]
    Rank(#[from] RankError),
}

/// How a surface bends in a direction, beside another: curvature [1/m], hollow positive.
fn bend(own: f64, other: f64) -> String {
    if own.abs() <= 1e-9 * other.abs() {
        return "flat".to_owned();
    }
    let kind = if own > 0.0 { "hollow" } else { "round" };
    format!("{kind} with a radius of {} m", readable(1.0 / own.abs()))
}
