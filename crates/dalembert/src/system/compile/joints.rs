//! The planar joint catalogue: each kind becomes rows (its constraint subspace Phi) and free
//! coordinates (its motion subspace S).

use super::context::{Context, JointPlace, rotate};
use super::names::Property;
use super::place::Place;
use crate::diagnostic::Diagnostic;
use crate::joint::{
    Cam, ConstraintElement, Follower, Measure, MeasureKind, MeasureRow, MeasureRows, MeasureTerm,
    Profile, RollingOnCircle, TimeFunction,
};
use crate::model::{CamFollower, CamProfile, GROUND, JointKind, Placement, Side, Value};
use crate::signal::SignalKind;
use crate::space::Planar;
use crate::system::{Coordinate, ElementData, Phase, Role};
use dalembert_expr::{Dim, Program, Quantity, Resolved, Scope, UnknownName};
use nalgebra::Vector2;
use smallvec::{SmallVec, smallvec};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Measure between the element's first and second marker.
const fn between(kind: MeasureKind) -> Measure {
    Measure {
        kind,
        first: 0,
        second: 1,
    }
}

const ANGLE: Coordinate = Coordinate {
    name: "angle",
    measure: between(MeasureKind::Angle),
};
const DISPLACEMENT: Coordinate = Coordinate {
    name: "displacement",
    measure: between(MeasureKind::AlongX),
};

/// What a kind of joint becomes.
pub(super) struct Built {
    pub kind: &'static str,
    pub element: Arc<dyn ConstraintElement<Planar>>,
    pub markers: SmallVec<[usize; 4]>,
    pub coordinates: SmallVec<[Coordinate; 2]>,
    pub auxiliary_start: SmallVec<[f64; 1]>,
    /// Marker of the user's second body, on which the reaction is reported.
    pub reaction_marker: usize,
}

impl Built {
    fn rows(
        kind: &'static str,
        markers: [usize; 2],
        rows: SmallVec<[MeasureRow; 3]>,
        coordinates: SmallVec<[Coordinate; 2]>,
    ) -> Self {
        Self {
            kind,
            element: Arc::new(MeasureRows { markers: 2, rows }),
            markers: SmallVec::from_slice(&markers),
            coordinates,
            auxiliary_start: SmallVec::new(),
            reaction_marker: 1,
        }
    }
}

/// The one name of a cam profile.
struct PhiScope<'a> {
    parameters: &'a indexmap::IndexMap<String, (f64, Quantity)>,
    functions: &'a std::collections::HashMap<String, Arc<dyn dalembert_expr::Function>>,
}

impl Scope for PhiScope<'_> {
    fn variable(&self, path: &[&str]) -> Result<Resolved, UnknownName> {
        if path == ["phi"] {
            return Ok(Resolved::Slot {
                index: 0,
                dim: Quantity::Known(Dim::NONE),
            });
        }
        super::names::ConstantScope {
            parameters: self.parameters,
            functions: self.functions,
        }
        .variable(path)
        .map_err(|mut e| {
            e.note = Some("a profile is a function of phi and parameters".to_owned());
            e
        })
    }

    fn function(&self, name: &str) -> Option<Arc<dyn dalembert_expr::Function>> {
        self.functions.get(name).cloned()
    }
}

