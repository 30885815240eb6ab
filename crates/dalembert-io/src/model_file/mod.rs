//! Model files: reading with every mistake reported, and writing.

mod context;
mod csv_table;
mod item;
mod kind_words;
mod known_mistakes;
mod line_column;
mod listed;
mod lower;
mod names;
mod parsed;
mod report;
mod schema;
mod source_map;
mod table_reader;
mod templates;
mod write;

pub use line_column::line_column;
pub use parsed::Parsed;
pub use report::{render, to_json};
pub use schema::schema;
pub use source_map::SourceMap;
pub use templates::{Template, templates};
pub use write::write_model;

use context::Context;
use dalembert::diagnostic::Diagnostic;
use line_column::Lines;
use std::path::Path;
use toml::de::DeTable;

/// Reads the text of a model file. `folder` is where the files lie that the model names.
///
/// Finds all mistakes at once, except that a file which is not TOML is not read further.
/// Expressions and units are not looked into: the engine does that.
pub fn parse_model(text: &str, folder: Option<&Path>) -> Parsed {
    let (root, errors) = DeTable::parse_recoverable(text);
    if !errors.is_empty() {
        return Parsed {
            model: None,
            draft: None,
            source: SourceMap::default(),
            diagnostics: syntax_errors(text, &errors),
        };
    }
    let mut source = SourceMap::new(text, root.get_ref());
    let context = Context::new(folder);
    let draft = lower::model(&context, root.get_ref());
    names::check(&context);
    for path in context.key_paths.take() {
        source.point_at_key(&path);
    }
    for (path, real) in context.aliases.take() {
        source.alias(&path, &real);
    }
    let mut diagnostics = context.diagnostics.take();
    diagnostics.sort_by_key(|d| source.locate_diagnostic(d).start);
    let usable = !diagnostics.iter().any(Diagnostic::is_error);
    Parsed {
        model: usable.then(|| draft.clone()),
        draft: (!context.lost.get()).then_some(draft),
        source,
        diagnostics,
    }
}

/// One error a line. A list that is not closed makes an error of every line behind it: of such a
/// run of lines only the first is kept.
fn syntax_errors(text: &str, errors: &[toml::de::Error]) -> Vec<Diagnostic> {
    let lines = Lines::new(text);
    let silent = |line: usize| {
        let text = lines.line(line).1.trim_start();
        text.is_empty() || text.starts_with('#')
    };
    let mut diagnostics: Vec<Diagnostic> = Vec::new();
    let (mut last_line, mut in_list) = (0, false);
    for error in errors {
        let span = error.span().unwrap_or(0..0);
        let (line, _) = lines.line_column(span.start);
        let run = in_list && (last_line + 1..line).all(silent);
        let same_line = line == last_line;
        last_line = line;
        if run || same_line {
            continue;
        }
        in_list = error.message().contains("array");
        if let Some(single) = single_bracket(&lines, line) {
            // All lists behind it meet the same one.
            if !diagnostics.iter().any(|d| d.span == single.span) {
                diagnostics.push(single);
            }
            continue;
        }
        let message = format!("not valid TOML: {}", error.message());
        let help = syntax_help(error.message());
        diagnostics.push(
            Diagnostic::error("toml-syntax", "", message)
                .span(span)
                .help(help),
        );
    }
    diagnostics
}

/// The section `[name]` above a line `[[name]]`, which contradict each other.
fn single_bracket(lines: &Lines<'_>, line: usize) -> Option<Diagnostic> {
    let without_comment = |line: usize| {
        let text = lines.line(line).1;
        text.split('#').next().unwrap_or_default().trim()
    };
    let name = without_comment(line)
        .strip_prefix("[[")?
        .strip_suffix("]]")?
        .trim();
    let is_single = |line: &usize| {
        let inside = without_comment(*line).strip_prefix('[');
        let inside = inside.and_then(|text| text.strip_suffix(']'));
        inside.is_some_and(|inside| inside.trim() == name)
    };
    let (start, text) = lines.line((1..line).find(is_single)?);
    let message = format!("not valid TOML: one [{name}] and a list of [[{name}]]");
    let help = format!("write [[{name}]] with two brackets here too");
    Some(
        Diagnostic::error("toml-syntax", "", message)
            .span(start..start + text.trim_end().len())
            .help(help),
    )
}

/// What to do after a message of the reader of TOML.
fn syntax_help(message: &str) -> &'static str {
    let says = |word: &str| message.contains(word);
    if says("duplicate key") {
        "a key stands only once in a section: remove one of the lines, or begin a new section above"
    } else if says("quoted") || says("string") {
        "texts, units and expressions stand in quotes, for example \"30 deg\""
    } else if says("array") {
        "a list stands in brackets with commas, for example [0, \"30 mm\"]"
    } else {
        "a line is `key = value` or `[section]`; texts stand in quotes, numbers have a decimal point"
    }
}
