//! Quantities that are driven, fixed and coupled, paths and user expressions against dual numbers.

use super::check::check;
use super::joints::{joint, spots};
use super::machine::{Machine, Spot, between};
use super::oracle::{Number, dot};
use super::rows::{Both, Follow, Motion, Pair, Residual, Sum, What};
use nalgebra::Vector3;
use serde_json::{Value, json};

const POINT: [f64; 3] = [0.3, 0.1, -0.4];
const FAR: [[f64; 3]; 2] = [[0.1, 0.2, 0.3], [4.5, -0.3, 2.0]];
/// An axis in ground axes at the estimate.
const AXIS: [f64; 3] = [0.7, -0.2, 0.4];

fn spot(body: &'static str, at: [f64; 3]) -> Spot {
    Spot {
        body,
        at,
        z: [0.0, 0.0, 1.0],
        x: [1.0, 0.0, 0.0],
    }
}

/// A cylindrical joint R of a and b and a universal joint U of c and b.
fn carriers() -> (Value, Both<Pair, Pair>) {
    let joints = json!([
        joint("R", "cylindrical", ["a", "b"]),
        joint("U", "universal", ["c", "b"])
    ]);
    let universal = Pair {
        kind: "universal",
        spots: cross(),
        pitch: 0.0,
    };
    let cylindrical = Pair {
        kind: "cylindrical",
        spots: spots(["a", "b"]),
        pitch: 0.0,
    };
    (joints, Both(cylindrical, universal))
}

/// The frames of angle_1: z along the first axis, x along the second as the estimate has it.
fn cross() -> [Spot; 2] {
    let [a, b] = spots(["c", "b"]);
    let estimate = Machine::estimate();
    let seen = estimate.marker(&b).axes[2];
    let x = estimate.poses[2].axes.tr_mul(&Vector3::from(seen));
    [Spot { x: x.into(), ..a }, b.along_x(b.z)]
}

/// The frames of angle_2: seen from the second body about minus its axis, to the first axis.
fn cross_back() -> [Spot; 2] {
    let [a, b] = spots(["c", "b"]);
    let estimate = Machine::estimate();
    let seen = estimate.marker(&a).axes[2];
    let x = estimate.poses[1].axes.tr_mul(&Vector3::from(seen));
    [
        Spot {
            z: b.z.map(|e| -e),
            x: x.into(),
            ..b
        },
        a.along_x(a.z),
    ]
}

/// The frames of a relative angle: z as the bodies see the axis, x the body axis after the nearest one.
fn about() -> [Spot; 2] {
    let estimate = Machine::estimate();
    [("c", 2), ("a", 0)].map(|(body, k)| {
        let z = estimate.poses[k].axes.tr_mul(&Vector3::from(AXIS));
        let mut x = [0.0; 3];
        x[(z.iamax() + 1) % 3] = 1.0;
        Spot {
            body,
            at: [0.0; 3],
            z: z.into(),
            x,
        }
    })
}

/// Every quantity, and whether it is a length. The joint R remembers angle 0, U the angles 1 and 2.
fn quantities() -> Vec<(Value, What, bool)> {
    let coordinate =
        |name: &str| json!({"kind": "coordinate", "body": "b", "at": POINT, "coordinate": name});
    let of_cross =
        |name: &str| json!({"kind": "joint-coordinate", "joint": "U", "coordinate": name});
    vec![
        (coordinate("x"), What::Ground(spot("b", POINT), 0), true),
        (coordinate("y"), What::Ground(spot("b", POINT), 1), true),
        (coordinate("z"), What::Ground(spot("b", POINT), 2), true),
        (
            json!({"kind": "angle", "joint": "R"}),
            What::Angle(spots(["a", "b"]), 0),
            false,
        ),
        (
            json!({"kind": "displacement", "joint": "R"}),
            What::Along(spots(["a", "b"])),
            true,
        ),
        (
            json!({"kind": "joint-coordinate", "joint": "R", "coordinate": "displacement"}),
            What::Along(spots(["a", "b"])),
            true,
        ),
        (of_cross("angle_1"), What::Angle(cross(), 1), false),
        (of_cross("angle_2"), What::Angle(cross_back(), 2), false),
        (
            json!({"kind": "relative-angle", "bodies": ["c", "a"], "axis": AXIS}),
            What::Angle(about(), 3),
            false,
        ),
        (
            json!({"kind": "distance", "bodies": ["a", "b"], "at": FAR}),
            What::Distance([spot("a", FAR[0]), spot("b", FAR[1])]),
            true,
        ),
    ]
}

