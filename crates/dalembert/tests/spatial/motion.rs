//! The motion subspace of joints: at poses on the manifold the free coordinates and the rows together have full rank, and
//! motions of the joint keep the rows to second order.

use super::joints::joint;
use super::machine::{bodies, evaluated};
use super::support::Random;
use super::{SEED, near};
use dalembert::analysis::Assembly;
use dalembert::space::{Space, Spatial};
use dalembert::system::{ElementData, State, System, Workspace};
use nalgebra::{DMatrix, DVector, Vector3};
use serde_json::{Value, json};

/// Kind, number of rows, freedoms that the joint reports as coordinates, freedoms that it does not.
pub const CATALOGUE: [(&str, usize, usize, usize); 14] = [
    ("weld", 6, 0, 0),
    ("spherical", 3, 0, 3),
    ("revolute", 5, 1, 0),
    ("cylindrical", 4, 2, 0),
    ("prismatic", 5, 1, 0),
    ("universal", 4, 2, 0),
    ("constant-velocity", 4, 0, 2),
    ("screw", 5, 1, 0),
    ("planar", 3, 0, 3),
    ("distance", 1, 0, 5),
    ("point-on-line", 2, 1, 3),
    ("point-on-plane", 1, 0, 5),
    ("parallel-axes", 2, 0, 4),
    ("perpendicular-axes", 1, 0, 5),
];

/// Two bodies with a joint, whose directions the estimate nearly meets, moved and put on the manifold.
pub fn on_manifold(joint: &Value, source: &mut Random) -> (System<Spatial>, State) {
    let mut list = bodies();
    list.as_array_mut().unwrap().truncate(2);
    // Each of a and b somewhere else, turned by a random angle about a random axis.
    for body in list.as_array_mut().unwrap() {
        let mut draw = || source.uniform(-1.0, 1.0);
        body["position"] = json!([draw(), draw(), draw()]);
        body["orientation"] = json!({"axis": [draw(), draw(), draw()], "angle": 3.0 * draw()});
    }
    let model = json!({"body": list, "joint": [joint]});
    let all = super::machine::compiled(model).system;
    // From estimates far off, the rows may also hold with axes against each other: then from elsewhere.
    match Assembly::default().run(&all) {
        Ok((mut state, _)) => {
            state.v = (0..all.nv()).map(|_| source.uniform(-1.0, 1.0)).collect();
            (all.running(), state)
        }
        Err(_) => on_manifold(joint, source),
    }
}

pub fn rank(matrix: &DMatrix<f64>) -> usize {
    matrix
        .clone()
        .svd(false, false)
        .rank(1e-9 * matrix.amax().max(1e-9))
}

/// Columns: a basis of the null space, by complement of the row space.
pub fn null_space(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let square = matrix.transpose() * matrix;
    let eigen = square.symmetric_eigen();
    let largest = eigen.eigenvalues.amax();
    let columns: Vec<DVector<f64>> = (0..matrix.ncols())
        .filter(|&k| eigen.eigenvalues[k].abs() < 1e-12 * largest)
        .map(|k| eigen.eigenvectors.column(k).into_owned())
        .collect();
    DMatrix::from_columns(&columns)
}

/// Gradients of the free coordinates of an element in the velocity coordinates.
fn gradients(
    system: &System<Spatial>,
    ws: &Workspace<Spatial>,
    e: &ElementData<Spatial>,
) -> DMatrix<f64> {
    let markers = ws.seen(&e.markers);
    let mut out = DMatrix::zeros(e.coordinates.len(), system.nv());
    for (r, c) in e.coordinates.iter().enumerate() {
        let m = c.measure.evaluate(&markers);
        for (local, gradient) in [(c.measure.first, m.first), (c.measure.second, m.second)] {
            if let Some(b) = system.markers[e.markers[local]].body {
                let pulled = Spatial::pull(&markers[local], &gradient);
                for k in 0..6 {
                    out[(r, 6 * b + k)] += pulled.as_slice()[k];
                }
            }
        }
    }
    out
}

