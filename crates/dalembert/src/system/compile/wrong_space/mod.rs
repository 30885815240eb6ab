//! Keys and kinds that belong to the other space: all of them, before anything is compiled.

mod findings;
mod kinds;

use super::place::Place;
use crate::diagnostic::Diagnostic;
use crate::model::{
    AxialVector, Body, ConstraintKind, CoordinateName, DriverKind, ForceKind, HeldCoordinate,
    Inertia, JointKind, Model, Placement, Quantity, Shape, ShapeKind,
    SpaceKind::{Planar, Spatial},
};
use findings::Findings;

/// Every key and kind of a model that its space does not have.
pub(super) fn check(model: &Model) -> Vec<Diagnostic> {
    let mut findings = Findings {
        space: model.info.space,
        list: Vec::new(),
    };
    for (index, body) in model.bodies.iter().enumerate() {
        let place = Place::new("body", index, "body", &body.name);
        findings.body(body, &place);
    }
    for (index, joint) in model.joints.iter().enumerate() {
        let place = Place::new("joint", index, "joint", &joint.name);
        findings.joint(&joint.kind, &place);
    }
    for (index, constraint) in model.constraints.iter().enumerate() {
        let place = Place::new("constraint", index, "constraint", &constraint.name);
        findings.constraint(&constraint.kind, &place);
    }
    for (index, driver) in model.drivers.iter().enumerate() {
        let place = Place::new("driver", index, "driver", &driver.name);
        match &driver.kind {
            DriverKind::Scalar { quantity, .. } => findings.quantity(quantity, &place),
            DriverKind::Path { z, .. } => {
                let remedy = "a planar path has x and y";
                findings.key(z.is_some(), Spatial, &place, "z", remedy);
            }
        }
    }
    for (index, force) in model.forces.iter().enumerate() {
        let place = Place::new("force", index, "force", &force.name);
        findings.force(&force.kind, &place);
    }
    for (index, initial) in model.initial.iter().enumerate() {
        let number = (index + 1).to_string();
        let place = Place::new("initial", index, "initial condition", &number);
        findings.quantity(&initial.quantity, &place);
    }
    for (index, trace) in model.traces.iter().enumerate() {
        let place = Place::new("trace", index, "trace", &trace.name);
        findings.turned(
            trace.angle.is_some(),
            trace.orientation.is_some(),
            "trace",
            &place,
        );
    }
    let output = Place {
        owner: "section [output]".to_owned(),
        path: "output".to_owned(),
    };
    findings.key(
        model.output.orientation.is_some(),
        Spatial,
        &output,
        "orientation",
        "the orientation of a planar body is its angle: leave the key out",
    );
    findings.list
}

impl Findings {
    fn body(&mut self, body: &Body, place: &Place) {
        let turned = (body.angle.is_some(), body.orientation.is_some());
        self.turned(turned.0, turned.1, "body", place);
        if let Some(inertia) = &body.inertia {
            self.inertia(inertia, place);
        }
        let about = "a planar body has one moment of inertia, about its centre of mass";
        let given = body.inertia_at.is_some();
        self.key(given, Spatial, place, "inertia_at", about);
        let given = body.inertia_orientation.is_some();
        self.key(given, Spatial, place, "inertia_orientation", about);
        if let Some(omega) = &body.angular_velocity {
            self.axial(omega, place, "angular_velocity");
        }
        self.key(
            body.angular_velocity_axes.is_some(),
            Spatial,
            place,
            "angular_velocity_axes",
            "a planar body turns about the axis across the plane: leave the key out",
        );
        for (k, held) in body.hold.iter().enumerate() {
            let key = format!("hold[{k}]");
            let planar = "a planar body holds \"x\", \"y\" and \"angle\"";
            match held {
                HeldCoordinate::X | HeldCoordinate::Y => {}
                HeldCoordinate::Angle => {
                    let remedy = "a spatial body holds \"x\", \"y\", \"z\" and \"orientation\"";
                    self.form(Planar, place, &key, "\"angle\"", remedy);
                }
                HeldCoordinate::Z => self.form(Spatial, place, &key, "\"z\"", planar),
                HeldCoordinate::Orientation => {
                    self.form(Spatial, place, &key, "\"orientation\"", planar);
                }
            }
        }
        for (k, shape) in body.shape.iter().enumerate() {
            let own = Place {
                owner: format!("{}, shape {}", place.owner, k + 1),
                path: format!("{}.shape[{k}]", place.path),
            };
            self.shape(shape, &own);
        }
    }

    /// The angle or orientation of a frame.
    fn turned(&mut self, angle: bool, orientation: bool, word: &str, place: &Place) {
        let spatial = format!(
            "a spatial {word} has `orientation`: write orientation = {{ axis = [0, 0, 1], angle = ... }}"
        );
        self.key(angle, Planar, place, "angle", &spatial);
        let planar = format!("a planar {word} has `angle`: write angle = ...");
        self.key(orientation, Spatial, place, "orientation", &planar);
    }

    fn inertia(&mut self, inertia: &Inertia, place: &Place) {
        let (of, form, remedy) = match inertia {
            Inertia::Moment(_) => (
                Planar,
                "an inertia of one number",
                "write inertia = [Ixx, Iyy, Izz], or the three rows of the tensor",
            ),
            Inertia::Moments(_) | Inertia::Tensor(_) => (
                Spatial,
                "an inertia of several numbers",
                "write the one moment of inertia about the axis across the plane",
            ),
        };
        self.form(of, place, "inertia", form, remedy);
    }

