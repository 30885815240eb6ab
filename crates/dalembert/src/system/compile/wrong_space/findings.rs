//! What has been found in the wrong space.

use super::super::place::Place;
use super::kinds::Kind;
use crate::diagnostic::Diagnostic;
use crate::model::SpaceKind;

/// Findings in a model of a space.
pub(super) struct Findings {
    pub space: SpaceKind,
    pub list: Vec<Diagnostic>,
}

impl Findings {
    /// A key that only one space has; `remedy` says what the other has instead.
    pub fn key(&mut self, given: bool, of: SpaceKind, place: &Place, key: &str, remedy: &str) {
        if given && of != self.space {
            let name = key.rsplit('.').next().unwrap_or(key);
            self.report(of, place, key, &format!("`{name}`"), remedy);
        }
    }

    /// A form of a value that only one space has.
    pub fn form(&mut self, of: SpaceKind, place: &Place, key: &str, form: &str, remedy: &str) {
        if of != self.space {
            self.report(of, place, key, form, remedy);
        }
    }

    /// A kind of element; false if the element does not belong to the space.
    pub fn kind(&mut self, kind: Option<Kind>, place: &Place) -> bool {
        match kind {
            Some(kind) if kind.space != self.space => {
                let what = format!("the kind `{}`", kind.word);
                self.report(kind.space, place, "kind", &what, kind.remedy);
                false
            }
            _ => true,
        }
    }

    fn report(&mut self, of: SpaceKind, place: &Place, key: &str, what: &str, remedy: &str) {
        let (models, way_out) = match of {
            SpaceKind::Planar => ("planar", ""),
            SpaceKind::Spatial => (
                "spatial",
                "; if the machine is spatial: space = \"spatial\" in [model]",
            ),
        };
        let message = format!("{}: {what} belongs to {models} models", place.owner);
        self.list.push(
            Diagnostic::error("wrong-space", place.key(key), message)
                .help(format!("{remedy}{way_out}")),
        );
    }
}
