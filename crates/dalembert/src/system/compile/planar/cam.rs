//! Cams.

use super::super::built::Built;
use super::super::context::Context;
use super::super::place::Place;
use crate::joint::{Cam, Follower, Profile};
use crate::model::{CamFollower, CamProfile, Value};
use crate::space::Planar;
use dalembert_expr::{Dim, Program};
use nalgebra::Vector2;
use smallvec::{SmallVec, smallvec};
use std::f64::consts::TAU;
use std::sync::Arc;

impl Context<'_, Planar> {
    fn profile_program(&mut self, value: &Value, place: &Place, key: &str) -> Option<Program> {
        let key = format!("profile.{key}");
        self.length_program(value, &["phi"], "a profile", place, &key)
    }

    /// The profile of a cam.
    pub fn profile(&mut self, profile: &CamProfile, place: &Place) -> Option<Profile> {
        match profile {
            CamProfile::Polar { radius } => self
                .profile_program(radius, place, "radius")
                .map(Profile::Polar),
            CamProfile::Cartesian { x, y } => {
                let (x, y) = (
                    self.profile_program(x, place, "x"),
                    self.profile_program(y, place, "y"),
                );
                x.zip(y).map(|(x, y)| Profile::Cartesian(x, y))
            }
        }
    }

    pub(super) fn cam(
        &mut self,
        m: [usize; 2],
        profile: &CamProfile,
        follower: &CamFollower,
        phi: Option<&Value>,
        place: &Place,
    ) -> Option<Built<Planar>> {
        let profile = self.profile(profile, place);
        let follower = match follower {
            CamFollower::KnifeEdge => Some(Follower::KnifeEdge),
            CamFollower::Flat => Some(Follower::Flat),
            CamFollower::Roller { radius } => self
                .positive(radius, Dim::LENGTH, "radius", place, "follower.radius")
                .map(Follower::Roller),
        };
        let phi = phi.map(|v| self.number(v, Dim::NONE, &place.owner, &place.key("phi")));
        let (profile, follower) = (profile?, follower?);
        let start = match phi {
            Some(value) => value?,
            None => self.nearest_phi(m, &profile, follower),
        };
        Some(Built {
            kind: "cam",
            element: Arc::new(Cam { profile, follower }),
            markers: SmallVec::from_slice(&m),
            coordinates: SmallVec::new(),
            auxiliary_start: smallvec![start],
            reaction_marker: 1,
        })
    }

    /// The surface parameter at which the profile comes nearest to the follower in the estimate.
    fn nearest_phi(&self, m: [usize; 2], profile: &Profile, follower: Follower) -> f64 {
        let [a, b] = m.map(|k| self.pose(k));
        let merit = |phi: f64| {
            let [u, u1, ..] = profile.derivatives(phi);
            let turn = |w: Vector2<f64>| w.x * a.ex + w.y * a.ey();
            let n = a.point + turn(u) - b.point;
            match follower {
                Follower::KnifeEdge | Follower::Roller(_) => n.norm_squared(),
                Follower::Flat => b.ey().dot(&n).powi(2) + b.ey().dot(&turn(u1)).powi(2),
            }
        };
        let samples = 720;
        (0..samples)
            .map(|k| TAU * f64::from(k) / f64::from(samples))
            .filter(|x| merit(*x).is_finite())
            .min_by(|x, y| merit(*x).total_cmp(&merit(*y)))
            .unwrap_or(0.0)
    }
}
