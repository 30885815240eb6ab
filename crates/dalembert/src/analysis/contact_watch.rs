//! Watches contacts of surfaces for places where their equations fail.

use super::AnalysisError;
use crate::joint::{ConstraintInput, Regularity};
use crate::space::Space;
use crate::system::{System, Workspace};
use nalgebra::Vector3;
use smallvec::SmallVec;

/// Part of the largest normal so far below which a pole of the parameters is reached.
const POLE: f64 = 1e-6;
/// Part of the largest flatness so far at which surfaces touch along a line: the point of contact then runs along the line
/// hundreds of times as fast as the bodies turn.
const LINE: f64 = 1e-5;
/// Smaller relative curvature, in parts of the inverse of the surfaces' reach, above which they touch in a point: very flat
/// and very slender bodies do, whose larger curvature is a million times as large.
const BENT: f64 = 1e-5;

/// The contacts of a system with parameters.
#[derive(Clone, Debug)]
pub(super) struct ContactWatch {
    contacts: Vec<Watched>,
}

/// What is remembered of a contact.
#[derive(Clone, Debug)]
struct Watched {
    /// Number of the element.
    element: usize,
    /// How far its surfaces reach [m].
    reach: f64,
    /// Coordinates of the last state, and those half way.
    last: SmallVec<[f64; 8]>,
    middle: SmallVec<[f64; 8]>,
    seen: Option<Regularity>,
    /// The largest normals so far.
    largest: [f64; 2],
    /// The largest smaller over larger relative curvature so far, in size.
    roundest: f64,
}

impl ContactWatch {
    /// Collects the contacts of a system.
    pub fn new<S: Space>(system: &System<S>) -> Self {
        let ws = Workspace::new(system);
        let contacts = system.elements.iter().enumerate().filter_map(|(k, e)| {
            let input = ConstraintInput {
                t: system.estimate.t,
                markers: &ws.seen(&e.markers),
                s: &ws.s[e.aux.clone()],
                s_rate: &ws.s_rate[e.aux.clone()],
            };
            e.element.regularity(&input)?;
            Some(Watched {
                element: k,
                reach: match e.element.reach() {
                    reach if reach > 0.0 => reach,
                    _ => system.size,
                },
                last: SmallVec::from_slice(input.s),
                middle: SmallVec::from_slice(input.s),
                seen: None,
                largest: [0.0; 2],
                roundest: 0.0,
            })
        });
        Self {
            contacts: contacts.collect(),
        }
    }

    /// Refuses a state, or the way to it from the last one; the workspace holds the state's markers and coordinates.
    ///
    /// # Errors
    /// [`AnalysisError::SurfacePole`], [`AnalysisError::LineContact`].
    pub fn step<S: Space>(
        &mut self,
        system: &System<S>,
        ws: &Workspace<S>,
        t: f64,
    ) -> Result<(), AnalysisError> {
        for contact in &mut self.contacts {
            let e = &system.elements[contact.element];
            let markers = [ws.markers[e.markers[0]], ws.markers[e.markers[1]]];
            let at = |s: &[f64]| {
                e.element.regularity(&ConstraintInput {
                    t,
                    markers: &markers,
                    s,
                    s_rate: &ws.s_rate[e.aux.clone()],
                })
            };
            let s = &ws.s[e.aux.clone()];
            let Some(now) = at(s) else { continue };
            for ((middle, last), s) in contact.middle.iter_mut().zip(&contact.last).zip(s) {
                *middle = 0.5 * (last + s);
            }
            let half = at(&contact.middle);
            let before = contact.seen.replace(now);
            contact.last.copy_from_slice(s);
            for k in 0..2 {
                let Some(n) = now.normals[k] else { continue };
                let size = n.norm();
                contact.largest[k] = contact.largest[k].max(size);
                let ends = [before, half].map(|x| x.and_then(|x| x.normals[k]));
                let flipped = matches!(ends, [Some(a), Some(m)] if turned_round(&a, &m, &n));
                if flipped || size.is_nan() || size <= POLE * contact.largest[k] {
                    return Err(AnalysisError::SurfacePole {
                        element: format!("'{}' ({})", e.name, e.kind),
                        surface: ["first", "second"][k],
                        time: t,
                        remedy: "start so that the contact passes beside the pole, or take a surface without poles (sphere, \
                                 ellipsoid), or one whose poles lie elsewhere (other expressions, another z axis of its frame)",
                    });
                }
            }
            let flat = now.relative.is_some_and(|[smaller, larger]| {
                let ratio = |s: f64, l: f64| if l == 0.0 { 0.0 } else { s / l };
                let now = ratio(smaller, larger);
                contact.roundest = contact.roundest.max(now.abs());
                let before = before.and_then(|x| x.relative);
                let before = before.map_or(now, |[s, l]| ratio(s, l));
                let line =
                    now.abs() <= LINE * contact.roundest && smaller.abs() * contact.reach <= BENT;
                before * now < 0.0 || line
            });
            if flat {
                return Err(AnalysisError::LineContact {
                    element: format!("'{}' ({})", e.name, e.kind),
                    time: t,
                });
            }
        }
        Ok(())
    }
}

/// Does a normal turn round between two states by vanishing, and not by going round?
fn turned_round(from: &Vector3<f64>, middle: &Vector3<f64>, to: &Vector3<f64>) -> bool {
    from.dot(to) < 0.0 && from.dot(middle).min(middle.dot(to)) < 0.0
}
