//! From a place in the model to bytes of its file.

use dalembert::diagnostic::Diagnostic;
use std::collections::HashMap;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Where the things of a model stand in its file, by element path (`joint[2].bodies[1]`).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SourceMap {
    places: HashMap<String, Place>,
}

/// Where one key and its value stand.
#[derive(Clone, Debug, PartialEq)]
struct Place {
    key: Option<Range<usize>>,
    value: Range<usize>,
    /// Start of the text inside the quotes, where bytes of the text are bytes of the file.
    inner: Option<Range<usize>>,
    /// Shall diagnostics point at the key?
    show_key: bool,
}

/// Sections that are lists of tables.
pub(super) const LISTS: [&str; 8] = [
    "table",
    "body",
    "joint",
    "constraint",
    "driver",
    "force",
    "initial",
    "trace",
];

/// No model has tables in tables deeper than this; deeper ones belong to mistakes.
const DEEPEST: usize = 12;

impl SourceMap {
    /// Reads the places of everything in a parsed file.
    pub(super) fn new(text: &str, root: &DeTable<'_>) -> Self {
        let mut map = Self::default();
        map.add_table(text, root, "", DEEPEST);
        map
    }

    fn add_table(&mut self, text: &str, table: &DeTable<'_>, path: &str, depth: usize) {
        let root = path.is_empty();
        for (key, value) in table.iter() {
            let mut path = child(path, key.get_ref());
            // `shape` may be one table instead of a list; the model has a list. One table where
            // the file should have a list of them is read as the first of the list.
            let list = key.get_ref() == "shape" || root && LISTS.contains(&key.get_ref().as_ref());
            if list && value.get_ref().is_table() {
                self.add(text, Some(key.span()), value, path.clone(), 0);
                path.push_str("[0]");
            }
            self.add(text, Some(key.span()), value, path, depth);
        }
    }

    fn add(
        &mut self,
        text: &str,
        key: Option<Range<usize>>,
        value: &Spanned<DeValue<'_>>,
        path: String,
        depth: usize,
    ) {
        match value.get_ref() {
            DeValue::Table(table) if depth > 0 => self.add_table(text, table, &path, depth - 1),
            DeValue::Array(items) if depth > 0 => {
                for (k, item) in items.iter().enumerate() {
                    self.add(text, None, item, format!("{path}[{k}]"), depth - 1);
                }
            }
            _ => {}
        }
        let inner = match value.get_ref() {
            DeValue::String(content) => inside_quotes(text, value.span(), content),
            _ => None,
        };
        let place = Place {
            key,
            value: value.span(),
            inner,
            show_key: false,
        };
        self.places.insert(path, place);
    }

    /// Bytes of the value at a path, or of the nearest enclosing one that the file has; `None`
    /// where the file has nothing of the path.
    pub fn locate(&self, path: &str) -> Option<Range<usize>> {
        self.nearest(path).map(|p| p.value.clone())
    }

    /// Has the file a value at exactly this path?
    pub(super) fn has(&self, path: &str) -> bool {
        self.places.contains_key(path)
    }

    /// Bytes of the key at a path, where the path ends in a key.
    pub fn locate_key(&self, path: &str) -> Option<Range<usize>> {
        self.places.get(path).and_then(|p| p.key.clone())
    }

    /// Bytes of the file that a diagnostic speaks of; the start of the file where it has no place.
    ///
    /// A diagnostic of the root (the empty path) carries bytes of the file itself.
    pub fn locate_diagnostic(&self, diagnostic: &Diagnostic) -> Range<usize> {
        let Some(place) = self.nearest(&diagnostic.path) else {
            return match &diagnostic.span {
                Some(span) if diagnostic.path.is_empty() => span.clone(),
                _ => 0..0,
            };
        };
        if place.show_key
            && let Some(key) = &place.key
        {
            return key.clone();
        }
        let exact = self.places.contains_key(&diagnostic.path);
        if let (true, Some(span), Some(inner)) = (exact, &diagnostic.span, &place.inner)
            && span.start <= span.end
            && span.end <= inner.len()
        {
            return inner.start + span.start..inner.start + span.end;
        }
        place.value.clone()
    }

    /// Lets diagnostics at a path point at the key, not at the value.
    pub(super) fn point_at_key(&mut self, path: &str) {
        if let Some(place) = self.places.get_mut(path) {
            place.show_key = true;
        }
    }

    /// Lets a path that the file does not have stand for one that it has.
    pub(super) fn alias(&mut self, path: &str, real: &str) {
        if let Some(place) = self.places.get(real).cloned() {
            self.places.entry(path.to_owned()).or_insert(place);
        }
    }

    fn nearest(&self, path: &str) -> Option<&Place> {
        let mut path = path;
        loop {
            if let Some(place) = self.places.get(path) {
                return Some(place);
            }
            path = &path[..path.rfind(['.', '['])?];
        }
    }
}

/// Path of a key in a table.
pub(super) fn child(path: &str, key: &str) -> String {
    if path.is_empty() {
        key.to_owned()
    } else {
        format!("{path}.{key}")
    }
}

/// Bytes of the content of a text value, if the file spells the content without escapes.
fn inside_quotes(text: &str, value: Range<usize>, content: &str) -> Option<Range<usize>> {
    let raw = text.get(value.clone())?;
    let quotes = if raw.starts_with("\"\"\"") || raw.starts_with("'''") {
        3
    } else {
        1
    };
    let inner = raw.get(quotes..raw.len().checked_sub(quotes)?)?;
    // TOML drops a newline that follows the opening quotes directly.
    let dropped = match inner {
        i if quotes == 3 && i.starts_with("\r\n") => 2,
        i if quotes == 3 && i.starts_with('\n') => 1,
        _ => 0,
    };
    let start = value.start + quotes + dropped;
    (inner.get(dropped..)? == content).then(|| start..start + content.len())
}
