//! Motion of bodies and traces.

use super::reaction::acceleration;
use super::{LETTERS, Recorder, turns};
use crate::space::{Space, spread};
use crate::system::{System, Workspace};
use nalgebra::Vector3;

impl Recorder {
    pub(super) fn point<S: Space>(
        &mut self,
        system: &System<S>,
        ws: &Workspace<S>,
        name: &str,
        marker: usize,
        what: &str,
    ) {
        let m = &ws.markers[marker];
        let axes = &LETTERS[..S::LINEAR];
        for (axis, x) in axes.iter().zip(S::point(m)) {
            let meaning = format!("{what}: position, ground {axis}");
            self.put(name, axis, "m", &meaning, x);
        }
        let labels = S::attitude_labels(self.recording.orientation);
        let before = self.last(labels.len());
        let attitude = S::attitude(m, self.recording.orientation, before.as_deref());
        for (label, x) in labels.iter().zip(attitude) {
            let meaning = format!("{what}: {}", label.meaning);
            self.put_attitude(name, &label.name, label.unit, &meaning, x);
        }
        let kinds = [
            ("v", "m/s", "velocity", "omega", "rad/s", "angular velocity"),
            (
                "a",
                "m/s^2",
                "acceleration",
                "alpha",
                "rad/s^2",
                "angular acceleration",
            ),
        ];
        let rates = [S::twist(m), acceleration(system, ws, marker)];
        let count = if self.dynamic { 2 } else { 1 };
        for ((short, unit, text, turn, turn_unit, turn_text), rate) in
            kinds.into_iter().zip(rates).take(count)
        {
            let [linear, angular] = spread::<S>(&rate);
            for (axis, x) in axes.iter().zip(&linear) {
                let meaning = format!("{what}: {text}, ground {axis}");
                self.put(name, &format!("{short}{axis}"), unit, &meaning, *x);
            }
            for (k, end, of) in turns::<S>() {
                let meaning = format!("{what}: {turn_text}{of}");
                let suffix = format!("{turn}{end}");
                self.put(name, &suffix, turn_unit, &meaning, angular[k]);
            }
        }
    }

    /// Motion of a point as another body sees it, in that body's axes (Shabana 3.59 to 3.69).
    pub(super) fn relative<S: Space>(
        &mut self,
        system: &System<S>,
        ws: &Workspace<S>,
        name: &str,
        marker: usize,
        observer: usize,
        body: &str,
    ) {
        let (p, o) = (&ws.markers[marker], &ws.markers[observer]);
        let axes = S::axes(o);
        let d = Vector3::from(S::point(p)) - Vector3::from(S::point(o));
        let [v_p, w_p] = spread::<S>(&S::twist(p));
        let [v_o, w_o] = spread::<S>(&S::twist(o));
        // v_p = v_o + w x d + v_rel
        let v_rel = v_p - v_o - w_o.cross(&d);
        let seen = |what: &str| format!("{what} seen from {body}");
        let mut vectors = vec![
            ("", "m", seen("position"), d),
            ("v", "m/s", seen("velocity"), v_rel),
        ];
        if self.dynamic {
            let [a_p, _] = spread::<S>(&acceleration(system, ws, marker));
            let [a_o, alpha_o] = spread::<S>(&acceleration(system, ws, observer));
            let coriolis = 2.0 * w_o.cross(&v_rel);
            let carried = a_o + alpha_o.cross(&d) + w_o.cross(&w_o.cross(&d));
            let a_rel = a_p - carried - coriolis;
            let part = "Coriolis part of the acceleration 2 w x v_rel".to_owned();
            vectors.push(("a", "m/s^2", seen("acceleration"), a_rel));
            vectors.push(("coriolis_", "m/s^2", part, coriolis));
        }
        for (suffix, unit, text, vector) in vectors {
            let vector = axes.tr_mul(&vector);
            for (axis, x) in LETTERS[..S::LINEAR].iter().zip(&vector) {
                let meaning = format!("{text}, {axis} axis of {body}");
                let suffix = format!("relative.{suffix}{axis}");
                self.put(name, &suffix, unit, &meaning, *x);
            }
        }
        let relative = S::relative(o, p);
        let labels = S::attitude_labels(self.recording.orientation);
        let before = self.last(labels.len());
        let attitude = S::attitude(&relative, self.recording.orientation, before.as_deref());
        for (label, x) in labels.iter().zip(attitude) {
            let kind = if S::ANGULAR.len() == 1 {
                "angle"
            } else {
                label.meaning.as_str()
            };
            let meaning = format!("{kind} from {body}");
            let suffix = format!("relative.{}", label.name);
            self.put_attitude(name, &suffix, label.unit, &meaning, x);
        }
        let w = axes.tr_mul(&(w_p - w_o));
        for (k, end, _) in turns::<S>() {
            let of = if end.is_empty() {
                String::new()
            } else {
                format!(", {} axis of it", LETTERS[k])
            };
            let meaning = format!("angular velocity from {body}{of}");
            self.put(
                name,
                &format!("relative.omega{end}"),
                "rad/s",
                &meaning,
                w[k],
            );
        }
    }
}
