//! One value of the file with its place, and how it is read as a number, text, list or table.

use super::context::Context;
use super::listed::listed;
use super::names::{Reference, Section};
use super::table_reader::TableReader;
use dalembert::diagnostic::Diagnostic;
use dalembert::model::{Point, SpaceKind, Value};
use dalembert_expr::nearest;
use std::rc::Rc;
use toml::de::DeValue;

/// A value of the file and where it stands. Reading returns `None` after reporting a mistake.
pub(super) struct Item<'a> {
    pub context: &'a Context<'a>,
    pub value: &'a DeValue<'a>,
    pub place: Place,
}

/// Where a value stands, and how a person calls it.
#[derive(Clone)]
pub(super) struct Place {
    /// Path in the model.
    pub path: String,
    /// The element, as messages name it: `body "crank"`.
    pub label: Rc<str>,
    /// Bytes of `path` that name the element and its dot.
    pub element: usize,
}

impl Place {
    /// A message about this place, naming the element and the key.
    pub fn message(&self, text: &str) -> String {
        match self.path.get(self.element..) {
            Some(key) if !key.is_empty() => format!("{}: `{key}`: {text}", self.label),
            _ => format!("{}: {text}", self.label),
        }
    }
}

impl<'a> Item<'a> {
    /// Reports a mistake of this value.
    pub fn error(&self, code: &str, text: &str, help: impl Into<String>) {
        let message = self.place.message(text);
        self.context
            .report(Diagnostic::error(code, self.place.path.clone(), message).help(help));
    }

    /// Reports that the value has the wrong type.
    pub fn wrong_type(&self, expected: &str) {
        let text = format!("expected {expected}, found {}", type_name(self.value));
        let help = match self.value {
            DeValue::String(word) if matches!(word.trim(), "true" | "false") => {
                "leave out the quotes".to_owned()
            }
            DeValue::Datetime(_) => "texts stand in quotes".to_owned(),
            _ => format!("write {expected}"),
        };
        self.error("wrong-type", &text, help);
    }

    /// A number in SI units, or a text with a unit or an expression.
    pub fn value(&self) -> Option<Value> {
        match self.value {
            DeValue::String(text) if text.trim().is_empty() => {
                self.error(
                    "empty-text",
                    "expected a number or a text like \"30 deg\", found an empty text",
                    "give the value, or remove the key",
                );
                None
            }
            DeValue::String(text) => Some(Value::Text(text.to_string())),
            DeValue::Integer(_) | DeValue::Float(_) => self.number().map(Value::Number),
            _ => {
                self.wrong_type("a number or a text like \"30 deg\"");
                None
            }
        }
    }

    fn number(&self) -> Option<f64> {
        let number = match self.value {
            // Radix is 2, 8, 10 or 16 here; a number with too many digits is refused below.
            DeValue::Integer(digits) => i64::from_str_radix(digits.as_str(), digits.radix())
                .map_or(f64::INFINITY, |n| n as f64),
            DeValue::Float(digits) => digits.as_str().parse().unwrap_or(f64::NAN),
            _ => f64::NAN,
        };
        if number.is_finite() {
            return Some(number);
        }
        self.error(
            "not-finite",
            "the number must be finite and not too large",
            "give a number of a usual size; a limit that does not exist is left out",
        );
        None
    }

    /// A text that is not empty.
    pub fn text(&self) -> Option<String> {
        match self.value {
            DeValue::String(text) if text.trim().is_empty() => {
                self.error(
                    "empty-text",
                    "the text must not be empty",
                    "give the text, or remove the key",
                );
                None
            }
            DeValue::String(text) => Some(text.to_string()),
            _ => {
                self.wrong_type("a text");
                None
            }
        }
    }

    /// True or false.
    pub fn boolean(&self) -> Option<bool> {
        let result = match self.value {
            DeValue::Boolean(b) => Some(*b),
            _ => None,
        };
        if result.is_none() {
            self.wrong_type("`true` or `false`");
        }
        result
    }

