//! Evaluation of a system at a state: markers, constraints, forces.

use super::{System, Workspace};
use crate::joint::{ConstraintInput, ConstraintOutput};
use crate::space::{Space, Tuple};

impl<S: Space> System<S> {
    /// Poses and velocities of all markers.
    pub fn update_markers(&self, q: &[f64], v: &[f64], ws: &mut Workspace<S>) {
        self.update_poses(q, v, ws);
        for m in 0..self.markers.len() {
            self.update_marker(m, v, ws);
        }
        self.set_turns(q, ws);
    }

    /// Poses and velocities of the markers that elements and forces see: all that an evaluation of
    /// the equations of motion needs.
    pub fn update_active_markers(&self, q: &[f64], v: &[f64], ws: &mut Workspace<S>) {
        self.update_poses(q, v, ws);
        for &m in &self.active {
            self.update_marker(m, v, ws);
        }
        self.set_turns(q, ws);
    }

    fn update_marker(&self, m: usize, v: &[f64], ws: &mut Workspace<S>) {
        let data = &self.markers[m];
        // Markers on the ground stay as the workspace was made.
        if let Some(b) = data.body {
            ws.markers[m] = S::marker(&data.frame, &ws.poses[b], &v[b * S::NV..(b + 1) * S::NV]);
        }
    }

    fn update_poses(&self, q: &[f64], v: &[f64], ws: &mut Workspace<S>) {
        for (pose, q) in ws.poses.iter_mut().zip(q.chunks_exact(S::NQ)) {
            *pose = S::pose(q);
        }
        if S::GYROSCOPIC {
            let (bodies, n) = (self.bodies.len(), S::NV);
            for (b, v) in v.chunks_exact(n).take(bodies).enumerate() {
                ws.gyroscopic[b] = S::gyroscopic(self.mass_block(b), v);
            }
        }
        let (nq, nv) = (self.bodies.len() * S::NQ, self.body_nv());
        ws.s.copy_from_slice(&q[nq..nq + self.aux]);
        ws.s_rate.copy_from_slice(&v[nv..]);
    }

    /// C, C_q, C_t and Q_d at the markers of the workspace.
    ///
    /// Q_d = -(d2C/dt2 at zero accelerations) (Shabana 3.124, 6.140).
    pub fn evaluate_constraints(&self, t: f64, ws: &mut Workspace<S>) {
        let Workspace {
            markers,
            s,
            s_rate,
            value,
            time,
            qd,
            jac,
            jac_aux,
            local_markers,
            gradient,
            ..
        } = ws;
        let (mut row, mut aux, mut at, mut at_aux) = (0, 0, 0, 0);
        for step in self.plan.steps() {
            let (nm, nr, na) = (step.places.len(), step.rows, step.aux);
            for (local, place) in local_markers.iter_mut().zip(step.places) {
                *local = markers[place.marker()];
            }
            let block = nr * S::NV;
            let rows = row..row + nr;
            let auxiliaries = aux..aux + na;
            let gradient = &mut gradient[..nr * nm];
            let jac = &mut jac[at..at + step.bodies * block];
            let jac_aux = &mut jac_aux[at_aux..at_aux + nr * na];
            let (value, time, qd) = (
                &mut value[rows.clone()],
                &mut time[rows.clone()],
                &mut qd[rows.clone()],
            );
            for out in [&mut *value, &mut *time, &mut *qd, &mut *jac, &mut *jac_aux] {
                out.fill(0.0);
            }
            gradient.fill(S::Twist::zero());
            step.element.evaluate(
                &ConstraintInput {
                    t,
                    markers: &local_markers[..nm],
                    s: &s[auxiliaries.clone()],
                    s_rate: &s_rate[auxiliaries.clone()],
                },
                &mut ConstraintOutput {
                    value,
                    gradient,
                    auxiliary: jac_aux,
                    time,
                    bias: qd,
                },
            );
            for (k, place) in step.places.iter().enumerate() {
                let Some(slot) = place.slot() else { continue };
                let m = &local_markers[k];
                let own = S::bias(m);
                for r in 0..nr {
                    let g = &gradient[r * nm + k];
                    let pulled = S::pull(m, g);
                    let start = slot * block + r * S::NV;
                    for (x, y) in jac[start..start + S::NV].iter_mut().zip(pulled.as_slice()) {
                        *x += y;
                    }
                    qd[r] += g.dot(&own);
                }
            }
            for x in qd.iter_mut() {
                *x = -*x;
            }
            row = rows.end;
            aux = auxiliaries.end;
            at += step.bodies * block;
            at_aux += nr * na;
        }
    }

    /// The same as [`System::evaluate_constraints`], for what holds positions alone: rows that hold for velocities only
    /// have no gradient.
    pub fn evaluate_positions(&self, t: f64, ws: &mut Workspace<S>) {
        self.evaluate_constraints(t, ws);
        if self.velocity_rows().is_empty() {
            return;
        }
        let (jac, jac_aux) = (&mut ws.jac, &mut ws.jac_aux);
        self.each_block(|e, _, at| {
            for (r, row) in e.rows.clone().enumerate() {
                if self.velocity_rows().binary_search(&row).is_ok() {
                    jac[at + r * S::NV..at + (r + 1) * S::NV].fill(0.0);
                }
            }
        });
        self.each_aux(|row, _, at| {
            if self.velocity_rows().binary_search(&row).is_ok() {
                jac_aux[at] = 0.0;
            }
        });
    }

    /// Generalized applied forces Q_e (gravity and force elements) and inertia forces Q_v of turning
    /// bodies, into `ws.force`.
    pub fn evaluate_forces(&self, t: f64, ws: &mut Workspace<S>) {
        let Workspace {
            markers,
            force,
            gyroscopic,
            local_markers,
            gradient,
            ..
        } = ws;
        force[..self.weight.len()].copy_from_slice(&self.weight);
        force[self.weight.len()..].fill(0.0);
        for (force, own) in force.chunks_exact_mut(S::NV).zip(gyroscopic.iter()) {
            for (x, y) in force.iter_mut().zip(own.as_slice()) {
                *x += y;
            }
        }
        for f in &self.forces {
            let nm = f.markers.len();
            for (slot, &m) in local_markers.iter_mut().zip(&f.markers) {
                *slot = markers[m];
            }
            let wrench = &mut gradient[..nm];
            wrench.fill(S::Twist::zero());
            f.element.wrenches(t, &local_markers[..nm], wrench);
            for (k, &m) in f.markers.iter().enumerate() {
                if let Some(b) = self.markers[m].body {
                    let pulled = S::pull(&local_markers[k], &wrench[k]);
                    let at = b * S::NV;
                    for (x, y) in force[at..at + S::NV].iter_mut().zip(pulled.as_slice()) {
                        *x += y;
                    }
                }
            }
        }
    }

    /// Power of the force elements beyond what their potentials lose [W].
    pub fn force_power(&self, t: f64, ws: &mut Workspace<S>) -> f64 {
        let Workspace {
            markers,
            local_markers,
            gradient,
            ..
        } = ws;
        let mut power = 0.0;
        for f in &self.forces {
            let nm = f.markers.len();
            for (slot, &m) in local_markers.iter_mut().zip(&f.markers) {
                *slot = markers[m];
            }
            let (seen, wrench) = (&local_markers[..nm], &mut gradient[..nm]);
            wrench.fill(S::Twist::zero());
            f.element.wrenches(t, seen, wrench);
            power += f.element.report(t, seen).potential_rate;
            for (w, m) in wrench.iter().zip(seen) {
                power += w.dot(&S::twist(m));
            }
        }
        power
    }
}
