//! What makes results unfit for a file.

use dalembert::results::Results;
use std::collections::HashSet;
use thiserror::Error;

/// Why results cannot be written, or why a file's content is no results.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Defect {
    /// There is no channel at all.
    #[error("there are no channels")]
    NoChannels,
    /// Two channels have one name.
    #[error("the channel name {name:?} appears twice")]
    DuplicateChannel {
        /// The name.
        name: String,
    },
    /// A channel's length differs from the first channel's.
    #[error("channel {name:?} has {found} values, but the first channel has {expected}")]
    UnequalLengths {
        /// Name of the channel.
        name: String,
        /// Its number of values.
        found: usize,
        /// Number of values of the first channel.
        expected: usize,
    },
    /// A value is not a finite number.
    #[error("channel {name:?} is not a finite number at instant {index} (counted from 0)")]
    ChannelNotFinite {
        /// Name of the channel.
        name: String,
        /// Instant, counted from 0.
        index: usize,
    },
    /// A statistic is not a finite number.
    #[error("the statistic {name:?} is not a finite number")]
    StatisticNotFinite {
        /// Name of the statistic.
        name: String,
    },
}

/// Finds the first defect of results.
pub(super) fn check(results: &Results) -> Result<(), Defect> {
    if results.channels.is_empty() {
        return Err(Defect::NoChannels);
    }
    let expected = results.len();
    let mut names = HashSet::new();
    for channel in &results.channels {
        let name = || channel.name.clone();
        if !names.insert(channel.name.as_str()) {
            return Err(Defect::DuplicateChannel { name: name() });
        }
        if channel.values.len() != expected {
            return Err(Defect::UnequalLengths {
                name: name(),
                found: channel.values.len(),
                expected,
            });
        }
        let bad = |v: &f64| !(v.is_finite() || channel.gaps && v.is_nan());
        if let Some(index) = channel.values.iter().position(bad) {
            return Err(Defect::ChannelNotFinite {
                name: name(),
                index,
            });
        }
    }
    match results.statistics.iter().find(|(_, v)| !v.is_finite()) {
        Some((name, _)) => Err(Defect::StatisticNotFinite { name: name.clone() }),
        None => Ok(()),
    }
}
