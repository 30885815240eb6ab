//! The picture of a machine: shapes and elements with numbers instead of names and expressions.

use super::context::Context;
use super::outlines::Outlines;
use super::place::Place;
use crate::model::{Shape, ShapeKind};
use crate::space::Planar;
use crate::system::{Role, System};
use dalembert_expr::Dim;
use nalgebra::Vector2;

/// A form with its sizes [m].
#[derive(Clone, Debug, PartialEq)]
pub enum DrawnForm {
    /// Length between the ends, width.
    Bar(f64, f64),
    /// Width, height.
    Rectangle(f64, f64),
    /// Radius.
    Circle(f64),
    /// Outer and inner radius.
    Ring(f64, f64),
    /// Corners.
    Polygon(Vec<[f64; 2]>),
    /// A dot.
    Lump,
}

/// A shape in the frame of its body.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnShape {
    /// Form.
    pub form: DrawnForm,
    /// Centre.
    pub at: [f64; 2],
    /// Angle [rad].
    pub angle: f64,
    /// Colour.
    pub color: Option<String>,
    /// Is it cut out?
    pub cut: bool,
}

/// Shapes of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnBody {
    /// Name; "ground" for fixed bodies.
    pub name: String,
    /// Shapes; those of fixed bodies in ground axes.
    pub shapes: Vec<DrawnShape>,
}

/// One end of an element.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnEnd {
    /// Body or "ground".
    pub body: String,
    /// Point in the body's frame.
    pub at: [f64; 2],
    /// Direction of the element's x axis in the body's frame.
    pub direction: [f64; 2],
    /// Closed curve of the joint on the body, in the body's frame: a pitch circle, a profile;
    /// mostly empty.
    pub outline: Vec<[f64; 2]>,
}

/// A joint or a two-point force element.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnElement {
    /// Name.
    pub name: String,
    /// Kind.
    pub kind: String,
    /// First end.
    pub first: DrawnEnd,
    /// Second end.
    pub second: DrawnEnd,
}

/// Everything that a picture needs beside the poses.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// Movable bodies in the order of the system, then the ground.
    pub bodies: Vec<DrawnBody>,
    /// Joints.
    pub joints: Vec<DrawnElement>,
    /// Springs and bushings.
    pub springs: Vec<DrawnElement>,
    /// Elements that push a body at a point: name and place.
    pub loads: Vec<(String, DrawnEnd)>,
    /// Traces: name and place.
    pub traces: Vec<(String, DrawnEnd)>,
}

impl Drawing {
    /// Adds joints, springs and traces of a system.
    pub(super) fn add_elements(&mut self, system: &System<Planar>, outlines: &Outlines) {
        for e in &system.elements {
            if e.role == Role::Joint && e.markers.len() >= 2 {
                // The user's second body is the one on which the reaction is reported.
                let second = e.reaction_marker;
                let first = usize::from(second == 0);
                let mut ends = [first, second].map(|k| end(system, e.markers[k]));
                outlines.put(&e.name, &mut ends);
                let [first, second] = ends;
                self.joints.push(DrawnElement {
                    name: e.name.clone(),
                    kind: e.kind.clone(),
                    first,
                    second,
                });
            }
            if e.kind == "path driver" {
                let on = end(system, e.markers[e.reaction_marker]);
                self.loads.push((e.name.clone(), on));
            }
        }
        for f in &system.forces {
            if f.kind == "force" {
                let on = end(system, f.markers[0]);
                self.loads.push((f.name.clone(), on));
            }
            if matches!(f.kind.as_str(), "spring-damper" | "bushing") {
                self.springs.push(DrawnElement {
                    name: f.name.clone(),
                    kind: f.kind.clone(),
                    first: end(system, f.markers[0]),
                    second: end(system, f.markers[1]),
                });
            }
        }
        for t in &system.traces {
            self.traces.push((t.name.clone(), end(system, t.marker)));
        }
    }
}

