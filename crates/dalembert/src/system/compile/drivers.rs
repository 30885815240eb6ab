//! Drivers and initial conditions.

use super::built::Built;
use super::constraints::measure_rows;
use super::context::{Context, GlobalMeasure};
use super::geometry::Geometry;
use super::place::Place;
use crate::diagnostic::Diagnostic;
use crate::joint::{Measure, MeasureKind, MeasureRow, MeasureRows, TimeFunction};
use crate::model::{DriverKind, Motion, Quantity};
use crate::system::{Coordinate, Phase, Role};
use dalembert_expr::Dim;
use smallvec::{SmallVec, smallvec};
use std::sync::Arc;

/// Words for the kind of a driven quantity.
fn kind_name(q: &Quantity) -> &'static str {
    match q {
        Quantity::Coordinate { .. } => "coordinate driver",
        Quantity::Angle { .. } => "angle driver",
        Quantity::Displacement { .. } => "displacement driver",
        Quantity::JointCoordinate { .. } => "joint-coordinate driver",
        Quantity::RelativeAngle { .. } => "relative-angle driver",
        Quantity::Distance { .. } => "distance driver",
    }
}

impl<S: Geometry> Context<'_, S> {
    /// Compiles the drivers.
    pub fn drivers(&mut self) {
        let model = self.model;
        for (index, driver) in model.drivers.iter().enumerate() {
            let place = Place::new("driver", index, "driver", &driver.name);
            if let Some(built) = self.driver(&driver.kind, &place) {
                self.push_element(driver.name.clone(), Role::Driver, place.path, built);
            }
        }
    }

    fn driver(&mut self, kind: &DriverKind, place: &Place) -> Option<Built<S>> {
        match kind {
            DriverKind::Scalar { quantity, motion } => {
                let m = self.quantity(quantity, &place.owner, &place.path);
                let target = self.motion(motion, m, Self::quantity_dim(quantity), place);
                let (m, target) = (m?, target?);
                self.start_near(m, target.jet(self.options.start).v);
                let mut built = measure_rows(kind_name(quantity), &[(1.0, m)], target, "value");
                built.coordinates = smallvec![Coordinate {
                    name: if m.kind.is_angle() {
                        "angle"
                    } else {
                        "displacement"
                    },
                    measure: Measure {
                        kind: m.kind,
                        first: 0,
                        second: built.markers.len() - 1
                    },
                }];
                Some(built)
            }
            DriverKind::Path {
                body,
                at,
                from,
                from_at,
                x,
                y,
                z,
                ..
            } => {
                let second = self.place(body, &place.owner, &place.key("body"));
                let at = self.optional_point(at.as_ref(), place, "at");
                let at = self.or_origin(at);
                let from = from.as_deref().unwrap_or(crate::model::GROUND);
                let first = self.place(from, &place.owner, &place.key("from"));
                let from_at = self.optional_point(from_at.as_ref(), place, "from_at");
                let from_at = self.or_origin(from_at);
                let mut rows = SmallVec::new();
                for (axis, (value, key)) in [(x, "x"), (y, "y"), (z, "z")].into_iter().enumerate() {
                    let Some(value) = value else { continue };
                    let f = self
                        .time_function(value, Dim::LENGTH, &place.owner, &place.key(key))
                        .unwrap_or(TimeFunction::Constant(0.0));
                    rows.push(MeasureRow::follow(
                        Measure {
                            kind: S::along_ground(axis),
                            first: 0,
                            second: 1,
                        },
                        f,
                        key,
                    ));
                }
                if rows.is_empty() {
                    self.report(
                        Diagnostic::error(
                            "no-motion",
                            &place.path,
                            if S::LINEAR == 2 {
                                format!("{}: neither x nor y is given", place.owner)
                            } else {
                                format!("{}: none of x, y and z is given", place.owner)
                            },
                        )
                        .help(if S::LINEAR == 2 {
                            "give x = \"...\", y = \"...\", or both"
                        } else {
                            "give x = \"...\", y = \"...\", z = \"...\", or some of them"
                        }),
                    );
                    return None;
                }
                let a = self.marker(&first, &S::frame(&from_at));
                let b = self.marker(&second, &S::frame(&at));
                Some(Built {
                    kind: "path driver",
                    element: Arc::new(MeasureRows::new(2, rows)),
                    markers: smallvec![a, b],
                    coordinates: SmallVec::new(),
                    auxiliary_start: SmallVec::new(),
                    reaction_marker: 1,
                })
            }
        }
    }

    /// A motion of the dimension of its quantity; without the quantity it is only looked at.
    fn motion(
        &mut self,
        motion: &Motion,
        m: Option<GlobalMeasure<S>>,
        dim: Dim,
        place: &Place,
    ) -> Option<TimeFunction> {
        match motion {
            Motion::Value { value } => {
                self.time_function(value, dim, &place.owner, &place.key("value"))
            }
            Motion::Rate { rate, start } => {
                let program =
                    self.time_program(rate, dim / Dim::TIME, &place.owner, &place.key("rate"));
                let start = match start {
                    Some(v) => self.number(v, dim, &place.owner, &place.key("start")),
                    None => m.map(|m| self.estimate(m)),
                };
                let (from, to) = (self.options.start, self.options.end);
                let integral = TimeFunction::integral(program?, start?, from, to);
                if integral.is_none() {
                    self.report(
                        Diagnostic::error(
                            "unresolved-rate",
                            place.key("rate"),
                            format!(
                                "{}: the rate cannot be integrated from {} s to {} s",
                                place.owner,
                                crate::words::readable(from),
                                crate::words::readable(to)
                            ),
                        )
                        .help("it is not finite there, or changes too often: give value instead of rate"),
                    );
                }
                integral
            }
        }
    }

    /// Compiles the initial conditions.
    pub fn initial(&mut self) {
        let model = self.model;
        for (index, initial) in model.initial.iter().enumerate() {
            let place = Place::new(
                "initial",
                index,
                "initial condition",
                &(index + 1).to_string(),
            );
            if initial.value.is_none() && initial.rate.is_none() {
                self.report(
                    Diagnostic::error(
                        "no-motion",
                        &place.path,
                        format!("{}: neither value nor rate is given", place.owner),
                    )
                    .help("give value, rate, or both"),
                );
                continue;
            }
            let m = self.quantity(&initial.quantity, &place.owner, &place.path);
            let dim = Self::quantity_dim(&initial.quantity);
            let name = self.quantity_name(&initial.quantity);
            let value = self.optional(initial.value.as_ref(), dim, &place, "value");
            let rate = self.optional(initial.rate.as_ref(), dim / Dim::TIME, &place, "rate");
            let Some(m) = m else { continue };
            if let Some(x) = value {
                let name = format!("initial {name}");
                self.start_near(m, x);
                self.start_element(name, place.key("value"), m, x, Phase::StartPosition);
            }
            if let Some(x) = rate {
                let name = format!("initial rate of {name}");
                self.start_element(name, place.key("rate"), m, x, Phase::StartVelocity);
            }
        }
    }

    fn quantity_name(&self, quantity: &Quantity) -> String {
        match quantity {
            Quantity::Coordinate {
                body, coordinate, ..
            } => {
                format!("{body}.{}", format!("{coordinate:?}").to_lowercase())
            }
            Quantity::Angle { joint } => format!("{joint}.angle"),
            Quantity::Displacement { joint } => format!("{joint}.displacement"),
            Quantity::JointCoordinate { joint, coordinate } => format!("{joint}.{coordinate}"),
            Quantity::RelativeAngle { bodies, .. } => {
                format!("angle of {} from {}", bodies[1], bodies[0])
            }
            Quantity::Distance { bodies, .. } => {
                format!("distance of {} and {}", bodies[0], bodies[1])
            }
        }
    }
}