#[test]
fn coordinates_complete_the_rows() {
    let mut source = Random::new(SEED);
    for (kind, rows, reported, silent) in CATALOGUE {
        for between in [["a", "b"], ["ground", "b"]] {
            for pose in 0..5 {
                let what = format!("{kind} between {between:?}, pose {pose}");
                let (system, state) = on_manifold(&joint("J", kind, between), &mut source);
                let ws = evaluated(&system, &state);
                assert!(
                    system.violation(&ws).0 < 1e-12,
                    "{what}: not on the manifold"
                );
                let jacobian = system.dense_jacobian(&ws);
                let e = &system.elements[0];
                assert_eq!((system.rows, rank(&jacobian)), (rows, rows), "{what}");
                assert_eq!(e.coordinates.len(), reported, "{what}: coordinates");
                assert_eq!(rows + reported + silent, 6, "{what}: freedoms");
                let own = gradients(&system, &ws, e);
                let mut both = jacobian.clone().resize_vertically(rows + reported, 0.0);
                both.rows_mut(rows, reported).copy_from(&own);
                assert_eq!(rank(&both), rows + reported, "{what}: with coordinates");

                let null = null_space(&jacobian);
                assert_eq!(null.ncols(), system.nv() - rows, "{what}: motions");
                second_order(&what, &system, &state, &null, &mut source);
                rates(&what, kind, &system, &state, &null);
            }
        }
    }
}

/// With velocities of the joint's motion and the accelerations that Q_d asks for, C vanishes to third order in time.
fn second_order(
    what: &str,
    system: &System<Spatial>,
    state: &State,
    null: &DMatrix<f64>,
    source: &mut Random,
) {
    if null.ncols() == 0 {
        return;
    }
    let mix = DVector::from_fn(null.ncols(), |_, _| source.uniform(-1.0, 1.0));
    let v = null * mix;
    let moving = State {
        v: v.as_slice().to_vec(),
        ..state.clone()
    };
    let ws = evaluated(system, &moving);
    let jacobian = system.dense_jacobian(&ws);
    let inverse = jacobian.pseudo_inverse(1e-10).unwrap();
    let a = inverse * DVector::from_column_slice(&ws.qd);
    let left = |h: f64| {
        let mut later = moving.clone();
        let step = &v * h + &a * (0.5 * h * h);
        system.advance(&mut later.q, 1.0, step.as_slice());
        let ws = evaluated(system, &later);
        ws.value.iter().fold(0.0_f64, |m, c| m.max(c.abs()))
    };
    // The third derivative of C is some cubes of velocities below 3 and products with accelerations below 20.
    for h in [1e-2, 1e-3] {
        let most = 100.0 * h * h * h;
        assert!(left(h) < most, "{what}: C = {:e} after {h} s", left(h));
    }
}

/// Along the joint's motion its coordinates change as the geometry says.
fn rates(what: &str, kind: &str, system: &System<Spatial>, state: &State, null: &DMatrix<f64>) {
    for v in null.column_iter() {
        let moving = State {
            v: v.as_slice().to_vec(),
            ..state.clone()
        };
        let ws = evaluated(system, &moving);
        let e = &system.elements[0];
        let markers = ws.seen(&e.markers);
        let [a, b] = [&markers[0], &markers[1]];
        let turning = b.omega - a.omega;
        // What an observer on the first body sees of the second point.
        let sliding = b.velocity - a.velocity - a.omega.cross(&(b.point - a.point));
        let axis: Vector3<f64> = a.axes.column(2).into_owned();
        let rate = |k: usize| e.coordinates[k].measure.evaluate(&markers).rate;
        match kind {
            "universal" => {
                let second: Vector3<f64> = b.axes.column(0).into_owned();
                let found = axis * rate(0) + second * rate(1);
                near(what, found.as_slice(), turning.as_slice(), 1e-12);
            }
            "screw" => {
                near(what, &[rate(0)], &[axis.dot(&turning)], 1e-12);
                let moved = -0.37 / std::f64::consts::TAU * rate(0);
                near(what, &[axis.dot(&sliding)], &[moved], 1e-12);
                near(what, (axis * rate(0)).as_slice(), turning.as_slice(), 1e-12);
            }
            "revolute" | "cylindrical" => {
                near(what, (axis * rate(0)).as_slice(), turning.as_slice(), 1e-12);
                let moved = if kind == "revolute" { 0.0 } else { rate(1) };
                near(what, (axis * moved).as_slice(), sliding.as_slice(), 1e-12);
            }
            "prismatic" | "point-on-line" => {
                near(what, (axis * rate(0)).as_slice(), sliding.as_slice(), 1e-12);
            }
            "weld" => near(what, &[turning.norm(), sliding.norm()], &[0.0; 2], 1e-12),
            "constant-velocity" => {
                // Equal angles of both shafts: no relative turn about the bisector of the shafts.
                let other: Vector3<f64> = b.axes.column(2).into_owned();
                // The assembly stops at 1e-13, and the row is weak where the shafts nearly fold.
                near(what, &[turning.dot(&(axis + other))], &[0.0], 1e-11);
            }
            _ => assert!(e.coordinates.is_empty()),
        }
    }
}
