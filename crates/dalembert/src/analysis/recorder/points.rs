//! Motion of bodies and traces.

use super::Recorder;
use super::reaction::acceleration;
use crate::space::{Planar, perpendicular};
use crate::system::{System, Workspace};
use nalgebra::Vector2;

impl Recorder {
    pub(super) fn point(
        &mut self,
        system: &System<Planar>,
        ws: &Workspace<Planar>,
        name: &str,
        marker: usize,
        what: &str,
    ) {
        let m = &ws.markers[marker];
        let put = &mut |s: &mut Self, suffix, unit, text: &str, value| {
            s.put(name, suffix, unit, &format!("{what}: {text}"), value);
        };
        put(self, "x", "m", "position, ground x", m.point.x);
        put(self, "y", "m", "position, ground y", m.point.y);
        put(
            self,
            "angle",
            "rad",
            "angle, counter-clockwise, counting turns",
            m.angle,
        );
        put(self, "vx", "m/s", "velocity, ground x", m.velocity.x);
        put(self, "vy", "m/s", "velocity, ground y", m.velocity.y);
        put(self, "omega", "rad/s", "angular velocity", m.omega);
        if self.dynamic {
            let a = acceleration(system, ws, marker);
            put(self, "ax", "m/s^2", "acceleration, ground x", a.x);
            put(self, "ay", "m/s^2", "acceleration, ground y", a.y);
            put(self, "alpha", "rad/s^2", "angular acceleration", a.z);
        }
    }

    /// Motion of a point as another body sees it, in that body's axes (Shabana 3.59 to 3.69).
    pub(super) fn relative(
        &mut self,
        system: &System<Planar>,
        ws: &Workspace<Planar>,
        name: &str,
        marker: usize,
        observer: usize,
        body: &str,
    ) {
        let (p, o) = (&ws.markers[marker], &ws.markers[observer]);
        let in_axes = |v: Vector2<f64>| Vector2::new(o.ex.dot(&v), o.ey().dot(&v));
        let d = p.point - o.point;
        // v_p = v_o + w x d + v_rel
        let v_rel = p.velocity - o.velocity - o.omega * perpendicular(&d);
        let mut put = |suffix: &str, unit: &str, text: &str, value: Vector2<f64>| {
            for (k, axis) in ["x", "y"].into_iter().enumerate() {
                let meaning = format!("{text}, {axis} axis of {body}");
                self.put(
                    name,
                    &format!("relative.{suffix}{axis}"),
                    unit,
                    &meaning,
                    value[k],
                );
            }
        };
        put("", "m", &format!("position seen from {body}"), in_axes(d));
        put(
            "v",
            "m/s",
            &format!("velocity seen from {body}"),
            in_axes(v_rel),
        );
        if self.dynamic {
            let (a_p, a_o) = (
                acceleration(system, ws, marker),
                acceleration(system, ws, observer),
            );
            let coriolis = 2.0 * o.omega * perpendicular(&v_rel);
            let carried =
                Vector2::new(a_o.x, a_o.y) + a_o.z * perpendicular(&d) - o.omega * o.omega * d;
            let a_rel = Vector2::new(a_p.x, a_p.y) - carried - coriolis;
            let mut put = |suffix: &str, text: &str, value: Vector2<f64>| {
                for (k, axis) in ["x", "y"].into_iter().enumerate() {
                    let meaning = format!("{text}, {axis} axis of {body}");
                    self.put(
                        name,
                        &format!("relative.{suffix}{axis}"),
                        "m/s^2",
                        &meaning,
                        value[k],
                    );
                }
            };
            put(
                "a",
                &format!("acceleration seen from {body}"),
                in_axes(a_rel),
            );
            put(
                "coriolis_",
                "Coriolis part of the acceleration 2 w x v_rel",
                in_axes(coriolis),
            );
        }
        self.put(
            name,
            "relative.angle",
            "rad",
            &format!("angle from {body}"),
            p.angle - o.angle,
        );
        self.put(
            name,
            "relative.omega",
            "rad/s",
            &format!("angular velocity from {body}"),
            p.omega - o.omega,
        );
    }
}
