//! The spatial joint catalogue: each kind becomes rows (its constraint subspace Phi) and free coordinates (its motion
//! subspace S), made of the primitives of Shabana 7.10.
//!
//! The joint's axis is z of its frames (e on the first body, f on the second).

use super::super::built::Built;
use super::super::context::{Context, GlobalMeasure};
use super::super::place::Place;
use super::super::placement::Points;
use super::ALIKE;
use super::axes::{with_x, with_z};
use super::placement::Zero;
use crate::diagnostic::Diagnostic;
use crate::joint::{
    KnifeEdge, Measure, MeasureRow, MeasureRows, MeasureTerm, RollingOnPlane, SpatialMeasure,
    TimeFunction,
};
use crate::model::{JointKind, Placement, Point};
use crate::space::Spatial;
use crate::space::orientation::Axis;
use crate::system::Coordinate;
use SpatialMeasure::{Along, Angle, Distance, Dot, Ground};
use dalembert_expr::Dim;
use nalgebra::Vector3;
use smallvec::{SmallVec, smallvec};
use std::f64::consts::TAU;
use std::sync::Arc;

type Row = MeasureRow<Spatial>;
type Rows = SmallVec<[Row; 2]>;
/// Sums of cosines that are one in the pose that is meant.
type Alike = SmallVec<[SmallVec<[MeasureTerm<Spatial>; 1]>; 1]>;

/// Measure between the element's first and second marker.
const fn between(kind: SpatialMeasure) -> Measure<Spatial> {
    Measure {
        kind,
        first: 0,
        second: 1,
    }
}

const ANGLE: Coordinate<Spatial> = Coordinate {
    name: "angle",
    measure: between(Angle(Axis::Z)),
};
const DISPLACEMENT: Coordinate<Spatial> = Coordinate {
    name: "displacement",
    measure: between(Along(Axis::Z)),
};

fn row(kind: SpatialMeasure, label: &str) -> Row {
    MeasureRow::minus(between(kind), 0.0, label)
}

/// The points coincide.
fn together() -> Rows {
    smallvec![
        row(Ground(Axis::X), "x"),
        row(Ground(Axis::Y), "y"),
        row(Ground(Axis::Z), "z"),
    ]
}

/// The second point stays on the first axis.
fn on_axis() -> Rows {
    smallvec![
        row(Along(Axis::X), "across the axis, x"),
        row(Along(Axis::Y), "across the axis, y"),
    ]
}

/// The axes have the same direction: e_x.f_z = e_y.f_z = 0. Opposite axes fulfil this too.
fn parallel() -> Rows {
    smallvec![
        row(Dot(Axis::X, Axis::Z), "tilt about y"),
        row(Dot(Axis::Y, Axis::Z), "tilt about x"),
    ]
}

/// The frames stand alike.
fn alike() -> Rows {
    ALIKE
        .into_iter()
        .zip(["turn about z", "turn about x", "turn about y"])
        .map(|((e, f), label)| row(Dot(e, f), label))
        .collect()
}

fn chain(parts: impl IntoIterator<Item = Rows>) -> Rows {
    parts.into_iter().flatten().collect()
}

/// What must be one for a joint to stand as it is meant: its rows also hold with opposite axes, those of [`alike`] with
/// axes that are exchanged in a circle too.
fn same_sense(axes: &[Axis]) -> Alike {
    axes.iter().map(|a| smallvec![cosine(1.0, *a)]).collect()
}

/// Of a joint that turns about axes across z only: e_x.f_x + e_y.f_y - e_z.f_z is one then, and where its row holds with a
/// twist of half a turn it is -1 - 2 e_z.f_z.
fn not_twisted() -> Alike {
    smallvec![smallvec![
        cosine(1.0, Axis::X),
        cosine(1.0, Axis::Y),
        cosine(-1.0, Axis::Z)
    ]]
}

fn cosine(factor: f64, axis: Axis) -> MeasureTerm<Spatial> {
    MeasureTerm {
        factor,
        measure: between(Dot(axis, axis)),
    }
}

fn built(
    kind: &'static str,
    markers: [usize; 2],
    rows: Rows,
    axes: &[Axis],
    coordinates: SmallVec<[Coordinate<Spatial>; 2]>,
) -> Built<Spatial> {
    standing(kind, markers, rows, same_sense(axes), coordinates)
}

fn standing(
    kind: &'static str,
    markers: [usize; 2],
    rows: Rows,
    alike: Alike,
    coordinates: SmallVec<[Coordinate<Spatial>; 2]>,
) -> Built<Spatial> {
    Built {
        kind,
        element: Arc::new(MeasureRows {
            markers: 2,
            rows,
            alike,
        }),
        markers: SmallVec::from_slice(&markers),
        coordinates,
        auxiliary_start: SmallVec::new(),
        reaction_marker: 1,
    }
}

