//! From results to the data of the animated page.

use crate::load::Loaded;
use dalembert::mass::Solid;
use dalembert::model::{GROUND, SpaceKind};
use dalembert::results::Results;
use dalembert::space::Space;
use dalembert::space::orientation::{OrientationSet, Rotation};
use dalembert::system::compile::{DrawnEnd, DrawnForm, DrawnShape};
use dalembert::words::listed;
use dalembert_io::animation::{
    self, AnimatedBody, AnimatedChannel, AnimatedTrace, Animation, Form, Joint, JointEnd, Load,
    Shape, Spring, SpringEnd,
};

/// The page's data for a run.
pub fn animation<S: Space>(
    loaded: &Loaded<S>,
    results: &Results,
    summary: Vec<(String, String)>,
) -> Animation {
    let drawing = &loaded.compiled.drawing;
    let spatial = loaded.model.info.space == SpaceKind::Spatial;
    let mut animation = Animation {
        title: results.model.clone(),
        space: if spatial { "spatial" } else { "planar" }.to_owned(),
        up: upwards(&loaded.compiled.system.gravity),
        analysis: results.analysis.clone(),
        time: values(results, "time").to_vec(),
        notes: results.notes.clone(),
        summary,
        ..Animation::default()
    };
    let set = loaded.compiled.options.recording.orientation;
    for body in &drawing.bodies {
        let shapes: Vec<Shape> = body.shapes.iter().map(shape).collect();
        if body.name == GROUND {
            animation.ground.shapes = shapes;
            continue;
        }
        let place = ["x", "y", "z"].map(|c| values(results, &format!("{}.{c}", body.name)));
        let turned = orientations(results, &body.name, spatial.then_some(set));
        let mut own = AnimatedBody {
            name: body.name.clone(),
            color: body.shapes.iter().find_map(|s| s.color.clone()),
            position: Vec::with_capacity(3 * turned.len()),
            quaternion: Vec::with_capacity(4 * turned.len()),
            shapes,
        };
        for (k, b) in turned.iter().enumerate() {
            // In the plane there is no z.
            own.position
                .extend(place.map(|x| x.get(k).copied().unwrap_or(0.0)));
            own.quaternion.extend([b.w, b.i, b.j, b.k]);
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
            along: None,
        });
    }
    for (name, end) in &drawing.traces {
        animation.traces.push(AnimatedTrace {
            name: name.clone(),
            body: end.body.clone(),
            at: end.at,
        });
    }
    // The page draws whole curves only.
    let (gaps, whole): (Vec<_>, Vec<_>) = results.channels.iter().skip(1).partition(|c| c.gaps);
    animation.channels = whole.into_iter().map(AnimatedChannel::from).collect();
    if !gaps.is_empty() {
        let names: Vec<&str> = gaps.iter().map(|c| c.name.as_str()).collect();
        animation.notes.push(format!(
            "not drawn, as they have no value at some instants: {}",
            listed(&names)
        ));
    }
    animation
}

fn values<'r>(results: &'r Results, name: &str) -> &'r [f64] {
    results.channel(name).map_or(&[][..], |c| &c.values[..])
}

/// Against gravity; none in the plane and where there is none.
fn upwards(gravity: &[f64]) -> Option<[f64; 3]> {
    let g: [f64; 3] = gravity.try_into().ok()?;
    let size = g.iter().fold(0.0_f64, |m, x| m.hypot(*x));
    (size > 0.0).then(|| g.map(|x| -x / size + 0.0))
}

/// How a body stands at each instant: by its angle in the plane, by a set of coordinates in space.
fn orientations(results: &Results, body: &str, set: Option<OrientationSet>) -> Vec<Rotation> {
    let of = |name: &str| values(results, &format!("{body}.{name}"));
    let Some(set) = set else {
        let about_z = |angle: &f64| Rotation::from_euler_angles(0.0, 0.0, *angle);
        return of("angle").iter().map(about_z).collect();
    };
    let columns: Vec<&[f64]> = set.names().iter().map(|name| of(name)).collect();
    let instants = columns.first().map_or(0, |c| c.len());
    let known: Vec<Option<Rotation>> = (0..instants)
        .map(|k| {
            let numbers: Vec<f64> = columns.iter().map(|c| c[k]).collect();
            set.rotation(&numbers).ok()
        })
        .collect();
    filled(values(results, "time"), &known)
}

