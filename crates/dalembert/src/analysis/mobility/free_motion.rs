//! Free motions in words.

use super::body_motion::{BodyMotion, Moving, moving, twist};
use crate::formulation::column_scale;
use crate::joint::MeasureKind;
use crate::space::{Space, Tuple};
use crate::system::{Role, System, Workspace};
use crate::words::listed;
use nalgebra::{DMatrix, DVector};
use serde::Serialize;
use std::borrow::Cow;
use std::fmt;

/// Free motions with one measure of what moves.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct FreeMotion {
    /// Coordinates that can be chosen at will: "O.angle", "block.x"; one for each freedom.
    pub coordinates: Vec<String>,
    /// The bodies that then move.
    pub bodies: Vec<BodyMotion>,
    /// Do the bodies move as one piece, free from everything else?
    pub rigid: bool,
}

/// Most bodies of a motion that a text names with what they do.
const MOST: usize = 8;
/// The same where the axes of the motions make it long.
const MOST_WITH_AXES: usize = 4;

/// A coordinate in which a motion may be measured.
struct Candidate {
    name: String,
    /// Body whose own coordinate it is.
    body: Option<usize>,
    /// Preference: smaller first.
    class: usize,
    /// Value in each free motion.
    rates: DVector<f64>,
}

/// Describes free motions (columns of `motions`, user's units) at the markers of a workspace.
pub(in crate::analysis) fn describe<S: Space>(
    system: &System<S>,
    ws: &Workspace<S>,
    motions: &DMatrix<f64>,
) -> Vec<FreeMotion> {
    let free = motions.ncols();
    if free == 0 {
        return Vec::new();
    }
    let candidates = candidates(system, ws, motions);
    let pivots = choose(&candidates, free);
    let chosen = DMatrix::from_fn(pivots.len(), free, |i, j| candidates[pivots[i]].rates[j]);
    // Without a full set of measures the motions are shown as they are.
    let normal = match chosen.clone().try_inverse() {
        Some(inverse) if pivots.len() == free => motions * inverse,
        _ => motions.clone(),
    };
    let mut list: Vec<Group> = Vec::new();
    for (k, column) in normal.column_iter().enumerate() {
        let bodies = moving(system, ws, &column.into_owned());
        let pivot = pivots.get(k).map(|&p| &candidates[p]);
        let name = pivot.map_or_else(|| format!("motion {}", k + 1), |c| c.name.clone());
        let body = pivot.and_then(|c| c.body);
        // x, y and angle of one body are told as one thing; axes also where others follow in some of them only.
        if body.is_some()
            && let Some(last) = list.last_mut()
            && body == last.body
            && (same_bodies(&last.bodies, &bodies) || bodies.iter().any(Moving::has_axes))
        {
            last.coordinates.push(name);
            for new in bodies {
                match last.bodies.iter_mut().find(|old| old.body == new.body) {
                    Some(old) => old.merge(new),
                    None => last.bodies.push(new),
                }
            }
            continue;
        }
        list.push(Group {
            body,
            coordinates: vec![name],
            bodies,
        });
    }
    list.into_iter().map(|group| group.told(system)).collect()
}

/// Motions that are told together.
struct Group {
    /// Body whose own coordinates measure them.
    body: Option<usize>,
    coordinates: Vec<String>,
    bodies: Vec<Moving>,
}

impl Group {
    fn told<S: Space>(mut self, system: &System<S>) -> FreeMotion {
        // Of many bodies with axes only some are told: the greatest motions then.
        if self.bodies.len() > MOST_WITH_AXES && self.bodies.iter().any(Moving::has_axes) {
            self.bodies.sort_by(|a, b| b.size.total_cmp(&a.size));
        }
        // Axes say more than the names of coordinates, but where a body is free in all of them.
        let by_axes = self.coordinates.len() < S::NV && self.bodies.iter().any(Moving::has_axes);
        let as_one = self.bodies.windows(2).all(|p| p[0].as_one_with(&p[1]));
        FreeMotion {
            bodies: self.bodies.iter().map(|b| b.in_words(system)).collect(),
            rigid: self.body.is_some() && as_one && !by_axes,
            coordinates: self.coordinates,
        }
    }
}

fn same_bodies(a: &[Moving], b: &[Moving]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(x, y)| x.body == y.body)
}

