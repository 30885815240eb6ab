//! Surfaces that touch, and points on surfaces.

use super::super::built::Built;
use super::super::context::Context;
use super::super::place::Place;
use super::placement::Zero;
use crate::diagnostic::Diagnostic;
use crate::joint::{PointOnSurface, SphereContact, SurfaceContact};
use crate::model::{self, Placement, SurfaceForm, Value};
use crate::space::Spatial;
use crate::surface::{
    Coordinates, Placed, Surface, SurfaceShape, Touch, nearest_pair, nearest_point, touch,
};
use dalembert_expr::Dim;
use nalgebra::{Matrix3, Vector3};
use smallvec::{SmallVec, smallvec};
use std::f64::consts::PI;
use std::sync::Arc;

/// What the expressions of a surface are, in words.
const WHAT: &str = "a surface";

impl Context<'_, Spatial> {
    /// A surface in numbers.
    fn surface(&mut self, surface: &model::Surface, place: &Place, key: &str) -> Option<Surface> {
        let mut length = |value: &Value, name: &str| {
            self.positive(value, Dim::LENGTH, name, place, &format!("{key}.{name}"))
        };
        let shape = match &surface.form {
            SurfaceForm::Plane => SurfaceShape::Plane,
            SurfaceForm::Sphere { radius } => SurfaceShape::Sphere(length(radius, "radius")?),
            SurfaceForm::Cylinder { radius } => SurfaceShape::Cylinder(length(radius, "radius")?),
            SurfaceForm::Cone { radius, height } => {
                let (r, h) = (length(radius, "radius"), length(height, "height"));
                SurfaceShape::Cone(r?, h?)
            }
            SurfaceForm::Ellipsoid { semi_axes } => {
                let [a, b, c] =
                    [0, 1, 2].map(|k| length(&semi_axes[k], &format!("semi_axes[{k}]")));
                SurfaceShape::Ellipsoid([a?, b?, c?])
            }
            SurfaceForm::Torus { radius, tube } => {
                let (r, t) = (length(radius, "radius"), length(tube, "tube"));
                let (r, t) = (r?, t?);
                if t >= r {
                    self.report(
                        Diagnostic::error(
                            "crossing-torus",
                            place.key(&format!("{key}.tube")),
                            format!("{}: this torus crosses itself", place.owner),
                        )
                        .help("tube must be less than radius, the radius of the circle on which the tube's centre lies"),
                    );
                    return None;
                }
                SurfaceShape::Torus(r, t)
            }
            SurfaceForm::Revolved { r, z } => {
                let [r, z] = [(r, "r"), (z, "z")].map(|(value, name)| {
                    self.length_program(value, &["b"], WHAT, place, &format!("{key}.{name}"))
                });
                SurfaceShape::Revolved(Box::new([r?, z?]))
            }
            SurfaceForm::Expression { x, y, z } => {
                let [x, y, z] = [(x, "x"), (y, "y"), (z, "z")].map(|(value, name)| {
                    self.length_program(value, &["a", "b"], WHAT, place, &format!("{key}.{name}"))
                });
                let programs = [x?, y?, z?];
                // A program sees only what it uses, in the order of the names.
                let uses = programs.each_ref().map(|p| {
                    let place = |name: usize| p.slots().iter().position(|slot| *slot == name);
                    [0, 1].map(|name| place(name).unwrap_or(usize::MAX))
                });
                SurfaceShape::Expressions(Box::new(programs), uses)
            }
        };
        Some(Surface {
            shape,
            inside: surface.inside,
        })
    }

    /// Frames of surfaces: those of the bodies, or with the z axes that are given.
    fn surface_frames(&mut self, placement: &Placement, place: &Place) -> Option<[usize; 2]> {
        let points = self.points(placement, place, false)?;
        let given = placement.axis.is_some() || placement.axes.is_some();
        let axes = if given || placement.x_axis.is_some() || placement.x_axes.is_some() {
            self.directions(placement, &points, place, true, Zero::OfBodies)?
        } else {
            [Matrix3::identity(); 2]
        };
        Some(self.two_frames(&points, axes))
    }

    pub(super) fn point_on_surface(
        &mut self,
        placement: &Placement,
        surface: &model::Surface,
        parameters: Option<&[Value; 2]>,
        place: &Place,
    ) -> Option<Built<Spatial>> {
        let surface = self.surface(surface, place, "surface");
        let given = match parameters {
            Some(values) => {
                Some(self.numbers(values, Dim::NONE, place, &place.key("parameters"))?)
            }
            None => None,
        };
        let m = self.sit(placement, place, false, Zero::OfBodies)?;
        self.on_surface("point-on-surface", surface?, 0.0, m, false, given, place)
    }

    /// A point, or a ball about it, on a surface.
    #[allow(clippy::too_many_arguments)]
    fn on_surface(
        &mut self,
        kind: &'static str,
        surface: Surface,
        distance: f64,
        m: [usize; 2],
        reversed: bool,
        given: Option<[f64; 2]>,
        place: &Place,
    ) -> Option<Built<Spatial>> {
        let [base, other] = if reversed { [m[1], m[0]] } else { m };
        let (marker, point) = (self.pose(base), self.pose(other).point);
        let placed = Placed {
            surface: &surface,
            marker: &marker,
        };
        let start = given.map_or_else(
            || nearest_point(placed, distance, &point, &self.down()),
            |ab| Some(surface.coordinates(ab)),
        );
        let start = self.no_pole(start.map(|s| [s]), [placed], place)?;
        let [start] = start;
        let [near, _] = given.unwrap_or_else(|| surface.parameters(&start, PI));
        Some(Built {
            kind,
            element: Arc::new(PointOnSurface::new(
                surface, distance, reversed, &start, near,
            )),
            markers: SmallVec::from_slice(&m),
            coordinates: SmallVec::new(),
            auxiliary_start: SmallVec::from_slice(&start),
            reaction_marker: 1,
        })
    }

    /// The direction in which bodies fall; against z where there is no gravity.
    fn down(&self) -> Vector3<f64> {
        let down = self.gravity.try_normalize(f64::MIN_POSITIVE);
        down.unwrap_or_else(|| -Vector3::z())
    }

    /// Refuses a start at a pole of a surface, or none at all.
    fn no_pole<const N: usize>(
        &mut self,
        start: Option<[Coordinates; N]>,
        surfaces: [Placed<'_>; N],
        place: &Place,
    ) -> Option<[Coordinates; N]> {
        let pole = start.as_ref().is_some_and(|all| {
            let mut parts = all.iter().zip(surfaces);
            parts.any(|(s, surface)| surface.is_pole(s))
        });
        let (message, help) = match start {
            Some(start) if !pole => return Some(start),
            _ if self.stand_ins => return None,
            Some(_) => (
                "the contact lies at a pole of the surface's parameters in the initial estimate",
                "start the contact elsewhere, or give the surface another form: a sphere or an ellipsoid has no poles, and other \
                 expressions or another z axis of the frame (axes) have theirs elsewhere",
            ),
            None => (
                "no point of the surface comes near the other body in the initial estimate",
                "give parameters = [...] of the contact at the start, or correct the estimates",
            ),
        };
        self.report(
            Diagnostic::error(
                "no-contact",
                &place.path,
                format!("{}: {message}", place.owner),
            )
            .help(help),
        );
        None
    }

    pub(super) fn surface_contact(
        &mut self,
        placement: &Placement,
        surfaces: &[model::Surface; 2],
        parameters: Option<&[[Value; 2]; 2]>,
        place: &Place,
    ) -> Option<Built<Spatial>> {
        const KIND: &str = "surface-contact";
        let [one, two] =
            [0, 1].map(|k| self.surface(&surfaces[k], place, &format!("surfaces[{k}]")));
        let given = match parameters {
            Some(values) => {
                let [s, t] = [0, 1].map(|k| {
                    let path = place.key(&format!("parameters[{k}]"));
                    self.numbers(&values[k], Dim::NONE, place, &path)
                });
                Some([s?, t?])
            }
            None => None,
        };
        let m = self.surface_frames(placement, place)?;
        let surfaces = [one?, two?];
        // Balls need no parameters of their own, which would have poles where they roll.
        if let Some(built) = self.spheres(&surfaces, m, place) {
            return built;
        }
        for k in 0..2 {
            if let Some(radius) = surfaces[k].ball() {
                let other = surfaces[1 - k].clone();
                let start = given.map(|all| all[1 - k]);
                return self.on_surface(KIND, other, radius, m, k == 0, start, place);
            }
        }
        let markers = m.map(|k| self.pose(k));
        let pair = [0, 1].map(|k| Placed {
            surface: &surfaces[k],
            marker: &markers[k],
        });
        let start = given.map_or_else(
            || nearest_pair(pair),
            |all| Some([0, 1].map(|k| surfaces[k].coordinates(all[k]))),
        );
        let start = self.no_pole(start, pair, place)?;
        let points = start.each_ref().map(|s| &s[..]);
        let held = match touch(pair, points)? {
            Touch::Point => None,
            Touch::Line(k) => {
                self.report(
                    Diagnostic::warning(
                        "line-contact",
                        &place.path,
                        format!("{}: the surfaces touch along a line", place.owner),
                    )
                    .help(
                        "the force is given at one point of the line, which stays where it is on the surface; the line holds \
                         the tilt of the bodies too",
                    ),
                );
                Some((k, start.concat()[k]))
            }
            Touch::Face => {
                self.report(
                    Diagnostic::error(
                        "face-contact",
                        &place.path,
                        format!("{}: the surfaces touch everywhere around", place.owner),
                    )
                    .help("use a joint that slides so: kind = \"planar\", \"cylindrical\" or \"spherical\""),
                );
                return None;
            }
        };
        let near = [0, 1].map(|k| match given {
            Some(all) => all[k][0],
            None => surfaces[k].parameters(points[k], PI)[0],
        });
        Some(Built {
            kind: KIND,
            auxiliary_start: SurfaceContact::start(&surfaces, points),
            element: Arc::new(SurfaceContact::new(surfaces, points, near, held)),
            markers: SmallVec::from_slice(&m),
            coordinates: SmallVec::new(),
            reaction_marker: 1,
        })
    }

    /// The contact of two spheres; none where one of the surfaces is none.
    fn spheres(
        &mut self,
        surfaces: &[Surface; 2],
        m: [usize; 2],
        place: &Place,
    ) -> Option<Option<Built<Spatial>>> {
        let radius = |s: &Surface| match s.shape {
            SurfaceShape::Sphere(radius) => Some(radius),
            _ => None,
        };
        let radii = [radius(&surfaces[0])?, radius(&surfaces[1])?];
        let hollow = surfaces.each_ref().map(|s| s.inside);
        let fits = match hollow {
            [false, false] => true,
            [true, false] => radii[0] > radii[1],
            [false, true] => radii[1] > radii[0],
            [true, true] => false,
        };
        if !fits {
            self.report(
                Diagnostic::error(
                    "no-contact",
                    place.key("surfaces"),
                    format!("{}: these spheres cannot touch", place.owner),
                )
                .help("a hollow sphere (inside = true) must be larger than the ball in it"),
            );
            return Some(None);
        }
        let inside = hollow != [false, false];
        Some(Some(Built {
            kind: "surface-contact",
            element: Arc::new(SphereContact::new(radii, inside)),
            markers: SmallVec::from_slice(&m),
            coordinates: SmallVec::new(),
            auxiliary_start: smallvec![],
            reaction_marker: 1,
        }))
    }
}
