//! Machines that several tests look at.
#![allow(dead_code)]

use dalembert::model::Model;
use dalembert::space::Planar;
use dalembert::system::System;
use dalembert::system::compile::compile;
use serde_json::{Value, json};
use std::f64::consts::TAU;

pub type Point = [f64; 2];

/// A machine that grows by bodies and joints given at their places in the ground.
#[derive(Default)]
pub struct Machine {
    bodies: Vec<Value>,
    joints: Vec<Value>,
    constraints: Vec<Value>,
    drivers: Vec<Value>,
    forces: Vec<Value>,
}

impl Machine {
    /// A bar from one point to another; its frame lies in the middle, along the bar.
    pub fn bar(self, name: &str, a: Point, b: Point) -> Self {
        let [x, y] = [b[0] - a[0], b[1] - a[1]];
        self.body(json!({
            "name": name, "mass": 1.0, "inertia": 0.1,
            "position": [a[0] + x / 2.0, a[1] + y / 2.0], "angle": y.atan2(x)
        }))
    }

    pub fn body(mut self, body: Value) -> Self {
        self.bodies.push(body);
        self
    }

    pub fn pin(self, name: &str, first: &str, second: &str, point: Point) -> Self {
        self.joint(json!({
            "name": name, "kind": "revolute", "bodies": [first, second], "point": point
        }))
    }

    pub fn slide(self, name: &str, first: &str, second: &str, point: Point, along: Point) -> Self {
        self.joint(json!({
            "name": name, "kind": "prismatic", "bodies": [first, second],
            "point": point, "direction": along
        }))
    }

    pub fn joint(mut self, joint: Value) -> Self {
        self.joints.push(joint);
        self
    }

    pub fn constraint(mut self, constraint: Value) -> Self {
        self.constraints.push(constraint);
        self
    }

    pub fn driver(mut self, driver: Value) -> Self {
        self.drivers.push(driver);
        self
    }

    pub fn force(mut self, force: Value) -> Self {
        self.forces.push(force);
        self
    }

    pub fn model(self) -> Model {
        serde_json::from_value(json!({
            "model": { "name": "test" },
            "body": self.bodies, "joint": self.joints, "constraint": self.constraints,
            "driver": self.drivers, "force": self.forces
        }))
        .unwrap()
    }

    pub fn system(self) -> System<Planar> {
        compile::<dalembert::space::Planar>(&self.model(), &[])
            .unwrap()
            .system
    }
}

/// Crank of length `a`, rod of length `b`, slider on the x axis; the crank at an angle.
pub fn slider_crank(a: f64, b: f64, angle: f64) -> Machine {
    let pin = [a * angle.cos(), a * angle.sin()];
    let x = pin[0] + (b * b - pin[1] * pin[1]).max(0.0).sqrt();
    slider_crank_at(pin, x)
}

/// A slider crank with the crank pin at a point and the slider at x.
pub fn slider_crank_at(pin: Point, x: f64) -> Machine {
    Machine::default()
        .bar("crank", [0.0, 0.0], pin)
        .bar("rod", pin, [x, 0.0])
        .body(json!({ "name": "slider", "mass": 1.0, "inertia": 0.1, "position": [x, 0.0] }))
        .pin("O", "ground", "crank", [0.0, 0.0])
        .pin("A", "crank", "rod", pin)
        .pin("B", "rod", "slider", [x, 0.0])
        .slide("S", "ground", "slider", [x, 0.0], [1.0, 0.0])
}

pub fn four_bar() -> Machine {
    let (o, a, b, c) = ([0.0, 0.0], [0.1, 0.2], [0.6, 0.4], [0.6, 0.0]);
    Machine::default()
        .bar("crank", o, a)
        .bar("coupler", a, b)
        .bar("rocker", b, c)
        .pin("O", "ground", "crank", o)
        .pin("A", "crank", "coupler", a)
        .pin("B", "coupler", "rocker", b)
        .pin("C", "rocker", "ground", c)
}

