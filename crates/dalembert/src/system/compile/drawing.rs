//! The picture of a machine: shapes and elements with numbers instead of names and expressions.

use super::context::Context;
use super::geometry::Geometry;
use super::outlines::Outlines;
use super::place::Place;
use crate::mass::Solid;
use crate::model::GROUND;
use crate::surface::Sheet;
use crate::system::{Role, System};
use nalgebra::{Quaternion, Vector3};

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
    /// A solid of space.
    Solid(Solid),
    /// Length along x, radius.
    Rod(f64, f64),
    /// Radius, thickness along z.
    Disk(f64, f64),
    /// Width along x, height along y, thickness along z.
    Plate(f64, f64, f64),
    /// Radius of the middle circle about z, radius of the tube.
    Torus(f64, f64),
    /// A surface as a grid of points, which one can look through.
    Sheet(Sheet),
    /// Triangles.
    Mesh {
        /// Corners.
        vertices: Vec<[f64; 3]>,
        /// Numbers of the corners of each triangle.
        triangles: Vec<[usize; 3]>,
    },
}

/// A shape in the frame of its body.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnShape {
    /// Form.
    pub form: DrawnForm,
    /// Origin of its frame.
    pub at: [f64; 3],
    /// Orientation of its frame, scalar first.
    pub quaternion: [f64; 4],
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
    pub at: [f64; 3],
    /// Direction of the element's axis in the body's frame: x in the plane, z in space.
    pub direction: [f64; 3],
    /// Direction of the element's x axis in the body's frame, in space.
    pub reference: Option<[f64; 3]>,
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
    pub(super) fn add_elements<S: Geometry>(&mut self, system: &System<S>, outlines: &Outlines) {
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
        self.add_sheets(system);
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

impl Drawing {
    /// The surfaces of contacts on bodies that have no shape of their own: else these would float.
    fn add_sheets<S: Geometry>(&mut self, system: &System<S>) {
        let bare: Vec<bool> = self.bodies.iter().map(|b| b.shapes.is_empty()).collect();
        let aux = system.bodies.len() * S::NQ;
        let bodies = system.estimate.q[..aux].chunks_exact(S::NQ);
        // A ball alone is small beside the way on which it slides.
        let size = bodies.fold(system.size, |m, q| m.max(S::reach(q)[0]));
        for e in &system.elements {
            let s = &system.estimate.q[aux + e.aux.start..aux + e.aux.end];
            for (k, mut sheet) in e.element.sheets(s, size) {
                let m = &system.markers[e.markers[k]];
                // Movable bodies in their order, then the ground.
                let body = m.body.unwrap_or(system.bodies.len());
                if !bare.get(body).is_some_and(|bare| *bare) {
                    continue;
                }
                // Frames count from the centre of mass, shapes from the body's origin.
                let (mut at, mut turn) = (S::origin(&m.frame), S::rotation(&m.frame));
                if let Some(b) = m.body {
                    let own = &system.bodies[b].frame;
                    let back = S::rotation(own).inverse();
                    at = back * (at - S::origin(own));
                    turn = back * turn;
                }
                for p in &mut sheet.points {
                    *p = (at + turn * Vector3::from(*p)).into();
                }
                self.bodies[body].shapes.push(DrawnShape {
                    form: DrawnForm::Sheet(sheet),
                    at: [0.0; 3],
                    quaternion: [1.0, 0.0, 0.0, 0.0],
                    color: None,
                    cut: false,
                });
            }
        }
    }
}

fn end<S: Geometry>(system: &System<S>, marker: usize) -> DrawnEnd {
    let m = &system.markers[marker];
    let at = S::origin(&m.frame);
    let (body, at) = match m.body {
        Some(b) => {
            let own = &system.bodies[b];
            (own.name.clone(), at - S::origin(&own.frame))
        }
        None => (GROUND.to_owned(), at),
    };
    DrawnEnd {
        body,
        at: at.into(),
        direction: S::direction(&m.frame).into(),
        reference: S::reference(&m.frame).map(Into::into),
        outline: Vec::new(),
    }
}

impl<S: Geometry> Context<'_, S> {
    /// The shapes of the bodies; mistakes in them have been reported with the mass properties.
    pub fn drawing(&mut self) -> Drawing {
        let model = self.model;
        let mut drawing = Drawing::default();
        let mut ground = DrawnBody {
            name: GROUND.to_owned(),
            shapes: Vec::new(),
        };
        for (index, body) in model.bodies.iter().enumerate() {
            let place = Place::new("body", index, "body", &body.name);
            let mut shapes: Vec<DrawnShape> = body
                .shape
                .iter()
                .filter_map(|s| S::shape(self, s, &place))
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
                    let turn = S::rotation(&own.frame);
                    let at = S::origin(&own.frame) + turn * Vector3::from(s.at);
                    let [w, x, y, z] = s.quaternion;
                    let stands = turn.quaternion() * Quaternion::new(w, x, y, z);
                    s.at = at.into();
                    s.quaternion = [stands.w, stands.i, stands.j, stands.k];
                }
                ground.shapes.append(&mut shapes);
            }
        }
        drawing.bodies.push(ground);
        drawing
    }
}
