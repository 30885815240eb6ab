//! A table of the file that remembers which keys were asked for.

use super::context::Context;
use super::item::{Item, Place, did_you_mean};
use super::kind_words::other_words;
use super::listed::listed;
use super::names::{NameOf, Section, is_bad_name};
use super::source_map::child;
use dalembert::diagnostic::Diagnostic;
use dalembert::model::{Point, SpaceKind, Value};
use dalembert_expr::nearest;
use toml::de::{DeTable, DeValue};

/// Reads a table key by key. [`TableReader::finish`] reports the keys that nobody asked for, and
/// the needed ones that are missing.
pub(super) struct TableReader<'a> {
    context: &'a Context<'a>,
    table: &'a DeTable<'a>,
    place: Place,
    asked: Vec<&'static str>,
    /// Keys that the other space has: known, but not offered.
    foreign_keys: Vec<&'static str>,
    missing: Vec<&'static str>,
    /// Does the kind of the element belong to the other space? That is the mistake then; what such
    /// an element needs is not said.
    foreign: bool,
}

impl<'a> TableReader<'a> {
    /// Opens a table.
    pub fn new(context: &'a Context<'a>, table: &'a DeTable<'a>, place: Place) -> Self {
        Self {
            context,
            table,
            place,
            asked: Vec::new(),
            foreign_keys: Vec::new(),
            foreign: false,
            missing: Vec::new(),
        }
    }

    /// What all readers share.
    pub fn context(&self) -> &'a Context<'a> {
        self.context
    }

    /// Where the table stands.
    pub fn place(&self) -> &Place {
        &self.place
    }

    /// The value of a key, as it stands in the file.
    pub fn item(&mut self, key: &'static str) -> Option<Item<'a>> {
        if !self.asked.contains(&key) {
            self.asked.push(key);
        }
        self.value_of(key)
    }

    fn value_of(&self, key: &str) -> Option<Item<'a>> {
        let value = self.table.get(key)?;
        Some(Item {
            context: self.context,
            value: value.get_ref(),
            place: Place {
                path: child(&self.place.path, key),
                ..self.place.clone()
            },
        })
    }

    /// Does the table have the key?
    pub fn has(&self, key: &str) -> bool {
        self.table.contains_key(key)
    }

