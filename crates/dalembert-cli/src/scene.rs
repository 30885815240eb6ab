//! From results to the data of the animated page.

use crate::load::Loaded;
use dalembert::results::Results;
use dalembert::system::compile::{DrawnEnd, DrawnForm, DrawnShape};
use dalembert_io::animation::{
    AnimatedBody, AnimatedChannel, AnimatedTrace, Animation, Form, Joint, JointEnd, Load, Shape,
    Spring, SpringEnd,
};

/// The page's data for a run.
pub fn animation(loaded: &Loaded, results: &Results, summary: Vec<(String, String)>) -> Animation {
    let drawing = &loaded.compiled.drawing;
    let values = |name: String| results.channel(&name).map_or(&[][..], |c| &c.values[..]);
    let mut animation = Animation {
        title: results.model.clone(),
        space: "planar".to_owned(),
        analysis: results.analysis.clone(),
        time: values("time".to_owned()).to_vec(),
        notes: results.notes.clone(),
        summary,
        ..Animation::default()
    };
    for body in &drawing.bodies {
        let shapes: Vec<Shape> = body.shapes.iter().map(shape).collect();
        if body.name == dalembert::model::GROUND {
            animation.ground.shapes = shapes;
            continue;
        }
        let of = |c: &str| values(format!("{}.{c}", body.name));
        let (x, y, angle) = (of("x"), of("y"), of("angle"));
        let mut own = AnimatedBody {
            name: body.name.clone(),
            color: body.shapes.iter().find_map(|s| s.color.clone()),
            position: Vec::with_capacity(3 * x.len()),
            quaternion: Vec::with_capacity(4 * x.len()),
            shapes,
        };
        for ((x, y), angle) in x.iter().zip(y).zip(angle) {
            own.position.extend([*x, *y, 0.0]);
            let (s, c) = (0.5 * angle).sin_cos();
            own.quaternion.extend([c, 0.0, 0.0, s]);
        }
        animation.bodies.push(own);
    }
    for j in &drawing.joints {
        animation.joints.push(Joint {
            name: j.name.clone(),
            kind: j.kind.clone(),
            first: joint_end(&j.first),
            second: joint_end(&j.second),
        });
    }
    for s in &drawing.springs {
        animation.springs.push(Spring {
            name: s.name.clone(),
            kind: s.kind.clone(),
            first: spring_end(&s.first),
            second: spring_end(&s.second),
        });
    }
    for (name, end) in &drawing.loads {
        animation.loads.push(Load {
            name: name.clone(),
            on: spring_end(end),
            ..Load::default()
        });
    }
    for (name, end) in &drawing.traces {
        animation.traces.push(AnimatedTrace {
            name: name.clone(),
            body: end.body.clone(),
            at: [end.at[0], end.at[1], 0.0],
        });
    }
    animation.channels = results
        .channels
        .iter()
        .skip(1)
        .map(AnimatedChannel::from)
        .collect();
    animation
}

fn joint_end(e: &DrawnEnd) -> JointEnd {
    JointEnd {
        body: e.body.clone(),
        at: [e.at[0], e.at[1], 0.0],
        direction: Some([e.direction[0], e.direction[1], 0.0]),
        outline: e.outline.clone(),
        ..JointEnd::default()
    }
}

fn spring_end(e: &DrawnEnd) -> SpringEnd {
    SpringEnd {
        body: e.body.clone(),
        at: [e.at[0], e.at[1], 0.0],
    }
}

fn shape(s: &DrawnShape) -> Shape {
    let form = match &s.form {
        DrawnForm::Bar(length, width) => Form::Bar {
            length: *length,
            width: *width,
        },
        DrawnForm::Rectangle(width, height) => Form::Rectangle {
            width: *width,
            height: *height,
        },
        DrawnForm::Circle(radius) => Form::Circle { radius: *radius },
        DrawnForm::Ring(outer, inner) => Form::Ring {
            outer: *outer,
            inner: *inner,
        },
        DrawnForm::Polygon(points) => Form::Polygon {
            points: points.clone(),
        },
        DrawnForm::Lump => Form::Lump,
    };
    let mut out = Shape::new(form).planar(s.at, s.angle);
    out.color = s.color.clone();
    out.cut = s.cut;
    out
}
