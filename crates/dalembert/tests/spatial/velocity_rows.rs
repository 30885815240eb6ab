//! Rows that hold for velocities only, against velocities written from geometry.

use super::contact_rows::Two;
use super::oracle::{Marker, Number, Vector, cross, dot, measure};
use super::shapes::program;
use super::*;
use dalembert::joint::{
    ConstraintElement, KnifeEdge, Measure, RollingOnPlane, SpatialMeasure, VelocityRows,
};
use dalembert::signal::{Signal, SignalKind};
use dalembert::space::orientation::Axis;
use dalembert::space::{Space, Spatial};
use num_dual::{Dual, Dual64};

/// A few roundings of terms of the size of the largest entry.
const EXACT: f64 = 5e-14;

/// A frame whose body moves.
struct Moving<D> {
    frame: Marker<D>,
    center: Vector<D>,
    velocity: Vector<D>,
    omega: Vector<D>,
}

impl<D: Number> Moving<D> {
    /// Velocity of the body's material point at a place.
    fn at(&self, place: &Vector<D>) -> Vector<D> {
        let arm = [0, 1, 2].map(|k| place[k] - self.center[k]);
        let turn = cross(&self.omega, &arm);
        [0, 1, 2].map(|k| self.velocity[k] + turn[k])
    }
}

/// Rows that are linear in the velocities, at a time.
trait Slip {
    fn rows<D: Number>(&self, a: &Moving<D>, b: &Moving<D>) -> Vec<D>;
}

/// Both bodies after the time s along constant velocities `path`, moving with velocities `v`. The angular velocity along
/// such a path stays what it was in ground axes: the body turns about it. That of `v` turns with the body.
fn moving<D: Number>(two: &Two, path: &[[f64; 6]; 2], v: &[[f64; 6]; 2], s: D) -> [Moving<D>; 2] {
    let frames = two.after(path, s);
    let mut k = 0;
    frames.map(|frame| {
        let (pose, v, path, seen) = (&two.poses[k], &v[k], &path[k], &two.frames[k]);
        k += 1;
        // Body axes from those of the frame: A = F E^T.
        let axis = |j: usize| -> Vector<D> {
            [0, 1, 2].map(|i| {
                (0..3).fold(D::from(0.0), |sum, l| {
                    sum + frame.axes[l][i] * seen.axes[(j, l)]
                })
            })
        };
        let axes = [axis(0), axis(1), axis(2)];
        Moving {
            center: [0, 1, 2].map(|i| s * path[i] + pose.point[i]),
            velocity: [0, 1, 2].map(|i| D::from(v[i])),
            omega: [0, 1, 2].map(|i| axes[0][i] * v[3] + axes[1][i] * v[4] + axes[2][i] * v[5]),
            frame,
        }
    })
}

fn check(name: &str, element: &dyn ConstraintElement<Spatial>, oracle: &impl Slip) {
    let mut source = Random::new(SEED + 4);
    let rows = element.velocity_rows();
    assert!(!rows.is_empty());
    for state in 0..8 {
        let name = format!("{name}, state {state}");
        let two = Two::new(&mut source);
        let found = two.evaluate(element, 0.7, &[], &[]);
        for row in rows.clone() {
            assert_eq!((found.value[row], found.time[row]), (0.0, 0.0), "{name}");
        }
        for body in 0..2 {
            for k in 0..6 {
                let mut v = [[0.0; 6]; 2];
                v[body][k] = 1.0;
                let [a, b] = moving(&two, &two.v, &v, 0.0);
                let column: Vec<f64> = rows
                    .clone()
                    .map(|row| two.pulled(&found, row, body)[k])
                    .collect();
                let what = format!("{name}: body {body}, column {k}");
                near(&what, &column, &oracle.rows(&a, &b), EXACT);
            }
        }
        let [a, b] = moving(&two, &two.v, &two.v, Dual64::new(0.0, 1.0));
        let rate: Vec<f64> = oracle.rows(&a, &b).iter().map(|x| x.eps).collect();
        let own: Vec<f64> = rows.clone().map(|row| two.second(&found, row)).collect();
        near(
            &format!("{name}: rate at zero accelerations"),
            &own,
            &rate,
            EXACT,
        );
    }
}

/// No slip between the material points at the lowest point of a wheel.
struct NoSlip(RollingOnPlane);

impl Slip for NoSlip {
    fn rows<D: Number>(&self, a: &Moving<D>, b: &Moving<D>) -> Vec<D> {
        let (n, axle) = (&a.frame.axes[2], &b.frame.axes[2]);
        let c = dot(n, axle);
        let w = [0, 1, 2].map(|k| n[k] - c * axle[k]);
        let length = dot(&w, &w).sqrt();
        let contact = [0, 1, 2]
            .map(|k| b.frame.point[k] - w[k] / length * self.0.radius - n[k] * self.0.rounding);
        let (one, two) = (a.at(&contact), b.at(&contact));
        let slip = [0, 1, 2].map(|k| two[k] - one[k]);
        [0, 1].map(|k| dot(&a.frame.axes[k], &slip)).to_vec()
    }
}

#[test]
fn wheels_do_not_slip() {
    for (radius, rounding) in [(0.4, 0.0), (0.4, 0.1), (0.0, 0.3)] {
        let wheel = RollingOnPlane { radius, rounding };
        assert_eq!(ConstraintElement::<Spatial>::velocity_rows(&wheel), 1..3);
        check(&format!("{wheel:?}"), &wheel, &NoSlip(wheel));
    }
}

struct Sideways;

impl Slip for Sideways {
    fn rows<D: Number>(&self, a: &Moving<D>, b: &Moving<D>) -> Vec<D> {
        let (one, two) = (a.at(&b.frame.point), b.at(&b.frame.point));
        let slip = [0, 1, 2].map(|k| two[k] - one[k]);
        vec![dot(&b.frame.axes[2], &slip)]
    }
}

