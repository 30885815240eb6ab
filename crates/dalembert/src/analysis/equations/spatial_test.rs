//! Equations of motion of spatial bodies.

use super::{EquationBasis, Equations, EquationsReport, ReferenceFrame};
use crate::space::orientation::Rotation;
use crate::space::{Space, Spatial, Tuple};
use crate::system::test_machine::Machine;
use crate::system::{State, System, Workspace};
use nalgebra::{DMatrix, DVector, Matrix3, Vector3, Vector6};

const G: f64 = 9.81;

/// Mass points whose centre is the origin: [kg], [m].
fn points() -> Vec<(f64, Vector3<f64>)> {
    let mut list = vec![
        (1.0, Vector3::new(0.4, 0.1, -0.2)),
        (0.5, Vector3::new(-0.1, 0.5, 0.3)),
        (0.7, Vector3::new(0.2, -0.3, 0.6)),
        (0.9, Vector3::new(-0.5, -0.2, 0.1)),
    ];
    let mass: f64 = list.iter().map(|p| p.0).sum();
    let center = list.iter().map(|(m, p)| *m * p).sum::<Vector3<f64>>() / mass;
    for (_, p) in &mut list {
        *p -= center;
    }
    list
}

fn tensor() -> Matrix3<f64> {
    let one = |(m, p): (f64, Vector3<f64>)| {
        m * (p.norm_squared() * Matrix3::identity() - p * p.transpose())
    };
    points().into_iter().map(one).sum()
}

const FRAME: [f64; 3] = [0.3, -0.7, 0.2];

fn turned() -> Rotation {
    Rotation::from_euler_angles(0.9, -0.4, 1.3)
}

/// A body of the mass points with a frame of its own, in some motion; held at its frame's origin or free.
fn body(held: bool) -> (System<Spatial>, State) {
    let mut machine = Machine::default();
    let turn = Rotation::from_euler_angles(-0.5, 1.2, 0.4);
    let mass = points().iter().map(|p| p.0).sum();
    let number = machine.body("rock", [0.2, 0.9, -0.4], turn, mass, tensor());
    machine.frame(number, FRAME, turned());
    if held {
        let at = Vector3::new(0.2, 0.9, -0.4) + turn * Vector3::from(FRAME);
        let ground = machine.marker(None, at.into(), Matrix3::identity());
        let own = machine.bodies[number].frame_marker;
        machine.spherical("ball", [ground, own]);
    }
    let system = machine.build(G);
    let mut state = system.estimate.clone();
    let omega = Vector3::new(1.1, -2.0, 0.7);
    let velocity = if held {
        -(turn * omega.cross(&Vector3::from(FRAME)))
    } else {
        Vector3::new(0.3, 0.1, -0.6)
    };
    state.v = [velocity.as_slice(), omega.as_slice()].concat();
    (system, state)
}

fn run(frame: ReferenceFrame, held: bool) -> (EquationsReport, System<Spatial>, State) {
    let (system, state) = body(held);
    let equations = Equations {
        frame,
        ..Equations::default()
    };
    (equations.run(&system, &state).unwrap(), system, state)
}

fn near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (x, y) in found.iter().zip(expected) {
        assert!((x - y).abs() <= tolerance, "{found:?} for {expected:?}");
    }
}

/// Velocity of every mass point with user velocities u, its acceleration with u and u' (both linear, angular in the axes
/// of the frame), and the motion of it that each coordinate makes.
struct Points {
    mass: Vec<f64>,
    arms: Vec<Vector3<f64>>,
    axes: Matrix3<f64>,
}

impl Points {
    fn new(system: &System<Spatial>, state: &State) -> Self {
        let mut ws = Workspace::new(system);
        system.update_markers(&state.q, &state.v, &mut ws);
        let frame = ws.markers[system.bodies[0].frame_marker];
        let arm = |(_, p): &(f64, Vector3<f64>)| frame.body * (p - Vector3::from(FRAME));
        Self {
            mass: points().iter().map(|p| p.0).collect(),
            arms: points().iter().map(arm).collect(),
            axes: frame.axes,
        }
    }

