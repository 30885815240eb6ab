//! What the readers of one file share.

use super::names::{NameOf, Reference};
use dalembert::diagnostic::Diagnostic;
use dalembert::model::SpaceKind;
use std::cell::{Cell, RefCell};
use std::path::Path;

/// What the readers of one file collect. Every reader has it by shared reference, so that one
/// table can be read while another is open.
pub(super) struct Context<'a> {
    /// Folder of the model file, for files that it names.
    pub folder: Option<&'a Path>,
    /// Components of a point: 2 or 3.
    pub dimension: Cell<usize>,
    /// Is a whole section something else than a list of tables?
    pub lost: Cell<bool>,
    /// Sections that cannot be read or are misspelt: names in them are not known.
    pub absent: RefCell<Vec<&'static str>>,
    /// Findings so far.
    pub diagnostics: RefCell<Vec<Diagnostic>>,
    /// Names that elements have.
    pub names: RefCell<Vec<NameOf>>,
    /// Names that elements use.
    pub references: RefCell<Vec<Reference>>,
    /// Paths whose diagnostics point at the key.
    pub key_paths: RefCell<Vec<String>>,
    /// Paths that stand for others: (path, path in the file).
    pub aliases: RefCell<Vec<(String, String)>>,
}

impl<'a> Context<'a> {
    /// Nothing read yet.
    pub fn new(folder: Option<&'a Path>) -> Self {
        Self {
            folder,
            dimension: Cell::new(2),
            lost: Cell::new(false),
            absent: RefCell::default(),
            diagnostics: RefCell::default(),
            names: RefCell::default(),
            references: RefCell::default(),
            key_paths: RefCell::default(),
            aliases: RefCell::default(),
        }
    }

    /// The space of the model.
    pub fn space(&self) -> SpaceKind {
        if self.dimension.get() == 2 {
            SpaceKind::Planar
        } else {
            SpaceKind::Spatial
        }
    }

    /// Notes a finding.
    pub fn report(&self, diagnostic: Diagnostic) {
        self.diagnostics.borrow_mut().push(diagnostic);
    }

    /// Notes a finding that speaks of the key at its path.
    pub fn report_key(&self, diagnostic: Diagnostic) {
        self.key_paths.borrow_mut().push(diagnostic.path.clone());
        self.report(diagnostic);
    }
}