#[test]
fn blades_do_not_move_sideways() {
    check("blade", &KnifeEdge, &Sideways);
}

const TURN: SpatialMeasure = SpatialMeasure::Turn(Axis::Y);

/// e_y of the first frame times the relative angular velocity.
fn turn_rate<D: Number>(a: &Moving<D>, b: &Moving<D>) -> D {
    let relative = [0, 1, 2].map(|k| b.omega[k] - a.omega[k]);
    dot(&a.frame.axes[1], &relative)
}

#[test]
fn turns_have_rates() {
    let mut source = Random::new(SEED + 5);
    for _ in 0..10 {
        let two = Two::new(&mut source);
        let markers = two.markers();
        let found = TURN.evaluate(&markers[0], &markers[1]);
        let [a, b] = moving(&two, &two.v, &two.v, Dual64::new(0.0, 1.0));
        let expected = turn_rate(&a, &b);
        assert_eq!(found.value, 0.0);
        near("rate", &[found.rate], &[expected.re], EXACT);
        let own = [0, 1].map(|k| Spatial::bias(&markers[k]));
        let second = found.bias + found.first.dot(&own[0]) + found.second.dot(&own[1]);
        near("bias", &[second], &[expected.eps], EXACT);
        for (body, gradient) in [found.first, found.second].into_iter().enumerate() {
            let pulled = Spatial::pull(&markers[body], &gradient);
            for k in 0..6 {
                let mut v = [[0.0; 6]; 2];
                v[body][k] = 1.0;
                let [a, b] = moving(&two, &two.v, &v, 0.0);
                near("gradient", &[pulled[k]], &[turn_rate(&a, &b)], EXACT);
            }
        }
    }
}

const HEIGHT: SpatialMeasure = SpatialMeasure::Along(Axis::Z);
const SPEED: SpatialMeasure = SpatialMeasure::Along(Axis::X);
const LENGTH: SpatialMeasure = SpatialMeasure::Distance;

/// sin(height) speed + t^2 length turn - 0.3 t length_rate + t - height.
fn user<D: Number>(t: D, two: &Two, v: &[[f64; 6]; 2], s: D) -> [D; 2] {
    let [a, b] = two.after(&two.v, s);
    let of = |kind| measure(kind, &a, &b);
    // The rate of a measure for other velocities at the same place: v tells by how much the frames move on.
    let rate = |kind| rate_of(kind, two, v, s);
    let [one, other] = moving(two, &two.v, v, s);
    let linear = of(HEIGHT).sin() * rate(SPEED) + t * t * of(LENGTH) * turn_rate(&one, &other)
        - t * rate(LENGTH) * 0.3;
    [linear, t - of(HEIGHT)]
}

/// d'.e + d.(omega x e) and n.d', written with velocities.
fn rate_of<D: Number>(kind: SpatialMeasure, two: &Two, v: &[[f64; 6]; 2], s: D) -> D {
    let [a, b] = moving(two, &two.v, v, s);
    let (va, vb) = (a.at(&a.frame.point), b.at(&b.frame.point));
    // A step of the frames along those velocities.
    let step = |m: &Moving<D>, v: &Vector<D>| {
        let number = |x: D, y: D| Dual::<D, f64>::new(x, y);
        Marker {
            point: [0, 1, 2].map(|k| number(m.frame.point[k], v[k])),
            axes: [0, 1, 2].map(|j| {
                let e = &m.frame.axes[j];
                let turn = cross(&m.omega, e);
                [0, 1, 2].map(|k| number(e[k], turn[k]))
            }),
        }
    };
    measure(kind, &step(&a, &va), &step(&b, &vb)).eps
}

#[test]
fn constraints_of_users() {
    const NAMES: &[&str] = &["h", "u", "l", "w", "dl", "t"];
    let signal = |kind, measure| Signal::<Spatial> {
        kind,
        measure: Measure {
            kind: measure,
            first: 0,
            second: 1,
        },
    };
    let all = [
        signal(SignalKind::Value, HEIGHT),
        signal(SignalKind::Rate, SPEED),
        signal(SignalKind::Value, LENGTH),
        signal(SignalKind::Rate, TURN),
        signal(SignalKind::Rate, LENGTH),
        signal(SignalKind::Time, HEIGHT),
    ];
    let program = program("sin(h)*u + t^2*l*w - 0.3*t*dl + t - h", NAMES);
    let element = VelocityRows::<Spatial> {
        inputs: program.slots().iter().map(|slot| all[*slot]).collect(),
        program,
        markers: 2,
    };
    let mut source = Random::new(SEED + 6);
    let t = 0.7;
    for state in 0..8 {
        let name = format!("state {state}");
        let two = Two::new(&mut source);
        let found = two.evaluate(&element, t, &[], &[]);
        let [_, constant] = user(t, &two, &two.v, 0.0);
        near(&format!("{name}: C_t"), &found.time, &[constant], EXACT);
        assert_eq!(found.value, [0.0]);
        for body in 0..2 {
            for k in 0..6 {
                let mut v = [[0.0; 6]; 2];
                v[body][k] = 1.0;
                let [slope, _] = user(t, &two, &v, 0.0);
                let what = format!("{name}: body {body}, column {k}");
                near(&what, &[two.pulled(&found, 0, body)[k]], &[slope], EXACT);
            }
        }
        let time = Dual64::new(t, 1.0);
        let [linear, rest] = user(time, &two, &two.v, Dual64::new(0.0, 1.0));
        let second = two.second(&found, 0);
        near(
            &format!("{name}: rate"),
            &[second],
            &[(linear + rest).eps],
            EXACT,
        );
    }
}
