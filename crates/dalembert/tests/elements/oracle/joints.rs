//! Joints of two bodies, gears, racks and rolling.

use super::{Machine, Marker, Number, Residual, dot};

/// Two markers, with the residual of a joint without parameters.
pub struct Pair {
    pub kind: &'static str,
    pub bodies: [&'static str; 2],
    pub at: [[f64; 2]; 2],
    pub angles: [f64; 2],
}

impl Pair {
    fn markers<D: Number>(&self, machine: &Machine<D>) -> [Marker<D>; 2] {
        [0, 1].map(|k| machine.marker(self.bodies[k], self.at[k], self.angles[k]))
    }
}

impl Residual for Pair {
    fn rows<D: Number>(&self, machine: &Machine<D>) -> Vec<D> {
        let [a, b] = self.markers(machine);
        let d = a.to(&b);
        let angle = a.angle - b.angle;
        match self.kind {
            "revolute" => vec![-d[0], -d[1]],
            "prismatic" => vec![angle, -dot(a.ey(), d)],
            "weld" => vec![-d[0], -d[1], angle],
            "pin-slot" => vec![-dot(a.ey(), d)],
            "distance" => vec![-dot(d, d).sqrt()],
            other => panic!("no oracle for {other}"),
        }
    }

    fn constants(&self, estimate: &Machine<f64>) -> Vec<f64> {
        let rows = self.rows(estimate);
        match self.kind {
            // The estimated distance is the length.
            "distance" => rows,
            _ => vec![0.0; rows.len()],
        }
    }
}

/// Equal arcs on the pitch circles, seen from the carrier.
pub struct Gear {
    pub carrier: &'static str,
    pub radii: [f64; 2],
    pub internal: bool,
}

impl Residual for Gear {
    fn rows<D: Number>(&self, machine: &Machine<D>) -> Vec<D> {
        let angle = |body| machine.marker(body, [0.0; 2], 0.0).angle;
        let carrier = angle(self.carrier);
        let [a, b] = self.radii;
        let b = if self.internal { -b } else { b };
        // Divided by the first radius: the row is an angle of the first gear.
        vec![((angle("a") - carrier) * a + (angle("b") - carrier) * b) / a]
    }

    fn constants(&self, estimate: &Machine<f64>) -> Vec<f64> {
        self.rows(estimate)
    }
}

/// A circle about the centre of one marker on the x axis of another; a rack holds the arc only.
pub struct Rolling {
    pub line: (&'static str, [f64; 2], f64),
    pub circle: (&'static str, [f64; 2], f64),
    pub radius: f64,
    /// +1 where the circle is to the left of the line.
    pub side: f64,
    pub touches: bool,
}

impl Residual for Rolling {
    fn rows<D: Number>(&self, machine: &Machine<D>) -> Vec<D> {
        let frame = |(body, at, angle)| machine.marker(body, at, angle);
        let (line, circle) = (frame(self.line), frame(self.circle));
        let d = line.to(&circle);
        let radius = self.side * self.radius;
        let arc = dot(line.ex(), d) + (circle.angle - line.angle) * radius;
        if self.touches {
            vec![dot(line.ey(), d) - radius, arc]
        } else {
            vec![arc]
        }
    }

    fn constants(&self, estimate: &Machine<f64>) -> Vec<f64> {
        let mut rows = self.rows(estimate);
        if self.touches {
            rows[0] = 0.0;
        }
        rows
    }
}

/// A circle that rolls on a circle; the angle of the line of centres is an auxiliary coordinate.
pub struct RollingCircle {
    pub pair: Pair,
    pub radii: [f64; 2],
    pub internal: bool,
}

impl RollingCircle {
    fn at<D: Number>(&self, machine: &Machine<D>, psi: D) -> Vec<D> {
        let [a, b] = self.pair.markers(machine);
        let d = a.to(&b);
        let [first, second] = self.radii;
        let second = if self.internal { -second } else { second };
        let reach = first + second;
        vec![
            psi.cos() * reach - d[0],
            psi.sin() * reach - d[1],
            (psi - a.angle) * first + (psi - b.angle) * second,
        ]
    }
}

impl Residual for RollingCircle {
    fn rows<D: Number>(&self, machine: &Machine<D>) -> Vec<D> {
        self.at(machine, machine.auxiliary())
    }

    fn constants(&self, estimate: &Machine<f64>) -> Vec<f64> {
        let [a, b] = self.pair.markers(estimate);
        let d = a.to(&b);
        let ring = self.internal && self.radii[1] > self.radii[0];
        let side = if ring { -1.0 } else { 1.0 };
        let psi = (side * d[1]).atan2(side * d[0]);
        vec![0.0, 0.0, self.at(estimate, psi)[2]]
    }
}