/// Joint coordinates against the ground, other joint coordinates, coordinates of bodies, auxiliaries.
fn candidates<S: Space>(
    system: &System<S>,
    ws: &Workspace<S>,
    motions: &DMatrix<f64>,
) -> Vec<Candidate> {
    let mut list = Vec::new();
    for e in system.elements.iter().filter(|e| e.role == Role::Joint) {
        for c in &e.coordinates {
            let (a, b) = (e.markers[c.measure.first], e.markers[c.measure.second]);
            let m = c.measure.kind.evaluate(&ws.markers[a], &ws.markers[b]);
            let unit = if c.measure.kind.is_angle() {
                1.0
            } else {
                system.size
            };
            let rates = DVector::from_fn(motions.ncols(), |k, _| {
                let rate = |marker: usize, gradient: &S::Twist| {
                    gradient.dot(&twist(system, ws, marker, motions.column(k).as_slice()))
                };
                (rate(a, &m.first) + rate(b, &m.second)) / unit
            });
            let on_ground = [a, b].iter().any(|&m| system.markers[m].body.is_none());
            list.push(Candidate {
                name: format!("{}.{}", e.name, c.name),
                body: None,
                class: usize::from(!on_ground),
                rates,
            });
        }
    }
    let scale = column_scale(system);
    // Where a body has several axes to turn about, its turns are told first: moves of the centre that turns bring along
    // would hide the axes.
    let turns_first = S::NV - S::LINEAR > 1;
    for (k, name) in system.coordinate_names().into_iter().enumerate() {
        let own = k < system.body_nv();
        list.push(Candidate {
            name,
            body: own.then_some(k / S::NV),
            class: match own {
                true => 2 + usize::from(turns_first && k % S::NV < S::LINEAR),
                false => 4,
            },
            rates: motions.row(k).transpose() / scale[k],
        });
    }
    list
}

/// Independent coordinates, one for each motion: of every class the first good ones.
fn choose(candidates: &[Candidate], free: usize) -> Vec<usize> {
    let mut rest: Vec<DVector<f64>> = candidates.iter().map(|c| c.rates.clone()).collect();
    let overall = rest.iter().fold(0.0_f64, |m, r| m.max(r.norm()));
    let mut chosen = Vec::new();
    for class in 0..=4 {
        // A joint that hardly takes part is no measure; bodies take what remains.
        let least = if class < 2 { 1e-3 } else { 1e-8 } * overall;
        while chosen.len() < free {
            let of_class = || (0..rest.len()).filter(|&k| candidates[k].class == class);
            let largest = of_class().fold(0.0_f64, |m, k| m.max(rest[k].norm()));
            if largest.is_nan() || largest <= least {
                break;
            }
            let Some(k) = of_class().find(|&k| rest[k].norm() >= 0.3 * largest) else {
                break;
            };
            let direction = rest[k].normalize();
            for r in &mut rest {
                let part = direction.dot(r);
                r.axpy(-part, &direction, 1.0);
            }
            chosen.push(k);
        }
    }
    chosen
}

impl fmt::Display for FreeMotion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.rigid {
            let suffixes: Vec<String> = self
                .coordinates
                .iter()
                .map(|c| c.rsplit('.').next().unwrap_or(c).to_owned())
                .collect();
            let names: Vec<String> = self.bodies.iter().map(|b| b.body.clone()).collect();
            return match names.len() {
                1 => write!(f, "body {} is free in {}", names[0], listed(&suffixes)),
                _ => write!(
                    f,
                    "{} move together, free in {}",
                    listed(&names),
                    listed(&suffixes)
                ),
            };
        }
        // Words that name axes are made for the motion.
        let axes = self
            .bodies
            .iter()
            .any(|b| matches!(b.motion, Cow::Owned(_)));
        let most = if axes { MOST_WITH_AXES } else { MOST };
        let words: Vec<String> = self
            .bodies
            .iter()
            .take(most)
            .map(|b| format!("{} {}", b.body, b.motion))
            .collect();
        let words = match (self.bodies.len(), self.bodies.len().saturating_sub(most)) {
            (0, _) => "no body moves".to_owned(),
            (_, 0) => words.join(", "),
            (_, 1) => format!("{} and 1 more body", words.join(", ")),
            (_, n) => format!("{} and {n} more bodies", words.join(", ")),
        };
        write!(f, "{}: {words}", listed(&self.coordinates))
    }
}
