//! Writes the channels of a machine at one instant after another.

mod elements;
mod energy;
mod points;
mod reaction;
mod totals;

pub(super) use energy::{energies, outside_power};

use crate::results::{Channel, Results};
use crate::space::Space;
use crate::space::orientation::OrientationSet;
use crate::system::{State, System, Workspace};

/// Records every coordinate, reaction, force, energy and violation of a machine.
#[derive(Debug)]
pub struct Recorder {
    channels: Vec<Channel>,
    at: usize,
    scratch: Vec<f64>,
    /// Are accelerations and reactions recorded?
    dynamic: bool,
    /// Coordinates in which orientations in space are written.
    orientation: OrientationSet,
}

/// Quantities of an instant that the workspace does not hold.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extra {
    /// Work of drivers and of forces without potential since the start [J].
    pub work: f64,
    /// Energy at the start [J].
    pub start_energy: Option<f64>,
}

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
            orientation: OrientationSet::EulerParameters,
        }
    }

    /// The same with other coordinates for orientations in space.
    #[must_use]
    pub fn with_orientation(mut self, set: OrientationSet) -> Self {
        self.orientation = set;
        self
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