/// Poses at instants, those that a set of coordinates leaves open between their neighbours.
fn filled(time: &[f64], known: &[Option<Rotation>]) -> Vec<Rotation> {
    let at = |k: usize| known[k].map(|r| (time.get(k).copied().unwrap_or(k as f64), r));
    let between = |k: usize| {
        let before = (0..k).rev().find_map(at);
        let after = (k + 1..known.len()).find_map(at);
        match (before, after) {
            (Some((t0, from)), Some((t1, to))) => {
                let t = time.get(k).copied().unwrap_or(k as f64);
                // None where both are half a turn apart: every way is as short then.
                from.try_slerp(&to, (t - t0) / (t1 - t0), 0.0)
                    .unwrap_or(from)
            }
            (Some((_, only)), None) | (None, Some((_, only))) => only,
            (None, None) => Rotation::identity(),
        }
    };
    let pose = |(k, r): (usize, &Option<Rotation>)| r.unwrap_or_else(|| between(k));
    known.iter().enumerate().map(pose).collect()
}

fn joint_end(e: &DrawnEnd) -> JointEnd {
    JointEnd {
        body: e.body.clone(),
        at: e.at,
        direction: Some(e.direction),
        reference: e.reference,
        outline: e.outline.clone(),
    }
}

fn spring_end(e: &DrawnEnd) -> SpringEnd {
    SpringEnd {
        body: e.body.clone(),
        at: e.at,
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
        DrawnForm::Solid(form) => solid(form).into(),
        DrawnForm::Rod(length, radius) => animation::Solid::Rod {
            length: *length,
            radius: *radius,
        }
        .into(),
        DrawnForm::Disk(radius, thickness) => animation::Solid::Disk {
            radius: *radius,
            thickness: *thickness,
        }
        .into(),
        DrawnForm::Plate(width, height, thickness) => animation::Solid::Plate {
            width: *width,
            height: *height,
            thickness: *thickness,
        }
        .into(),
        DrawnForm::Torus(radius, tube) => animation::Solid::Torus {
            radius: *radius,
            tube: *tube,
        }
        .into(),
        DrawnForm::Sheet(sheet) => animation::Solid::Surface {
            nu: sheet.nu,
            nv: sheet.nv,
            points: sheet.points.as_flattened().to_vec(),
        }
        .into(),
        DrawnForm::Mesh {
            vertices,
            triangles,
        } => animation::Solid::Mesh {
            vertices: vertices.as_flattened().to_vec(),
            triangles: triangles.as_flattened().iter().map(|&k| k as u32).collect(),
        }
        .into(),
    };
    let mut out = Shape::new(form);
    out.position = s.at;
    out.quaternion = s.quaternion;
    out.color = s.color.clone();
    out.cut = s.cut;
    out
}

fn solid(form: &Solid) -> animation::Solid {
    use animation::Solid as Drawn;
    match *form {
        Solid::Box(size) => Drawn::Box { size },
        Solid::Cylinder { radius, length } => Drawn::Cylinder { radius, length },
        Solid::Tube {
            inner,
            outer,
            length,
        } => Drawn::Tube {
            outer,
            inner,
            length,
        },
        Solid::Sphere { radius } | Solid::Shell { radius } => Drawn::Sphere { radius },
        Solid::Hemisphere { radius } => Drawn::Hemisphere { radius },
        Solid::Cone { radius, height } => Drawn::Cone { radius, height },
        Solid::Rod { length } => Drawn::Rod {
            length,
            radius: 0.025 * length,
        },
        Solid::Disk { radius } => Drawn::Disk {
            radius,
            thickness: 0.025 * radius,
        },
        Solid::Plate([width, height]) => Drawn::Plate {
            width,
            height,
            thickness: 0.025 * width.min(height),
        },
        Solid::Ellipsoid(semi_axes) => Drawn::Ellipsoid { semi_axes },
    }
}
