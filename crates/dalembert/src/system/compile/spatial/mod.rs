//! Models in space.

mod axes;
mod body;
mod curve;
mod joint_rows;
mod joints;
mod mass;
mod orientation;
mod pairs;
mod placement;
mod rolling;
mod shapes;
mod surfaces;
mod universal;

use super::built::Built;
use super::context::{Context, GlobalMeasure};
use super::drawing::DrawnShape;
use super::geometry::{BodyParts, Direction, Geometry};
use super::names::Property;
use super::place::Place;
use crate::joint::SpatialMeasure;
use crate::model::{
    AxialVector, Body, CoordinateName, HeldCoordinate, JointKind, Placement, Point, Shape, Trace,
    Value,
};
use crate::signal::SignalKind;
use crate::space::orientation::{Axis, Rotation, rotation_of};
use crate::space::{Spatial, SpatialFrame};
use dalembert_expr::Dim;
use nalgebra::{Matrix3, Vector3};

/// The three scalar products that vanish where two frames stand alike.
const ALIKE: [(Axis, Axis); 3] = [(Axis::X, Axis::Y), (Axis::Y, Axis::Z), (Axis::Z, Axis::X)];

impl Geometry for Spatial {
    const NAME: &'static str = "spatial";
    const GRAVITY: Vector3<f64> = Vector3::new(0.0, 0.0, -9.81);

    fn frame(at: &Vector3<f64>) -> SpatialFrame {
        SpatialFrame {
            at: *at,
            axes: Matrix3::identity(),
        }
    }

    fn origin(frame: &SpatialFrame) -> Vector3<f64> {
        frame.at
    }

    fn compose(outer: &SpatialFrame, inner: &SpatialFrame) -> SpatialFrame {
        SpatialFrame {
            at: outer.at + outer.axes * inner.at,
            axes: outer.axes * inner.axes,
        }
    }

    fn seen_from(frame: &SpatialFrame, point: &Vector3<f64>) -> Vector3<f64> {
        frame.axes.tr_mul(&(point - frame.at))
    }

    fn from_center(frame: &SpatialFrame, center: &Vector3<f64>) -> SpatialFrame {
        SpatialFrame {
            at: frame.at - center,
            axes: frame.axes,
        }
    }

    fn rotation(frame: &SpatialFrame) -> Rotation {
        rotation_of(&frame.axes)
    }

    fn direction(frame: &SpatialFrame) -> Vector3<f64> {
        frame.axes.column(2).into_owned()
    }

    fn reference(frame: &SpatialFrame) -> Option<Vector3<f64>> {
        Some(frame.axes.column(0).into_owned())
    }

    fn along_ground(axis: usize) -> SpatialMeasure {
        SpatialMeasure::Ground(Axis::ALL[axis])
    }

    fn coordinate(name: CoordinateName) -> Option<SpatialMeasure> {
        Some(SpatialMeasure::Ground(match name {
            CoordinateName::X => Axis::X,
            CoordinateName::Y => Axis::Y,
            CoordinateName::Z => Axis::Z,
            // Refused before.
            CoordinateName::Angle => return None,
        }))
    }

    fn held(name: HeldCoordinate) -> Vec<SpatialMeasure> {
        let axis = match name {
            HeldCoordinate::X => Axis::X,
            HeldCoordinate::Y => Axis::Y,
            HeldCoordinate::Z => Axis::Z,
            HeldCoordinate::Orientation => {
                return ALIKE.map(|(e, f)| SpatialMeasure::Dot(e, f)).to_vec();
            }
            // Refused before.
            HeldCoordinate::Angle => return Vec::new(),
        };
        vec![SpatialMeasure::Ground(axis)]
    }

    fn relative_angle(
        context: &mut Context<'_, Self>,
        bodies: &[String; 2],
        axis: Option<&Point>,
        place: &Place,
    ) -> Option<GlobalMeasure<Self>> {
        context.angle_about(bodies, axis, place)
    }

    fn axial(vector: &AxialVector) -> &[Value] {
        match vector {
            AxialVector::Spatial(values) => values,
            // Refused before.
            AxialVector::Planar(_) => &[],
        }
    }

    fn body(context: &mut Context<'_, Self>, body: &Body, place: &Place) -> BodyParts<Self> {
        context.spatial_body(body, place)
    }

    fn point_properties(marker: usize) -> Vec<Property<Self>> {
        let of = |name: String, kind, measure, dim| Property {
            name,
            kind,
            measure: GlobalMeasure {
                kind: measure,
                first: 0,
                second: marker,
            },
            dim,
        };
        let mut list = Vec::new();
        for axis in Axis::ALL {
            let (letter, along) = (axis.letter(), SpatialMeasure::Ground(axis));
            let turn = SpatialMeasure::Turn(axis);
            list.push(of(
                letter.to_string(),
                SignalKind::Value,
                along,
                Dim::LENGTH,
            ));
            list.push(of(
                format!("v{letter}"),
                SignalKind::Rate,
                along,
                Dim::VELOCITY,
            ));
            list.push(of(
                format!("omega_{letter}"),
                SignalKind::Rate,
                turn,
                Dim::FREQUENCY,
            ));
        }
        for own in Axis::ALL {
            for ground in Axis::ALL {
                let name = format!("a{}{}", ground.number() + 1, own.number() + 1);
                let cosine = SpatialMeasure::Dot(ground, own);
                list.push(of(name, SignalKind::Value, cosine, Dim::NONE));
            }
        }
        list
    }

    fn trace(context: &mut Context<'_, Self>, trace: &Trace, place: &Place) -> SpatialFrame {
        let at = context.optional_point(trace.at.as_ref(), place, "at");
        SpatialFrame {
            at: context.or_origin(at),
            axes: context.axes_of(trace.orientation.as_ref(), place, "orientation"),
        }
    }

    fn placement(
        context: &mut Context<'_, Self>,
        placement: &Placement,
        place: &Place,
        direction: Direction,
    ) -> Option<[usize; 2]> {
        context.spatial_placement(placement, place, direction)
    }

    fn joint(
        context: &mut Context<'_, Self>,
        kind: &JointKind,
        place: &Place,
    ) -> Option<Built<Self>> {
        context.spatial_joint(kind, place)
    }

    fn shape(context: &mut Context<'_, Self>, shape: &Shape, place: &Place) -> Option<DrawnShape> {
        context.spatial_shape(shape, place)
    }

    fn outline(
        _: &mut Context<'_, Self>,
        _: &str,
        _: &JointKind,
        _: &Place,
    ) -> Option<[Vec<[f64; 2]>; 2]> {
        None
    }
}
