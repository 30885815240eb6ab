//! Writes the channels of a machine at one instant after another.

mod elements;
mod energy;
mod points;
mod reaction;
mod recording;
mod totals;

pub(super) use energy::{energies, outside_power};
pub use recording::Recording;

use crate::results::{Channel, Results};
use crate::space::Space;
use crate::system::{State, System, Workspace};

/// Records every coordinate, reaction, force, energy and violation of a machine.
#[derive(Debug)]
pub struct Recorder {
    channels: Vec<Channel>,
    at: usize,
    scratch: Vec<f64>,
    /// Are accelerations and reactions recorded?
    dynamic: bool,
    recording: Recording,
    /// Bodies and traces that came near a singular pose of the set: name, time and how near.
    singular: Vec<(String, f64, f64)>,
}

/// Quantities of an instant that the workspace does not hold.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extra {
    /// Work of drivers and of forces without potential since the start [J].
    pub work: f64,
    /// Energy at the start [J].
    pub start_energy: Option<f64>,
}

/// Distance from a singular pose below which the coordinates lose three digits.
const SINGULAR: f64 = 1e-3;

/// Letters of the axes of the ground.
const LETTERS: [&str; 3] = ["x", "y", "z"];

/// Angular components of a space: the place in a vector of space, the end of the channel's name, and of its meaning.
fn turns<S: Space>() -> impl Iterator<Item = (usize, String, String)> {
    let plane = S::ANGULAR.len() == 1;
    S::ANGULAR.iter().map(move |&k| {
        if plane {
            return (k, String::new(), String::new());
        }
        let letter = LETTERS[k];
        (k, format!("_{letter}"), format!(", ground {letter}"))
    })
}

impl Recorder {
    /// A recorder; `dynamic` says whether accelerations and reactions belong to the results.
    pub fn new(dynamic: bool) -> Self {
        Self {
            channels: Vec::new(),
            at: 0,
            scratch: Vec::new(),
            dynamic,
            recording: Recording::default(),
            singular: Vec::new(),
        }
    }

    /// The same with other choices of what is written.
    #[must_use]
    pub fn writing(mut self, recording: Recording) -> Self {
        self.recording = recording;
        self
    }

    /// Keeps how near a frame comes to a singular pose of the set.
    fn watch(&mut self, name: &str, regularity: f64, t: f64) {
        if regularity >= SINGULAR {
            return;
        }
        match self.singular.iter_mut().find(|(known, ..)| known == name) {
            Some((_, time, least)) if regularity < *least => (*time, *least) = (t, regularity),
            Some(_) => {}
            None => self.singular.push((name.to_owned(), t, regularity)),
        }
    }

    /// Where the coordinates of the set are singular.
    fn singular_notes(&self) -> Vec<String> {
        let note = |(name, t, _): &(String, f64, f64)| {
            format!(
                "warning: near t = {t:.6} s the orientation of {name} is singular in {}: its coordinates are not unique or \
                 infinite there; another output.orientation has other singular poses, Euler parameters have none",
                self.recording.orientation
            )
        };
        self.singular.iter().map(note).collect()
    }

    /// The results so far.
    pub fn into_results(self, model: &str, analysis: &str) -> Results {
        let notes = self.singular_notes();
        Results {
            model: model.to_owned(),
            analysis: analysis.to_owned(),
            channels: self.channels,
            notes,
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
                gaps: false,
            });
        }
        // Adding zero turns a negative zero into a plain one.
        self.channels[self.at].values.push(value + 0.0);
        self.at += 1;
    }

    /// A coordinate of an orientation: a gap where it is infinite.
    fn put_attitude(&mut self, owner: &str, suffix: &str, unit: &str, meaning: &str, value: f64) {
        let gap = !value.is_finite();
        let value = if gap { f64::NAN } else { value };
        self.put(owner, suffix, unit, meaning, value);
        self.channels[self.at - 1].gaps |= gap;
    }

    /// The last values of the next channels, where there are any.
    fn last(&self, count: usize) -> Option<Vec<f64>> {
        let next = self.channels.get(self.at..self.at + count)?;
        next.iter().map(|c| c.values.last().copied()).collect()
    }

    /// Records one instant. The workspace must hold markers, constraints and (where dynamic)
    /// accelerations and multipliers of the state.
    pub fn record<S: Space>(
        &mut self,
        system: &System<S>,
        ws: &Workspace<S>,
        state: &State,
        extra: Extra,
    ) {
        self.at = 0;
        self.put("", "time", "s", "time", state.t);
        for body in &system.bodies {
            let marker = &ws.markers[body.frame_marker];
            self.watch(
                &body.name,
                S::regularity(marker, self.recording.orientation),
                state.t,
            );
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
}
