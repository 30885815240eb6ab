//! Rows of contacts against the same rows in dual numbers, off the manifold, with everything in motion.

use super::oracle::{Marker, Number, Vector, dot, marker};
use super::shapes::{Shape, program};
use super::*;
use dalembert::joint::{
    ConstraintElement, ConstraintInput, ConstraintOutput, PointOnCurve, PointOnSurface,
    RollingOnPlane, SphereContact, SurfaceContact,
};
use dalembert::space::orientation::EulerSequence;
use dalembert::space::{Space, Spatial, SpatialFrame, SpatialMarker, SpatialPose};
use nalgebra::{Vector3, Vector6};
use num_dual::{Dual2_64, Dual64};

/// A few roundings of terms of the size of the largest entry.
const EXACT: f64 = 5e-14;

/// Residuals from geometry.
pub trait Rows {
    fn rows<D: Number>(&self, a: &Marker<D>, b: &Marker<D>, s: &[D]) -> Vec<D>;
}

/// Two bodies with a frame each, in motion.
pub struct Two {
    pub poses: [SpatialPose; 2],
    pub frames: [SpatialFrame; 2],
    pub v: [[f64; 6]; 2],
}

/// What an element answers.
pub struct Answer {
    pub value: Vec<f64>,
    pub gradient: Vec<Vector6<f64>>,
    pub auxiliary: Vec<f64>,
    pub time: Vec<f64>,
    pub bias: Vec<f64>,
}

impl Two {
    pub fn new(source: &mut Random) -> Self {
        Self {
            poses: [0; 2].map(|_| Spatial::pose(&random::<7>(source, 1.5))),
            frames: [0; 2].map(|_| SpatialFrame {
                at: Vector3::from(random(source, 0.7)),
                axes: *EulerSequence::ZXZ
                    .rotation(&Vector3::from(random(source, 3.0)))
                    .to_rotation_matrix()
                    .matrix(),
            }),
            v: [0; 2].map(|_| random(source, 2.0)),
        }
    }

    pub fn markers(&self) -> [SpatialMarker; 2] {
        [0, 1].map(|k| Spatial::marker(&self.frames[k], &self.poses[k], &self.v[k]))
    }

    /// The frames after the time s, with other velocities.
    pub fn after<D: Number>(&self, v: &[[f64; 6]; 2], s: D) -> [Marker<D>; 2] {
        [0, 1].map(|k| marker(&self.poses[k], &self.frames[k], &v[k], s))
    }

    pub fn evaluate(
        &self,
        element: &dyn ConstraintElement<Spatial>,
        t: f64,
        s: &[f64],
        s_rate: &[f64],
    ) -> Answer {
        let (rows, aux) = (element.labels().len(), element.auxiliaries().len());
        assert_eq!(aux, s.len());
        let mut out = Answer {
            value: vec![0.0; rows],
            gradient: vec![Vector6::zeros(); 2 * rows],
            auxiliary: vec![0.0; rows * aux],
            time: vec![0.0; rows],
            bias: vec![0.0; rows],
        };
        element.evaluate(
            &ConstraintInput {
                t,
                markers: &self.markers(),
                s,
                s_rate,
            },
            &mut ConstraintOutput {
                value: &mut out.value,
                gradient: &mut out.gradient,
                auxiliary: &mut out.auxiliary,
                time: &mut out.time,
                bias: &mut out.bias,
            },
        );
        out
    }

    /// Gradient of a row by the velocities of a body, from that by its marker's twist.
    pub fn pulled(&self, answer: &Answer, row: usize, body: usize) -> Vector6<f64> {
        Spatial::pull(&self.markers()[body], &answer.gradient[2 * row + body])
    }

    /// The second derivative of a row at zero accelerations of the bodies.
    pub fn second(&self, answer: &Answer, row: usize) -> f64 {
        let markers = self.markers();
        let parts = (0..2).map(|k| answer.gradient[2 * row + k].dot(&Spatial::bias(&markers[k])));
        answer.bias[row] + parts.sum::<f64>()
    }
}

