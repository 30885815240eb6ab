//! Joint coordinates, reactions, drivers, force elements.

use super::energy::driver_power;
use super::reaction::{acceleration, reaction};
use super::{LETTERS, Recorder, turns};
use crate::joint::{ConstraintInput, MeasureKind};
use crate::space::{Space, Tuple, spread};
use crate::system::{Role, System, Workspace};

impl Recorder {
    pub(super) fn element<S: Space>(
        &mut self,
        system: &System<S>,
        ws: &Workspace<S>,
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
            let meaning = if c.measure.kind.is_angle() {
                "angle of the second body from the first, counting turns"
            } else if c.measure.kind == S::Measure::DISTANCE {
                "distance of the two points"
            } else {
                "displacement along the axis, second body from the first"
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
        let units = e.element.auxiliaries();
        let s = &ws.s[e.aux.clone()];
        let last = self.last(e.element.parameters(s, &[]).len());
        let parameters = e.element.parameters(s, &last.unwrap_or_default());
        for ((text, value), label) in parameters.into_iter().zip(&units) {
            let unit = label.unit.symbol();
            self.put(name, &text, unit, "surface parameter", value);
        }
        if !self.dynamic {
            return;
        }
        let wrench = reaction(system, ws, number, e.reaction_marker, t, &mut self.scratch);
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
            let [force, moment] = spread::<S>(&wrench);
            for (axis, x) in LETTERS[..S::LINEAR].iter().zip(&force) {
                let meaning = format!("{on} on the second body, ground {axis}");
                self.put(name, &format!("force_{axis}"), "N", &meaning, *x);
            }
            for (k, end, of) in turns::<S>() {
                let meaning = format!("{on} moment on the second body at the joint's point{of}");
                self.put(name, &format!("moment{end}"), "N m", &meaning, moment[k]);
            }
            let axes = S::axes(&ws.markers[e.markers[e.axes_marker]]);
            let (force, moment) = (axes.tr_mul(&force), axes.tr_mul(&moment));
            for (k, axis) in LETTERS[..S::LINEAR].iter().enumerate() {
                let meaning = format!("{on} on the second body along the joint's {axis} axis");
                self.put(name, &format!("force_{}", k + 1), "N", &meaning, force[k]);
            }
            if S::ANGULAR.len() > 1 {
                for (k, axis) in LETTERS.iter().enumerate() {
                    let meaning =
                        format!("{on} moment on the second body about the joint's {axis} axis");
                    self.put(
                        name,
                        &format!("moment_{}", k + 1),
                        "N m",
                        &meaning,
                        moment[k],
                    );
                }
            }
        }
        let input = ConstraintInput {
            t,
            markers: &ws.seen(&e.markers),
            s: &ws.s[e.aux.clone()],
            s_rate: &ws.s_rate[e.aux.clone()],
        };
        if let Some(contact) = e.element.contact(&input, &ws.lambda[e.rows.clone()]) {
            let meaning = "force of the contact, positive where the bodies push each other apart";
            self.put(name, "normal_force", "N", meaning, contact.normal);
            for (axis, x) in LETTERS[..S::LINEAR].iter().zip(&contact.point) {
                let meaning = format!("point of contact, ground {axis}");
                self.put(name, &format!("point_{axis}"), "m", &meaning, *x);
            }
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
    pub(super) fn forces<S: Space>(
        &mut self,
        system: &System<S>,
        ws: &Workspace<S>,
        t: f64,
    ) -> (f64, f64) {
        let (mut potential, mut power) = (0.0, 0.0);
        for f in &system.forces {
            let markers = ws.seen(&f.markers);
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
            let mut wrench = vec![S::Twist::zero(); markers.len()];
            f.element.wrenches(t, &markers, &mut wrench);
            let own: f64 = wrench
                .iter()
                .zip(&markers)
                .map(|(w, m)| w.dot(&S::twist(m)))
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
