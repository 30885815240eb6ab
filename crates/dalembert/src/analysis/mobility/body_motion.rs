//! What single bodies do in a free motion, in words.

use super::axis_words::axis_words;
use crate::formulation::column_scale;
use crate::space::{Screw, Space, Tuple, norm};
use crate::system::{Role, System, Workspace};
use nalgebra::{DVector, Vector3};
use serde::Serialize;
use std::borrow::Cow;

/// What a body does in a free motion.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct BodyMotion {
    /// Name of the body.
    pub body: String,
    /// "turns", "slides", "moves", "moves and turns"; in space with the axis.
    pub motion: Cow<'static, str>,
}

/// A body that takes part in one motion, or in several that are told together.
#[derive(Clone, Debug)]
pub(super) struct Moving {
    pub body: usize,
    word: &'static str,
    /// The greatest of its moves, in units of the machine's size, and turns.
    pub size: f64,
    /// The axis of each motion; empty where axes go without saying.
    screws: Vec<Screw>,
}

/// Parts of a motion below this are rounding.
const SILENT: f64 = 1e-6;

impl Moving {
    /// Takes up what the same body does in a further motion.
    pub fn merge(&mut self, other: Self) {
        if self.word != other.word {
            self.word = "moves and turns";
        }
        self.size = self.size.max(other.size);
        self.screws.extend(other.screws);
    }

    /// Does the body move as one piece with another in every motion, as far as axes tell?
    pub fn as_one_with(&self, other: &Self) -> bool {
        let alike = |(a, b): (&Screw, &Screw)| {
            a.point.is_some() == b.point.is_some()
                && a.direction.cross(&b.direction).norm() <= SILENT
        };
        self.screws.len() == other.screws.len() && self.screws.iter().zip(&other.screws).all(alike)
    }

    /// Do the words name axes?
    pub fn has_axes(&self) -> bool {
        !self.screws.is_empty()
    }

    /// In words.
    pub fn in_words<S: Space>(&self, system: &System<S>) -> BodyMotion {
        BodyMotion {
            body: system.bodies[self.body].name.clone(),
            motion: if self.has_axes() {
                Cow::Owned(axis_words(self.word, &self.screws, system.size))
            } else {
                Cow::Borrowed(self.word)
            },
        }
    }
}

/// Twist of a marker when the coordinates move with the velocities `v`.
pub(super) fn twist<S: Space>(
    system: &System<S>,
    ws: &Workspace<S>,
    marker: usize,
    v: &[f64],
) -> S::Twist {
    match system.markers[marker].body {
        Some(b) => S::push(
            &ws.markers[marker],
            &S::Twist::of(&v[S::NV * b..S::NV * (b + 1)]),
        ),
        None => S::Twist::zero(),
    }
}

/// The bodies that move in a motion.
pub(super) fn moving<S: Space>(
    system: &System<S>,
    ws: &Workspace<S>,
    v: &DVector<f64>,
) -> Vec<Moving> {
    let scale = column_scale(system);
    let largest = v
        .iter()
        .zip(&scale)
        .fold(0.0_f64, |m, (x, s)| m.max((x / s).abs()));
    let least = SILENT * largest;
    let mut list = Vec::new();
    for b in 0..system.bodies.len() {
        let mut own = S::Twist::of(&v.as_slice()[S::NV * b..S::NV * (b + 1)]);
        let (linear, angular) = own.as_mut_slice().split_at_mut(S::LINEAR);
        let (move_size, turn_size) = (norm(linear) / system.size, norm(angular));
        let (moves, turns) = (move_size > least, turn_size > least);
        if !moves {
            linear.fill(0.0);
        }
        if !turns {
            angular.fill(0.0);
        }
        let on_ground = |kind: &str, fits: &dyn Fn(usize) -> bool| {
            system.elements.iter().any(|e| {
                e.kind == kind
                    && e.bodies.len() == 1
                    && e.bodies[0] == b
                    && e.markers
                        .iter()
                        .any(|&m| system.markers[m].body == Some(b) && fits(m))
            })
        };
        let word = match (moves, turns) {
            (false, false) => continue,
            (false, true) => "turns",
            (true, false) => {
                if on_ground("prismatic", &|_| true) {
                    "slides"
                } else {
                    "moves"
                }
            }
            (true, true) => {
                let still = |m: usize| {
                    let t = twist(system, ws, m, v.as_slice());
                    norm(&t.as_slice()[..S::LINEAR]) / system.size <= least
                };
                if on_ground("revolute", &still) {
                    "turns"
                } else {
                    "moves and turns"
                }
            }
        };
        let screw = screw(system, ws, b, &own);
        list.push(Moving {
            body: b,
            word,
            size: move_size.max(turn_size),
            screws: screw.into_iter().collect(),
        });
    }
    list
}

/// The axis of a body's motion with the velocities `own`; none where axes go without saying.
fn screw<S: Space>(
    system: &System<S>,
    ws: &Workspace<S>,
    body: usize,
    own: &S::Twist,
) -> Option<Screw> {
    let center = &ws.markers[system.bodies[body].center_marker];
    S::screw(center, own).map(|screw| told(system, ws, body, screw))
}

/// What a body does that moves with the velocities `own`, with its axis; none where axes go without saying.
pub(in crate::analysis) fn with_axis<S: Space>(
    system: &System<S>,
    ws: &Workspace<S>,
    body: usize,
    own: &S::Twist,
) -> Option<String> {
    let screw = screw(system, ws, body, own)?;
    Some(axis_words("moves", &[screw], system.size))
}

/// A screw as it is told: through a joint of the body where one lies on the axis.
fn told<S: Space>(system: &System<S>, ws: &Workspace<S>, body: usize, mut screw: Screw) -> Screw {
    if let Some(nearest) = screw.point {
        let joints = system.elements.iter().filter(|e| e.role == Role::Joint);
        let own = joints
            .flat_map(|e| e.markers.iter())
            .filter(|&&m| system.markers[m].body == Some(body));
        let mut points = own.map(|&m| Vector3::from(S::point(&ws.markers[m])));
        let on_axis =
            |p: &Vector3<f64>| (p - nearest).cross(&screw.direction).norm() <= SILENT * system.size;
        screw.point = points.find(on_axis).or(screw.point);
    }
    screw
}
