//! A spatial system put together by hand: Shabana, Example 7.12, the manipulator with two revolute joints. The book is
//! symbolic; the numbers were found by Lagrange's equations, by its recursive formulation and by Newton-Euler.

use super::{BodyData, ElementData, ForceData, MarkerData, Phase, Role, State, System, Workspace};
use crate::force::MeasureForce;
use crate::joint::{Measure, MeasureRow, MeasureRows, SpatialMeasure};
use crate::signal::Coefficient;
use crate::space::orientation::{Axis, Rotation, triad};
use crate::space::{Space, Spatial, SpatialFrame, Tuple};
use nalgebra::{Matrix3, Vector3};
use smallvec::{SmallVec, smallvec};
use std::sync::Arc;

const EXACT: f64 = 4e-14;

const U_Q2: [f64; 3] = [0.02, -0.25, 0.03];
const U_P2: [f64; 3] = [0.05, 0.25, 0.1];
const U_P3: [f64; 3] = [-0.3, 0.02, -0.04];
const R_Q: [f64; 3] = [0.1, 0.2, -0.1];

fn between(kind: SpatialMeasure) -> Measure<Spatial> {
    Measure {
        kind,
        first: 0,
        second: 1,
    }
}

/// Points together, z axes aligned.
fn revolute(name: &str, markers: [usize; 2]) -> ElementData<Spatial> {
    let minus = |kind, label| MeasureRow::minus(between(kind), 0.0, label);
    let rows = smallvec![
        minus(SpatialMeasure::Ground(Axis::X), "x"),
        minus(SpatialMeasure::Ground(Axis::Y), "y"),
        minus(SpatialMeasure::Ground(Axis::Z), "z"),
        minus(SpatialMeasure::Dot(Axis::X, Axis::Z), "tilt about y"),
        minus(SpatialMeasure::Dot(Axis::Y, Axis::Z), "tilt about x"),
    ];
    ElementData {
        name: name.to_owned(),
        role: Role::Joint,
        kind: "revolute".to_owned(),
        path: String::new(),
        phase: Phase::Always,
        element: Arc::new(MeasureRows::new(2, rows)),
        markers: SmallVec::from_slice(&markers),
        reaction_marker: 1,
        axes_marker: 0,
        coordinates: SmallVec::new(),
        auxiliary_start: SmallVec::new(),
        scale: 1.0,
        bodies: SmallVec::new(),
        slots: SmallVec::new(),
        rows: 0..0,
        aux: 0..0,
    }
}

fn motor(name: &str, markers: [usize; 2], moment: f64) -> ForceData<Spatial> {
    ForceData {
        name: name.to_owned(),
        kind: "actuator".to_owned(),
        path: String::new(),
        element: Arc::new(MeasureForce {
            measure: between(SpatialMeasure::Angle(Axis::Z)),
            stiffness: Coefficient::Constant(0.0),
            damping: Coefficient::Constant(0.0),
            free: Coefficient::Constant(0.0),
            actuator: Coefficient::Constant(-moment),
            pushes: true,
        }),
        markers: SmallVec::from_slice(&markers),
    }
}

fn manipulator() -> System<Spatial> {
    let upright = *triad(&Vector3::y()).unwrap().to_rotation_matrix().matrix();
    let marker = |body, at: [f64; 3], axes| MarkerData {
        body,
        frame: SpatialFrame {
            at: Vector3::from(at),
            axes,
        },
    };
    let plain = Matrix3::identity();
    let markers = vec![
        marker(None, R_Q, upright),
        marker(Some(0), U_Q2, upright),
        marker(Some(0), U_P2, plain),
        marker(Some(1), U_P3, plain),
        marker(Some(0), [0.0; 3], plain),
        marker(Some(1), [0.0; 3], plain),
    ];
    let body = |name: &str, marker| BodyData {
        name: name.to_owned(),
        index: 0,
        frame: SpatialFrame::default(),
        frame_marker: marker,
        center_marker: marker,
        massless: false,
    };
    let block = |mass: f64, inertia: [[f64; 3]; 3]| {
        let mut block = vec![0.0; 36];
        for i in 0..3 {
            block[7 * i] = mass;
            for j in 0..3 {
                block[6 * (3 + i) + 3 + j] = inertia[i][j];
            }
        }
        block
    };
    let mut mass = block(4.0, [[0.12, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.1]]);
    mass.extend(block(
        2.5,
        [
            [0.02, 0.004, 0.0],
            [0.004, 0.09, -0.003],
            [0.0, -0.003, 0.085],
        ],
    ));
    let mut system = System::new(
        "manipulator".to_owned(),
        vec![body("2", 4), body("3", 5)],
        markers,
        vec![revolute("Q", [0, 1]), revolute("P", [2, 3])],
        vec![motor("T2", [0, 1], 3.0), motor("T3", [2, 3], 5.0)],
        Vec::new(),
        mass,
        vec![0.0, -9.81, 0.0],
    );
    system.set_size();
    system.set_masses();
    system
}

