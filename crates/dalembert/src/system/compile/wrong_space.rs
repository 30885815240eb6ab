//! Keys and kinds that belong to the other space.
use crate::diagnostic::Diagnostic;
use crate::model::Model;
pub(super) fn check(_model: &Model) -> Vec<Diagnostic> {
    Vec::new()
}