    /// A key that may be left out.
    pub fn optional<T>(
        &mut self,
        key: &'static str,
        read: impl FnOnce(&Item<'a>) -> Option<T>,
    ) -> Option<T> {
        read(&self.item(key)?)
    }

    /// A key that only one space has, and that may be left out. In the other space it is read all
    /// the same: the engine says that it does not belong there.
    pub fn of_space<T>(
        &mut self,
        space: SpaceKind,
        key: &'static str,
        read: impl FnOnce(&Item<'a>) -> Option<T>,
    ) -> Option<T> {
        if space == self.context.space() {
            return self.optional(key, read);
        }
        self.foreign_keys.push(key);
        read(&self.value_of(key)?)
    }

    /// A key that must be there; `None` after a mistake, which is reported.
    pub fn required<T>(
        &mut self,
        key: &'static str,
        read: impl FnOnce(&Item<'a>) -> Option<T>,
    ) -> Option<T> {
        let item = self.item(key);
        if item.is_none() {
            self.missing.push(key);
        }
        read(&item?)
    }

    /// A list that may be left out.
    pub fn list<T>(&mut self, key: &'static str, read: impl Fn(&Item<'a>) -> Option<T>) -> Vec<T> {
        self.optional(key, |item| item.list(read))
            .unwrap_or_default()
    }

    /// A number or text that may be left out.
    pub fn value(&mut self, key: &'static str) -> Option<Value> {
        self.optional(key, Item::value)
    }

    /// A number or text that must be there; after a mistake a placeholder.
    pub fn need_value(&mut self, key: &'static str) -> Value {
        self.required(key, Item::value).unwrap_or_default()
    }

    /// A point that may be left out.
    pub fn point(&mut self, key: &'static str) -> Option<Point> {
        self.optional(key, Item::point)
    }

    /// The points in the frames of two bodies, that must be there; after a mistake placeholders.
    pub fn need_points(&mut self, key: &'static str) -> [Point; 2] {
        self.required(key, Item::two_points).unwrap_or_default()
    }

    /// A body that must be there; after a mistake a placeholder.
    pub fn need_body(&mut self, key: &'static str) -> String {
        self.required(key, Item::body).unwrap_or_default()
    }

    /// Two bodies that must be there; after a mistake placeholders.
    pub fn need_bodies(&mut self) -> [String; 2] {
        self.required("bodies", |item| item.pair(Item::body))
            .unwrap_or_default()
    }

    /// A joint that must be there; after a mistake a placeholder.
    pub fn need_joint(&mut self) -> String {
        self.required("joint", Item::joint).unwrap_or_default()
    }

    /// A yes or no that may be left out and is then no.
    pub fn flag(&mut self, key: &'static str) -> bool {
        self.optional(key, Item::boolean).unwrap_or_default()
    }

    /// The element's own name; whether another has it too is checked when all are known.
    pub fn name(&mut self, section: Section) -> String {
        let Some(item) = self.item("name") else {
            self.missing.push("name");
            return String::new();
        };
        let DeValue::String(name) = item.value else {
            item.wrong_type("a text");
            return String::new();
        };
        if is_bad_name(name) {
            item.error(
                "bad-name",
                "a name must not be empty, start or end with a space, or contain a dot, a quote \
                 or a line break",
                "choose another name, such as `crank_2`",
            );
            return String::new();
        }
        self.context.names.borrow_mut().push(NameOf {
            section,
            name: name.to_string(),
            place: item.place,
        });
        name.to_string()
    }

    /// The `kind` of the element: one of `kinds`.
    ///
    /// After a mistake of spelling it is the nearest one. `None` says that nothing is known of the
    /// kind.
    pub fn kind<T: Copy>(&mut self, kinds: &[(&'static str, T)]) -> Option<T> {
        self.kind_of(kinds, &[])
    }

    /// The `kind` of an element of which the spaces have different kinds: those of this space, and
    /// those of the other, which the engine refuses.
    pub fn kind_of<T: Copy>(
        &mut self,
        kinds: &[(&'static str, T)],
        foreign: &[(&'static str, T)],
    ) -> Option<T> {
        let Some(item) = self.item("kind") else {
            let allowed = listed(kinds.iter().map(|(word, _)| *word));
            let message = self.place.message("the key `kind` is missing");
            self.context.report(
                Diagnostic::error("missing-key", self.place.path.clone(), message)
                    .help(format!("one of {allowed}")),
            );
            return None;
        };
        let DeValue::String(word) = item.value else {
            item.wrong_type("a text");
            return None;
        };
        if let Some((_, kind)) = foreign.iter().find(|(kind, _)| kind == word) {
            self.foreign = true;
            return Some(*kind);
        }
        let of = |word: &str| kinds.iter().find(|(kind, _)| *kind == word);
        let mut found = of(word);
        if found.is_none() {
            let words = || kinds.iter().map(|(kind, _)| *kind);
            let meant = other_words(word).find(|kind| words().any(|k| k == *kind));
            let help = match meant {
                Some(kind) => format!("write `{kind}`; allowed here: {}", listed(words())),
                None => did_you_mean(word, words()),
            };
            let text = format!("there is no kind `{word}`");
            item.error("unknown-kind", &text, help);
            let nearest = || nearest(word, words()).first().copied();
            found = meant.or_else(nearest).and_then(of);
        }
        found.map(|(_, kind)| *kind)
    }

    /// Reports a wrong combination of keys; `key` is where the diagnostic points if it is there.
    pub fn combination(&self, key: &str, text: &str, help: &str) {
        if self.foreign {
            return;
        }
        let path = if self.has(key) {
            child(&self.place.path, key)
        } else {
            self.place.path.clone()
        };
        let message = self.place.message(text);
        let diagnostic = Diagnostic::error("wrong-combination", path, message).help(help);
        if self.has(key) {
            self.context.report_key(diagnostic);
        } else {
            self.context.report(diagnostic);
        }
    }

    /// Reports keys that nobody asked for and needed keys that are missing; returns the keys that
    /// the unknown ones were probably meant to be.
    pub fn finish(self) -> Vec<&'static str> {
        let mut missing = self.missing;
        let mut misspelt = Vec::new();
        for (key, _) in self.table.iter() {
            let key = key.get_ref();
            let known = |keys: &[&str]| keys.contains(&key.as_ref());
            if known(&self.asked) || known(&self.foreign_keys) {
                continue;
            }
            let free = self
                .asked
                .iter()
                .copied()
                .filter(|k| !self.table.contains_key(*k));
            // A misspelt needed key is one mistake, not two.
            if let Some(&meant) = nearest(key, free).first() {
                missing.retain(|k| *k != meant);
                misspelt.push(meant);
            }
            let message = self.place.message(&format!("unknown key `{key}`"));
            let path = child(&self.place.path, key);
            self.context.report_key(
                Diagnostic::error("unknown-key", path, message)
                    .help(did_you_mean(key, self.asked.iter().copied())),
            );
        }
        if self.foreign {
            missing.clear();
        }
        for key in missing {
            let message = self.place.message(&format!("the key `{key}` is missing"));
            let help = format!("add `{key} = ...`");
            self.context.report(
                Diagnostic::error("missing-key", self.place.path.clone(), message).help(help),
            );
        }
        misspelt
    }
}
