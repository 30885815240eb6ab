//! The curves by which joints touch, as forms of bodies that have none: pitch circles, profiles.

use super::super::context::Context;
use super::super::place::Place;
use crate::joint::PlanarMeasure;
use crate::model::{CamFollower, JointKind, Value};
use crate::space::Planar;
use crate::system::{ElementData, Role};
use dalembert_expr::{Dim, Quantity};
use std::f64::consts::TAU;

/// Corners of a circle.
const CORNERS: u32 = 180;

/// Thickness of a flat face, as a part of its length.
const FACE: f64 = 0.04;

type Curve = Vec<[f64; 2]>;

impl Context<'_, Planar> {
    pub(super) fn curves(
        &mut self,
        name: &str,
        kind: &JointKind,
        place: &Place,
    ) -> Option<[Curve; 2]> {
        match kind {
            JointKind::Rack { radius, .. } => {
                Some([circle(self.length(place, radius, "radius")?), Curve::new()])
            }
            JointKind::RollingOnLine { radius, .. } => {
                Some([Curve::new(), circle(self.length(place, radius, "radius")?)])
            }
            JointKind::RollingOnCircle { radii, .. } => Some([
                circle(self.length(place, &radii[0], "radii[0]")?),
                circle(self.length(place, &radii[1], "radii[1]")?),
            ]),
            JointKind::Gear {
                radii, internal, ..
            } => {
                let mut of = |k: usize| {
                    let path = place.key(&format!("radii[{k}]"));
                    self.constant(&radii[k], Quantity::Free, &place.owner, &path)
                };
                let radii = [of(0)?, of(1)?];
                let markers = &self.joint_places.get(name)?.markers;
                let poses = [markers[0], markers[1]].map(|m| self.pose(m));
                let distance = (poses[1].point - poses[0].point).norm();
                let radii = pitch_radii(radii, *internal, distance)?;
                Some(radii.map(circle))
            }
            JointKind::Cam { follower, .. } => {
                let own = |e: &&ElementData<Planar>| e.role == Role::Joint && e.name == name;
                let profile = self.elements.iter().find(own)?.element.outline();
                let other = match follower {
                    CamFollower::KnifeEdge => Curve::new(),
                    CamFollower::Roller { radius } => {
                        circle(self.length(place, radius, "follower.radius")?)
                    }
                    CamFollower::Flat => self.face(name, &profile)?,
                };
                Some([profile, other])
            }
            JointKind::Revolute { .. }
            | JointKind::Prismatic { .. }
            | JointKind::Weld { .. }
            | JointKind::Distance { .. }
            | JointKind::PinSlot { .. } => None,
            // Refused before.
            JointKind::Spherical { .. }
            | JointKind::Cylindrical { .. }
            | JointKind::Universal { .. }
            | JointKind::ConstantVelocity { .. }
            | JointKind::Screw { .. }
            | JointKind::Planar { .. }
            | JointKind::PointOnLine { .. }
            | JointKind::PointOnPlane { .. }
            | JointKind::PointOnCurve { .. }
            | JointKind::ParallelAxes { .. }
            | JointKind::PerpendicularAxes { .. }
            | JointKind::RollingDisc { .. }
            | JointKind::RollingBall { .. }
            | JointKind::KnifeEdge { .. }
            | JointKind::SurfaceContact { .. }
            | JointKind::PointOnSurface { .. }
            | JointKind::GearPair { .. }
            | JointKind::RackPair { .. } => None,
        }
    }

    fn length(&mut self, place: &Place, value: &Value, key: &str) -> Option<f64> {
        self.number(value, Dim::LENGTH, &place.owner, &place.key(key))
    }

    /// The face of a flat follower: as long as the cam is wide, thick on the side without the cam.
    fn face(&self, name: &str, cam: &Curve) -> Option<Curve> {
        let markers = &self.joint_places.get(name)?.markers;
        let [cam_pose, face_pose] = [markers[0], markers[1]].map(|m| self.pose(m));
        let reach = cam.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
        let side = PlanarMeasure::AlongY.value(&face_pose, &cam_pose);
        let back = if side > 0.0 { -FACE } else { FACE } * reach;
        Some(vec![
            [-reach, 0.0],
            [reach, 0.0],
            [reach, back],
            [-reach, back],
        ])
    }
}

fn circle(radius: f64) -> Curve {
    let corner = |k: u32| {
        let (s, c) = (TAU * f64::from(k) / f64::from(CORNERS)).sin_cos();
        [radius * c, radius * s]
    };
    (0..CORNERS).map(corner).collect()
}

/// Radii of circles that touch. Numbers of teeth (and lengths that do not fit the distance of the
/// centres) only say the ratio.
fn pitch_radii(given: [f64; 2], internal: bool, distance: f64) -> Option<[f64; 2]> {
    let [a, b] = given;
    let sum = if internal { (a - b).abs() } else { a + b };
    // An estimate of the poses may be off by a little; lengths are then right, it is not.
    if (sum - distance).abs() <= 0.2 * distance {
        return Some(given);
    }
    (sum > 0.0 && distance > 0.0).then(|| given.map(|r| r * distance / sum))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn teeth_become_circles_that_touch() {
        assert_eq!(pitch_radii([20.0, 40.0], false, 0.3), Some([0.1, 0.2]));
        let [a, b] = pitch_radii([20.0, 60.0], true, 0.2).unwrap();
        assert!((b - a - 0.2).abs() < 1e-15 && (b - 3.0 * a).abs() < 1e-15);
        assert_eq!(pitch_radii([0.1, 0.21], false, 0.3), Some([0.1, 0.21]));
        assert_eq!(pitch_radii([20.0, 20.0], true, 0.2), None);
    }
}
