//! Force elements.

use super::bodies::planar;
use super::context::{Context, GlobalMeasure};
use super::joints::Direction;
use super::names::Property;
use super::place::Place;
use crate::diagnostic::Diagnostic;
use crate::force::{Bushing, ForceElement, MeasureForce, PointForce, PointGravity};
use crate::joint::{Measure, PlanarMeasure};
use crate::model::{Axes, ForceKind, Matrix, Value};
use crate::signal::{Coefficient, SignalKind};
use crate::space::Planar;
use crate::system::ForceData;
use dalembert_expr::{Dim, Quantity};
use nalgebra::{Matrix3, Vector2};
use smallvec::{SmallVec, smallvec};
use std::sync::Arc;

type Built = (
    &'static str,
    Arc<dyn ForceElement<Planar>>,
    SmallVec<[usize; 4]>,
);

/// Coefficients of a spring-damper-actuator as the user gave them.
#[derive(Clone, Copy, Default)]
struct Law<'a> {
    stiffness: Option<&'a Value>,
    damping: Option<&'a Value>,
    free: Option<(&'a str, &'a Value)>,
    actuator: Option<(&'a str, &'a Value)>,
}

impl Context<'_> {
    /// Compiles the force elements.
    pub fn forces(&mut self) {
        let model = self.model;
        for (index, force) in model.forces.iter().enumerate() {
            let place = Place::new("force", index, "force", &force.name);
            let Some((kind, element, markers)) = self.force(&force.name, &force.kind, &place)
            else {
                self.spoilt.insert(force.name.clone());
                continue;
            };
            self.force_elements.push(ForceData {
                name: force.name.clone(),
                kind: kind.to_owned(),
                path: place.path,
                element,
                markers,
            });
        }
    }

    /// Places the spring-dampers, so that every expression may use their lengths and rates.
    pub fn springs(&mut self) {
        let model = self.model;
        for (index, force) in model.forces.iter().enumerate() {
            let ForceKind::SpringDamper { bodies, at, .. } = &force.kind else {
                continue;
            };
            let place = Place::new("force", index, "force", &force.name);
            let [first, second] = self.two_points(bodies, at, &place.owner, &place.path);
            let m = GlobalMeasure {
                kind: PlanarMeasure::Distance,
                first,
                second,
            };
            let Some(measure) = self.nonzero_distance(m, &place.owner, &place.path) else {
                continue;
            };
            self.spring_measures.insert(force.name.clone(), measure);
            let of = |name: &str, kind, dim| Property {
                name: name.to_owned(),
                kind,
                measure,
                dim,
            };
            self.properties.insert(
                force.name.clone(),
                vec![
                    of("length", SignalKind::Value, Dim::LENGTH),
                    of("rate", SignalKind::Rate, Dim::VELOCITY),
                ],
            );
        }
    }

    fn force(&mut self, name: &str, kind: &ForceKind, place: &Place) -> Option<Built> {
        match kind {
            ForceKind::Force {
                body,
                at,
                value,
                axes,
            } => {
                let own = self.place(body, &place.owner, &place.key("body"));
                let at = self.optional_point(at.as_ref(), place, "at");
                let at = self.or_origin(at);
                if value.len() != 2 {
                    self.report(
                        Diagnostic::error(
                            "wrong-length",
                            place.key("value"),
                            format!(
                                "{}: expected 2 components, found {}",
                                place.owner,
                                value.len()
                            ),
                        )
                        .help("write value = [fx, fy]"),
                    );
                    return None;
                }
                let mut markers: SmallVec<[usize; 4]> = smallvec![self.marker(&own, at, 0.0)];
                let force = [0, 1].map(|k| {
                    self.coefficient(
                        Some(&value[k]),
                        0.0,
                        Dim::FORCE,
                        place,
                        &format!("value[{k}]"),
                        &mut markers,
                    )
                });
                let element = PointForce {
                    force,
                    moment: Coefficient::Constant(0.0),
                    body_axes: *axes == Axes::Body,
                    moment_only: false,
                };
                Some(("force", Arc::new(element), markers))
            }
            ForceKind::Moment { body, value, .. } => {
                let own = self.place(body, &place.owner, &place.key("body"));
                let mut markers: SmallVec<[usize; 4]> =
                    smallvec![self.marker(&own, Vector2::zeros(), 0.0)];
                let moment = self.coefficient(
                    planar(value),
                    0.0,
                    Dim::MOMENT,
                    place,
                    "value",
                    &mut markers,
                );
                let element = PointForce {
                    force: [Coefficient::Constant(0.0), Coefficient::Constant(0.0)],
                    moment,
                    body_axes: false,
                    moment_only: true,
                };
                Some(("moment", Arc::new(element), markers))
            }
            ForceKind::Actuator {
                joint,
                value,
                coordinate,
            } => {
                let law = Law {
                    actuator: Some(("value", value)),
                    ..Law::default()
                };
                let m = self.actuated(joint, coordinate.as_deref(), law, place)?;
                Some(self.measure_force("actuator", m, law, 0.0, true, place))
            }
            ForceKind::SpringDamper {
                stiffness,
                damping,
                free_length,
                force,
                ..
            } => {
                let m = *self.spring_measures.get(name)?;
                let law = Law {
                    stiffness: stiffness.as_ref(),
                    damping: damping.as_ref(),
                    free: free_length.as_ref().map(|v| ("free_length", v)),
                    actuator: force.as_ref().map(|v| ("force", v)),
                };
                self.warn_powerless(law, place);
                let rest = self.estimate(m);
                Some(self.measure_force("spring-damper", m, law, rest, false, place))
            }
            ForceKind::TorsionSpring {
                bodies,
                stiffness,
                damping,
                free_angle,
                moment,
                ..
            } => {
                let q = crate::model::Quantity::RelativeAngle {
                    bodies: bodies.clone(),
                    axis: None,
                };
                let m = self.quantity(&q, &place.owner, &place.path)?;
                let law = Law {
                    stiffness: stiffness.as_ref(),
                    damping: damping.as_ref(),
                    free: free_angle.as_ref().map(|v| ("free_angle", v)),
                    actuator: moment.as_ref().map(|v| ("moment", v)),
                };
                self.warn_powerless(law, place);
                let rest = self.estimate(m);
                Some(self.measure_force("torsion-spring", m, law, rest, false, place))
            }
            ForceKind::JointSpring {
                joint,
                stiffness,
                damping,
                free,
                coordinate,
            } => {
                let law = Law {
                    stiffness: stiffness.as_ref(),
                    damping: damping.as_ref(),
                    free: free.as_ref().map(|v| ("free", v)),
                    actuator: None,
                };
                let m = self.actuated(joint, coordinate.as_deref(), law, place)?;
                self.warn_powerless(law, place);
                Some(self.measure_force("joint-spring", m, law, 0.0, false, place))
            }
            ForceKind::Bushing {
                placement,
                stiffness,
                damping,
            } => {
                let m = self.placement(placement, place, Direction::Keep)?;
                let k = self.matrix(
                    stiffness,
                    [Dim::STIFFNESS, Dim::FORCE, Dim::MOMENT],
                    place,
                    "stiffness",
                );
                let c = match damping {
                    Some(c) => {
                        let dims = [Dim::STIFFNESS, Dim::FORCE, Dim::MOMENT].map(|d| d * Dim::TIME);
                        self.matrix(c, dims, place, "damping")
                    }
                    None => Some(Matrix3::zeros()),
                };
                let element = Bushing {
                    stiffness: k?,
                    damping: c?,
                };
                Some(("bushing", Arc::new(element), SmallVec::from_slice(&m)))
            }
            ForceKind::PointGravity { body, mu, center } => {
                let own = self.place(body, &place.owner, &place.key("body"));
                let mu_dim = Dim::LENGTH * Dim::LENGTH * Dim::ACCELERATION;
                let mu = self.number(mu, mu_dim, &place.owner, &place.key("mu"));
                let at = self.optional_point(center.as_ref(), place, "center");
                let (mu, at) = (mu?, at?);
                let Some(number) = own.body else {
                    if !self.places.contains_key(body) {
                        return None;
                    }
                    self.report(
                        Diagnostic::error(
                            "fixed-body",
                            place.key("body"),
                            format!("{}: '{body}' cannot move", place.owner),
                        )
                        .help("name a movable body"),
                    );
                    return None;
                };
                let mass = self.mass[9 * number];
                let marker = self.marker(&own, own.center, 0.0);
                let element = PointGravity {
                    mass,
                    mu,
                    center: at,
                };
                Some(("point-gravity", Arc::new(element), smallvec![marker]))
            }
        }
    }

    /// The coordinate of the joint that a law acts on. Without one the law is looked at all the
    /// same, with whatever dimensions it has.
    fn actuated(
        &mut self,
        joint: &str,
        coordinate: Option<&str>,
        law: Law<'_>,
        place: &Place,
    ) -> Option<GlobalMeasure> {
        let m = match coordinate {
            Some(name) => self.joint_coordinate(joint, name, &place.owner, &place.path),
            None => self.only_coordinate(joint, &place.owner, &place.path),
        };
        if m.is_none() {
            let plain = |value: Option<_>, key| value.map(|value| (key, value));
            for (key, value) in [
                plain(law.stiffness, "stiffness"),
                plain(law.damping, "damping"),
                law.free,
                law.actuator,
            ]
            .into_iter()
            .flatten()
            {
                let path = place.key(key);
                let mut markers = SmallVec::new();
                self.state_program(value, Quantity::Free, &place.owner, &path, &mut markers);
            }
        }
        m
    }

    fn warn_powerless(&mut self, law: Law<'_>, place: &Place) {
        if law.stiffness.is_none() && law.damping.is_none() && law.actuator.is_none() {
            self.report(
                Diagnostic::warning(
                    "no-effect",
                    &place.path,
                    format!(
                        "{}: it has neither stiffness nor damping nor force",
                        place.owner
                    ),
                )
                .help("give one of them, or remove the element"),
            );
        }
    }

    fn measure_force(
        &mut self,
        kind: &'static str,
        m: GlobalMeasure,
        law: Law<'_>,
        rest: f64,
        pushes: bool,
        place: &Place,
    ) -> Built {
        let mut markers: SmallVec<[usize; 4]> = smallvec![m.first, m.second];
        let force = if m.kind.is_angle() {
            Dim::MOMENT
        } else {
            Dim::FORCE
        };
        let stiffness_dim = force / m.kind.dim();
        let stiffness = self.coefficient(
            law.stiffness,
            0.0,
            stiffness_dim,
            place,
            "stiffness",
            &mut markers,
        );
        let damping = self.coefficient(
            law.damping,
            0.0,
            stiffness_dim * Dim::TIME,
            place,
            "damping",
            &mut markers,
        );
        let (key, value) = law.free.map_or(("free", None), |(k, v)| (k, Some(v)));
        let free = self.coefficient(value, rest, m.kind.dim(), place, key, &mut markers);
        let (key, value) = law.actuator.map_or(("force", None), |(k, v)| (k, Some(v)));
        let mut actuator = self.coefficient(value, 0.0, force, place, key, &mut markers);
        if pushes {
            // An actuator increases its coordinate: the opposite of tension.
            actuator = actuator.negated();
        }
        for (c, key) in [(&stiffness, "stiffness"), (&damping, "damping")] {
            if c.constant().is_some_and(|x| x < 0.0) {
                self.report(
                    Diagnostic::warning(
                        "negative-coefficient",
                        place.key(key),
                        format!("{}: {key} is negative", place.owner),
                    )
                    .help("it then feeds energy into the machine"),
                );
            }
        }
        let element = MeasureForce {
            measure: Measure {
                kind: m.kind,
                first: 0,
                second: 1,
            },
            stiffness,
            damping,
            free,
            actuator,
            pushes,
        };
        (kind, Arc::new(element), markers)
    }

    fn matrix(
        &mut self,
        matrix: &Matrix,
        dims: [Dim; 3],
        place: &Place,
        key: &str,
    ) -> Option<Matrix3<f64>> {
        // dims: translation-translation, translation-rotation, rotation-rotation.
        let dim = |i: usize, j: usize| dims[usize::from(i == 2) + usize::from(j == 2)];
        let path = place.key(key);
        let wrong = |context: &mut Self| {
            context.report(
                Diagnostic::error(
                    "wrong-length",
                    &path,
                    format!("{}: {key} must be 3 numbers or 3 rows of 3", place.owner),
                )
                .help("write [kx, ky, k_angle]"),
            );
        };
        let mut out = Matrix3::zeros();
        match matrix {
            Matrix::Diagonal(values) => {
                if values.len() != 3 {
                    wrong(self);
                    return None;
                }
                for (k, value) in values.iter().enumerate() {
                    out[(k, k)] = self.constant(
                        value,
                        Quantity::Known(dim(k, k)),
                        &place.owner,
                        &format!("{path}[{k}]"),
                    )?;
                }
            }
            Matrix::Rows(rows) => {
                if rows.len() != 3 || rows.iter().any(|r| r.len() != 3) {
                    wrong(self);
                    return None;
                }
                for (i, row) in rows.iter().enumerate() {
                    for (j, value) in row.iter().enumerate() {
                        out[(i, j)] = self.constant(
                            value,
                            Quantity::Known(dim(i, j)),
                            &place.owner,
                            &format!("{path}[{i}][{j}]"),
                        )?;
                    }
                }
            }
        }
        Some(out)
    }
}