/// Three equal parallel rockers of 0.5 m, pivots 1 m apart, one coupler.
pub fn double_parallelogram(angle: f64) -> Machine {
    let top = |x: f64| [x + 0.5 * angle.cos(), 0.5 * angle.sin()];
    let mut machine = Machine::default();
    for (k, x) in [0.0, 1.0, 2.0].into_iter().enumerate() {
        machine = machine.bar(&format!("rocker {}", k + 1), [x, 0.0], top(x));
    }
    machine = machine.bar("coupler", top(0.0), top(2.0));
    for (k, x) in [0.0, 1.0, 2.0].into_iter().enumerate() {
        let rocker = format!("rocker {}", k + 1);
        machine = machine
            .pin(&format!("J{}", 2 * k + 1), "ground", &rocker, [x, 0.0])
            .pin(&format!("J{}", 2 * k + 2), &rocker, "coupler", top(x));
    }
    machine
}

/// Peaucellier's straight-line linkage: 8 links with the ground, 10 revolutes.
pub fn peaucellier() -> Machine {
    let (o, q) = ([0.0, 0.0], [1.0, 0.0]);
    let turn: f64 = 0.7;
    let p = [1.0 + turn.cos(), turn.sin()];
    let along = f64::hypot(p[0], p[1]);
    let e = [p[0] / along, p[1] / along];
    // Arms of length 3, rhombus of side 1.2; A and B lie beside the line O-P.
    let (long, side): (f64, f64) = (3.0, 1.2);
    // Distance of the foot of A from O, where |OA| = long and |PA| = side.
    let foot = (long * long - side * side + along * along) / (2.0 * along);
    let h = (long * long - foot * foot).sqrt();
    let a = [foot * e[0] - h * e[1], foot * e[1] + h * e[0]];
    let b = [foot * e[0] + h * e[1], foot * e[1] - h * e[0]];
    let r = [a[0] + b[0] - p[0], a[1] + b[1] - p[1]];
    Machine::default()
        .bar("QP", q, p)
        .bar("OA", o, a)
        .bar("OB", o, b)
        .bar("AP", a, p)
        .bar("BP", b, p)
        .bar("AR", a, r)
        .bar("BR", b, r)
        .pin("J1", "ground", "QP", q)
        .pin("J2", "ground", "OA", o)
        .pin("J3", "ground", "OB", o)
        .pin("J4", "OA", "AP", a)
        .pin("J5", "OA", "AR", a)
        .pin("J6", "OB", "BP", b)
        .pin("J7", "OB", "BR", b)
        .pin("J8", "QP", "AP", p)
        .pin("J9", "QP", "BP", p)
        .pin("J10", "AR", "BR", r)
}

/// A closed chain of equal links around a centre, floating.
pub fn ring(mut machine: Machine, links: usize, center: Point, radius: f64) -> Machine {
    let corner = |k: usize| {
        let angle = TAU * k as f64 / links as f64;
        [
            center[0] + radius * angle.cos(),
            center[1] + radius * angle.sin(),
        ]
    };
    for k in 0..links {
        machine = machine.bar(
            &format!("link {}", k + 1),
            corner(k),
            corner((k + 1) % links),
        );
    }
    for k in 0..links {
        let (a, b) = (k + 1, (k + 1) % links + 1);
        machine = machine.pin(
            &format!("R{a}"),
            &format!("link {a}"),
            &format!("link {b}"),
            corner((k + 1) % links),
        );
    }
    machine
}

/// A tracked vehicle's topology: chassis, 10 wheels, a closed chain of 42 track links.
pub fn tracked_vehicle() -> Machine {
    let mut machine =
        Machine::default().body(json!({ "name": "chassis", "mass": 100.0, "inertia": 50.0 }));
    let mut wheels: Vec<(String, Point)> = vec![
        ("sprocket".into(), [-2.0, 0.3]),
        ("idler".into(), [2.0, 0.3]),
    ];
    for k in 0..7 {
        wheels.push((format!("roller {}", k + 1), [-1.5 + 0.5 * k as f64, 0.0]));
    }
    wheels.push(("upper roller".into(), [0.1, 0.6]));
    for (name, at) in &wheels {
        machine = machine.body(json!({
            "name": name, "mass": 5.0, "inertia": 0.2, "position": at
        }));
    }
    for (name, at) in &wheels {
        machine = machine.pin(&format!("pin of {name}"), "chassis", name, *at);
    }
    ring(machine, 42, [0.0, 0.3], 2.5)
}
