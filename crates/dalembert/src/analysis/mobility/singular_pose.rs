//! Poses at which drivers lose their hold.

use serde::Serialize;
use std::fmt;

/// What happens at a singular pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SingularKind {
    /// The drivers do not determine the motion; the machine without them is regular.
    DeadCentre,
    /// The machine itself is singular: it can go on in more than one way (change point).
    Bifurcation,
}

/// A pose on the way of the drivers at which the driven machine is singular.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SingularPose {
    /// Time [s].
    pub time: f64,
    /// What happens.
    pub kind: SingularKind,
    /// Names of the drivers that lose their hold.
    pub drivers: Vec<String>,
    /// Names of the bodies that the drivers no longer hold.
    pub bodies: Vec<String>,
    /// Does the way of the drivers end here: is there no pose behind it?
    pub end: bool,
    /// Sine of the smallest angle between the gradient of a row and the others, at the pose found.
    pub smallest: f64,
}

impl fmt::Display for SingularPose {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list = crate::words::listed;
        write!(f, "t = {:.6} s: ", self.time)?;
        match self.kind {
            SingularKind::DeadCentre => write!(
                f,
                "dead centre: {} cannot drive {} through this pose",
                list(&self.drivers),
                if self.bodies.is_empty() {
                    "the machine".to_owned()
                } else {
                    list(&self.bodies)
                }
            )?,
            SingularKind::Bifurcation => write!(
                f,
                "change point: the machine can go on in more than one way{}",
                if self.bodies.is_empty() {
                    String::new()
                } else {
                    format!("; {} choose", list(&self.bodies))
                }
            )?,
        }
        if self.end {
            f.write_str("; the given motion goes beyond what the machine can reach")?;
        }
        Ok(())
    }
}