impl Context<'_> {
    /// Compiles the joints.
    pub fn joints(&mut self) {
        let model = self.model;
        for (index, joint) in model.joints.iter().enumerate() {
            let place = Place::new("joint", index, "joint", &joint.name);
            let Some(built) = self.joint(&joint.kind, &place) else {
                self.spoilt.insert(joint.name.clone());
                continue;
            };
            self.joint_places.insert(
                joint.name.clone(),
                JointPlace {
                    markers: built.markers.clone(),
                    coordinates: built.coordinates.clone(),
                },
            );
            self.joint_properties(&joint.name);
            self.push_element(joint.name.clone(), Role::Joint, place.path, built);
        }
    }

    pub fn push_element(&mut self, name: String, role: Role, path: String, built: Built) {
        self.elements.push(ElementData {
            name,
            role,
            kind: built.kind.to_owned(),
            path,
            phase: Phase::Always,
            element: built.element,
            markers: built.markers,
            reaction_marker: built.reaction_marker,
            axes_marker: 0,
            coordinates: built.coordinates,
            auxiliary_start: built.auxiliary_start,
            scale: 1.0,
            bodies: SmallVec::new(),
            slots: SmallVec::new(),
            rows: 0..0,
            aux: 0..0,
        });
    }

    fn joint_properties(&mut self, name: &str) {
        let place = &self.joint_places[name];
        let mut list = Vec::new();
        for c in &place.coordinates {
            let measure = super::context::GlobalMeasure {
                kind: c.measure.kind,
                first: place.markers[c.measure.first],
                second: place.markers[c.measure.second],
            };
            let (dim, rate) = if c.measure.kind.is_angle() {
                (Dim::NONE, Dim::FREQUENCY)
            } else {
                (Dim::LENGTH, Dim::VELOCITY)
            };
            list.push(Property {
                name: c.name.to_owned(),
                kind: SignalKind::Value,
                measure,
                dim,
            });
            list.push(Property {
                name: format!("{}_rate", c.name),
                kind: SignalKind::Rate,
                measure,
                dim: rate,
            });
        }
        self.properties.insert(name.to_owned(), list);
    }

    fn joint(&mut self, kind: &JointKind, place: &Place) -> Option<Built> {
        use MeasureKind::{AlongY, GroundX, GroundY};
        let minus = |kind, label| MeasureRow::minus(between(kind), 0.0, label);
        match kind {
            JointKind::Revolute { placement } => {
                let m = self.placement(placement, place, Direction::Optional)?;
                let rows = smallvec![minus(GroundX, "x"), minus(GroundY, "y")];
                Some(Built::rows("revolute", m, rows, smallvec![ANGLE]))
            }
            JointKind::Prismatic { placement } => {
                let m = self.placement(placement, place, Direction::Needed)?;
                let rows = smallvec![self.same_angle(m), minus(AlongY, "across the slide")];
                Some(Built::rows("prismatic", m, rows, smallvec![DISPLACEMENT]))
            }
            JointKind::Weld { placement } => {
                let m = self.placement(placement, place, Direction::Keep)?;
                let rows = smallvec![minus(GroundX, "x"), minus(GroundY, "y"), self.same_angle(m)];
                Some(Built::rows("weld", m, rows, SmallVec::new()))
            }
            JointKind::Distance { placement, length } => {
                let m = self.placement(placement, place, Direction::Optional)?;
                let measure = super::context::GlobalMeasure {
                    kind: MeasureKind::Distance,
                    first: m[0],
                    second: m[1],
                };
                let target = match length {
                    Some(l) => self.positive(l, Dim::LENGTH, "length", place, "length")?,
                    None => self.estimate(measure),
                };
                self.nonzero_distance(measure, &place.owner, &place.path)?;
                let row = MeasureRow::minus(between(MeasureKind::Distance), target, "length");
                Some(Built::rows("distance", m, smallvec![row], SmallVec::new()))
            }
            JointKind::PinSlot { placement } => {
                let m = self.placement(placement, place, Direction::Needed)?;
                let rows = smallvec![minus(AlongY, "across the slot")];
                Some(Built::rows(
                    "pin-slot",
                    m,
                    rows,
                    smallvec![DISPLACEMENT, ANGLE],
                ))
            }
            JointKind::Gear {
                bodies,
                carrier,
                radii,
                internal,
            } => self.gear(bodies, carrier.as_deref(), radii, *internal, place),
            JointKind::Rack {
                placement,
                radius,
                side,
            } => {
                // The rack is the second body, but its axes measure: markers (rack, pinion).
                let m = self.placement(placement, place, Direction::Needed)?;
                let radius = self.positive(radius, Dim::LENGTH, "radius", place, "radius")?;
                let line = [m[1], m[0]];
                let sign = self.side(*side, line, place)?;
                let row = self.rolling_row(line, sign * radius);
                let mut built = Built::rows("rack", line, smallvec![row], SmallVec::new());
                built.coordinates = smallvec![DISPLACEMENT, ANGLE];
                built.reaction_marker = 0;
                Some(built)
            }
            JointKind::RollingOnLine {
                placement,
                radius,
                side,
            } => {
                let m = self.placement(placement, place, Direction::Needed)?;
                let radius = self.positive(radius, Dim::LENGTH, "radius", place, "radius")?;
                let sign = self.side(*side, m, place)?;
                let rows = smallvec![
                    MeasureRow::follow(
                        between(AlongY),
                        TimeFunction::Constant(sign * radius),
                        "contact"
                    ),
                    self.rolling_row(m, sign * radius)
                ];
                Some(Built::rows(
                    "rolling-on-line",
                    m,
                    rows,
                    smallvec![DISPLACEMENT, ANGLE],
                ))
            }
            JointKind::RollingOnCircle {
                placement,
                radii,
                internal,
            } => {
                let m = self.placement(placement, place, Direction::Optional)?;
                let first = self.positive(&radii[0], Dim::LENGTH, "radius", place, "radii[0]");
                let second = self.positive(&radii[1], Dim::LENGTH, "radius", place, "radii[1]");
                let (first, second) = (first?, second?);
                self.rolling_on_circle(m, first, if *internal { -second } else { second }, place)
            }
            JointKind::Cam {
                placement,
                profile,
                follower,
                phi,
            } => {
                let need = if matches!(follower, CamFollower::Flat) {
                    Direction::Needed
                } else {
                    Direction::Optional
                };
                let m = self.placement(placement, place, need)?;
                self.cam(m, profile, follower, phi.as_ref(), place)
            }
        }
    }

    /// Equal angles of two markers, on the turn on which the estimate is.
    fn same_angle(&self, m: [usize; 2]) -> MeasureRow {
        let now = self.pose(m[1]).angle - self.pose(m[0]).angle;
        MeasureRow::minus(
            between(MeasureKind::Angle),
            TAU * (now / TAU).round(),
            "angle",
        )
    }

    /// Rolling without slip of the second marker's circle on the first marker's x axis:
    /// xi + sigma r phi = constant, sigma = +1 where the circle lies to the left (Shabana, rack and
    /// pinion, with the sign by side).
    fn rolling_row(&self, m: [usize; 2], signed_radius: f64) -> MeasureRow {
        let mut row = MeasureRow {
            terms: smallvec![
                MeasureTerm {
                    factor: 1.0,
                    measure: between(MeasureKind::AlongX)
                },
                MeasureTerm {
                    factor: signed_radius,
                    measure: between(MeasureKind::Angle)
                }
            ],
            target: TimeFunction::Constant(0.0),
            label: "no slip".to_owned(),
        };
        let poses = m.map(|k| self.pose(k));
        row.target = TimeFunction::Constant(row.sum(&poses));
        row
    }

    /// +1 to the left of the first marker's x axis, -1 to the right.
    fn side(&mut self, side: Option<Side>, m: [usize; 2], place: &Place) -> Option<f64> {
        if let Some(side) = side {
            return Some(if side == Side::Left { 1.0 } else { -1.0 });
        }
        let eta = MeasureKind::AlongY.value(&self.pose(m[0]), &self.pose(m[1]));
        if eta == 0.0 && self.stand_ins {
            return None;
        }
        if eta == 0.0 {
            self.report(
                Diagnostic::error(
                    "side-unknown",
                    &place.path,
                    format!(
                        "{}: the centre of the circle lies on the line in the initial estimate",
                        place.owner
                    ),
                )
                .help("give side = \"left\" or \"right\", or move the estimate"),
            );
            return None;
        }
        Some(eta.signum())
    }

    fn gear(
        &mut self,
        bodies: &[String; 2],
        carrier: Option<&str>,
        radii: &[Value; 2],
        internal: bool,
        place: &Place,
    ) -> Option<Built> {
        let names = [
            bodies[0].as_str(),
            bodies[1].as_str(),
            carrier.unwrap_or(GROUND),
        ];
        let twice = (names[0] == names[1] || names[0] == names[2] || names[1] == names[2])
            && names.iter().all(|n| !n.is_empty());
        if twice {
            self.report(
                Diagnostic::error(
                    "same-body",
                    place.key("bodies"),
                    format!(
                        "{}: the two gears and their carrier must be three different bodies",
                        place.owner
                    ),
                )
                .help("name two gears and, where it is not the ground, the body that carries both"),
            );
            return None;
        }
        let origin = |context: &mut Self, name: &str, path: String| {
            let body = context.place(name, &place.owner, &path);
            context.marker(&body, Vector2::zeros(), 0.0)
        };
        let k = origin(self, carrier.unwrap_or(GROUND), place.key("carrier"));
        let i = origin(self, &bodies[0], place.key("bodies[0]"));
        let j = origin(self, &bodies[1], place.key("bodies[1]"));
        let mut radius = |n: usize| {
            let path = place.key(&format!("radii[{n}]"));
            let x = self.constant(&radii[n], Quantity::Free, &place.owner, &path)?;
            if x > 0.0 {
                return Some(x);
            }
            self.report(
                Diagnostic::error(
                    "not-positive",
                    path,
                    format!("{}: a radius is {x}, it must be positive", place.owner),
                )
                .help("internal meshing is internal = true, not a negative radius"),
            );
            None
        };
        let (a, b) = (radius(0), radius(1));
        let (a, b) = (a?, b?);
        // (th_i - th_k) a_i = -+ (th_j - th_k) a_j (Shabana 3.103), divided by a_i: an angle.
        let ratio = if internal { -b / a } else { b / a };
        let markers: SmallVec<[usize; 4]> = smallvec![i, j, k];
        let mut row = MeasureRow {
            terms: smallvec![
                MeasureTerm {
                    factor: 1.0,
                    measure: Measure {
                        kind: MeasureKind::Angle,
                        first: 2,
                        second: 0
                    }
                },
                MeasureTerm {
                    factor: ratio,
                    measure: Measure {
                        kind: MeasureKind::Angle,
                        first: 2,
                        second: 1
                    }
                }
            ],
            target: TimeFunction::Constant(0.0),
            label: "mesh".to_owned(),
        };
        let poses = [i, j, k].map(|m| self.pose(m));
        row.target = TimeFunction::Constant(row.sum(&poses));
        Some(Built {
            kind: "gear",
            element: Arc::new(MeasureRows {
                markers: 3,
                rows: smallvec![row],
            }),
            markers,
            coordinates: SmallVec::new(),
            auxiliary_start: SmallVec::new(),
            reaction_marker: 1,
        })
    }

    fn rolling_on_circle(
        &mut self,
        m: [usize; 2],
        first: f64,
        second: f64,
        place: &Place,
    ) -> Option<Built> {
        let distance = first + second;
        if distance == 0.0 {
            self.report(
                Diagnostic::error(
                    "zero-length",
                    place.key("radii"),
                    format!(
                        "{}: circles of equal radius cannot roll inside each other",
                        place.owner
                    ),
                )
                .help("make one radius smaller"),
            );
            return None;
        }
        let [a, b] = m.map(|k| self.pose(k));
        let d = distance.signum() * (b.point - a.point);
        if d.norm() == 0.0 && self.stand_ins {
            return None;
        }
        if d.norm() == 0.0 {
            self.report(
                Diagnostic::error(
                    "zero-length",
                    &place.path,
                    format!(
                        "{}: the centres of the circles coincide in the initial estimate",
                        place.owner
                    ),
                )
                .help("move the estimate of one body"),
            );
            return None;
        }
        let psi = d.y.atan2(d.x);
        let constant = first * (psi - a.angle) + second * (psi - b.angle);
        Some(Built {
            kind: "rolling-on-circle",
            element: Arc::new(RollingOnCircle {
                first,
                second,
                constant,
            }),
            markers: SmallVec::from_slice(&m),
            coordinates: smallvec![ANGLE],
            auxiliary_start: smallvec![psi],
            reaction_marker: 1,
        })
    }

    fn profile_program(&mut self, value: &Value, place: &Place, key: &str) -> Option<Program> {
        let text = super::context::text_of(value);
        let scope = PhiScope {
            parameters: &self.parameters,
            functions: &self.functions,
        };
        let compiled = dalembert_expr::compile(&text, &scope, Quantity::Known(Dim::LENGTH));
        let path = place.key(&format!("profile.{key}"));
        self.accept(compiled, &place.owner, &path)
    }

    /// The profile of a cam.
    pub fn profile(&mut self, profile: &CamProfile, place: &Place) -> Option<Profile> {
        match profile {
            CamProfile::Polar { radius } => self
                .profile_program(radius, place, "radius")
                .map(Profile::Polar),
            CamProfile::Cartesian { x, y } => {
                let (x, y) = (
                    self.profile_program(x, place, "x"),
                    self.profile_program(y, place, "y"),
                );
                x.zip(y).map(|(x, y)| Profile::Cartesian(x, y))
            }
        }
    }

    fn cam(
        &mut self,
        m: [usize; 2],
        profile: &CamProfile,
        follower: &CamFollower,
        phi: Option<&Value>,
        place: &Place,
    ) -> Option<Built> {
        let profile = self.profile(profile, place);
        let follower = match follower {
            CamFollower::KnifeEdge => Some(Follower::KnifeEdge),
            CamFollower::Flat => Some(Follower::Flat),
            CamFollower::Roller { radius } => self
                .positive(radius, Dim::LENGTH, "radius", place, "follower.radius")
                .map(Follower::Roller),
        };
        let phi = phi.map(|v| self.number(v, Dim::NONE, &place.owner, &place.key("phi")));
        let (profile, follower) = (profile?, follower?);
        let start = match phi {
            Some(value) => value?,
            None => self.nearest_phi(m, &profile, follower),
        };
        Some(Built {
            kind: "cam",
            element: Arc::new(Cam { profile, follower }),
            markers: SmallVec::from_slice(&m),
            coordinates: SmallVec::new(),
            auxiliary_start: smallvec![start],
            reaction_marker: 1,
        })
    }

    /// The surface parameter at which the profile comes nearest to the follower in the estimate.
    fn nearest_phi(&self, m: [usize; 2], profile: &Profile, follower: Follower) -> f64 {
        let [a, b] = m.map(|k| self.pose(k));
        let merit = |phi: f64| {
            let [u, u1, ..] = profile.derivatives(phi);
            let turn = |w: Vector2<f64>| w.x * a.ex + w.y * a.ey();
            let n = a.point + turn(u) - b.point;
            match follower {
                Follower::KnifeEdge | Follower::Roller(_) => n.norm_squared(),
                Follower::Flat => b.ey().dot(&n).powi(2) + b.ey().dot(&turn(u1)).powi(2),
            }
        };
        let samples = 720;
        (0..samples)
            .map(|k| TAU * f64::from(k) / f64::from(samples))
            .filter(|x| merit(*x).is_finite())
            .min_by(|x, y| merit(*x).total_cmp(&merit(*y)))
            .unwrap_or(0.0)
    }

    /// Markers of a placement on its two bodies.
    pub fn placement(
        &mut self,
        p: &Placement,
        place: &Place,
        direction: Direction,
    ) -> Option<[usize; 2]> {
        let [a, b] = [0, 1].map(|k| {
            self.place(
                &p.bodies[k],
                &place.owner,
                &place.key(&format!("bodies[{k}]")),
            )
        });
        // Empty names stand for a mistake that is known already.
        if p.bodies[0] == p.bodies[1] && !p.bodies[0].is_empty() {
            self.report(
                Diagnostic::error(
                    "same-body",
                    place.key("bodies"),
                    format!("{}: both bodies are '{}'", place.owner, p.bodies[0]),
                )
                .help("name two different bodies"),
            );
            return None;
        }
        let points = match (&p.at, &p.point) {
            (Some(at), None) => {
                let [x, y] = [0, 1].map(|k| {
                    self.vector(
                        &at[k],
                        Dim::LENGTH,
                        &place.owner,
                        &place.key(&format!("at[{k}]")),
                    )
                });
                [self.or_origin(x), self.or_origin(y)]
            }
            (None, Some(point)) => {
                let point = self.vector(point, Dim::LENGTH, &place.owner, &place.key("point"));
                let point = self.or_origin(point);
                [&a, &b].map(|body| rotate(-body.angle, &(point - body.origin)))
            }
            (given, _) => {
                let (code, text) = if given.is_some() {
                    ("placed-twice", "both 'at' and 'point' are given")
                } else {
                    ("not-placed", "neither 'at' nor 'point' is given")
                };
                self.report(
                    Diagnostic::error(code, &place.path, format!("{}: {text}", place.owner))
                        .help("give at = [[x, y], [x, y]] (a point in each body's frame) or point = [x, y] (ground axes)"),
                );
                return None;
            }
        };
        let angles = match (&p.angles, &p.direction) {
            (Some(angles), None) => {
                let [x, y] = [0, 1].map(|k| {
                    self.number(
                        &angles[k],
                        Dim::NONE,
                        &place.owner,
                        &place.key(&format!("angles[{k}]")),
                    )
                });
                [x?, y?]
            }
            (None, Some(d)) => {
                let d = self.vector(d, Dim::NONE, &place.owner, &place.key("direction"))?;
                if d.norm() == 0.0 {
                    self.report(
                        Diagnostic::error(
                            "zero-axis",
                            place.key("direction"),
                            format!("{}: the direction has zero length", place.owner),
                        )
                        .help("give a direction like [1, 0]"),
                    );
                    return None;
                }
                let angle = d.y.atan2(d.x);
                [angle - a.angle, angle - b.angle]
            }
            (Some(_), Some(_)) => {
                self.report(
                    Diagnostic::error(
                        "placed-twice",
                        &place.path,
                        format!("{}: both 'angles' and 'direction' are given", place.owner),
                    )
                    .help("give one of them"),
                );
                return None;
            }
            (None, None) => match direction {
                Direction::Optional => [0.0, 0.0],
                Direction::Keep => [0.0, a.angle - b.angle],
                Direction::Needed => {
                    self.report(
                        Diagnostic::error("no-direction", &place.path, format!("{}: its direction is missing", place.owner))
                            .help("give direction = [x, y] (ground axes) or angles = [a, b] (of the axis in each body's frame)"),
                    );
                    return None;
                }
            },
        };
        Some([
            self.marker(&a, points[0], angles[0]),
            self.marker(&b, points[1], angles[1]),
        ])
    }
}

/// What a placement needs of its direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Direction {
    /// Axes of the bodies where none is given.
    Optional,
    /// The relative angle of the estimate where none is given.
    Keep,
    /// Must be given.
    Needed,
}