    fn motion(&self, point: usize, u: &[f64]) -> Vector3<f64> {
        let omega = self.axes * Vector3::new(u[3], u[4], u[5]);
        Vector3::new(u[0], u[1], u[2]) + omega.cross(&self.arms[point])
    }

    fn normal(&self, point: usize, u: &[f64]) -> Vector3<f64> {
        let omega = self.axes * Vector3::new(u[3], u[4], u[5]);
        omega.cross(&omega.cross(&self.arms[point]))
    }

    fn along(&self, k: usize, of: impl Fn(usize) -> Vector3<f64>) -> f64 {
        let mut unit = [0.0; 6];
        unit[k] = 1.0;
        let parts = (0..self.mass.len()).map(|p| self.mass[p] * self.motion(p, &unit).dot(&of(p)));
        parts.sum()
    }
}

#[test]
fn terms_in_a_frame_of_the_user() {
    let (report, system, state) = run(ReferenceFrame::User, false);
    let oracle = Points::new(&system, &state);
    let u = &report.velocities.values;
    for i in 0..6 {
        for j in 0..6 {
            let mut unit = [0.0; 6];
            unit[j] = 1.0;
            let m = oracle.along(i, |p| oracle.motion(p, &unit));
            assert!((report.mass.values[i][j] - m).abs() < 1e-14, "M {i} {j}");
        }
        let inertial = -oracle.along(i, |p| oracle.normal(p, u));
        assert!(
            (report.centrifugal.values[i] - inertial).abs() < 1e-13,
            "Q_v {i}"
        );
        let weight = oracle.along(i, |_| Vector3::new(0.0, 0.0, -G));
        assert!((report.applied.values[i] - weight).abs() < 1e-13, "Q_e {i}");
    }
    // q: the origin and axes of the frame.
    let mut ws = Workspace::new(&system);
    system.update_markers(&state.q, &state.v, &mut ws);
    let frame = &ws.markers[system.bodies[0].frame_marker];
    let pose = Spatial::pose(&report.positions.values);
    assert!((pose.point - frame.point).amax() < 1e-15);
    assert!((pose.axes - frame.axes).amax() < 1e-15);
    assert_eq!(report.positions.rows[3], "rock.b0");
    assert_eq!(report.velocities.rows[3], "rock.turn about x");
    let text = report.to_text();
    for words in [
        "rock.b3",
        "Q_v",
        "rock.turn about z",
        "turns about the axes of the body frames",
    ] {
        assert!(text.contains(words), "{text}");
    }
}

#[test]
fn gyroscopic_forces_stand_beside_the_applied_ones() {
    let (report, system, state) = run(ReferenceFrame::Center, false);
    let own = Spatial::gyroscopic(system.mass_block(0), &state.v);
    near(&report.centrifugal.values, own.as_slice(), 0.0);
    let mass = system.mass_block(0)[0];
    near(
        &report.applied.values,
        &[0.0, 0.0, -mass * G, 0.0, 0.0, 0.0],
        1e-15,
    );
    near(&report.positions.values, &state.q, 0.0);
}

