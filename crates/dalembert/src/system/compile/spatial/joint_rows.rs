//! Rows, coordinates and elements that the kinds of joints are made of (Shabana 7.10).

use super::super::built::Built;
use super::ALIKE;
use crate::joint::{Measure, MeasureRow, MeasureRows, MeasureTerm, SpatialMeasure, SumOfMeasures};
use crate::space::Spatial;
use crate::space::orientation::Axis;
use crate::system::Coordinate;
use SpatialMeasure::{Along, Angle, Dot, Ground};
use smallvec::{SmallVec, smallvec};
use std::sync::Arc;

pub(super) type Row = MeasureRow<Spatial>;
pub(super) type Rows = SmallVec<[Row; 2]>;
/// Sums of cosines that are one in the pose that is meant.
pub(super) type Alike = SmallVec<[SumOfMeasures<Spatial>; 1]>;

/// Measure between the element's first and second marker.
pub(super) const fn between(kind: SpatialMeasure) -> Measure<Spatial> {
    Measure {
        kind,
        first: 0,
        second: 1,
    }
}

pub(super) const ANGLE: Coordinate<Spatial> = Coordinate {
    name: "angle",
    measure: between(Angle(Axis::Z)),
};
pub(super) const DISPLACEMENT: Coordinate<Spatial> = Coordinate {
    name: "displacement",
    measure: between(Along(Axis::Z)),
};

pub(super) fn row(kind: SpatialMeasure, label: &str) -> Row {
    MeasureRow::minus(between(kind), 0.0, label)
}

/// The points coincide.
pub(super) fn together() -> Rows {
    smallvec![
        row(Ground(Axis::X), "x"),
        row(Ground(Axis::Y), "y"),
        row(Ground(Axis::Z), "z"),
    ]
}

/// The second point stays on the first axis.
pub(super) fn on_axis() -> Rows {
    smallvec![
        row(Along(Axis::X), "across the axis, x"),
        row(Along(Axis::Y), "across the axis, y"),
    ]
}

/// The axes have the same direction: e_x.f_z = e_y.f_z = 0. Opposite axes fulfil this too.
pub(super) fn parallel() -> Rows {
    smallvec![
        row(Dot(Axis::X, Axis::Z), "tilt about y"),
        row(Dot(Axis::Y, Axis::Z), "tilt about x"),
    ]
}

/// The frames stand alike.
pub(super) fn alike() -> Rows {
    ALIKE
        .into_iter()
        .zip(["turn about z", "turn about x", "turn about y"])
        .map(|((e, f), label)| row(Dot(e, f), label))
        .collect()
}

pub(super) fn chain(parts: impl IntoIterator<Item = Rows>) -> Rows {
    parts.into_iter().flatten().collect()
}

/// What must be one for a joint to stand as it is meant: its rows also hold with opposite axes, those of [`alike`] with
/// axes that are exchanged in a circle too.
pub(super) fn same_sense(axes: &[Axis]) -> Alike {
    axes.iter().map(|a| smallvec![cosine(1.0, *a)]).collect()
}

/// Of a joint that turns about axes across z only: e_x.f_x + e_y.f_y - e_z.f_z is one then, and where its row holds with a
/// twist of half a turn it is -1 - 2 e_z.f_z.
pub(super) fn not_twisted() -> Alike {
    smallvec![smallvec![
        cosine(1.0, Axis::X),
        cosine(1.0, Axis::Y),
        cosine(-1.0, Axis::Z)
    ]]
}

pub(super) fn cosine(factor: f64, axis: Axis) -> MeasureTerm<Spatial> {
    MeasureTerm {
        factor,
        measure: between(Dot(axis, axis)),
    }
}

pub(super) fn built(
    kind: &'static str,
    markers: [usize; 2],
    rows: Rows,
    axes: &[Axis],
    coordinates: SmallVec<[Coordinate<Spatial>; 2]>,
) -> Built<Spatial> {
    standing(kind, markers, rows, same_sense(axes), coordinates)
}

pub(super) fn standing(
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