/// The pose of joint angles 0.4 and 0.3 rad with 1.2 and -0.7 rad/s.
fn state() -> State {
    let second = Rotation::from_axis_angle(&Vector3::y_axis(), 0.4);
    let third = second * Rotation::from_axis_angle(&Vector3::z_axis(), 0.3);
    let [q2, p2, p3] = [
        second * Vector3::from(U_Q2),
        second * Vector3::from(U_P2),
        third * Vector3::from(U_P3),
    ];
    let omega2 = Vector3::new(0.0, 1.2, 0.0);
    let omega3 = omega2 - 0.7 * (second * Vector3::z());
    let r2 = Vector3::from(R_Q) - q2;
    let v2 = -omega2.cross(&q2);
    let r3 = r2 + p2 - p3;
    let v3 = v2 + omega2.cross(&p2) - omega3.cross(&p3);
    let mut state = State::default();
    for (r, turn, v, omega) in [(r2, second, v2, omega2), (r3, third, v3, omega3)] {
        state
            .q
            .extend([r.x, r.y, r.z, turn.w, turn.i, turn.j, turn.k]);
        let own = turn.inverse() * omega;
        state.v.extend([v.x, v.y, v.z, own.x, own.y, own.z]);
    }
    state
}

fn near(found: &[f64], expected: &[f64]) {
    for (x, y) in found.iter().zip(expected) {
        assert!(
            (x - y).abs() <= EXACT * y.abs().max(1.0),
            "{found:?} for {expected:?}"
        );
    }
}

#[test]
fn accelerations_and_reactions() {
    let (system, state) = (manipulator(), state());
    let mut ws = Workspace::new(&system);
    system.update_markers(&state.q, &state.v, &mut ws);
    system.evaluate_constraints(0.0, &mut ws);
    assert!(system.violation(&ws).0 < 1e-15);
    system.evaluate_forces(0.0, &mut ws);
    let mut rate = vec![0.0; system.rows];
    system.jac_mul(&ws, &state.v, &mut rate);
    assert!(system.largest(&rate).0 < 1e-15);
    ws.rhs.copy_from_slice(&ws.qd);
    ws.factor(&system.metric.inverse);
    assert!(ws.solve_forces(&system.mass).converged);
    // In ground axes: the centre's acceleration and the angular one.
    let ground = |body: usize| -> Vec<f64> {
        let (m, a) = (&ws.markers[4 + body], &ws.a[6 * body..6 * body + 6]);
        let a = nalgebra::Vector6::from_column_slice(a);
        let mut total = Spatial::push(m, &a);
        total.add_scaled(1.0, &Spatial::bias(m));
        total.as_slice().to_vec()
    };
    near(
        &ground(0),
        &[
            -0.083_811_938_590_488,
            0.0,
            0.221_486_307_146_818_8,
            0.0,
            6.408_224_601_354_748,
            0.0,
        ],
    );
    near(
        &ground(1),
        &[
            -0.382_266_885_373_528_04,
            -2.044_379_310_953_854_4,
            -2.381_065_237_207_607_3,
            -3.449_989_932_491_421_4,
            6.408_224_601_354_748,
            -6.002_930_274_577_788,
        ],
    );
    // The rows read first - second: the multipliers of the points are the forces on the second body.
    near(
        &ws.lambda[..3],
        &[
            -1.290_914_967_795_772_3,
            58.654_051_722_615_364,
            -5.066_717_864_431_741,
        ],
    );
    near(
        &ws.lambda[5..8],
        &[
            -0.955_667_213_433_820_2,
            19.414_051_722_615_362,
            -5.952_663_093_019_017,
        ],
    );
}