/// C, C_q, C_s, C_t and -Q_d of the rows that hold for positions.
fn check(
    name: &str,
    element: &dyn ConstraintElement<Spatial>,
    oracle: &impl Rows,
    parameters: impl Fn(&mut Random) -> Vec<f64>,
) {
    let mut source = Random::new(SEED + 2);
    for state in 0..6 {
        let name = format!("{name}, state {state}");
        let two = Two::new(&mut source);
        let s = parameters(&mut source);
        let s_rate: Vec<f64> = s.iter().map(|_| source.uniform(-2.0, 2.0)).collect();
        let found = two.evaluate(element, 0.7, &s, &s_rate);
        let [a, b] = two.after(&two.v, 0.0);
        let value = oracle.rows(&a, &b, &s);
        assert!(
            value.iter().any(|c| c.abs() > 1e-3),
            "{name}: on the manifold"
        );
        near(
            &format!("{name}: C"),
            &found.value[..value.len()],
            &value,
            EXACT,
        );
        let count = value.len();
        let slopes = |v: &[[f64; 6]; 2], ds: &[f64]| -> Vec<f64> {
            let [a, b] = two.after(v, Dual64::new(0.0, 1.0));
            let s: Vec<Dual64> = s.iter().zip(ds).map(|(s, d)| Dual64::new(*s, *d)).collect();
            oracle.rows(&a, &b, &s).iter().map(|c| c.eps).collect()
        };
        let still = vec![0.0; s.len()];
        for body in 0..2 {
            for k in 0..6 {
                let mut v = [[0.0; 6]; 2];
                v[body][k] = 1.0;
                let column: Vec<f64> = (0..count)
                    .map(|row| two.pulled(&found, row, body)[k])
                    .collect();
                let what = format!("{name}: C_q, body {body}, column {k}");
                near(&what, &column, &slopes(&v, &still), EXACT);
            }
        }
        for k in 0..s.len() {
            let mut ds = still.clone();
            ds[k] = 1.0;
            let column: Vec<f64> = (0..count)
                .map(|row| found.auxiliary[s.len() * row + k])
                .collect();
            let what = format!("{name}: C_s, column {k}");
            near(&what, &column, &slopes(&[[0.0; 6]; 2], &ds), EXACT);
        }
        assert!(found.time.iter().all(|x| *x == 0.0), "{name}: C_t");
        let [a, b] = two.after(&two.v, Dual2_64::new(0.0, 1.0, 0.0));
        let path = s.iter().zip(&s_rate);
        let path: Vec<Dual2_64> = path.map(|(s, d)| Dual2_64::new(*s, *d, 0.0)).collect();
        let second: Vec<f64> = oracle.rows(&a, &b, &path).iter().map(|c| c.v2).collect();
        let own: Vec<f64> = (0..count).map(|row| two.second(&found, row)).collect();
        near(&format!("{name}: second derivative"), &own, &second, EXACT);
    }
}

/// A vector of a frame in ground axes.
fn in_ground<D: Number>(m: &Marker<D>, u: &Vector<D>) -> Vector<D> {
    [0, 1, 2].map(|i| m.axes[0][i] * u[0] + m.axes[1][i] * u[1] + m.axes[2][i] * u[2])
}

fn add<D: Number>(a: &Vector<D>, b: &Vector<D>) -> Vector<D> {
    [0, 1, 2].map(|k| a[k] + b[k])
}

fn minus<D: Number>(a: &Vector<D>, b: &Vector<D>) -> Vector<D> {
    [0, 1, 2].map(|k| a[k] - b[k])
}

/// The row of a unit vector.
fn unit<D: Number>(w: &[D]) -> D {
    (w[0] * w[0] + w[1] * w[1] + w[2] * w[2] - 1.0) * 0.5
}

/// Parameters away from poles.
fn somewhere(count: usize) -> impl Fn(&mut Random) -> Vec<f64> {
    move |source| {
        (0..count)
            .map(|k| {
                let limit = if k % 2 == 0 { 3.0 } else { 0.8 };
                source.uniform(-limit, limit)
            })
            .collect()
    }
}

struct Touching {
    shapes: [Shape; 2],
    inside: [bool; 2],
    held: Option<(usize, f64)>,
}

