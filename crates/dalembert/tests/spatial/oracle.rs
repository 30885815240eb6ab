//! Poses and measures for any kind of number. A body moves along r + s v, A exp(s skew(omegabar)): constant velocities
//! in the engine's coordinates, so that second derivatives by s are those at zero accelerations.

use dalembert::joint::SpatialMeasure;
use dalembert::space::orientation::Axis;
use dalembert::space::{SpatialFrame, SpatialPose};
use num_dual::DualNum;

pub trait Number: DualNum<f64> + Copy {}
impl<D: DualNum<f64> + Copy> Number for D {}

pub type Vector<D> = [D; 3];

pub fn dot<D: Number>(a: &Vector<D>, b: &Vector<D>) -> D {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross<D: Number>(a: &Vector<D>, b: &Vector<D>) -> Vector<D> {
    [0, 1, 2].map(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i] * b[j] - a[j] * b[i]
    })
}

/// A frame in ground axes.
pub struct Marker<D> {
    pub point: Vector<D>,
    /// Its three axes.
    pub axes: [Vector<D>; 3],
}

/// A frame on a body after the time s.
pub fn marker<D: Number>(pose: &SpatialPose, frame: &SpatialFrame, v: &[f64], s: D) -> Marker<D> {
    let w = [v[3], v[4], v[5]];
    let speed = w.iter().map(|x| x * x).sum::<f64>().sqrt();
    let angle = s * speed;
    let turned = |u: Vector<f64>| -> Vector<D> {
        // Rodriguez: u + sin(t) n x u + (1 - cos(t)) n x (n x u), then to ground axes.
        let u = u.map(D::from);
        let moved = if speed == 0.0 {
            u
        } else {
            let n = w.map(|x| D::from(x / speed));
            let first = cross(&n, &u);
            let second = cross(&n, &first);
            [0, 1, 2]
                .map(|k| u[k] + angle.sin() * first[k] + (D::from(1.0) - angle.cos()) * second[k])
        };
        [0, 1, 2].map(|i| {
            moved[0] * pose.axes[(i, 0)]
                + moved[1] * pose.axes[(i, 1)]
                + moved[2] * pose.axes[(i, 2)]
        })
    };
    let arm = turned(frame.at.into());
    Marker {
        point: [0, 1, 2].map(|k| arm[k] + s * v[k] + pose.point[k]),
        axes: [0, 1, 2].map(|k| turned(frame.axes.column(k).into_owned().into())),
    }
}

/// A measure from its geometry.
pub fn measure<D: Number>(kind: SpatialMeasure, a: &Marker<D>, b: &Marker<D>) -> D {
    let d = [0, 1, 2].map(|k| b.point[k] - a.point[k]);
    match kind {
        SpatialMeasure::Ground(axis) => d[axis.number()],
        SpatialMeasure::Along(axis) => dot(&a.axes[axis.number()], &d),
        SpatialMeasure::Dot(e, f) => dot(&a.axes[e.number()], &b.axes[f.number()]),
        SpatialMeasure::Distance => dot(&d, &d).sqrt(),
        SpatialMeasure::Turn(_) => panic!("a turn has no value"),
        SpatialMeasure::Angle(axis) => {
            let i = match axis {
                Axis::X => 1,
                Axis::Y => 2,
                Axis::Z => 0,
            };
            let x = dot(&a.axes[i], &b.axes[i]);
            let y = dot(&a.axes[(i + 1) % 3], &b.axes[i]);
            y.atan2(x)
        }
    }
}