    /// An angular velocity or a moment.
    fn axial(&mut self, vector: &AxialVector, place: &Place, key: &str) {
        let (of, remedy) = match vector {
            AxialVector::Planar(_) => (
                Planar,
                format!("write {key} = [x, y, z], its three components"),
            ),
            AxialVector::Spatial(_) => (
                Spatial,
                format!("write {key} = ..., one number, counter-clockwise"),
            ),
        };
        let form = match of {
            Planar => format!("`{key}` of one number"),
            Spatial => format!("`{key}` of three components"),
        };
        self.form(of, place, key, &form, &remedy);
    }

    fn shape(&mut self, shape: &Shape, place: &Place) {
        if !self.kind(kinds::of_shape(&shape.kind), place) {
            return;
        }
        let turned = (shape.angle.is_some(), shape.orientation.is_some());
        self.turned(turned.0, turned.1, "shape", place);
        match &shape.kind {
            ShapeKind::Lump {
                inertia: Some(inertia),
            } => self.inertia(inertia, place),
            ShapeKind::Shell { .. } | ShapeKind::Disk { .. } | ShapeKind::Plate { .. } => return,
            _ => {}
        }
        let remedy = "in space only `shell`, `disk` and `plate` have a thickness, other shapes \
                      have a volume of their own: leave the key out";
        let given = shape.thickness.is_some();
        self.key(given, Planar, place, "thickness", remedy);
    }

    fn joint(&mut self, kind: &JointKind, place: &Place) {
        if self.kind(kinds::of_joint(kind), place)
            && let Some(placement) = kind.placement()
        {
            self.placement(placement, place);
        }
    }

    fn placement(&mut self, placement: &Placement, place: &Place) {
        let spatial = "in space `axis = [x, y, z]` is the joint's z axis in ground axes at the \
                       initial estimate, `axes` the same in each body's frame";
        let planar = "in the plane `direction = [x, y]` is the joint's x axis in ground axes at \
                      the initial estimate, `angles` its angle in each body's frame";
        let p = placement;
        for (given, of, key, remedy) in [
            (p.angles.is_some(), Planar, "angles", spatial),
            (p.direction.is_some(), Planar, "direction", spatial),
            (p.axis.is_some(), Spatial, "axis", planar),
            (p.axes.is_some(), Spatial, "axes", planar),
            (p.x_axis.is_some(), Spatial, "x_axis", planar),
            (p.x_axes.is_some(), Spatial, "x_axes", planar),
        ] {
            self.key(given, of, place, key, remedy);
        }
    }

    fn constraint(&mut self, kind: &ConstraintKind, place: &Place) {
        let inside = |key: &str| Place {
            owner: place.owner.clone(),
            path: place.key(key),
        };
        match kind {
            ConstraintKind::Fixed { quantity, .. } => self.quantity(quantity, &inside("quantity")),
            ConstraintKind::Coupler { terms, .. } => {
                for (k, term) in terms.iter().enumerate() {
                    self.quantity(&term.quantity, &inside(&format!("terms[{k}]")));
                }
            }
            ConstraintKind::Expression { .. } | ConstraintKind::Velocity { .. } => {}
        }
    }

    fn quantity(&mut self, quantity: &Quantity, place: &Place) {
        match quantity {
            Quantity::Coordinate { coordinate, .. } => match coordinate {
                CoordinateName::X | CoordinateName::Y => {}
                CoordinateName::Z => {
                    let remedy = "a planar body has the coordinates \"x\", \"y\" and \"angle\"";
                    self.form(Spatial, place, "coordinate", "\"z\"", remedy);
                }
                CoordinateName::Angle => {
                    let remedy = "a spatial body has no single angle: use kind = \"angle\" of a \
                                  joint, or kind = \"relative-angle\" with an axis";
                    self.form(Planar, place, "coordinate", "\"angle\"", remedy);
                }
            },
            Quantity::RelativeAngle { axis, .. } => self.axis(axis.is_some(), place),
            Quantity::Angle { .. }
            | Quantity::Displacement { .. }
            | Quantity::JointCoordinate { .. }
            | Quantity::Distance { .. } => {}
        }
    }

    /// The axis of an angle between two bodies.
    fn axis(&mut self, given: bool, place: &Place) {
        let remedy = "angles of a planar model are about the axis across the plane: leave it out";
        self.key(given, Spatial, place, "axis", remedy);
    }

    fn force(&mut self, kind: &ForceKind, place: &Place) {
        match kind {
            ForceKind::Moment { value, axes, .. } => {
                self.axial(value, place, "value");
                let remedy = "a planar moment is about the axis across the plane: leave it out";
                self.key(axes.is_some(), Spatial, place, "axes", remedy);
            }
            ForceKind::TorsionSpring { axis, .. } => self.axis(axis.is_some(), place),
            ForceKind::Bushing { placement, .. } => self.placement(placement, place),
            ForceKind::Force { .. }
            | ForceKind::Actuator { .. }
            | ForceKind::SpringDamper { .. }
            | ForceKind::JointSpring { .. }
            | ForceKind::PointGravity { .. } => {}
        }
    }
}