fn rolling(kind: &'static str, wheel: RollingOnPlane, m: [usize; 2]) -> Built<Spatial> {
    Built {
        kind,
        element: Arc::new(wheel),
        markers: SmallVec::from_slice(&m),
        coordinates: SmallVec::new(),
        auxiliary_start: SmallVec::new(),
        reaction_marker: 1,
    }
}

impl Context<'_, Spatial> {
    pub(super) fn spatial_joint(
        &mut self,
        kind: &JointKind,
        place: &Place,
    ) -> Option<Built<Spatial>> {
        use Zero::{OfBodies, OfEstimate};
        Some(match kind {
            JointKind::Spherical { placement } => {
                let m = self.sit(placement, place, false, OfEstimate)?;
                built("spherical", m, together(), &[], SmallVec::new())
            }
            JointKind::Revolute { placement } => {
                let m = self.sit(placement, place, true, OfBodies)?;
                self.turns(m);
                let rows = chain([together(), parallel()]);
                built("revolute", m, rows, &[Axis::Z], smallvec![ANGLE])
            }
            JointKind::Cylindrical { placement } => {
                let m = self.sit(placement, place, true, OfBodies)?;
                self.turns(m);
                let rows = chain([on_axis(), parallel()]);
                built(
                    "cylindrical",
                    m,
                    rows,
                    &[Axis::Z],
                    smallvec![ANGLE, DISPLACEMENT],
                )
            }
            JointKind::Prismatic { placement } => {
                let m = self.sit(placement, place, true, OfEstimate)?;
                let rows = chain([on_axis(), alike()]);
                built(
                    "prismatic",
                    m,
                    rows,
                    &[Axis::X, Axis::Z],
                    smallvec![DISPLACEMENT],
                )
            }
            JointKind::Weld { placement } => {
                let m = self.sit(placement, place, false, OfEstimate)?;
                let rows = chain([together(), alike()]);
                built("weld", m, rows, &[Axis::X, Axis::Z], SmallVec::new())
            }
            JointKind::Universal {
                placement,
                second_axis,
            } => self.universal(placement, second_axis.as_ref(), place)?,
            JointKind::ConstantVelocity { placement } => {
                let m = self.sit(placement, place, true, OfEstimate)?;
                // The turn from one shaft to the other has its axis across both: e_x.f_y = e_y.f_x.
                let mut twist = row(Dot(Axis::X, Axis::Y), "twist");
                twist.terms.push(MeasureTerm {
                    factor: 1.0,
                    measure: between(Dot(Axis::Y, Axis::X)),
                });
                let rows = chain([together(), smallvec![twist]]);
                standing("constant-velocity", m, rows, not_twisted(), SmallVec::new())
            }
            JointKind::Screw { placement, pitch } => {
                let pitch = self.number(pitch, Dim::LENGTH, &place.owner, &place.key("pitch"));
                let m = self.sit(placement, place, true, OfBodies)?;
                self.turns(m);
                let rows = chain([on_axis(), parallel(), smallvec![self.thread(m, pitch?)]]);
                built("screw", m, rows, &[Axis::Z], smallvec![ANGLE])
            }
            JointKind::Planar { placement } => {
                let m = self.sit(placement, place, true, OfBodies)?;
                let lifted = row(Along(Axis::Z), "off the plane");
                let rows = chain([smallvec![lifted], parallel()]);
                built("planar", m, rows, &[Axis::Z], SmallVec::new())
            }
            JointKind::Distance { placement, length } => {
                let m = self.sit(placement, place, false, OfEstimate)?;
                let measure = GlobalMeasure {
                    kind: Distance,
                    first: m[0],
                    second: m[1],
                };
                let target = match length {
                    Some(l) => self.positive(l, Dim::LENGTH, "length", place, "length")?,
                    None => self.estimate(measure),
                };
                self.nonzero_distance(measure, &place.owner, &place.path)?;
                let rows = smallvec![MeasureRow::minus(between(Distance), target, "length")];
                built("distance", m, rows, &[], SmallVec::new())
            }
            JointKind::PointOnLine { placement } => {
                let m = self.sit(placement, place, true, OfBodies)?;
                built("point-on-line", m, on_axis(), &[], smallvec![DISPLACEMENT])
            }
            JointKind::PointOnPlane { placement } => {
                let m = self.sit(placement, place, true, OfBodies)?;
                let rows = smallvec![row(Along(Axis::Z), "off the plane")];
                built("point-on-plane", m, rows, &[], SmallVec::new())
            }
            JointKind::PointOnCurve {
                placement,
                curve,
                u,
            } => self.point_on_curve(placement, curve, u.as_ref(), place)?,
            JointKind::ParallelAxes { placement } => {
                let points = self.points(placement, place, false)?;
                let axes = self.directions(placement, &points, place, true, OfBodies)?;
                let m = self.two_frames(&points, axes);
                built("parallel-axes", m, parallel(), &[Axis::Z], SmallVec::new())
            }
            JointKind::PerpendicularAxes {
                placement,
                second_axis,
            } => {
                let points = self.points(placement, place, false)?;
                let [a, b] = self.two_axes(placement, second_axis.as_ref(), &points, place)?;
                let axes = [with_z(&a)?, with_z(&b)?];
                let m = self.two_frames(&points, axes);
                let rows = smallvec![row(Dot(Axis::Z, Axis::Z), "angle of the axes")];
                built("perpendicular-axes", m, rows, &[], SmallVec::new())
            }
            JointKind::RollingDisc {
                placement,
                second_axis,
                radius,
                rounding,
            } => {
                let radius = self.positive(radius, Dim::LENGTH, "radius", place, "radius");
                let rounding = match rounding {
                    Some(r) => self.positive(r, Dim::LENGTH, "rounding", place, "rounding"),
                    None => Some(0.0),
                };
                let points = self.points(placement, place, true)?;
                let [a, b] = self.two_axes(placement, second_axis.as_ref(), &points, place)?;
                let m = self.two_frames(&points, [with_z(&a)?, with_z(&b)?]);
                let (radius, rounding) = (radius?, rounding?);
                if rounding >= radius {
                    self.report(
                        Diagnostic::error(
                            "bad-ring",
                            place.key("rounding"),
                            format!(
                                "{}: the rounding is not smaller than the radius of the wheel",
                                place.owner
                            ),
                        )
                        .help("use kind = \"rolling-ball\" for a ball, or correct the radii"),
                    );
                    return None;
                }
                self.lies_flat(m, place)?;
                let wheel = RollingOnPlane {
                    radius: radius - rounding,
                    rounding,
                };
                rolling("rolling-disc", wheel, m)
            }
            JointKind::RollingBall { placement, radius } => {
                let rounding = self.positive(radius, Dim::LENGTH, "radius", place, "radius");
                let m = self.sit(placement, place, true, OfBodies)?;
                let ball = RollingOnPlane {
                    radius: 0.0,
                    rounding: rounding?,
                };
                rolling("rolling-ball", ball, m)
            }
            JointKind::KnifeEdge { placement } => {
                let m = self.sit(placement, place, true, OfBodies)?;
                Built {
                    kind: "knife-edge",
                    element: Arc::new(KnifeEdge),
                    markers: SmallVec::from_slice(&m),
                    coordinates: SmallVec::new(),
                    auxiliary_start: SmallVec::new(),
                    reaction_marker: 1,
                }
            }
            JointKind::SurfaceContact {
                placement,
                surfaces,
                parameters,
            } => self.surface_contact(placement, surfaces, parameters.as_ref(), place)?,
            JointKind::PointOnSurface {
                placement,
                surface,
                parameters,
            } => self.point_on_surface(placement, surface, parameters.as_ref(), place)?,
            JointKind::GearPair { joints, ratio } => self.gear_pair(joints, ratio, place)?,
            JointKind::RackPair { joints, radius } => self.rack_pair(joints, radius, place)?,
            // Refused before.
            JointKind::PinSlot { .. }
            | JointKind::Gear { .. }
            | JointKind::Rack { .. }
            | JointKind::Cam { .. }
            | JointKind::RollingOnLine { .. }
            | JointKind::RollingOnCircle { .. } => return None,
        })
    }

    /// Markers of a joint.
    pub(super) fn sit(
        &mut self,
        placement: &Placement,
        place: &Place,
        needed: bool,
        zero: Zero,
    ) -> Option<[usize; 2]> {
        let points = self.points(placement, place, true)?;
        let axes = self.directions(placement, &points, place, needed, zero)?;
        Some(self.two_frames(&points, axes))
    }

    /// Refuses a wheel that lies flat on its plane in the estimate: it then touches everywhere.
    fn lies_flat(&mut self, m: [usize; 2], place: &Place) -> Option<()> {
        let [n, a] = m.map(|k| self.pose(k).axes.column(2).into_owned());
        if self.stand_ins || n.cross(&a).norm() > 1e-9 {
            return Some(());
        }
        self.report(
            Diagnostic::error(
                "zero-axis",
                &place.path,
                format!(
                    "{}: the wheel lies flat on its plane in the initial estimate",
                    place.owner
                ),
            )
            .help("correct its axle, or the estimate of its orientation"),
        );
        None
    }

    /// Makes the angle of a joint count turns.
    fn turns(&mut self, m: [usize; 2]) {
        self.count_turns(GlobalMeasure {
            kind: Angle(Axis::Z),
            first: m[0],
            second: m[1],
        });
    }

    /// Along - pitch/(2 pi) angle = constant, the value of the estimate (Shabana 3.8, screw).
    fn thread(&self, m: [usize; 2], pitch: f64) -> Row {
        let mut row = row(Along(Axis::Z), "thread");
        row.terms.push(MeasureTerm {
            factor: pitch / TAU,
            measure: between(Angle(Axis::Z)),
        });
        let poses = m.map(|k| self.pose(k));
        row.target = TimeFunction::Constant(row.sum(&poses));
        row
    }

    /// The axis of the first body and that of the second, each in its own body's frame.
    fn two_axes(
        &mut self,
        p: &Placement,
        second: Option<&Point>,
        points: &Points<Spatial>,
        place: &Place,
    ) -> Option<[Vector3<f64>; 2]> {
        let of = |k: usize, d: Vector3<f64>| points.bodies[k].frame.axes.tr_mul(&d);
        match (&p.axes, &p.axis, second) {
            (Some(axes), None, None) => {
                let [a, b] = [0, 1].map(|k| self.direction(&axes[k], place, &format!("axes[{k}]")));
                Some([a?, b?])
            }
            (None, Some(first), Some(second)) => {
                let a = self.direction(first, place, "axis");
                let b = self.direction(second, place, "second_axis");
                Some([of(0, a?), of(1, b?)])
            }
            _ => {
                self.report(
                    Diagnostic::error(
                        "no-direction",
                        &place.path,
                        format!("{}: it needs an axis on each of its bodies", place.owner),
                    )
                    .help(
                        "give axes = [[x, y, z], [x, y, z]] (in each body's frame), or axis and second_axis (ground axes)",
                    ),
                );
                None
            }
        }
    }

    /// Hooke's joint: the centre, and an axis a of the first body across an axis b of the second (Shabana 7.181).
    ///
    /// Markers: e has z = a, f has x = b; angle_1 turns the cross about a. For angle_2, about b, the frames change their
    /// parts: g on the second body has z = -b, h on the first has x = a. Both are zero in the estimate.
    fn universal(
        &mut self,
        p: &Placement,
        second: Option<&Point>,
        place: &Place,
    ) -> Option<Built<Spatial>> {
        if p.x_axis.is_some() || p.x_axes.is_some() {
            self.report(
                Diagnostic::error(
                    "placed-twice",
                    &place.path,
                    format!("{}: the axes of the cross say how it stands", place.owner),
                )
                .help("leave x_axis and x_axes out; both angles are zero in the initial estimate"),
            );
            return None;
        }
        let points = self.points(p, place, true)?;
        let [a, b] = self.two_axes(p, second, &points, place)?;
        let [first, other] = [0, 1].map(|k: usize| points.bodies[k].frame.axes);
        // Each axis as the other body sees it in the estimate.
        let (b_seen, a_seen) = (first.tr_mul(&(other * b)), other.tr_mul(&(first * a)));
        let frames = with_x(&a, &b_seen).zip(with_x(&-b, &a_seen));
        let Some((e, g)) = frames else {
            self.report(
                Diagnostic::error(
                    "zero-axis",
                    &place.path,
                    format!(
                        "{}: its two axes have the same direction in the initial estimate",
                        place.owner
                    ),
                )
                .help("the axes of a cross stand at right angles: correct them, or the estimate"),
            );
            return None;
        };
        let f = with_x(&g.column(0).into_owned(), &b)?;
        let h = with_x(&e.column(0).into_owned(), &a)?;
        let mut markers: SmallVec<[usize; 4]> = SmallVec::new();
        for (k, axes) in [(0, e), (1, f), (1, g), (0, h)] {
            let frame = crate::space::SpatialFrame {
                at: points.at[k],
                axes,
            };
            markers.push(self.marker(&points.bodies[k], &frame));
        }
        let angle = |name, first, second| Coordinate {
            name,
            measure: Measure {
                kind: Angle(Axis::Z),
                first,
                second,
            },
        };
        let coordinates: SmallVec<[Coordinate<Spatial>; 2]> =
            smallvec![angle("angle_1", 0, 1), angle("angle_2", 2, 3)];
        for c in &coordinates {
            self.count_turns(GlobalMeasure {
                kind: c.measure.kind,
                first: markers[c.measure.first],
                second: markers[c.measure.second],
            });
        }
        let cross = row(Dot(Axis::Z, Axis::X), "angle of the cross");
        Some(Built {
            kind: "universal",
            element: Arc::new(MeasureRows {
                markers: 4,
                rows: chain([together(), smallvec![cross]]),
                alike: SmallVec::new(),
            }),
            markers,
            coordinates,
            auxiliary_start: SmallVec::new(),
            reaction_marker: 1,
        })
    }
}
