//! Diagnostics for people and for programs.

use super::line_column::line_column;
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
    let mut result = String::new();
    for diagnostic in diagnostics {
        let level = match diagnostic.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
        };
        let mut group = level
            .primary_title(diagnostic.message.as_str())
            .id(diagnostic.code.as_str())
            .element(Snippet::source(text).path(file_name).annotation(
                AnnotationKind::Primary.span(first_line(text, place(diagnostic, source, text))),
            ));
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
    let one = |diagnostic: &Diagnostic| {
        let span = place(diagnostic, source, text);
        let (line, column) = line_column(text, span.start);
        let (end_line, end_column) = line_column(text, span.end);
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
fn place(diagnostic: &Diagnostic, source: &SourceMap, text: &str) -> Range<usize> {
    let span = source.locate_diagnostic(diagnostic).unwrap_or(0..0);
    let start = boundary(text, span.start);
    start..boundary(text, span.end).max(start)
}

fn boundary(text: &str, byte: usize) -> usize {
    let mut byte = byte.min(text.len());
    while !text.is_char_boundary(byte) {
        byte -= 1;
    }
    byte
}

/// A mistake of a whole table is shown at its first line.
fn first_line(text: &str, span: Range<usize>) -> Range<usize> {
    let line = text[span.clone()].find(['\n', '\r']);
    span.start..line.map_or(span.end, |k| span.start + k)
}
