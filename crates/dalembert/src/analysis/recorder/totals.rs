//! Energies, momentum and violation of the whole machine.

use super::energy::{driver_power, energies, momentum};
use super::{Extra, LETTERS, Recorder, turns};
use crate::space::Space;
use crate::system::{State, System, Workspace};
use nalgebra::Vector3;

impl Recorder {
    pub(super) fn totals<S: Space>(
        &mut self,
        system: &System<S>,
        ws: &Workspace<S>,
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
            let drivers = system.drivers().map(|e| driver_power(ws, e.rows.clone()));
            let drivers: f64 = drivers.sum();
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
        self.momenta(system, ws, state);
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

    /// Momentum of the machine, and where it is asked for of each body.
    fn momenta<S: Space>(&mut self, system: &System<S>, ws: &Workspace<S>, state: &State) {
        let about = Vector3::from(self.recording.momentum_about.unwrap_or_default());
        let place = match self.recording.momentum_about {
            None => "the origin".to_owned(),
            Some([x, y, z]) => format!("({x}, {y}, {z})"),
        };
        let mut sum = [Vector3::zeros(); 2];
        for (b, body) in system.bodies.iter().enumerate() {
            let own = momentum(system, ws, &state.v, b, &about);
            if self.recording.momentum_about.is_some() {
                let owner = format!("{}.momentum", body.name);
                self.momentum::<S>(&owner, &own, &place);
            }
            for (sum, own) in sum.iter_mut().zip(own) {
                *sum += own;
            }
        }
        self.momentum::<S>("momentum", &sum, &place);
    }

    fn momentum<S: Space>(
        &mut self,
        owner: &str,
        [linear, angular]: &[Vector3<f64>; 2],
        place: &str,
    ) {
        for (axis, x) in LETTERS[..S::LINEAR].iter().zip(linear) {
            let meaning = format!("linear momentum, ground {axis}");
            self.put(owner, axis, "kg m/s", &meaning, *x);
        }
        for (k, end, of) in turns::<S>() {
            let meaning = format!("angular momentum about {place}{of}");
            let suffix = format!("angular{end}");
            self.put(owner, &suffix, "kg m^2/s", &meaning, angular[k]);
        }
    }
}
