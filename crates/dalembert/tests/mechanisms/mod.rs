//! Machines for tests, built without a file.

use dalembert::model::{
    Body, Force, ForceKind, Info, Initial, Joint, JointKind, Model, Placement, Point, Quantity,
};

/// A point.
pub fn point(x: f64, y: f64) -> Point {
    vec![x.into(), y.into()]
}

/// A slender bar with its frame in the middle.
pub fn bar(name: &str, mass: f64, length: f64, at: [f64; 2], angle: f64) -> Body {
    Body {
        name: name.to_owned(),
        mass: Some(mass.into()),
        inertia: Some((mass * length * length / 12.0).into()),
        position: Some(point(at[0], at[1])),
        angle: Some(angle.into()),
        ..Body::default()
    }
}

/// Points of a joint.
pub fn at(bodies: [&str; 2], first: [f64; 2], second: [f64; 2]) -> Placement {
    Placement {
        bodies: bodies.map(str::to_owned),
        at: Some([point(first[0], first[1]), point(second[0], second[1])]),
        ..Placement::default()
    }
}

/// A pin.
pub fn revolute(name: &str, bodies: [&str; 2], first: [f64; 2], second: [f64; 2]) -> Joint {
    Joint {
        name: name.to_owned(),
        kind: JointKind::Revolute {
            placement: at(bodies, first, second),
        },
    }
}

/// A slide along x of both frames.
pub fn prismatic(name: &str, bodies: [&str; 2], first: [f64; 2], second: [f64; 2]) -> Joint {
    let mut placement = at(bodies, first, second);
    placement.angles = Some([0.0.into(), 0.0.into()]);
    Joint {
        name: name.to_owned(),
        kind: JointKind::Prismatic { placement },
    }
}

/// Slider crank: crank 0.15 m, rod 0.35 m, crank at 30 degrees (Shabana, Computational Dynamics,
/// section 3.9).
pub fn slider_crank() -> Model {
    let (l2, l3, th) = (0.15_f64, 0.35_f64, 30.0_f64.to_radians());
    let th3 = (-l2 * th.sin() / l3).asin();
    let (ax, ay) = (l2 * th.cos(), l2 * th.sin());
    Model {
        info: Info {
            name: "slider crank".to_owned(),
            ..Info::default()
        },
        bodies: vec![
            bar("crank", 0.5, l2, [ax / 2.0, ay / 2.0], th),
            bar("rod", 0.8, l3, [ax + l3 / 2.0 * th3.cos(), ay / 2.0], th3),
            bar("slider", 0.6, 0.08, [ax + l3 * th3.cos(), 0.0], 0.0),
        ],
        joints: vec![
            revolute("O", ["ground", "crank"], [0.0, 0.0], [-l2 / 2.0, 0.0]),
            revolute("A", ["crank", "rod"], [l2 / 2.0, 0.0], [-l3 / 2.0, 0.0]),
            revolute("B", ["rod", "slider"], [l3 / 2.0, 0.0], [0.0, 0.0]),
            prismatic("guide", ["ground", "slider"], [0.0, 0.0], [0.0, 0.0]),
        ],
        ..Model::default()
    }
}

/// An initial rate of a joint's angle.
pub fn spinning(joint: &str, rate: f64) -> Initial {
    Initial {
        quantity: Quantity::Angle {
            joint: joint.to_owned(),
        },
        value: None,
        rate: Some(rate.into()),
    }
}

/// A spring-damper between two points.
pub fn spring(
    name: &str,
    bodies: [&str; 2],
    points: [[f64; 2]; 2],
    k: f64,
    c: f64,
    free: f64,
) -> Force {
    Force {
        name: name.to_owned(),
        kind: ForceKind::SpringDamper {
            bodies: bodies.map(str::to_owned),
            at: points.map(|p| point(p[0], p[1])),
            stiffness: Some(k.into()),
            damping: Some(c.into()),
            free_length: Some(free.into()),
            force: None,
        },
    }
}

/// A moment on a body, as an expression.
pub fn moment(name: &str, body: &str, value: &str) -> Force {
    Force {
        name: name.to_owned(),
        kind: ForceKind::Moment {
            body: body.to_owned(),
            value: value.into(),
            axes: None,
        },
    }
}
