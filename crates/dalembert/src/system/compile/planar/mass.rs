//! Mass properties of bodies from their shapes.

use super::super::context::Context;
use super::super::place::Place;
use super::rotate;
use crate::diagnostic::Diagnostic;
use crate::model::{Body, Inertia, Shape, ShapeKind, Value};
use crate::space::Planar;
use dalembert_expr::Dim;
use nalgebra::Vector2;

/// Mass, centre of mass (user's frame) and moment of inertia about it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct MassProperties {
    pub mass: f64,
    pub center: Vector2<f64>,
    pub inertia: f64,
}

/// Area, centroid (shape's frame) and radius of gyration squared about the centroid.
struct Geometry {
    area: f64,
    centroid: Vector2<f64>,
    gyration2: f64,
}

/// The moment of inertia in the plane; tensors have been refused before.
fn planar(inertia: &Inertia) -> Option<&Value> {
    match inertia {
        Inertia::Moment(value) => Some(value),
        Inertia::Moments(_) | Inertia::Tensor(_) => None,
    }
}

impl MassProperties {
    /// Sum of parts: parallel axes; cut-outs come with negative mass (Shabana 6.12 to 6.15).
    fn sum(parts: &[Self]) -> Self {
        let mass: f64 = parts.iter().map(|p| p.mass).sum();
        let center = parts
            .iter()
            .map(|p| p.mass * p.center)
            .sum::<Vector2<f64>>()
            / mass;
        let inertia = parts
            .iter()
            .map(|p| p.inertia + p.mass * (p.center - center).norm_squared())
            .sum();
        Self {
            mass,
            center,
            inertia,
        }
    }
}

