//! Three bodies in space for the tests of joints: as a model, and once more as the oracle sees them.

use super::oracle::{Marker, Number, Vector, marker};
use dalembert::model::Model;
use dalembert::space::{Spatial, SpatialFrame, SpatialPose};
use dalembert::system::compile::{Compiled, compile};
use dalembert::system::{State, System, Workspace};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use serde_json::{Value, json};

type Triple = [f64; 3];

/// Name, centre of mass, position and Euler angles zxz of the bodies.
const BODIES: [(&str, Triple, Triple, Triple); 3] = [
    ("a", [0.13, -0.21, 0.08], [0.2, 0.5, -0.3], [0.3, 0.7, -0.5]),
    ("b", [-0.17, 0.08, 0.22], [1.1, 0.9, 0.4], [-0.4, 1.1, 0.9]),
    ("c", [0.05, 0.11, -0.14], [-0.6, 0.4, 0.8], [1.2, 0.4, 0.3]),
];

/// The bodies of a model: frames neither central nor principal.
pub fn bodies() -> Value {
    BODIES
        .iter()
        .map(|(name, center, position, angles)| {
            json!({"name": name, "mass": 1.7, "center": center, "position": position,
                   "inertia": [[0.5, 0.04, -0.06], [0.04, 0.4, 0.05], [-0.06, 0.05, 0.3]],
                   "orientation": {"euler": "zxz", "angles": angles}})
        })
        .collect()
}

pub fn model(mut value: Value) -> Model {
    if value.get("model").is_none() {
        value["model"] = json!({"name": "test", "space": "spatial", "gravity": [0, 0, 0]});
    }
    serde_json::from_value(value).expect("a model")
}

pub fn compiled(value: Value) -> Compiled<Spatial> {
    compile::<Spatial>(&model(value), &[]).unwrap_or_else(|e| panic!("{e:?}"))
}

/// The three bodies with some elements.
pub fn system(parts: &Value) -> System<Spatial> {
    let mut model = json!({"body": bodies()});
    for (key, value) in parts.as_object().unwrap() {
        model[key] = value.clone();
    }
    compiled(model).system
}

pub fn evaluated(system: &System<Spatial>, state: &State) -> Workspace<Spatial> {
    let mut ws = Workspace::new(system);
    system.update_markers(&state.q, &state.v, &mut ws);
    system.evaluate_constraints(state.t, &mut ws);
    ws
}

/// The pose of Euler parameters, written out (Shabana 8.17).
pub fn pose(q: &[f64]) -> SpatialPose {
    let [a, b, c, d] = [q[3], q[4], q[5], q[6]];
    SpatialPose {
        point: Vector3::new(q[0], q[1], q[2]),
        axes: Matrix3::new(
            1.0 - 2.0 * (c * c + d * d),
            2.0 * (b * c - a * d),
            2.0 * (b * d + a * c),
            2.0 * (b * c + a * d),
            1.0 - 2.0 * (b * b + d * d),
            2.0 * (c * d - a * b),
            2.0 * (b * d - a * c),
            2.0 * (c * d + a * b),
            1.0 - 2.0 * (b * b + c * c),
        ),
    }
}

/// A frame on a body: its point, its z axis, and a direction to whose side its x axis points; in the body's frame.
#[derive(Clone, Copy)]
pub struct Spot {
    pub body: &'static str,
    pub at: [f64; 3],
    pub z: [f64; 3],
    pub x: [f64; 3],
}

impl Spot {
    /// The same point with an x axis in exactly this direction; z is some axis across it.
    pub fn along_x(self, x: [f64; 3]) -> Self {
        let z = Vector3::from(x).cross(&Vector3::new(0.2, 0.7, 0.1));
        Self {
            z: z.into(),
            x,
            ..self
        }
    }

    /// The frame's axes in the body's frame, as columns.
    pub fn axes(&self) -> Matrix3<f64> {
        let z = Vector3::from(self.z).normalize();
        let y = z.cross(&Vector3::from(self.x)).normalize();
        Matrix3::from_columns(&[y.cross(&z), y, z])
    }
}

/// Positions of the second of two frames' body, where that frame stands turned from the first, on the ground, its point
/// moved along the ground's axes.
pub fn placed(spots: &[Spot; 2], turn: &Matrix3<f64>, apart: [f64; 3]) -> [f64; 7] {
    let body = BODIES
        .iter()
        .find(|b| b.0 == spots[1].body)
        .expect("a body");
    let axes = spots[0].axes() * turn * spots[1].axes().transpose();
    let arm = Vector3::from(spots[1].at) - Vector3::from(body.1);
    let point = Vector3::from(spots[0].at) + Vector3::from(apart) - axes * arm;
    let q = UnitQuaternion::from_matrix(&axes);
    [point.x, point.y, point.z, q.w, q.i, q.j, q.k]
}

/// The bodies and where they move: each with constant velocities, for the time s.
pub struct Machine<D> {
    pub t: D,
    pub s: D,
    pub poses: Vec<SpatialPose>,
    pub v: Vec<f64>,
    pub auxiliary: Vec<D>,
    /// What each angle was last.
    pub memory: Vec<f64>,
}

impl Machine<f64> {
    /// The estimated poses of the model.
    pub fn estimate() -> Self {
        let poses = BODIES.map(|(_, center, position, [a, b, c])| {
            let turn = |axis, angle| Rotation3::from_axis_angle(&axis, angle);
            let (x, z) = (Vector3::x_axis(), Vector3::z_axis());
            let axes = *(turn(z, a) * turn(x, b) * turn(z, c)).matrix();
            SpatialPose {
                point: Vector3::from(position) + axes * Vector3::from(center),
                axes,
            }
        });
        Self {
            t: 0.0,
            s: 0.0,
            poses: poses.to_vec(),
            v: vec![0.0; 18],
            auxiliary: vec![0.0; 4],
            memory: vec![0.0; 8],
        }
    }
}

impl<D: Number> Machine<D> {
    pub fn marker(&self, spot: &Spot) -> Marker<D> {
        let axes = spot.axes();
        let Some(k) = BODIES.iter().position(|b| b.0 == spot.body) else {
            assert_eq!(spot.body, "ground");
            let frame = SpatialFrame {
                at: spot.at.into(),
                axes,
            };
            let still = pose(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
            return marker(&still, &frame, &[0.0; 6], self.s);
        };
        let frame = SpatialFrame {
            at: Vector3::from(spot.at) - Vector3::from(BODIES[k].1),
            axes,
        };
        marker(&self.poses[k], &frame, &self.v[6 * k..6 * k + 6], self.s)
    }
}

/// From one point to another.
pub fn between<D: Number>(a: &Marker<D>, b: &Marker<D>) -> Vector<D> {
    [0, 1, 2].map(|k| b.point[k] - a.point[k])
}
