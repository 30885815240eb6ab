//! Diagnostics for people and for programs.

use super::line_column::Lines;
use super::source_map::SourceMap;
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet, normalize_untrusted_str};
use dalembert::diagnostic::{Diagnostic, Severity};
use serde_json::{Value, json};
use std::ops::Range;

/// Writes diagnostics as a compiler does: the sentence, the place, the line with marks under it,
/// and what to do.
pub fn render(
    diagnostics: &[Diagnostic],
    source: &SourceMap,
    file_name: &str,
    text: &str,
    color: bool,
) -> String {
    let renderer = if color {
        Renderer::styled()
    } else {
        Renderer::plain()
    };
    let lines = Lines::new(text);
    let mut result = String::new();
    for diagnostic in diagnostics {
        let level = match diagnostic.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
        };
        // A mistake of several lines is shown at the first of them.
        let span = place(diagnostic, source, &lines);
        let (number, _) = lines.line_column(span.start);
        let (start, line) = lines.line(number);
        let first = (span.start - start).min(line.len());
        let last = (span.end - start).min(line.len());
        let snippet = Snippet::source(line)
            .line_start(number)
            .path(file_name)
            .annotation(AnnotationKind::Primary.span(first..last));
        let mut group = level
            .primary_title(diagnostic.message.as_str())
            .id(diagnostic.code.as_str())
            .element(snippet);
        if let Some(help) = &diagnostic.help {
            group = group.element(Level::HELP.message(normalize_untrusted_str(help)));
        }
        result.push_str(&renderer.render(&[group]));
        result.push_str("\n\n");
    }
    result
}

/// Diagnostics as a JSON list; each with file, first and last line and column, counted from 1.
pub fn to_json(
    diagnostics: &[Diagnostic],
    source: &SourceMap,
    file_name: &str,
    text: &str,
) -> Value {
    let lines = Lines::new(text);
    let one = |diagnostic: &Diagnostic| {
        let span = place(diagnostic, source, &lines);
        let (line, column) = lines.line_column(span.start);
        let (end_line, end_column) = lines.line_column(span.end);
        json!({
            "severity": diagnostic.severity,
            "code": diagnostic.code,
            "message": diagnostic.message,
            "help": diagnostic.help,
            "path": diagnostic.path,
            "file": file_name,
            "line": line,
            "column": column,
            "end_line": end_line,
            "end_column": end_column,
        })
    };
    diagnostics.iter().map(one).collect()
}

/// Bytes of the text, never outside of it and never inside a character.
fn place(diagnostic: &Diagnostic, source: &SourceMap, lines: &Lines<'_>) -> Range<usize> {
    let span = source.locate_diagnostic(diagnostic);
    let start = lines.boundary(span.start);
    start..lines.boundary(span.end).max(start)
}
