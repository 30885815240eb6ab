//! Which findings of the engine only follow from mistakes that reading the file has found.

use super::source_map::{LISTS, SourceMap};
use dalembert::diagnostic::Diagnostic;

/// Findings of the engine about names; reading has checked all of them already.
const NAMES: [&str; 2] = ["unknown-body", "unknown-joint"];

/// Findings of the engine that depend on where the bodies are in the initial estimate.
const ESTIMATES: [&str; 2] = ["side-unknown", "zero-length"];

/// The mistakes that reading a file has found.
pub(super) struct KnownMistakes<'a> {
    /// Path and code of each.
    mistakes: Vec<(String, String)>,
    source: &'a SourceMap,
}

impl<'a> KnownMistakes<'a> {
    /// The errors among findings.
    pub fn new(findings: &[Diagnostic], source: &'a SourceMap) -> Self {
        let errors = findings.iter().filter(|d| d.is_error());
        Self {
            mistakes: errors.map(|d| (d.path.clone(), d.code.clone())).collect(),
            source,
        }
    }

    /// Does a finding of the engine only follow from these mistakes?
    pub fn explain(&self, finding: &Diagnostic) -> bool {
        let code = finding.code.as_str();
        if self.mistakes.is_empty() {
            return false;
        }
        if self.mistakes.iter().any(|(path, _)| hides_all(path)) || NAMES.contains(&code) {
            return true;
        }
        let in_bodies = |(path, _): &(String, String)| path.starts_with("body[");
        if ESTIMATES.contains(&code) && self.mistakes.iter().any(in_bodies) {
            return true;
        }
        let own = element(&finding.path);
        let mut of_element = self
            .mistakes
            .iter()
            .filter(|(path, _)| element(path) == own)
            .peekable();
        // A value that the file does not have is a placeholder.
        if of_element.peek().is_some() && !self.source.has(&finding.path) {
            return true;
        }
        of_element.any(|(path, code)| {
            // What is there beside a missing key can be judged.
            let spoils_what_is_inside = code != "missing-key" && code != "wrong-combination";
            // The section of the parameters is only a place for what is said of the command line.
            finding.path != "parameters" && contains(&finding.path, path)
                || spoils_what_is_inside && contains(path, &finding.path)
        })
    }
}

/// Is the inner path the outer one, or inside of it?
fn contains(outer: &str, inner: &str) -> bool {
    inner
        .strip_prefix(outer)
        .is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}

/// The element or section of a path: `body[2]` of `body[2].shape[0].radius`.
fn element(path: &str) -> &str {
    path.split('.').next().unwrap_or_default()
}

/// Does a mistake there make everything else look wrong: a section that cannot be read, or the
/// number of dimensions?
fn hides_all(path: &str) -> bool {
    let section = !path.is_empty() && !path.contains(['.', '[']);
    let harmless = path == "analysis" || path == "output" || LISTS.contains(&path);
    path == "model.space" || section && !harmless
}