impl Context<'_, Planar> {
    /// Mass properties of a body; missing ones are zero (massless).
    pub(super) fn mass_properties(&mut self, body: &Body, place: &Place) -> MassProperties {
        let mut parts = Vec::new();
        for (k, shape) in body.shape.iter().enumerate() {
            let own = Place {
                owner: format!("{}, shape {}", place.owner, k + 1),
                path: format!("{}.shape[{k}]", place.path),
            };
            if let Some(part) = self.shape_part(shape, &own) {
                parts.push(part);
            }
        }
        let mass = self.optional(body.mass.as_ref(), Dim::MASS, place, "mass");
        let moment = body.inertia.as_ref().and_then(planar);
        let inertia = self.optional(moment, Dim::INERTIA, place, "inertia");
        let center = match &body.center {
            Some(c) => self.vector(c, Dim::LENGTH, &place.owner, &place.key("center")),
            None => None,
        }
        .map_or_else(Vector2::zeros, |c| c.xy());
        for (value, key) in [(mass, "mass"), (inertia, "inertia")] {
            if let Some(x) = value
                && x < 0.0
            {
                self.report(
                    Diagnostic::error(
                        "negative-mass",
                        place.key(key),
                        format!("{}: {key} is {x}, it must not be negative", place.owner),
                    )
                    .help(format!(
                        "give a {key} of zero or more; cut-outs are shapes with cut = true"
                    )),
                );
            }
        }
        if !parts.is_empty() {
            if body.mass.is_some() || body.inertia.is_some() || body.center.is_some() {
                self.report(
                    Diagnostic::error(
                        "mass-twice",
                        &place.path,
                        format!(
                            "{}: mass is given both by the body and by its shapes",
                            place.owner
                        ),
                    )
                    .help("give mass, inertia and center, or mass/density of the shapes, not both"),
                );
            }
            let sum = MassProperties::sum(&parts);
            if !(sum.mass > 0.0 && sum.inertia >= 0.0) {
                self.report(
                    Diagnostic::error(
                        "negative-mass",
                        place.key("shape"),
                        if sum.mass > 0.0 {
                            format!(
                                "{}: the shapes add up to inertia {} kg m^2",
                                place.owner, sum.inertia
                            )
                        } else {
                            format!("{}: the shapes add up to mass {} kg", place.owner, sum.mass)
                        },
                    )
                    .help("cut-outs must be smaller than what they are cut from"),
                );
                return MassProperties::default();
            }
            return sum;
        }
        if !body.fixed && body.inertia.is_none() && mass.is_some_and(|m| m > 0.0) {
            self.report(
                Diagnostic::warning(
                    "no-inertia",
                    // Where a misspelt key may stand: the reader then knows that this follows.
                    place.key("inertia"),
                    format!(
                        "{}: it has mass but no inertia, and turns without resistance",
                        place.owner
                    ),
                )
                .help(
                    "add inertia (about the centre of mass), or give the mass to the shape instead \
                     of the body; inertia = 0 if it is meant",
                ),
            );
        }
        MassProperties {
            mass: mass.unwrap_or(0.0),
            center,
            inertia: inertia.unwrap_or(0.0),
        }
    }

    fn shape_part(&mut self, shape: &Shape, place: &Place) -> Option<MassProperties> {
        let at = self.optional_point(shape.at.as_ref(), place, "at")?.xy();
        let given = shape.angle.as_ref();
        let angle = given.and_then(|angle| self.angle(angle, place, &place.key("angle")));
        let angle = angle.unwrap_or(0.0);
        let geometry = self.geometry(&shape.kind, place)?;
        let mass = match (&shape.mass, &shape.density) {
            (Some(_), Some(_)) => {
                self.report(
                    Diagnostic::error(
                        "mass-twice",
                        place.key("density"),
                        format!("{}: mass and density are both given", place.owner),
                    )
                    .help("give one of them"),
                );
                return None;
            }
            (Some(mass), None) => self.positive(mass, Dim::MASS, "mass", place, "mass")?,
            (None, Some(density)) => {
                let density = self.positive(density, Dim::DENSITY, "density", place, "density")?;
                let Some(thickness) = &shape.thickness else {
                    self.report(
                        Diagnostic::error(
                            "missing-thickness",
                            &place.path,
                            format!("{}: density needs a thickness", place.owner),
                        )
                        .help("add thickness = \"...\" (out of the plane)"),
                    );
                    return None;
                };
                let thickness =
                    self.positive(thickness, Dim::LENGTH, "thickness", place, "thickness")?;
                if geometry.area == 0.0 {
                    self.report(
                        Diagnostic::error(
                            "no-area",
                            &place.path,
                            format!("{}: the shape has no area for its density", place.owner),
                        )
                        .help("give mass instead, or the width of a bar"),
                    );
                    return None;
                }
                density * thickness * geometry.area
            }
            (None, None) => return None,
        };
        let lump_inertia = match &shape.kind {
            ShapeKind::Lump { inertia } => self
                .optional(
                    inertia.as_ref().and_then(planar),
                    Dim::INERTIA,
                    place,
                    "inertia",
                )
                .unwrap_or(0.0),
            _ => 0.0,
        };
        let sign = if shape.cut { -1.0 } else { 1.0 };
        Some(MassProperties {
            mass: sign * mass,
            center: at + rotate(angle, &geometry.centroid),
            inertia: sign * (mass * geometry.gyration2 + lump_inertia),
        })
    }

    fn geometry(&mut self, kind: &ShapeKind, place: &Place) -> Option<Geometry> {
        let centred = |area, gyration2| Geometry {
            area,
            centroid: Vector2::zeros(),
            gyration2,
        };
        let mut length = |value, key: &str| self.positive(value, Dim::LENGTH, key, place, key);
        Some(match kind {
            ShapeKind::Bar { length: l, width } => {
                let l = length(l, "length")?;
                let w = match width {
                    Some(w) => length(w, "width")?,
                    None => 0.0,
                };
                centred(l * w, l * l / 12.0)
            }
            ShapeKind::Rectangle { width, height } => {
                let (w, h) = (length(width, "width")?, length(height, "height")?);
                centred(w * h, (w * w + h * h) / 12.0)
            }
            ShapeKind::Circle { radius } => {
                let r = length(radius, "radius")?;
                centred(std::f64::consts::PI * r * r, r * r / 2.0)
            }
            ShapeKind::Ring { outer, inner } => {
                let (r, i) = (length(outer, "outer")?, length(inner, "inner")?);
                if i >= r {
                    self.report(
                        Diagnostic::error(
                            "bad-ring",
                            place.key("inner"),
                            format!(
                                "{}: the inner radius is not smaller than the outer",
                                place.owner
                            ),
                        )
                        .help("exchange or correct the radii"),
                    );
                    return None;
                }
                centred(
                    std::f64::consts::PI * (r * r - i * i),
                    (r * r + i * i) / 2.0,
                )
            }
            ShapeKind::Polygon { points } => {
                let path = place.key("points");
                let corners: Vec<Option<Vector2<f64>>> = points
                    .iter()
                    .enumerate()
                    .map(|(k, p)| {
                        self.vector(p, Dim::LENGTH, &place.owner, &format!("{path}[{k}]"))
                            .map(|p| p.xy())
                    })
                    .collect();
                let corners: Option<Vec<_>> = corners.into_iter().collect();
                return self.polygon(&corners?, place);
            }
            ShapeKind::Lump { .. } => centred(0.0, 0.0),
            // Refused before.
            ShapeKind::Box { .. }
            | ShapeKind::Cylinder { .. }
            | ShapeKind::Tube { .. }
            | ShapeKind::Sphere { .. }
            | ShapeKind::Shell { .. }
            | ShapeKind::Hemisphere { .. }
            | ShapeKind::Cone { .. }
            | ShapeKind::Rod { .. }
            | ShapeKind::Disk { .. }
            | ShapeKind::Plate { .. }
            | ShapeKind::Ellipsoid { .. }
            | ShapeKind::Mesh { .. }
            | ShapeKind::Torus { .. } => return None,
        })
    }

    /// Green's formulas over the edges of a polygon.
    fn polygon(&mut self, corners: &[Vector2<f64>], place: &Place) -> Option<Geometry> {
        let (mut area, mut first, mut second) = (0.0, Vector2::zeros(), 0.0);
        for (k, p) in corners.iter().enumerate() {
            let r = corners[(k + 1) % corners.len()];
            let cross = p.x * r.y - r.x * p.y;
            area += cross / 2.0;
            first += cross / 6.0 * (p + r);
            second += cross / 12.0 * (p.norm_squared() + p.dot(&r) + r.norm_squared());
        }
        if corners.len() < 3 || area == 0.0 {
            self.report(
                Diagnostic::error(
                    "no-area",
                    place.key("points"),
                    format!("{}: the polygon has no area", place.owner),
                )
                .help("give at least three corners that are not on one line"),
            );
            return None;
        }
        let centroid = first / area;
        // Orientation cancels in the quotients; the area itself is taken positive.
        let gyration2 = second / area - centroid.norm_squared();
        Some(Geometry {
            area: area.abs(),
            centroid,
            gyration2,
        })
    }
}