    /// A whole number, 1 or more.
    pub fn count(&self) -> Option<u32> {
        let DeValue::Integer(digits) = self.value else {
            self.wrong_type("a whole number");
            return None;
        };
        match u32::from_str_radix(digits.as_str(), digits.radix()) {
            Ok(count) if count > 0 => Some(count),
            _ => {
                let text = format!("expected a whole number from 1 to {}", u32::MAX);
                self.error("out-of-range", &text, "give a number from this range");
                None
            }
        }
    }

    /// One of a few words.
    pub fn choice<T: Copy>(&self, choices: &[(&'static str, T)]) -> Option<T> {
        self.choice_of(choices, &[])
    }

    /// One of a few words; those of the other space are read too, but not offered.
    pub fn choice_of<T: Copy>(
        &self,
        choices: &[(&'static str, T)],
        foreign: &[(&'static str, T)],
    ) -> Option<T> {
        let words = || choices.iter().map(|(word, _)| *word);
        let DeValue::String(text) = self.value else {
            self.wrong_type(&format!("one of {}", listed(words())));
            return None;
        };
        let mut all = choices.iter().chain(foreign);
        let found = all.find(|(word, _)| *word == text.as_ref());
        if found.is_none() {
            self.error(
                "unknown-word",
                &format!("`{text}` is not known here"),
                did_you_mean(text, words()),
            );
        }
        found.map(|(_, choice)| *choice)
    }

    /// A list; entries that cannot be read are reported and left out.
    pub fn list<T>(&self, read: impl Fn(&Item<'a>) -> Option<T>) -> Option<Vec<T>> {
        Some(self.entries("a list")?.iter().filter_map(read).collect())
    }

    /// A list of numbers and texts, with placeholders for what cannot be read.
    pub fn values(&self) -> Option<Vec<Value>> {
        self.list(|item| Some(item.value().unwrap_or_default()))
    }

    /// Two things, with placeholders for what cannot be read.
    pub fn pair<T: Default>(&self, read: impl Fn(&Item<'a>) -> Option<T>) -> Option<[T; 2]> {
        let entries = self.entries("a list of 2")?;
        let found = entries.len();
        let pair: Vec<T> = entries
            .iter()
            .map(|item| read(item).unwrap_or_default())
            .collect();
        if found != 2 {
            self.wrong_length("2", found, "write [first, second]");
        }
        pair.try_into().ok()
    }

    /// A point or vector with as many components as the space has; placeholders stand for
    /// components that cannot be read.
    pub fn point(&self) -> Option<Point> {
        let help = match self.context.space() {
            SpaceKind::Planar => "write [x, y]: the model is planar",
            SpaceKind::Spatial => "write [x, y, z]",
        };
        self.components(self.context.dimension.get(), help)
    }

    /// A direction in the plane, whatever the space of the model.
    pub fn planar_direction(&self) -> Option<Point> {
        match self.context.space() {
            SpaceKind::Planar => self.point(),
            SpaceKind::Spatial => self.components(2, "write [x, y]"),
        }
    }

    /// A direction in space, whatever the space of the model.
    pub fn axis(&self) -> Option<Point> {
        self.components(3, "write [x, y, z]")
    }

    fn components(&self, expected: usize, help: &str) -> Option<Point> {
        let entries = self.entries(&format!("a list of {expected} numbers"))?;
        if entries.len() != expected {
            self.wrong_length(&expected.to_string(), entries.len(), help);
        }
        self.values()
    }

    /// As many numbers as are asked for; `help` says how they are written.
    pub fn numbers<const N: usize>(&self, help: &str) -> Option<[Value; N]> {
        self.components(N, help)?.try_into().ok()
    }

    /// Three rows of three numbers.
    pub fn rows(&self, help: &str) -> Option<[[Value; 3]; 3]> {
        let entries = self.entries("a list of 3 rows")?;
        let rows: Vec<[Value; 3]> = entries
            .iter()
            .map(|row| row.numbers(help).unwrap_or_default())
            .collect();
        if entries.len() != 3 {
            self.wrong_length("3", entries.len(), help);
        }
        rows.try_into().ok()
    }

    /// One point in the frame of each of two bodies; a single point is one mistake.
    pub fn two_points(&self) -> Option<[Point; 2]> {
        let (text, one) = match self.context.space() {
            SpaceKind::Planar => ("[[x, y], [x, y]]", "the point [x, y]"),
            SpaceKind::Spatial => ("[[x, y, z], [x, y, z]]", "the point [x, y, z]"),
        };
        self.two_lists("two points", text, one, Item::point)
    }

    /// One axis in the frame of each of two bodies; a single axis is one mistake.
    pub fn two_axes(&self) -> Option<[Point; 2]> {
        let text = "[[x, y, z], [x, y, z]]";
        self.two_lists("two axes", text, "the axis [x, y, z]", Item::axis)
    }

    fn two_lists(
        &self,
        what: &str,
        text: &str,
        one: &str,
        read: impl Fn(&Item<'a>) -> Option<Point>,
    ) -> Option<[Point; 2]> {
        let plain = |entry: &toml::Spanned<DeValue<'_>>| {
            matches!(
                entry.get_ref(),
                DeValue::String(_) | DeValue::Integer(_) | DeValue::Float(_)
            )
        };
        match self.value {
            DeValue::Array(array) if !array.is_empty() && array.iter().all(plain) => {
                self.error(
                    "wrong-type",
                    &format!("expected {what}, {text}, found one"),
                    format!("write {text}: {one} in the frame of each body"),
                );
                None
            }
            _ => self.pair(read),
        }
    }

    /// The entries of a list.
    pub fn entries(&self, expected: &str) -> Option<Vec<Item<'a>>> {
        let DeValue::Array(array) = self.value else {
            self.wrong_type(expected);
            return None;
        };
        let entry = |(k, value): (usize, &'a toml::Spanned<DeValue<'a>>)| Item {
            context: self.context,
            value: value.get_ref(),
            place: Place {
                path: format!("{}[{k}]", self.place.path),
                ..self.place.clone()
            },
        };
        Some(array.iter().enumerate().map(entry).collect())
    }

    /// Reports a list of the wrong length.
    pub fn wrong_length(&self, expected: &str, found: usize, help: &str) {
        let entries = if expected.ends_with(" 1") {
            "entry"
        } else {
            "entries"
        };
        let text = format!("expected {expected} {entries}, found {found}");
        self.error("wrong-length", &text, help);
    }

    /// Name of a body; whether it exists is checked when all are known.
    pub fn body(&self) -> Option<String> {
        self.reference(Section::Body)
    }

    /// Name of a joint; whether it exists is checked when all are known.
    pub fn joint(&self) -> Option<String> {
        self.reference(Section::Joint)
    }

    fn reference(&self, section: Section) -> Option<String> {
        let name = self.text()?;
        self.context.references.borrow_mut().push(Reference {
            section,
            name: name.clone(),
            place: self.place.clone(),
        });
        Some(name)
    }

    /// A table.
    pub fn table(&self) -> Option<TableReader<'a>> {
        let DeValue::Table(table) = self.value else {
            self.wrong_type("a table");
            return None;
        };
        Some(TableReader::new(self.context, table, self.place.clone()))
    }
}

/// Help for a word that is not known.
pub(super) fn did_you_mean<'b>(word: &str, allowed: impl Iterator<Item = &'b str>) -> String {
    let allowed: Vec<&str> = allowed.collect();
    let list = listed(allowed.iter().copied());
    match nearest(word, allowed).first() {
        Some(near) => format!("did you mean `{near}`? allowed here: {list}"),
        None => format!("allowed here: {list}"),
    }
}

/// The type of a value, for people.
pub(super) fn type_name(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "`true` or `false`",
        DeValue::Datetime(_) => "a date or time",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}
