//! The curves by which joints touch, as forms of bodies that have none.

use super::context::Context;
use super::drawing::DrawnEnd;
use super::geometry::Geometry;
use super::place::Place;
use std::collections::HashMap;

/// A closed curve in the axes of a joint's end.
type Curve = Vec<[f64; 2]>;

/// The curves of the joints, by name: on the first and on the second body.
#[derive(Debug, Default)]
pub(super) struct Outlines(HashMap<String, [Curve; 2]>);

impl Outlines {
    /// Gives the ends of a joint their curves, in the frames of the bodies.
    pub fn put(&self, joint: &str, ends: &mut [DrawnEnd; 2]) {
        let Some(curves) = self.0.get(joint) else {
            return;
        };
        for (end, curve) in ends.iter_mut().zip(curves) {
            let ([x, y, _], [c, s, _]) = (end.at, end.direction);
            let moved = |&[u, v]: &[f64; 2]| [x + c * u - s * v, y + s * u + c * v];
            end.outline = curve.iter().map(moved).collect();
        }
    }
}

impl<S: Geometry> Context<'_, S> {
    /// The curves of all joints; mistakes in them have been reported with the joints.
    pub fn outlines(&mut self) -> Outlines {
        let model = self.model;
        let mut outlines = Outlines::default();
        for (index, joint) in model.joints.iter().enumerate() {
            let place = Place::new("joint", index, "joint", &joint.name);
            if let Some(curves) = S::outline(self, &joint.name, &joint.kind, &place) {
                outlines.0.insert(joint.name.clone(), curves);
            }
        }
        outlines
    }
}
