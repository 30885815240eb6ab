//! Models in the plane.

mod body;
mod cam;
mod gear;
mod joints;
mod mass;
mod outlines;
mod placement;
mod rolling;
mod shapes;

use super::built::Built;
use super::context::{Context, GlobalMeasure};
use super::drawing::DrawnShape;
use super::geometry::{BodyParts, Direction, Geometry};
use super::names::Property;
use super::place::Place;
use crate::joint::PlanarMeasure;
use crate::model::{
    AxialVector, Body, CoordinateName, HeldCoordinate, JointKind, Placement, Point, Shape, Trace,
    Value,
};
use crate::signal::SignalKind;
use crate::space::orientation::Rotation;
use crate::space::{Planar, PlanarFrame};
use dalembert_expr::Dim;
use nalgebra::{Vector2, Vector3};

/// Turns a vector by an angle.
fn rotate(angle: f64, a: &Vector2<f64>) -> Vector2<f64> {
    let (s, c) = angle.sin_cos();
    Vector2::new(c * a.x - s * a.y, s * a.x + c * a.y)
}

impl Geometry for Planar {
    const NAME: &'static str = "planar";
    const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.81, 0.0);

    fn frame(at: &Vector3<f64>) -> PlanarFrame {
        PlanarFrame {
            at: at.xy(),
            angle: 0.0,
        }
    }

    fn origin(frame: &PlanarFrame) -> Vector3<f64> {
        frame.at.push(0.0)
    }

    fn compose(outer: &PlanarFrame, inner: &PlanarFrame) -> PlanarFrame {
        PlanarFrame {
            at: outer.at + rotate(outer.angle, &inner.at),
            angle: outer.angle + inner.angle,
        }
    }

    fn seen_from(frame: &PlanarFrame, point: &Vector3<f64>) -> Vector3<f64> {
        rotate(-frame.angle, &(point.xy() - frame.at)).push(0.0)
    }

    fn from_center(frame: &PlanarFrame, center: &Vector3<f64>) -> PlanarFrame {
        PlanarFrame {
            at: frame.at - center.xy(),
            angle: frame.angle,
        }
    }

    fn rotation(frame: &PlanarFrame) -> Rotation {
        Rotation::from_axis_angle(&Vector3::z_axis(), frame.angle)
    }

    fn direction(frame: &PlanarFrame) -> Vector3<f64> {
        let (s, c) = frame.angle.sin_cos();
        Vector3::new(c, s, 0.0)
    }

    fn reference(_: &PlanarFrame) -> Option<Vector3<f64>> {
        None
    }

    fn along_ground(axis: usize) -> PlanarMeasure {
        if axis == 0 {
            PlanarMeasure::GroundX
        } else {
            PlanarMeasure::GroundY
        }
    }

    fn coordinate(name: CoordinateName) -> Option<PlanarMeasure> {
        Some(match name {
            CoordinateName::X => PlanarMeasure::GroundX,
            CoordinateName::Y => PlanarMeasure::GroundY,
            CoordinateName::Angle => PlanarMeasure::Angle,
            CoordinateName::Z => return None,
        })
    }

    fn held(name: HeldCoordinate) -> Vec<PlanarMeasure> {
        match name {
            HeldCoordinate::X => vec![PlanarMeasure::GroundX],
            HeldCoordinate::Y => vec![PlanarMeasure::GroundY],
            HeldCoordinate::Angle => vec![PlanarMeasure::Angle],
            HeldCoordinate::Z | HeldCoordinate::Orientation => Vec::new(),
        }
    }

    fn relative_angle(
        context: &mut Context<'_, Self>,
        bodies: &[String; 2],
        _: Option<&Point>,
        place: &Place,
    ) -> Option<GlobalMeasure<Self>> {
        let [first, second] = [0, 1].map(|k| {
            let path = place.key(&format!("bodies[{k}]"));
            let body = context.place(&bodies[k], &place.owner, &path);
            context.marker(&body, &PlanarFrame::default())
        });
        Some(GlobalMeasure {
            kind: PlanarMeasure::Angle,
            first,
            second,
        })
    }

    fn axial(vector: &AxialVector) -> &[Value] {
        match vector {
            AxialVector::Planar(value) => std::slice::from_ref(value),
            // Refused before.
            AxialVector::Spatial(_) => &[],
        }
    }

    fn body(context: &mut Context<'_, Self>, body: &Body, place: &Place) -> BodyParts<Self> {
        context.planar_body(body, place)
    }

    fn point_properties(marker: usize) -> Vec<Property<Self>> {
        use PlanarMeasure::{Angle, GroundX, GroundY};
        use SignalKind::{Rate, Value};
        let of = |name: &str, kind, measure, dim| Property {
            name: name.to_owned(),
            kind,
            measure: GlobalMeasure {
                kind: measure,
                first: 0,
                second: marker,
            },
            dim,
        };
        vec![
            of("x", Value, GroundX, Dim::LENGTH),
            of("y", Value, GroundY, Dim::LENGTH),
            of("angle", Value, Angle, Dim::NONE),
            of("vx", Rate, GroundX, Dim::VELOCITY),
            of("vy", Rate, GroundY, Dim::VELOCITY),
            of("omega", Rate, Angle, Dim::FREQUENCY),
        ]
    }

    fn trace(context: &mut Context<'_, Self>, trace: &Trace, place: &Place) -> PlanarFrame {
        let at = context.optional_point(trace.at.as_ref(), place, "at");
        let angle = context
            .optional(trace.angle.as_ref(), Dim::NONE, place, "angle")
            .unwrap_or(0.0);
        PlanarFrame {
            at: context.or_origin(at).xy(),
            angle,
        }
    }

    fn placement(
        context: &mut Context<'_, Self>,
        placement: &Placement,
        place: &Place,
        direction: Direction,
    ) -> Option<[usize; 2]> {
        context.planar_placement(placement, place, direction)
    }

    fn joint(
        context: &mut Context<'_, Self>,
        kind: &JointKind,
        place: &Place,
    ) -> Option<Built<Self>> {
        context.planar_joint(kind, place)
    }

    fn shape(context: &mut Context<'_, Self>, shape: &Shape, place: &Place) -> Option<DrawnShape> {
        context.planar_shape(shape, place)
    }

    fn outline(
        context: &mut Context<'_, Self>,
        name: &str,
        kind: &JointKind,
        place: &Place,
    ) -> Option<[Vec<[f64; 2]>; 2]> {
        context.curves(name, kind, place)
    }
}