impl Rows for Touching {
    fn rows<D: Number>(&self, a: &Marker<D>, b: &Marker<D>, s: &[D]) -> Vec<D> {
        let [one, two] = self.shapes;
        let (middle, end) = (one.count(), one.count() + two.count());
        let (s1, s2) = (&s[..middle], &s[middle..end]);
        let p = add(&a.point, &in_ground(a, &one.over(s1)));
        let q = add(&b.point, &in_ground(b, &two.over(s2)));
        let mut rows = minus(&p, &q).to_vec();
        let n1 = in_ground(a, &one.normal_over(s1, self.inside[0]));
        let n2 = in_ground(b, &two.normal_over(s2, self.inside[1]));
        if one.semi_axes().is_none() {
            for t in one.tangents(s1[0], s1[1]) {
                rows.push(dot(&in_ground(a, &t), &n2));
            }
        } else if two.semi_axes().is_none() {
            for t in two.tangents(s2[0], s2[1]) {
                rows.push(dot(&in_ground(b, &t), &n1));
            }
        } else {
            rows.extend(add(&n1, &n2.map(|x| x * s[end])));
        }
        for (shape, w) in [(one, s1), (two, s2)] {
            if shape.semi_axes().is_some() {
                rows.push(unit(w));
            }
        }
        if let Some((place, value)) = self.held {
            rows.push(s[place] - value);
        }
        rows
    }
}

#[test]
fn surfaces_that_touch() {
    let ellipsoid = Shape::Ellipsoid([0.5, 0.3, 0.2]);
    let pairs = [
        [ellipsoid, Shape::Plane],
        [Shape::Torus(0.6, 0.2), Shape::Plane],
        [Shape::Cone(0.5, 0.9), Shape::Cylinder(0.3)],
        [ellipsoid, Shape::Ellipsoid([0.2, 0.7, 0.4])],
        [Shape::Revolved, Shape::Plane],
        [Shape::Plane, Shape::Revolved],
        [Shape::Field, ellipsoid],
        [Shape::Sphere(0.4), Shape::Torus(0.6, 0.2)],
        [Shape::Odd, Shape::Field],
        [Shape::Plane, ellipsoid],
        [Shape::Sphere(0.9), ellipsoid],
    ];
    // Every pair of the round ones, in both orders.
    let round = [
        Shape::Cylinder(0.3),
        Shape::Cone(0.5, 0.9),
        Shape::Torus(0.6, 0.2),
        Shape::Revolved,
    ];
    let among = round.map(|one| round.map(|two| [one, two])).concat();
    let flags = [[false; 2], [true, false], [false, true]];
    for shapes in pairs.into_iter().chain(among) {
        for inside in flags {
            for held in [None, Some((1, 0.35)), Some((2, -0.2))] {
                let surfaces = [0, 1].map(|k| shapes[k].surface(inside[k]));
                let element = SurfaceContact::new(surfaces, [&[0.0; 3]; 2], [0.0; 2], held);
                let oracle = Touching {
                    shapes,
                    inside,
                    held,
                };
                let name = format!("{shapes:?}, inside {inside:?}, held {held:?}");
                let count = element.auxiliaries().len();
                check(&name, &element, &oracle, somewhere(count));
            }
        }
    }
}

struct Near {
    shape: Shape,
    inside: bool,
    distance: f64,
    reversed: bool,
}

impl Rows for Near {
    fn rows<D: Number>(&self, a: &Marker<D>, b: &Marker<D>, s: &[D]) -> Vec<D> {
        let (base, other) = if self.reversed { (b, a) } else { (a, b) };
        let u = self.shape.over(s);
        let n = self.shape.normal_over(s, self.inside);
        let length = dot(&n, &n).sqrt();
        let way = [0, 1, 2].map(|k| u[k] + n[k] / length * self.distance);
        let mut rows = minus(&add(&base.point, &in_ground(base, &way)), &other.point).to_vec();
        if self.shape.semi_axes().is_some() {
            rows.push(unit(s));
        }
        rows
    }
}

#[test]
fn points_and_balls_on_surfaces() {
    for shape in shapes::ALL {
        for (inside, distance, reversed) in [
            (false, 0.0, false),
            (true, 0.0, true),
            (false, 0.15, false),
            (true, 0.15, false),
            (false, 0.15, true),
        ] {
            let surface = shape.surface(inside);
            let element = PointOnSurface::new(surface, distance, reversed, &[0.0; 3], 0.0);
            let oracle = Near {
                shape,
                inside,
                distance,
                reversed,
            };
            let name = format!("{shape:?}, inside {inside}, R {distance}, reversed {reversed}");
            check(&name, &element, &oracle, somewhere(shape.count()));
        }
    }
}

struct Curve;

