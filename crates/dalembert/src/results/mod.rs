//! Results: named channels over time, with units. Readers and writers know channels, not bodies.

mod channel;

pub use channel::Channel;

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

/// Time histories of one analysis. The first channel is the time (or the sweep variable).
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Results {
    /// Name of the model.
    pub model: String,
    /// Name of the analysis: "kinematics", "simulate", ...
    pub analysis: String,
    /// Channels, all of the same length.
    pub channels: Vec<Channel>,
    /// Solver statistics by name.
    pub statistics: IndexMap<String, f64>,
    /// Messages for people: warnings, notes on reactions that are not unique, why a run ended early.
    pub notes: Vec<String>,
}

impl Results {
    /// The channel of a name.
    pub fn channel(&self, name: &str) -> Option<&Channel> {
        self.channels.iter().find(|c| c.name == name)
    }

    /// Number of instants.
    pub fn len(&self) -> usize {
        self.channels.first().map_or(0, |c| c.values.len())
    }

    /// Is there no instant?
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}
