//! Options and result of a search along the way of the drivers.

use super::singular_pose::SingularPose;
use serde::Serialize;
use std::fmt;

/// How the way of the drivers is searched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SweepOptions {
    /// End of the search [s].
    pub end: f64,
    /// Number of steps to the end: several for each turn of a driver, so that two singular poses do
    /// not fall into one.
    pub steps: usize,
    /// Machines with more coordinates than this get all drivers named, without the bodies that they lose.
    pub dense_limit: usize,
}

impl SweepOptions {
    /// Four hundred steps to the end.
    pub fn until(end: f64) -> Self {
        Self {
            end,
            steps: 400,
            dense_limit: 800,
        }
    }
}

/// What the search found.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct DriverSweep {
    /// Singular poses in the order of time.
    pub poses: Vec<SingularPose>,
    /// Time until which the drivers were followed [s].
    pub reached: f64,
    /// Why the search stopped before the end, in words.
    pub stopped: Option<String>,
}

impl fmt::Display for DriverSweep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for pose in &self.poses {
            writeln!(f, "{pose}")?;
        }
        match &self.stopped {
            Some(why) => writeln!(f, "Stopped at t = {:.6} s: {why}", self.reached),
            None if self.poses.is_empty() => {
                writeln!(f, "No singular pose until t = {:.6} s", self.reached)
            }
            None => Ok(()),
        }
    }
}
