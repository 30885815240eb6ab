//! Force elements.

use super::context::{Context, GlobalMeasure};
use super::geometry::{Direction, Geometry};
use super::names::Property;
use super::place::Place;
use super::quantities::dim_of;
use crate::diagnostic::Diagnostic;
use crate::force::{Bushing, ForceElement, MeasureForce, PointForce, PointGravity};
use crate::joint::{Measure, MeasureKind};
use crate::model::{Axes, ForceKind, Matrix, Value};
use crate::signal::{Coefficient, SignalKind};
use crate::system::ForceData;
use dalembert_expr::{Dim, Quantity};
use nalgebra::{DMatrix, Vector3};
use smallvec::{SmallVec, smallvec};
use std::marker::PhantomData;
use std::sync::Arc;

type Built<S> = (&'static str, Arc<dyn ForceElement<S>>, SmallVec<[usize; 4]>);

/// Coefficients of a spring-damper-actuator as the user gave them.
#[derive(Clone, Copy, Default)]
struct Law<'a> {
    stiffness: Option<&'a Value>,
    damping: Option<&'a Value>,
    free: Option<(&'a str, &'a Value)>,
    actuator: Option<(&'a str, &'a Value)>,
}

impl<S: Geometry> Context<'_, S> {
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
                kind: S::Measure::DISTANCE,
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

    fn force(&mut self, name: &str, kind: &ForceKind, place: &Place) -> Option<Built<S>> {
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
                if value.len() != S::LINEAR {
                    let help = if S::LINEAR == 2 {
                        "write value = [fx, fy]"
                    } else {
                        "write value = [fx, fy, fz]"
                    };
                    self.report(
                        Diagnostic::error(
                            "wrong-length",
                            place.key("value"),
                            format!(
                                "{}: expected {} components, found {}",
                                place.owner,
                                S::LINEAR,
                                value.len()
                            ),
                        )
                        .help(help),
                    );
                    return None;
                }
                let marker = self.marker(&own, &S::frame(&at));
                let mut markers: SmallVec<[usize; 4]> = smallvec![marker];
                let components = self.load_components(value, Dim::FORCE, place, &mut markers);
                let element = PointForce {
                    components,
                    body_axes: *axes == Axes::Body,
                    moment: false,
                };
                Some(("force", Arc::new(element), markers))
            }
            ForceKind::Moment { body, value, axes } => {
                let own = self.place(body, &place.owner, &place.key("body"));
                let marker = self.marker(&own, &S::frame(&Vector3::zeros()));
                let mut markers: SmallVec<[usize; 4]> = smallvec![marker];
                let value = S::axial(value);
                let components = self.load_components(value, Dim::MOMENT, place, &mut markers);
                let element = PointForce {
                    components,
                    body_axes: *axes == Some(Axes::Body),
                    moment: true,
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
                axis,
                stiffness,
                damping,
                free_angle,
                moment,
            } => {
                let m = S::relative_angle(self, bodies, axis.as_ref(), place)?;
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
                let m = S::placement(self, placement, place, Direction::Keep)?;
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
                    None => Some(DMatrix::zeros(S::NV, S::NV)),
                };
                let element = Bushing {
                    stiffness: k?,
                    damping: c?,
                    space: PhantomData,
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
                let mass = self.mass[S::NV * S::NV * number];
                let marker = self.marker(&own, &S::frame(&own.center));
                let element = PointGravity {
                    mass,
                    mu,
                    center: at,
                };
                Some(("point-gravity", Arc::new(element), smallvec![marker]))
            }
        }
    }

    /// The components of a force or of a moment.
    fn load_components(
        &mut self,
        value: &[Value],
        dim: Dim,
        place: &Place,
        markers: &mut SmallVec<[usize; 4]>,
    ) -> Vec<Coefficient<S>> {
        let count = value.len();
        let components = value.iter().enumerate();
        components
            .map(|(k, value)| {
                let key = if count == 1 {
                    "value".to_owned()
                } else {
                    format!("value[{k}]")
                };
                self.coefficient(Some(value), 0.0, dim, place, &key, markers)
            })
            .collect()
    }

    /// The coordinate of the joint that a law acts on. Without one the law is looked at all the
    /// same, with whatever dimensions it has.
    fn actuated(
        &mut self,
        joint: &str,
        coordinate: Option<&str>,
        law: Law<'_>,
        place: &Place,
    ) -> Option<GlobalMeasure<S>> {
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
        m: GlobalMeasure<S>,
        law: Law<'_>,
        rest: f64,
        pushes: bool,
        place: &Place,
    ) -> Built<S> {
        let mut markers: SmallVec<[usize; 4]> = smallvec![m.first, m.second];
        let force = if m.kind.is_angle() {
            Dim::MOMENT
        } else {
            Dim::FORCE
        };
        let own = dim_of::<S>(m.kind);
        let stiffness_dim = force / own;
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
        let free = self.coefficient(value, rest, own, place, key, &mut markers);
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
    ) -> Option<DMatrix<f64>> {
        // dims: translation-translation, translation-rotation, rotation-rotation.
        let n = S::NV;
        let turns = |k: usize| usize::from(k >= S::LINEAR);
        let dim = |i: usize, j: usize| dims[turns(i) + turns(j)];
        let path = place.key(key);
        let wrong = |context: &mut Self| {
            context.report(
                Diagnostic::error(
                    "wrong-length",
                    &path,
                    format!(
                        "{}: {key} must be {n} numbers or {n} rows of {n}",
                        place.owner
                    ),
                )
                .help(if n == 3 {
                    "write [kx, ky, k_angle]"
                } else {
                    "write [kx, ky, kz, k_about_x, k_about_y, k_about_z]"
                }),
            );
        };
        let mut out = DMatrix::zeros(n, n);
        match matrix {
            Matrix::Diagonal(values) => {
                if values.len() != n {
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
                if rows.len() != n || rows.iter().any(|r| r.len() != n) {
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