fn end(system: &System<Planar>, marker: usize) -> DrawnEnd {
    let m = &system.markers[marker];
    let (s, c) = m.frame.angle.sin_cos();
    let (body, at) = match m.body {
        Some(b) => (
            system.bodies[b].name.clone(),
            m.frame.at - system.bodies[b].frame.at,
        ),
        None => (crate::model::GROUND.to_owned(), m.frame.at),
    };
    DrawnEnd {
        body,
        at: [at.x, at.y],
        direction: [c, s],
        outline: Vec::new(),
    }
}

impl Context<'_> {
    /// The shapes of the bodies; mistakes in them have been reported with the mass properties.
    pub fn drawing(&mut self) -> Drawing {
        let model = self.model;
        let mut drawing = Drawing::default();
        let mut ground = DrawnBody {
            name: crate::model::GROUND.to_owned(),
            shapes: Vec::new(),
        };
        for (index, body) in model.bodies.iter().enumerate() {
            let place = Place::new("body", index, "body", &body.name);
            let mut shapes: Vec<DrawnShape> = body
                .shape
                .iter()
                .filter_map(|s| self.drawn_shape(s, &place))
                .collect();
            let Some(own) = self.places.get(&body.name).cloned() else {
                continue;
            };
            if own.body.is_some() {
                drawing.bodies.push(DrawnBody {
                    name: body.name.clone(),
                    shapes,
                });
            } else {
                for s in &mut shapes {
                    let at = own.origin
                        + super::context::rotate(own.angle, &Vector2::new(s.at[0], s.at[1]));
                    s.at = [at.x, at.y];
                    s.angle += own.angle;
                }
                ground.shapes.append(&mut shapes);
            }
        }
        drawing.bodies.push(ground);
        drawing
    }

    fn drawn_shape(&mut self, shape: &Shape, place: &Place) -> Option<DrawnShape> {
        let mut n = |v| self.number(v, Dim::LENGTH, &place.owner, &place.path);
        let form = match &shape.kind {
            ShapeKind::Bar { length, width } => {
                let l = n(length)?;
                DrawnForm::Bar(l, width.as_ref().and_then(&mut n).unwrap_or(0.1 * l))
            }
            ShapeKind::Rectangle { width, height } => DrawnForm::Rectangle(n(width)?, n(height)?),
            ShapeKind::Circle { radius } => DrawnForm::Circle(n(radius)?),
            ShapeKind::Ring { outer, inner } => DrawnForm::Ring(n(outer)?, n(inner)?),
            ShapeKind::Polygon { points } => {
                let corners: Option<Vec<[f64; 2]>> = points
                    .iter()
                    .map(|p| Some([n(p.first()?)?, n(p.get(1)?)?]))
                    .collect();
                DrawnForm::Polygon(corners?)
            }
            ShapeKind::Lump { .. } => DrawnForm::Lump,
            // A planar model has no others.
            ShapeKind::Box { .. }
            | ShapeKind::Cylinder { .. }
            | ShapeKind::Tube { .. }
            | ShapeKind::Sphere { .. }
            | ShapeKind::Shell { .. }
            | ShapeKind::Hemisphere { .. }
            | ShapeKind::Cone { .. }
            | ShapeKind::Rod { .. }
            | ShapeKind::Disk { .. }
            | ShapeKind::Plate { .. }
            | ShapeKind::Ellipsoid { .. }
            | ShapeKind::Mesh { .. }
            | ShapeKind::Torus { .. } => return None,
        };
        let at = self.optional_point(shape.at.as_ref(), place, "shape")?;
        let angle = self
            .optional(shape.angle.as_ref(), Dim::NONE, place, "shape")
            .unwrap_or(0.0);
        Some(DrawnShape {
            form,
            at: [at.x, at.y],
            angle,
            color: shape.color.clone(),
            cut: shape.cut,
        })
    }
}
