//! Which reactions of a run were not unique, and where.

use crate::words::listed;
use std::collections::BTreeMap;

/// Counts the poses of a run at which the reactions of elements were not unique.
#[derive(Clone, Debug, Default)]
pub(super) struct OpenReactions {
    poses: usize,
    /// For every element the place of its first pose, in words, and the number of its poses.
    elements: BTreeMap<String, (String, usize)>,
    /// Names in the order in which they came.
    order: Vec<String>,
}

impl OpenReactions {
    /// Takes up the elements of one pose; `place` says in words which pose it is.
    pub fn pose(&mut self, elements: &[&str], place: impl Fn() -> String) {
        self.poses += 1;
        for name in elements {
            if let Some((_, count)) = self.elements.get_mut(*name) {
                *count += 1;
            } else {
                self.elements.insert((*name).to_owned(), (place(), 1));
                self.order.push((*name).to_owned());
            }
        }
    }

    /// What a user must know: one note for what was open in every pose, one for every first pose of
    /// what was open in some.
    pub fn notes(&self) -> Vec<String> {
        let mut always = Vec::new();
        let mut sometimes: Vec<(&str, Vec<&str>)> = Vec::new();
        for name in &self.order {
            let Some((first, count)) = self.elements.get(name) else {
                continue;
            };
            if *count == self.poses {
                always.push(name.as_str());
            } else if let Some((_, names)) = sometimes.iter_mut().find(|(f, _)| f == first) {
                names.push(name);
            } else {
                sometimes.push((first, vec![name]));
            }
        }
        let mut notes = Vec::new();
        if !always.is_empty() {
            notes.push(format!(
                "warning: redundant constraints: {}",
                sentence(&always)
            ));
        }
        for (first, names) in sometimes {
            notes.push(format!(
                "warning: {first} the constraints depend on each other (a singular pose): {}",
                sentence(&names)
            ));
        }
        notes
    }
}

/// "the reactions of A and B are not unique; ..."
pub(super) fn sentence(names: &[&str]) -> String {
    format!(
        "the reactions of {} are not unique; the least set is given (least sum of squares, forces times the size of the machine)",
        listed(names)
    )
}

/// "at t = 1 s"
pub(super) fn at_time(t: f64) -> String {
    format!("at t = {t:.6} s")
}
