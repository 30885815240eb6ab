//! Writes the channels of a machine at one instant after another.

use crate::joint::MeasureKind;
use crate::results::{Channel, Results};
use crate::space::{Planar, PlanarMarker, Space, Tuple, perpendicular};
use crate::system::{Role, State, System, Workspace};
use nalgebra::{Vector2, Vector3};

/// Records every coordinate, reaction, force, energy and violation of a planar machine.
#[derive(Debug)]
pub struct Recorder {
    channels: Vec<Channel>,
    at: usize,
    scratch: Vec<f64>,
    /// Are accelerations and reactions recorded?
    dynamic: bool,
}

/// Quantities of an instant that the workspace does not hold.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extra {
    /// Work of drivers and of forces without potential since the start [J].
    pub work: f64,
    /// Energy at the start [J].
    pub start_energy: Option<f64>,
}

impl Recorder {
    /// A recorder; `dynamic` says whether accelerations and reactions belong to the results.
    pub fn new(dynamic: bool) -> Self {
        Self {
            channels: Vec::new(),
            at: 0,
            scratch: Vec::new(),
            dynamic,
        }
    }

    /// The results so far.
    pub fn into_results(self, model: &str, analysis: &str) -> Results {
        Results {
            model: model.to_owned(),
            analysis: analysis.to_owned(),
            channels: self.channels,
            ..Results::default()
        }
    }

    fn put(&mut self, owner: &str, suffix: &str, unit: &str, meaning: &str, value: f64) {
        if self.at == self.channels.len() {
            let name = if owner.is_empty() {
                suffix.to_owned()
            } else {
                format!("{owner}.{suffix}")
            };
            self.channels.push(Channel {
                name,
                unit: unit.to_owned(),
                meaning: meaning.to_owned(),
                values: Vec::new(),
            });
        }
        // Adding zero turns a negative zero into a plain one.
        self.channels[self.at].values.push(value + 0.0);
        self.at += 1;
    }

    /// Records one instant. The workspace must hold markers, constraints and (where dynamic)
    /// accelerations and multipliers of the state.
    pub fn record(
        &mut self,
        system: &System<Planar>,
        ws: &Workspace<Planar>,
        state: &State,
        extra: Extra,
    ) {
        self.at = 0;
        self.put("", "time", "s", "time", state.t);
        for body in &system.bodies {
            self.point(system, ws, &body.name, body.frame_marker, "body frame");
        }
        for trace in &system.traces {
            self.point(system, ws, &trace.name, trace.marker, "trace");
            if let Some((observer, name)) = &trace.observer {
                self.relative(system, ws, &trace.name, trace.marker, *observer, name);
            }
        }
        for number in 0..system.elements.len() {
            self.element(system, ws, number, state.t);
        }
        let powers = self.forces(system, ws, state.t);
        self.totals(system, ws, state, extra, powers);
    }

