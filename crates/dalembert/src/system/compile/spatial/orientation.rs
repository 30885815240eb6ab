//! Orientations that users write.

use super::super::context::Context;
use super::super::place::Place;
use crate::diagnostic::Diagnostic;
use crate::model::{EulerAxes, Orientation, Value};
use crate::space::Spatial;
use crate::space::orientation::{
    AxisAngle, EulerParameters, EulerSequence, OrientationError, RodriguezParameters, Rotation,
    from_axes, from_matrix, from_points,
};
use dalembert_expr::{Dim, Quantity};
use nalgebra::{Matrix3, Vector3, Vector4};

impl Context<'_, Spatial> {
    /// The axes of a frame as columns; not turned where nothing is given, or after a mistake.
    pub(super) fn axes_of(
        &mut self,
        orientation: Option<&Orientation>,
        place: &Place,
        key: &str,
    ) -> Matrix3<f64> {
        let rotation = match orientation {
            None => return Matrix3::identity(),
            Some(orientation) => self.rotation_of(orientation, place, key),
        };
        match rotation {
            Some(rotation) => rotation.to_rotation_matrix().into_inner(),
            None => {
                self.stand_ins = true;
                Matrix3::identity()
            }
        }
    }

    fn rotation_of(
        &mut self,
        orientation: &Orientation,
        place: &Place,
        key: &str,
    ) -> Option<Rotation> {
        let own = place.key(key);
        let found = match orientation {
            Orientation::Euler {
                euler,
                angles,
                axes,
            } => {
                let angles = [0, 1, 2]
                    .map(|k: usize| self.angle(&angles[k], place, &format!("{own}.angles[{k}]")));
                let name = match axes {
                    Some(EulerAxes::Space) => format!("{euler}-space"),
                    Some(EulerAxes::Body) | None => euler.clone(),
                };
                let Ok(sequence) = name.parse::<EulerSequence>() else {
                    self.report(
                        Diagnostic::error(
                            "bad-orientation",
                            format!("{own}.euler"),
                            format!(
                                "{}: '{euler}' is not a sequence of Euler angles",
                                place.owner
                            ),
                        )
                        .help(
                            "write three letters of x, y, z, neighbours different, like \"zxz\" or \"xyz\"",
                        ),
                    );
                    return None;
                };
                let [a, b, c] = angles;
                Ok(sequence.rotation(&Vector3::new(a?, b?, c?)))
            }
            Orientation::AxisAngle { axis, angle } => {
                let axis = self.direction_components(axis, place, &format!("{own}.axis"));
                let angle = self.angle(angle, place, &format!("{own}.angle"));
                AxisAngle::new(axis?.into(), angle?).map(|a| a.rotation())
            }
            Orientation::EulerParameters { euler_parameters } => {
                let path = format!("{own}.euler_parameters");
                let b = self.numbers(euler_parameters, Dim::NONE, place, &path)?;
                EulerParameters(Vector4::from(b)).rotation()
            }
            Orientation::Rodriguez { rodriguez } => {
                let path = format!("{own}.rodriguez");
                let g = self.numbers(rodriguez, Dim::NONE, place, &path)?;
                Ok(RodriguezParameters(g.into()).rotation())
            }
            Orientation::Matrix { matrix } => {
                let path = format!("{own}.matrix");
                let rows = self.rows(matrix, Dim::NONE, place, &path)?;
                from_matrix(&Matrix3::from_fn(|i, j| rows[i][j]))
            }
            Orientation::Points { points } => {
                let path = format!("{own}.points");
                let [o, p, q] = self
                    .rows(points, Dim::LENGTH, place, &path)?
                    .map(Vector3::from);
                from_points(&o, &p, &q)
            }
            Orientation::Axes { x, y, z } => {
                return self.by_directions([x.as_ref(), y.as_ref(), z.as_ref()], place, &own);
            }
        };
        self.accept_rotation(found, place, &own)
    }

    /// Directions of at least two axes; the third follows.
    fn by_directions(
        &mut self,
        given: [Option<&[Value; 3]>; 3],
        place: &Place,
        own: &str,
    ) -> Option<Rotation> {
        let mut axes = [None; 3];
        for ((axis, given), letter) in axes.iter_mut().zip(given).zip(["x", "y", "z"]) {
            if let Some(values) = given {
                let path = format!("{own}.{letter}");
                let components = self.direction_components(values, place, &path)?;
                *axis = Some(Vector3::from(components));
            }
        }
        let unit = |v: Vector3<f64>| v.try_normalize(0.0).unwrap_or(v);
        let axes = match axes {
            [Some(x), Some(y), None] => [x, y, unit(x).cross(&unit(y))],
            [Some(x), None, Some(z)] => [x, unit(z).cross(&unit(x)), z],
            [None, Some(y), Some(z)] => [unit(y).cross(&unit(z)), y, z],
            [Some(x), Some(y), Some(z)] => [x, y, z],
            _ => {
                self.report(
                    Diagnostic::error(
                        "bad-orientation",
                        own,
                        format!("{}: an orientation by axes needs two of them", place.owner),
                    )
                    .help("give x and y, or another two, as [x, y, z]"),
                );
                return None;
            }
        };
        let found = from_axes(axes);
        self.accept_rotation(found, place, own)
    }

    fn accept_rotation(
        &mut self,
        found: Result<Rotation, OrientationError>,
        place: &Place,
        path: &str,
    ) -> Option<Rotation> {
        match found {
            Ok(rotation) => Some(rotation),
            Err(error) => {
                self.report(
                    Diagnostic::error(
                        "bad-orientation",
                        path,
                        format!("{}: {error}", place.owner),
                    )
                    .help(
                        "check its numbers, or write it as { axis = [x, y, z], angle = \"30 deg\" }",
                    ),
                );
                None
            }
        }
    }

    /// Components of a direction: of any length, so also of any dimension, like the difference of two points.
    pub(super) fn direction_components(
        &mut self,
        values: &[Value; 3],
        place: &Place,
        path: &str,
    ) -> Option<[f64; 3]> {
        let [x, y, z] = [0, 1, 2].map(|k: usize| {
            self.constant(
                &values[k],
                Quantity::Free,
                &place.owner,
                &format!("{path}[{k}]"),
            )
        });
        Some([x?, y?, z?])
    }

    /// Numbers of one dimension; all mistakes in them are reported.
    pub(super) fn numbers<const N: usize>(
        &mut self,
        values: &[Value; N],
        dim: Dim,
        place: &Place,
        path: &str,
    ) -> Option<[f64; N]> {
        let mut out = [0.0; N];
        let mut whole = true;
        for (k, (out, value)) in out.iter_mut().zip(values).enumerate() {
            match self.number(value, dim, &place.owner, &format!("{path}[{k}]")) {
                Some(x) => *out = x,
                None => whole = false,
            }
        }
        whole.then_some(out)
    }

    /// Three rows of three numbers.
    pub(super) fn rows(
        &mut self,
        rows: &[[Value; 3]; 3],
        dim: Dim,
        place: &Place,
        path: &str,
    ) -> Option<[[f64; 3]; 3]> {
        let [a, b, c] =
            [0, 1, 2].map(|k| self.numbers(&rows[k], dim, place, &format!("{path}[{k}]")));
        Some([a?, b?, c?])
    }
}