impl Rows for Curve {
    fn rows<D: Number>(&self, a: &Marker<D>, b: &Marker<D>, s: &[D]) -> Vec<D> {
        let c = [s[0].cos(), s[0].sin() * 2.0, s[0] * s[0] * 0.1 + 0.2];
        let d = minus(&b.point, &a.point);
        let seen = [0, 1, 2].map(|k| dot(&a.axes[k], &d));
        minus(&c, &seen).to_vec()
    }
}

#[test]
fn points_on_curves() {
    let element = PointOnCurve {
        curve: ["cos(s)", "2*sin(s)", "0.2 + 0.1*s^2"].map(|text| program(text, &["s"])),
    };
    check("curve", &element, &Curve, somewhere(1));
    // A straight line: constants among the expressions.
    let element = PointOnCurve {
        curve: ["0.3", "s", "-0.1"].map(|text| program(text, &["s"])),
    };
    check("line", &element, &Line, somewhere(1));
}

struct Line;

impl Rows for Line {
    fn rows<D: Number>(&self, a: &Marker<D>, b: &Marker<D>, s: &[D]) -> Vec<D> {
        let d = minus(&b.point, &a.point);
        let seen = [0, 1, 2].map(|k| dot(&a.axes[k], &d));
        minus(&[D::from(0.3), s[0], D::from(-0.1)], &seen).to_vec()
    }
}

/// Spheres: the rows are |d| with a minus (the multiplier pushes).
struct Spheres(f64);

impl Rows for Spheres {
    fn rows<D: Number>(&self, a: &Marker<D>, b: &Marker<D>, _: &[D]) -> Vec<D> {
        let d = minus(&b.point, &a.point);
        vec![-(dot(&d, &d).sqrt()) + self.0]
    }
}

#[test]
fn spheres_that_touch() {
    for (radii, inside, distance) in [
        ([0.3, 0.4], false, 0.7),
        ([0.9, 0.2], true, 0.7),
        ([0.2, 0.9], true, 0.7),
    ] {
        let element = SphereContact::new(radii, inside);
        check(
            &format!("{radii:?}"),
            &element,
            &Spheres(distance),
            somewhere(0),
        );
        // The point of contact lies on both spheres, where they touch: on the line of centres.
        let two = Two::new(&mut Random::new(SEED + 3));
        let mut markers = two.markers();
        let way = Vector3::new(0.48, -0.64, 0.6).normalize() * distance;
        markers[1].point = markers[0].point + way;
        let input = ConstraintInput {
            t: 0.0,
            markers: &markers,
            s: &[],
            s_rate: &[],
        };
        let contact = element.contact(&input, &[2.5]).unwrap();
        for (m, r) in markers.iter().zip(radii) {
            let d = (contact.point - m.point).norm();
            assert!((d - r).abs() < 1e-15, "{radii:?}: {d} for {r}");
        }
        // Force on the second body: minus its gradient times the multiplier; it points away from the first, unless
        // the spheres lie in each other.
        let mut value = [0.0];
        let mut gradient = [Vector6::zeros(); 2];
        element.evaluate(
            &input,
            &mut ConstraintOutput {
                value: &mut value,
                gradient: &mut gradient,
                auxiliary: &mut [],
                time: &mut [0.0],
                bias: &mut [0.0],
            },
        );
        let force = -2.5 * gradient[1].fixed_rows::<3>(0).into_owned();
        // The normal at the contact out of the first body.
        let out = (contact.point - markers[0].point).normalize();
        let hollow = inside && radii[0] > radii[1];
        let out = if hollow { -out } else { out };
        assert!(
            (force.dot(&out) - contact.normal).abs() < 1e-14,
            "{radii:?}"
        );
    }
}

/// The contact of a wheel with a plane: its lowest point lies in the plane.
struct Lowest(RollingOnPlane);

impl Rows for Lowest {
    fn rows<D: Number>(&self, a: &Marker<D>, b: &Marker<D>, _: &[D]) -> Vec<D> {
        let (n, axle) = (&a.axes[2], &b.axes[2]);
        let c = dot(n, axle);
        let sine = (-(c * c) + 1.0).sqrt();
        let d = minus(&b.point, &a.point);
        vec![dot(n, &d) - sine * self.0.radius - self.0.rounding]
    }
}

#[test]
fn wheels_on_planes() {
    for (radius, rounding) in [(0.4, 0.0), (0.4, 0.1), (0.0, 0.3)] {
        let wheel = RollingOnPlane { radius, rounding };
        check(&format!("{wheel:?}"), &wheel, &Lowest(wheel), somewhere(0));
    }
}
