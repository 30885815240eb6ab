//! Mass properties of spatial bodies: given, or summed from their shapes.

use super::super::context::Context;
use super::super::place::Place;
use crate::diagnostic::Diagnostic;
use crate::mass::{InertiaWarning, MassProperties, mesh_properties};
use crate::model::{Body, Inertia, Shape, ShapeKind};
use crate::space::Spatial;
use crate::space::orientation::rotation_of;
use dalembert_expr::Dim;
use nalgebra::{Matrix3, Vector3};

/// Relative difference of two products of inertia that counts as rounding of given digits.
const SYMMETRIC: f64 = 1e-6;

impl Context<'_, Spatial> {
    /// Mass properties of a body; missing ones are zero (massless).
    pub(super) fn solid_mass(&mut self, body: &Body, place: &Place) -> MassProperties {
        let mut parts = Vec::new();
        for (k, shape) in body.shape.iter().enumerate() {
            let own = Place {
                owner: format!("{}, shape {}", place.owner, k + 1),
                path: format!("{}.shape[{k}]", place.path),
            };
            if let Some(part) = self.solid_part(shape, &own) {
                parts.push(part);
            }
        }
        let given = self.given_mass(body, place);
        if parts.is_empty() {
            let heavy = !body.fixed && given.mass > 0.0;
            if heavy && body.inertia.is_none() {
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
                        "add inertia = [Ixx, Iyy, Izz] (about the centre of mass), or give the mass to the \
                         shape instead of the body; inertia = [0, 0, 0] if it is meant",
                    ),
                );
            }
            return given;
        }
        let own = [
            body.mass.is_some(),
            body.inertia.is_some(),
            body.center.is_some(),
            body.inertia_at.is_some(),
            body.inertia_orientation.is_some(),
        ];
        if own.contains(&true) {
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
        // Sums with a negative mass pass through masses of zero, where there is no centre: what is added comes first.
        parts.sort_by(|a, b| b.mass.total_cmp(&a.mass));
        let sum = parts.iter().skip(1).fold(parts[0], |sum, p| sum.plus(p));
        if sum.mass.is_nan() || sum.mass <= 0.0 {
            self.report(
                Diagnostic::error(
                    "negative-mass",
                    place.key("shape"),
                    format!("{}: the shapes add up to mass {} kg", place.owner, sum.mass),
                )
                .help("cut-outs must be smaller than what they are cut from"),
            );
            return MassProperties::default();
        }
        let remedy = "cut-outs must lie inside of what they are cut from";
        self.judge(&sum, place, "shape", remedy);
        sum
    }

    /// Mass, centre and inertia as the body itself says.
    fn given_mass(&mut self, body: &Body, place: &Place) -> MassProperties {
        let mass = self.optional(body.mass.as_ref(), Dim::MASS, place, "mass");
        if let Some(x) = mass.filter(|x| *x < 0.0) {
            self.report(
                Diagnostic::error(
                    "negative-mass",
                    place.key("mass"),
                    format!("{}: mass is {x}, it must not be negative", place.owner),
                )
                .help("give a mass of zero or more; cut-outs are shapes with cut = true"),
            );
        }
        let mass = mass.unwrap_or(0.0);
        let center = self.optional_point(body.center.as_ref(), place, "center");
        let center = self.or_origin(center);
        let tensor = match &body.inertia {
            Some(inertia) => self.tensor(inertia, place, "inertia"),
            None => None,
        };
        let axes = self.axes_of(
            body.inertia_orientation.as_ref(),
            place,
            "inertia_orientation",
        );
        let tensor = axes * tensor.unwrap_or_else(Matrix3::zeros) * axes.transpose();
        let mut own = MassProperties {
            mass,
            center,
            inertia: tensor,
        };
        if let Some(at) = &body.inertia_at {
            let point = self.vector(at, Dim::LENGTH, &place.owner, &place.key("inertia_at"));
            if let Some(point) = point {
                // What the parallel axes add is taken away.
                let none = MassProperties {
                    inertia: Matrix3::zeros(),
                    ..own
                };
                own.inertia -= none.inertia_about(&point);
            }
        }
        let remedy = if body.inertia_at.is_some() {
            "is it the tensor about inertia_at? it cannot be less than mass times the squared distance of the centre"
        } else {
            "give the tensor itself, about the centre of mass, with the minus signs of its products"
        };
        self.judge(&own, place, "inertia", remedy);
        own
    }

    /// A tensor in its own axes.
    fn tensor(&mut self, inertia: &Inertia, place: &Place, key: &str) -> Option<Matrix3<f64>> {
        let path = place.key(key);
        let rows = match inertia {
            // Refused before.
            Inertia::Moment(_) => return None,
            Inertia::Moments(moments) => {
                let moments = self.numbers(moments, Dim::INERTIA, place, &path)?;
                return Some(Matrix3::from_diagonal(&moments.into()));
            }
            Inertia::Tensor(rows) => self.rows(rows, Dim::INERTIA, place, &path)?,
        };
        let tensor = Matrix3::from_fn(|i, j| rows[i][j]);
        let skew = (tensor - tensor.transpose()).amax();
        if skew > SYMMETRIC * tensor.amax() {
            self.report(
                Diagnostic::error(
                    "not-symmetric",
                    path,
                    format!("{}: the inertia tensor is not symmetric", place.owner),
                )
                .help("entries on both sides of the diagonal must be equal"),
            );
            return None;
        }
        Some(0.5 * (tensor + tensor.transpose()))
    }

    /// Refuses a tensor that no body can have; warns of one that the equations bear but no body has.
    fn judge(&mut self, own: &MassProperties, place: &Place, key: &str, remedy: &str) {
        match own.warning() {
            None => {}
            Some(InertiaWarning::Negative { smallest }) => self.report(
                Diagnostic::error(
                    "negative-inertia",
                    place.key(key),
                    format!(
                        "{}: the inertia about one of its principal axes is {smallest:.6} kg m^2, it must not be \
                         negative",
                        place.owner
                    ),
                )
                .help(remedy),
            ),
            Some(InertiaWarning::Triangle {
                moments: [a, b, c],
            }) => self.report(
                Diagnostic::warning(
                    "impossible-inertia",
                    place.key(key),
                    format!(
                        "{}: no body has the principal moments {a:.6}, {b:.6} and {c:.6} kg m^2: the largest exceeds the \
                         sum of the others",
                        place.owner
                    ),
                )
                .help(remedy),
            ),
        }
    }

    /// The part of a shape in the mass of its body, in the body frame; none where it carries none.
    fn solid_part(&mut self, shape: &Shape, place: &Place) -> Option<MassProperties> {
        // Sizes, place and orientation are right, or have been reported.
        self.spatial_shape(shape, place)?;
        let at = self.optional_point(shape.at.as_ref(), place, "at");
        let axes = self.axes_of(shape.orientation.as_ref(), place, "orientation");
        let thickness = match &shape.thickness {
            Some(t) => Some(self.positive(t, Dim::LENGTH, "thickness", place, "thickness")?),
            None => None,
        };
        let density = match (&shape.mass, &shape.density) {
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
            (Some(_), None) => None,
            (None, Some(density)) => {
                Some(self.positive(density, Dim::DENSITY, "density", place, "density")?)
            }
            // A shape for the picture.
            (None, None) => return None,
        };
        let mass = match &shape.mass {
            Some(mass) => Some(self.positive(mass, Dim::MASS, "mass", place, "mass")?),
            None => None,
        };
        let mut own = self.unit_part(&shape.kind, mass, density, thickness, place)?;
        if shape.cut {
            own.mass = -own.mass;
            own.inertia = -own.inertia;
        }
        let rotation = rotation_of(&axes);
        Some(own.placed(&at?, &rotation))
    }

    /// Mass properties of a form in its own frame, by its mass or by its density.
    fn unit_part(
        &mut self,
        kind: &ShapeKind,
        mass: Option<f64>,
        density: Option<f64>,
        thickness: Option<f64>,
        place: &Place,
    ) -> Option<MassProperties> {
        let heavy = |extent: f64| mass.or_else(|| density.map(|d| d * extent));
        match kind {
            ShapeKind::Lump { inertia } => {
                let tensor = match inertia {
                    Some(inertia) => self.tensor(inertia, place, "inertia")?,
                    None => Matrix3::zeros(),
                };
                let Some(mass) = mass else {
                    self.no_density(place, "a lump has no volume", "give mass instead");
                    return None;
                };
                Some(MassProperties {
                    mass,
                    center: Vector3::zeros(),
                    inertia: tensor,
                })
            }
            ShapeKind::Mesh {
                vertices,
                triangles,
                ..
            } => {
                let scale = self.mesh_scale(kind, place)?;
                let scaled: Vec<[f64; 3]> = vertices.iter().map(|v| v.map(|x| scale * x)).collect();
                match mesh_properties(&scaled, triangles) {
                    Ok(unit) => {
                        let factor = heavy(unit.mass)? / unit.mass;
                        Some(MassProperties {
                            mass: factor * unit.mass,
                            center: unit.center,
                            inertia: factor * unit.inertia,
                        })
                    }
                    Err(error) => {
                        self.report(
                            Diagnostic::error(
                                "bad-mesh",
                                place.key("file"),
                                format!("{}: {error}", place.owner),
                            )
                            .help(
                                "give a closed mesh, or the mass and inertia of the body and no mass of the mesh",
                            ),
                        );
                        None
                    }
                }
            }
            ShapeKind::Torus { .. } => {
                self.no_density(
                    place,
                    "a torus is for the picture only",
                    "give the mass to another shape or to the body",
                );
                None
            }
            _ => {
                let solid = self.solid(kind, place)?;
                let extent = match (kind, density) {
                    (ShapeKind::Rod { radius, .. }, Some(_)) => {
                        let Some(radius) = radius else {
                            self.no_density(
                                place,
                                "the density of a rod needs its radius",
                                "add radius, or give mass instead",
                            );
                            return None;
                        };
                        let r = self.positive(radius, Dim::LENGTH, "radius", place, "radius")?;
                        std::f64::consts::PI * r * r * solid.extent()
                    }
                    (
                        ShapeKind::Shell { .. } | ShapeKind::Disk { .. } | ShapeKind::Plate { .. },
                        Some(_),
                    ) => {
                        let Some(thickness) = thickness else {
                            self.no_density(
                                place,
                                "its density needs a thickness",
                                "add thickness, or give mass instead",
                            );
                            return None;
                        };
                        thickness * solid.extent()
                    }
                    _ => solid.extent(),
                };
                Some(solid.properties(heavy(extent)?))
            }
        }
    }

    fn no_density(&mut self, place: &Place, what: &str, help: &str) {
        self.report(
            Diagnostic::error("no-volume", &place.path, format!("{}: {what}", place.owner))
                .help(help),
        );
    }
}