#[test]
fn both_frames_tell_of_one_motion() {
    for held in [false, true] {
        let (central, system, state) = run(ReferenceFrame::Center, held);
        let (user, ..) = run(ReferenceFrame::User, held);
        let oracle = Points::new(&system, &state);
        let a = user.accelerations.as_ref().unwrap();
        let c = central.accelerations.as_ref().unwrap();
        let u = &user.velocities.values;
        // Every mass point has one acceleration.
        let pose = Spatial::pose(&state.q);
        let omega = pose.axes * Vector3::from_column_slice(&state.v[3..6]);
        let alpha = pose.axes * Vector3::from_column_slice(&c.values[3..6]);
        let mut sum = 0.0;
        for (k, (m, p)) in points().iter().enumerate() {
            let arm = pose.axes * p;
            let by_user = oracle.motion(k, &a.values) + oracle.normal(k, u);
            let by_center = Vector3::from_column_slice(&c.values[..3])
                + alpha.cross(&arm)
                + omega.cross(&omega.cross(&arm));
            assert!(
                (by_user - by_center).amax() < 1e-12,
                "{by_user} {by_center}"
            );
            sum += 0.5 * m * by_center.norm_squared();
        }
        for report in [&central, &user] {
            let s = &report.scalars;
            assert!((s.gibbs_appel.unwrap() - sum).abs() < 1e-12 * sum);
            assert!((s.kinetic - central.scalars.kinetic).abs() < 1e-14 * s.kinetic);
            assert!((s.potential - central.scalars.potential).abs() < 1e-14);
            assert!((s.hamiltonian - s.energy).abs() < 1e-13 * s.energy.abs().max(1.0));
        }
        let lambda = |r: &EquationsReport| r.multipliers.as_ref().unwrap().values.clone();
        near(&lambda(&user), &lambda(&central), 1e-11);
    }
}

/// A body held at the origin of its frame turns by Euler's equations about that point: Mbar is the inertia about it.
#[test]
fn a_held_body_in_independent_velocities() {
    let (system, state) = body(true);
    let own = |axis: &str| format!("rock.turn about {axis}");
    let equations = Equations {
        independent: ["x", "y", "z"].map(own).to_vec(),
        ..Equations::default()
    };
    let report = equations.run(&system, &state).unwrap();
    let found = report.independent.as_ref().unwrap();
    assert_eq!(found.force.rows, ["x", "y", "z"].map(own));
    let turn = *turned().to_rotation_matrix().matrix();
    let mut about = Matrix3::zeros();
    let mut first = Vector3::zeros();
    for (m, p) in points() {
        let arm = turn.tr_mul(&(p - Vector3::from(FRAME)));
        about += m * (arm.norm_squared() * Matrix3::identity() - arm * arm.transpose());
        first += m * arm;
    }
    for i in 0..3 {
        near(
            &found.mass.values[i],
            &[0, 1, 2].map(|j| about[(i, j)]),
            1e-13,
        );
    }
    let omega = Vector3::from_column_slice(&report.velocities.values[3..6]);
    let axes = Spatial::pose(&report.positions.values).axes;
    let weight = first.cross(&axes.tr_mul(&Vector3::new(0.0, 0.0, -G)));
    let expected = weight - omega.cross(&(about * omega));
    near(&found.force.values, expected.as_slice(), 1e-12);
    let solved = about.lu().solve(&expected).unwrap();
    near(
        &found.accelerations.as_ref().unwrap().values,
        solved.as_slice(),
        1e-12,
    );
    for basis in [EquationBasis::Qr, EquationBasis::Svd] {
        let quasi = Equations {
            basis,
            ..Equations::default()
        };
        let other = quasi.run(&system, &state).unwrap();
        let b = |r: &EquationsReport| {
            let i = r.independent.as_ref().unwrap();
            let rows = &i.motions.values;
            let matrix = DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j]);
            let a = DVector::from_vec(i.accelerations.as_ref().unwrap().values.clone());
            matrix * a + DVector::from_vec(i.acceleration_offset.values.clone())
        };
        assert!((b(&other) - b(&report)).amax() < 1e-12);
    }
}

#[test]
fn frames_and_centres_lead_to_each_other() {
    let (system, state) = body(false);
    let mut ws = Workspace::new(&system);
    system.update_markers(&state.q, &state.v, &mut ws);
    let data = &system.bodies[0];
    let marker = &ws.markers[data.frame_marker];
    let own = Spatial::own_velocity(marker);
    let back = Spatial::from_own(&data.frame, marker, &own);
    near(back.as_slice(), &state.v, 1e-15);
    let zero: Vector6<f64> = Tuple::zero();
    assert_eq!(Spatial::from_own(&data.frame, marker, &zero), zero);
}
