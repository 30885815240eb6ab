//! Small spatial machines for tests, compiled and run.

use dalembert::analysis::{Assembly, Dynamics, DynamicsReport, Mobility, MobilityReport};
use dalembert::model::Model;
use dalembert::space::{Space, Spatial, SpatialPose};
use dalembert::system::compile::{Compiled, compile};
use dalembert::system::{State, System, Workspace};
use nalgebra::Vector3;
use serde_json::{Value, json};

pub const G: f64 = 9.81;

/// Compiles a model; gravity points down unless it says otherwise.
pub fn compiled(mut parts: Value) -> Compiled<Spatial> {
    let gravity = parts
        .as_object_mut()
        .and_then(|map| map.remove("gravity"))
        .unwrap_or_else(|| json!([0, 0, -G]));
    parts["model"] = json!({"name": "test", "space": "spatial", "gravity": gravity});
    let model: Model = serde_json::from_value(parts).expect("a model");
    compile::<Spatial>(&model, &[]).unwrap_or_else(|e| panic!("{e:?}"))
}

/// The assembled start.
pub fn start(system: &System<Spatial>) -> State {
    let (state, report) = Assembly::default()
        .run(system)
        .unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(report.velocity_conflict, None);
    state
}

pub fn mobility(system: &System<Spatial>) -> MobilityReport {
    Mobility::default().run(system, &start(system)).unwrap()
}

/// A run over some instants.
pub fn run(system: &System<Spatial>, instants: &[f64], tolerance: f64) -> DynamicsReport {
    let mut options = Dynamics::new(&Default::default());
    options.instants = instants.to_vec();
    options.tolerance = tolerance;
    let report = options.run(system, &mut |_| true).unwrap();
    assert_eq!(report.stopped, None);
    report
}

/// Everything evaluated at a state of a running system, with accelerations and multipliers.
pub fn solved(system: &System<Spatial>, state: &State) -> Workspace<Spatial> {
    let mut ws = Workspace::new(system);
    system.update_markers(&state.q, &state.v, &mut ws);
    system.evaluate_constraints(state.t, &mut ws);
    system.evaluate_forces(state.t, &mut ws);
    dalembert::formulation::augmented(system, &mut ws).unwrap();
    ws
}

/// Pose, velocity and angular velocity (ground axes) of a body.
pub fn motion(state: &State, body: usize) -> (SpatialPose, Vector3<f64>, Vector3<f64>) {
    let pose = Spatial::pose(&state.q[7 * body..7 * body + 7]);
    let v = &state.v[6 * body..6 * body + 6];
    let omega = pose.axes * Vector3::new(v[3], v[4], v[5]);
    (pose, Vector3::new(v[0], v[1], v[2]), omega)
}

/// Largest minus smallest value of a channel.
pub fn spread(report: &DynamicsReport, channel: &str) -> f64 {
    let values = &report.results.channel(channel).unwrap().values;
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    most - values.iter().copied().fold(f64::INFINITY, f64::min)
}