#[test]
fn drivers() {
    for (quantity, what, is_length) in quantities() {
        let unit = if is_length { "m" } else { "rad" };
        let sine =
            format!("0.2 {unit} + 0.3 {unit} * sin(1.5 rad/s * t) + 0.1 {unit} * (t / 1 s)^3");
        let rate = format!("0.4 {unit}/s * cos(1.5 rad/s * t) + 0.2 {unit}/s");
        for (motion, follows) in [
            (json!({"value": sine}), Motion::Sine),
            (json!({"rate": rate, "start": 0.3}), Motion::ByRate),
        ] {
            let mut driver = quantity.clone();
            driver["name"] = json!("D");
            for (key, value) in motion.as_object().unwrap() {
                driver[key] = value.clone();
            }
            let (joints, oracle) = carriers();
            check(
                &driver.to_string(),
                &json!({"joint": joints, "driver": [driver]}),
                &Both(oracle, Follow(what, follows)),
            );
        }
    }
}

#[test]
fn fixed_quantities() {
    for (quantity, what, _) in quantities() {
        for value in [Some(0.3), None] {
            let mut fixed = json!({"name": "F", "kind": "fixed", "quantity": quantity});
            if let Some(value) = value {
                fixed["value"] = json!(value);
            }
            let (joints, oracle) = carriers();
            check(
                &fixed.to_string(),
                &json!({"joint": joints, "constraint": [fixed]}),
                &Both(oracle, Sum(vec![(1.0, what)], value)),
            );
        }
    }
}

#[test]
fn couplers() {
    let factors = [0.4, -1.1, 0.9, 1.5, -0.7, 0.3, 2.2, -0.8, 2.1, -1.2];
    let list = quantities();
    let mut terms = Vec::new();
    for ((quantity, _, _), factor) in list.iter().zip(factors) {
        let mut term = quantity.clone();
        term["factor"] = json!(factor);
        terms.push(term);
    }
    let (joints, oracle) = carriers();
    let sum = list.iter().zip(factors).map(|((_, what, _), f)| (f, *what));
    check(
        "coupler",
        &json!({"joint": joints, "constraint": [{"name": "K", "kind": "coupler", "terms": terms}]}),
        &Both(oracle, Sum(sum.collect(), None)),
    );
}

#[test]
fn path_drivers() {
    for from in [None, Some("c")] {
        let mut path = json!({"name": "D", "kind": "path", "body": "b", "at": POINT,
            "x": "0.2 m + 0.3 m * sin(1.5 rad/s * t) + 0.1 m * (t / 1 s)^3",
            "z": "0.4 m * cos(2 rad/s * t)"});
        let mut start = spot("ground", [0.0; 3]);
        if let Some(body) = from {
            path["from"] = json!(body);
            path["from_at"] = json!([0.2, 0.6, -0.1]);
            start = spot(body, [0.2, 0.6, -0.1]);
        }
        let spots = [start, spot("b", POINT)];
        let oracle = Both(
            Follow(What::Difference(spots, 0), Motion::Sine),
            Follow(What::Difference(spots, 2), Motion::Cosine),
        );
        check(&path.to_string(), &json!({"driver": [path]}), &oracle);
    }
}

/// The user expressions of these tests.
enum Expression {
    /// Positions and direction cosines.
    Cosines,
    /// Angles of joints and a trace.
    Angles,
}

impl Residual for Expression {
    fn rows<D: Number>(&self, m: &Machine<D>) -> Vec<D> {
        let [a, b, c] = ["a", "b", "c"].map(|body| m.marker(&spot(body, [0.0; 3])));
        vec![match self {
            Self::Cosines => {
                let d = a.point[0] - b.point[2];
                d * d + (a.point[1] + b.point[1]) * a.axes[1][0] * b.axes[0][2]
                    - (m.t * 3.0).cos() * b.axes[2][2] * 0.1
            }
            Self::Angles => {
                let tip = m.marker(&spot("b", POINT));
                let angle = What::Angle(spots(["a", "b"]), 0).value(m);
                let second = What::Angle(cross_back(), 2).value(m);
                let d = between(&c, &tip);
                (angle * 0.3).sin() * (dot(&d, &d) + 1.0).sqrt() + second.cos() * 0.2 - m.t * 0.2
            }
        }]
    }
}

#[test]
fn user_expressions() {
    for (expression, oracle) in [
        (
            "(a.x - b.z)^2 + 1 m * (a.y + b.y) * a.a12 * b.a31 - 0.1 m^2 * cos(3 rad/s * t) * b.a33",
            Expression::Cosines,
        ),
        (
            "sin(0.3 * R.angle) * sqrt(1 m^2 + (tip.x - c.x)^2 + (tip.y - c.y)^2 + (tip.z - c.z)^2) \
             + 0.2 m * cos(U.angle_2) - 0.2 m/s * t",
            Expression::Angles,
        ),
    ] {
        let (joints, others) = carriers();
        let parts = json!({
            "trace": [{"name": "tip", "body": "b", "at": POINT}],
            "joint": joints,
            "constraint": [{"name": "E", "kind": "expression", "expression": expression}]
        });
        check(expression, &parts, &Both(others, oracle));
    }
}
