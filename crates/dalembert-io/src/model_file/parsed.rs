//! What reading a model file gives.

use super::known_mistakes::KnownMistakes;
use super::source_map::SourceMap;
use dalembert::diagnostic::Diagnostic;
use dalembert::model::Model;

/// What reading a model file gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Parsed {
    /// The model, if the file has no errors.
    pub model: Option<Model>,
    /// The model with placeholders where the file has mistakes: not for use, but for finding more
    /// mistakes, such as those inside expressions; see [`Parsed::add`]. Every element has its place
    /// in it. `None` if the file is not TOML or if a list of elements is no list.
    pub draft: Option<Model>,
    /// Where everything stands in the file.
    pub source: SourceMap,
    /// All findings, in the order of the file.
    pub diagnostics: Vec<Diagnostic>,
}

impl Parsed {
    /// Adds what the engine says of the draft, so that all mistakes are reported at once.
    ///
    /// Left out is what only follows from mistakes that are known already. With an error there is
    /// no model any more.
    pub fn add(&mut self, findings: Vec<Diagnostic>) {
        let known = KnownMistakes::new(&self.diagnostics, &self.source);
        let news: Vec<Diagnostic> = findings
            .into_iter()
            .filter(|finding| !known.explain(finding))
            .collect();
        self.diagnostics.extend(news);
        let source = &self.source;
        self.diagnostics
            .sort_by_key(|d| source.locate_diagnostic(d).start);
        if self.diagnostics.iter().any(Diagnostic::is_error) {
            self.model = None;
        }
    }
}
