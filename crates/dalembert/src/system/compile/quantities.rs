//! Scalar quantities that users name.

use super::context::{Context, GlobalMeasure, JointPlace};
use super::geometry::Geometry;
use super::place::Place;
use crate::diagnostic::Diagnostic;
use crate::joint::MeasureKind;
use crate::model::{CoordinateName, JointKind, Point, Quantity};
use crate::space::Space;
use dalembert_expr::Dim;
use nalgebra::Vector3;

/// Dimension of the value of a measure.
pub(super) fn dim_of<S: Space>(kind: S::Measure) -> Dim {
    if kind.is_length() {
        Dim::LENGTH
    } else {
        Dim::NONE
    }
}

impl<S: Geometry> Context<'_, S> {
    /// Dimension of a quantity, which its kind alone says.
    pub fn quantity_dim(quantity: &Quantity) -> Dim {
        match quantity {
            Quantity::Coordinate {
                coordinate: CoordinateName::Angle,
                ..
            }
            | Quantity::Angle { .. }
            | Quantity::RelativeAngle { .. } => Dim::NONE,
            Quantity::JointCoordinate { coordinate, .. } if coordinate.starts_with("angle") => {
                Dim::NONE
            }
            Quantity::Coordinate { .. }
            | Quantity::Displacement { .. }
            | Quantity::JointCoordinate { .. }
            | Quantity::Distance { .. } => Dim::LENGTH,
        }
    }

    /// The measure that a quantity stands for.
    pub fn quantity(
        &mut self,
        quantity: &Quantity,
        owner: &str,
        path: &str,
    ) -> Option<GlobalMeasure<S>> {
        match quantity {
            Quantity::Coordinate {
                body,
                at,
                coordinate,
            } => {
                let place = self.place(body, owner, &format!("{path}.body"));
                let at = match at {
                    Some(at) => self.vector(at, Dim::LENGTH, owner, &format!("{path}.at")),
                    None => Some(Vector3::zeros()),
                };
                let at = self.or_origin(at);
                // A name of the other space has been reported.
                let kind = S::coordinate(*coordinate)?;
                let second = self.marker(&place, &S::frame(&at));
                Some(GlobalMeasure {
                    kind,
                    first: 0,
                    second,
                })
            }
            Quantity::Angle { joint } => self.joint_coordinate(joint, "angle", owner, path),
            Quantity::Displacement { joint } => {
                self.joint_coordinate(joint, "displacement", owner, path)
            }
            Quantity::JointCoordinate { joint, coordinate } => {
                self.joint_coordinate(joint, coordinate, owner, path)
            }
            Quantity::RelativeAngle { bodies, axis } => {
                let place = Place {
                    owner: owner.to_owned(),
                    path: path.to_owned(),
                };
                S::relative_angle(self, bodies, axis.as_ref(), &place)
            }
            Quantity::Distance { bodies, at } => {
                let [first, second] = self.two_points(bodies, at, owner, path);
                let m = GlobalMeasure {
                    kind: S::Measure::DISTANCE,
                    first,
                    second,
                };
                self.nonzero_distance(m, owner, path)
            }
        }
    }

    /// Markers at one point of each of two bodies.
    pub fn two_points(
        &mut self,
        bodies: &[String; 2],
        at: &[Point; 2],
        owner: &str,
        path: &str,
    ) -> [usize; 2] {
        [0, 1].map(|k| {
            let place = self.place(&bodies[k], owner, &format!("{path}.bodies[{k}]"));
            let point = self.vector(&at[k], Dim::LENGTH, owner, &format!("{path}.at[{k}]"));
            let point = self.or_origin(point);
            self.marker(&place, &S::frame(&point))
        })
    }

    /// Refuses a distance that is zero in the estimate: its direction would be undefined.
    pub fn nonzero_distance(
        &mut self,
        m: GlobalMeasure<S>,
        owner: &str,
        path: &str,
    ) -> Option<GlobalMeasure<S>> {
        if self.stand_ins || self.estimate(m) > 0.0 {
            return Some(m);
        }
        self.report(
            Diagnostic::error(
                "zero-length",
                path,
                format!("{owner}: its two points coincide in the initial estimate, the direction between them is undefined"),
            )
            .help("move one of the points or the estimate of a body"),
        );
        None
    }

    /// A free coordinate of a joint by its name.
    pub fn joint_coordinate(
        &mut self,
        joint: &str,
        name: &str,
        owner: &str,
        path: &str,
    ) -> Option<GlobalMeasure<S>> {
        self.coordinate_at(joint, name, owner, &format!("{path}.joint"))
    }

    /// A free coordinate of a joint by its name; `path` is where the joint is named.
    pub fn coordinate_at(
        &mut self,
        joint: &str,
        name: &str,
        owner: &str,
        path: &str,
    ) -> Option<GlobalMeasure<S>> {
        let place = self.joint_place(joint, owner, path)?;
        if let Some(c) = place.coordinates.iter().find(|c| c.name == name) {
            return Some(GlobalMeasure {
                kind: c.measure.kind,
                first: place.markers[c.measure.first],
                second: place.markers[c.measure.second],
            });
        }
        let has: Vec<&str> = place.coordinates.iter().map(|c| c.name).collect();
        let help = if has.is_empty() {
            "this kind of joint has no coordinate".to_owned()
        } else {
            format!("this joint has: {}", has.join(", "))
        };
        self.report(
            Diagnostic::error(
                "no-coordinate",
                path,
                format!("{owner}: joint '{joint}' has no {name}"),
            )
            .help(help),
        );
        None
    }

    /// The only free coordinate of a joint.
    pub fn only_coordinate(
        &mut self,
        joint: &str,
        owner: &str,
        path: &str,
    ) -> Option<GlobalMeasure<S>> {
        let place = self.joint_place(joint, owner, &format!("{path}.joint"))?;
        if let [c] = place.coordinates.as_slice() {
            return Some(GlobalMeasure {
                kind: c.measure.kind,
                first: place.markers[c.measure.first],
                second: place.markers[c.measure.second],
            });
        }
        self.report(
            Diagnostic::error(
                "no-coordinate",
                format!("{path}.joint"),
                format!("{owner}: joint '{joint}' does not have exactly one coordinate"),
            )
            .help("use a revolute or prismatic joint, or a force between two points"),
        );
        None
    }

    fn joint_place(&mut self, joint: &str, owner: &str, path: &str) -> Option<JointPlace<S>> {
        if let Some(j) = self.joint_places.get(joint) {
            return Some(j.clone());
        }
        let pairs = |kind: &JointKind| {
            matches!(
                kind,
                JointKind::GearPair { .. } | JointKind::RackPair { .. }
            )
        };
        if let Some(found) = self.model.joints.iter().find(|j| j.name == joint) {
            // Pairs join coordinates of other joints. Anything else that could not be compiled has been reported already.
            if pairs(&found.kind) {
                let said = format!(
                    "{owner}: '{joint}' couples other joints and has no coordinate of its own"
                );
                self.report(
                    Diagnostic::error("no-coordinate", path, said)
                        .help("name a joint between two bodies: a revolute or prismatic one"),
                );
            }
            return None;
        }
        let joints = self.model.joints.iter().filter(|j| !pairs(&j.kind));
        let known: Vec<&str> = joints.map(|j| j.name.as_str()).collect();
        let help = super::context::suggestion(joint, &known).unwrap_or_else(|| {
            if known.is_empty() {
                "the model has no joints".to_owned()
            } else {
                format!("the joints are: {}", known.join(", "))
            }
        });
        self.report(
            Diagnostic::error(
                "unknown-joint",
                path,
                format!("{owner}: there is no joint '{joint}'"),
            )
            .help(help),
        );
        None
    }
}
