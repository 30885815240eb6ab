//! What reading a model file gives.

use super::source_map::SourceMap;
use dalembert::diagnostic::Diagnostic;
use dalembert::model::Model;
use std::collections::HashSet;

/// What reading a model file gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Parsed {
    /// The model, if the file has no errors.
    pub model: Option<Model>,
    /// The model with placeholders (0, empty texts) where the file has mistakes: not for use, but
    /// for finding more mistakes, such as those inside expressions; see [`Parsed::add`]. `None` if
    /// the file is not TOML or if the kind of an element is not known.
    pub draft: Option<Model>,
    /// Where everything stands in the file.
    pub source: SourceMap,
    /// All findings, in the order of the file.
    pub diagnostics: Vec<Diagnostic>,
}

impl Parsed {
    /// Adds what the engine says of the draft, so that all mistakes are reported at once.
    ///
    /// Left out is what only follows from mistakes that are known already: findings about an
    /// element that has a mistake, and all findings if parameters, tables or a whole section have.
    /// With an error there is no model any more.
    pub fn add(&mut self, findings: Vec<Diagnostic>) {
        let errors = self.diagnostics.iter().filter(|d| d.is_error());
        let spoilt: HashSet<String> = errors.map(|d| element(&d.path).to_owned()).collect();
        if spoilt.iter().any(|element| spoils_others(element)) {
            return;
        }
        let news = findings
            .into_iter()
            .filter(|d| !spoilt.contains(element(&d.path)));
        self.diagnostics.extend(news);
        let source = &self.source;
        self.diagnostics
            .sort_by_key(|d| source.locate_diagnostic(d).start);
        if self.diagnostics.iter().any(Diagnostic::is_error) {
            self.model = None;
        }
    }
}

/// The element or section of a path: `body[2]` of `body[2].shape[0].radius`.
fn element(path: &str) -> &str {
    path.split('.').next().unwrap_or_default()
}

/// Does a mistake there make other elements look wrong?
fn spoils_others(element: &str) -> bool {
    let local = element.ends_with(']') && !element.starts_with("table[");
    !(local || element == "analysis" || element == "output")
}
