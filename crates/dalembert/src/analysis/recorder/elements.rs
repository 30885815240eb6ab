//! Joint coordinates, reactions, drivers, force elements.

use super::Recorder;
use super::energy::driver_power;
use super::reaction::{acceleration, reaction};
use crate::joint::PlanarMeasure;
use crate::space::{Planar, PlanarMarker, Space};
use crate::system::{Role, System, Workspace};
use nalgebra::{Vector2, Vector3};

impl Recorder {
    pub(super) fn element(
        &mut self,
        system: &System<Planar>,
        ws: &Workspace<Planar>,
        number: usize,
        t: f64,
    ) {
        let e = &system.elements[number];
        let name = e.name.as_str();
        for c in &e.coordinates {
            let (first, second) = (e.markers[c.measure.first], e.markers[c.measure.second]);
            let m = c
                .measure
                .kind
                .evaluate(&ws.markers[first], &ws.markers[second]);
            let (unit, rate, second_rate) = if c.measure.kind.is_angle() {
                ("rad", "rad/s", "rad/s^2")
            } else {
                ("m", "m/s", "m/s^2")
            };
            let meaning = match c.measure.kind {
                PlanarMeasure::Angle => "angle of the second body from the first, counting turns",
                PlanarMeasure::Distance => "distance of the two points",
                _ => "displacement along the axis, second body from the first",
            };
            self.put(name, c.name, unit, meaning, m.value);
            self.put(
                name,
                &format!("{}_rate", c.name),
                rate,
                &format!("rate: {meaning}"),
                m.rate,
            );
            if self.dynamic {
                let (a, b) = (
                    acceleration(system, ws, first),
                    acceleration(system, ws, second),
                );
                let value = m.bias + m.first.dot(&a) + m.second.dot(&b);
                self.put(
                    name,
                    &format!("{}_acceleration", c.name),
                    second_rate,
                    &format!("acceleration: {meaning}"),
                    value,
                );
            }
        }
        for (k, label) in e.element.auxiliaries().iter().enumerate() {
            self.put(
                name,
                &label.text,
                "rad",
                "surface parameter",
                ws.s[e.aux.start + k],
            );
        }
        if !self.dynamic {
            return;
        }
        let wrench = reaction(system, ws, number, e.reaction_marker, t, &mut self.scratch);
        let axes = &ws.markers[e.markers[e.axes_marker]];
        if e.role == Role::Driver && e.rows.len() == 1 {
            // C = x - f(t): the driver pushes x with -lambda.
            let effort = -ws.lambda[e.rows.start];
            let angle = e
                .coordinates
                .first()
                .is_some_and(|c| c.measure.kind.is_angle());
            let (suffix, unit) = if angle {
                ("moment", "N m")
            } else {
                ("force", "N")
            };
            self.put(
                name,
                suffix,
                unit,
                "what the driver exerts along its quantity",
                effort,
            );
        } else {
            let on = if e.role == Role::Driver {
                "driver"
            } else {
                "reaction"
            };
            self.put(
                name,
                "force_x",
                "N",
                &format!("{on} on the second body, ground x"),
                wrench.x,
            );
            self.put(
                name,
                "force_y",
                "N",
                &format!("{on} on the second body, ground y"),
                wrench.y,
            );
            self.put(
                name,
                "moment",
                "N m",
                &format!("{on} moment on the second body at the joint's point"),
                wrench.z,
            );
            let f = Vector2::new(wrench.x, wrench.y);
            self.put(
                name,
                "force_1",
                "N",
                &format!("{on} on the second body along the joint's x axis"),
                axes.ex.dot(&f),
            );
            self.put(
                name,
                "force_2",
                "N",
                &format!("{on} on the second body along the joint's y axis"),
                axes.ey().dot(&f),
            );
        }
        if e.role == Role::Driver {
            self.put(
                name,
                "power",
                "W",
                "power of the driver into the machine",
                driver_power(ws, e.rows.clone()),
            );
        }
    }

    /// Force elements; returns potential energy and the power of what has no potential.
    pub(super) fn forces(
        &mut self,
        system: &System<Planar>,
        ws: &Workspace<Planar>,
        t: f64,
    ) -> (f64, f64) {
        let (mut potential, mut power) = (0.0, 0.0);
        for f in &system.forces {
            let markers: Vec<PlanarMarker> = f.markers.iter().map(|&m| ws.markers[m]).collect();
            let report = f.element.report(t, &markers);
            for (channel, value) in f.element.channels().iter().zip(report.values) {
                self.put(
                    &f.name,
                    channel.suffix,
                    channel.unit,
                    channel.meaning,
                    value,
                );
            }
            let mut wrench = vec![Vector3::zeros(); markers.len()];
            f.element.wrenches(t, &markers, &mut wrench);
            let own: f64 = wrench
                .iter()
                .zip(&markers)
                .map(|(w, m)| w.dot(&Planar::twist(m)))
                .sum();
            self.put(
                &f.name,
                "energy",
                "J",
                "potential energy stored",
                report.potential,
            );
            potential += report.potential;
            power += own + report.potential_rate;
        }
        (potential, power)
    }
}