    fn point(
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
    fn relative(
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

    fn element(&mut self, system: &System<Planar>, ws: &Workspace<Planar>, number: usize, t: f64) {
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
                MeasureKind::Angle => "angle of the second body from the first, counting turns",
                MeasureKind::Distance => "distance of the two points",
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
    fn forces(&mut self, system: &System<Planar>, ws: &Workspace<Planar>, t: f64) -> (f64, f64) {
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

    fn totals(
        &mut self,
        system: &System<Planar>,
        ws: &Workspace<Planar>,
        state: &State,
        extra: Extra,
        (elastic, power): (f64, f64),
    ) {
        let (kinetic, gravity) = energies(system, ws, &state.v);
        let potential = gravity + elastic;
        self.put("energy", "kinetic", "J", "kinetic energy", kinetic);
        self.put(
            "energy",
            "potential",
            "J",
            "potential energy of gravity and springs",
            potential,
        );
        self.put(
            "energy",
            "total",
            "J",
            "kinetic and potential energy",
            kinetic + potential,
        );
        if self.dynamic {
            let drivers: f64 = system
                .elements
                .iter()
                .filter(|e| e.role == Role::Driver)
                .map(|e| driver_power(ws, e.rows.clone()))
                .sum();
            self.put(
                "energy",
                "power",
                "W",
                "power of drivers and of forces without potential",
                power + drivers,
            );
        }
        if let Some(start) = extra.start_energy {
            self.put(
                "energy",
                "work",
                "J",
                "work of drivers and of forces without potential since the start",
                extra.work,
            );
            self.put(
                "energy",
                "balance",
                "J",
                "total energy minus its start minus the work: the error of the run",
                kinetic + potential - start - extra.work,
            );
        }
        let momentum = momentum(system, ws, &state.v);
        self.put(
            "momentum",
            "x",
            "kg m/s",
            "linear momentum, ground x",
            momentum.x,
        );
        self.put(
            "momentum",
            "y",
            "kg m/s",
            "linear momentum, ground y",
            momentum.y,
        );
        self.put(
            "momentum",
            "angular",
            "kg m^2/s",
            "angular momentum about the origin",
            momentum.z,
        );
        let (violation, _) = system.violation(ws);
        self.put(
            "violation",
            "position",
            "",
            "largest constraint violation, relative to the size of the machine",
            violation,
        );
        let mut rate = std::mem::take(&mut self.scratch);
        rate.clear();
        rate.resize(system.rows, 0.0);
        system.jac_mul(ws, &state.v, &mut rate);
        for (r, t) in rate.iter_mut().zip(&ws.time) {
            *r += t;
        }
        let (violation, _) = system.largest(&rate);
        self.scratch = rate;
        self.put(
            "violation",
            "velocity",
            "1/s",
            "largest violation of the velocity constraints, relative to the size",
            violation,
        );
    }
}

/// Kinetic energy and potential energy of gravity (zero at the ground's origin).
pub(super) fn energies(system: &System<Planar>, ws: &Workspace<Planar>, v: &[f64]) -> (f64, f64) {
    let (mut kinetic, mut gravity) = (0.0, 0.0);
    for (b, body) in system.bodies.iter().enumerate() {
        let m = &system.mass[9 * b..9 * b + 9];
        let v = &v[3 * b..3 * b + 3];
        kinetic += 0.5 * (m[0] * (v[0] * v[0] + v[1] * v[1]) + m[8] * v[2] * v[2]);
        let p = ws.markers[body.center_marker].point;
        gravity -= system.weight[3 * b] * p.x + system.weight[3 * b + 1] * p.y;
    }
    (kinetic, gravity)
}

/// Linear momentum and angular momentum about the origin.
fn momentum(system: &System<Planar>, ws: &Workspace<Planar>, v: &[f64]) -> Vector3<f64> {
    let mut sum = Vector3::zeros();
    for (b, body) in system.bodies.iter().enumerate() {
        let (m, j) = (system.mass[9 * b], system.mass[9 * b + 8]);
        let p = ws.markers[body.center_marker].point;
        let (px, py) = (m * v[3 * b], m * v[3 * b + 1]);
        sum += Vector3::new(px, py, p.x * py - p.y * px + j * v[3 * b + 2]);
    }
    sum
}

/// Power that the constraint of a driver gives to the machine: lambda . C_t, since C_q v = -C_t.
pub(super) fn driver_power(ws: &Workspace<Planar>, rows: std::ops::Range<usize>) -> f64 {
    rows.map(|r| ws.lambda[r] * ws.time[r]).sum()
}

/// Power of drivers and of forces without potential.
pub(super) fn outside_power(system: &System<Planar>, ws: &Workspace<Planar>, t: f64) -> f64 {
    let mut power = 0.0;
    for e in &system.elements {
        if e.role == Role::Driver {
            power += driver_power(ws, e.rows.clone());
        }
    }
    let mut markers = [PlanarMarker::default(); MOST_MARKERS];
    let mut wrenches = [Vector3::zeros(); MOST_MARKERS];
    for f in &system.forces {
        let n = f.markers.len();
        for (slot, &m) in markers.iter_mut().zip(&f.markers) {
            *slot = ws.markers[m];
        }
        wrenches[..n].fill(Vector3::zeros());
        f.element.wrenches(t, &markers[..n], &mut wrenches[..n]);
        power += f.element.report(t, &markers[..n]).potential_rate;
        for (w, m) in wrenches[..n].iter().zip(&markers[..n]) {
            power += w.dot(&Planar::twist(m));
        }
    }
    power
}

/// Most markers of one force element: two of its own and two for each input of its expressions.
const MOST_MARKERS: usize = 2 + 8 * crate::signal::MAX_INPUTS;

/// Acceleration of a marker: (point, angular), ground axes.
pub(super) fn acceleration(
    system: &System<Planar>,
    ws: &Workspace<Planar>,
    marker: usize,
) -> Vector3<f64> {
    match system.markers[marker].body {
        None => Vector3::zeros(),
        Some(b) => {
            let a = Vector3::new(ws.a[3 * b], ws.a[3 * b + 1], ws.a[3 * b + 2]);
            let m = &ws.markers[marker];
            Planar::push(m, &a) + Planar::bias(m)
        }
    }
}

/// Wrench that an element exerts on the body of one of its markers, at that marker's point, ground
/// axes: the generalized force -C_q^T lambda carried to the point (Shabana 6.147).
pub(super) fn reaction(
    system: &System<Planar>,
    ws: &Workspace<Planar>,
    number: usize,
    local: usize,
    t: f64,
    scratch: &mut Vec<f64>,
) -> Vector3<f64> {
    let e = &system.elements[number];
    // The gradients of the rows by the marker's twist are evaluated again: the stored Jacobian has
    // them already carried to the bodies and summed.
    let markers: Vec<PlanarMarker> = e.markers.iter().map(|&m| ws.markers[m]).collect();
    let (nr, nm, na) = (e.rows.len(), markers.len(), e.aux.len());
    scratch.clear();
    scratch.resize(3 * nr + nr * na, 0.0);
    let (value, rest) = scratch.split_at_mut(nr);
    let (time, rest) = rest.split_at_mut(nr);
    let (bias, auxiliary) = rest.split_at_mut(nr);
    let mut gradient = vec![Vector3::zeros(); nr * nm];
    e.element.evaluate(
        &crate::joint::ConstraintInput {
            t,
            markers: &markers,
            s: &ws.s[e.aux.clone()],
            s_rate: &ws.s_rate[e.aux.clone()],
        },
        &mut crate::joint::ConstraintOutput {
            value,
            gradient: &mut gradient,
            auxiliary,
            time,
            bias,
        },
    );
    let mut wrench = Vector3::zeros();
    for (r, row) in e.rows.clone().enumerate() {
        wrench.add_scaled(-ws.lambda[row], &gradient[r * nm + local]);
    }
    wrench
}
