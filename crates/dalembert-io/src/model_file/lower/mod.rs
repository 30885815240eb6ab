//! From the parsed file to the model: one function for each kind of element.
//!
//! After a mistake a function puts a placeholder and goes on, so that all mistakes are found and
//! every element keeps its place; a model with mistakes is never handed out as a good one.

mod axial_vector;
mod body;
mod constraint;
mod driver;
mod force;
mod inertia;
mod initial;
mod joint;
mod orientation;
mod parameters;
mod placement;
mod quantity;
mod settings;
mod shape;
mod surface;
mod table;
mod trace;
mod unknown_kind;

use super::context::Context;
use super::item::{Item, Place};
use super::table_reader::TableReader;
use dalembert::diagnostic::Diagnostic;
use dalembert::model::Model;
use toml::de::{DeTable, DeValue};

/// Reads the whole file.
pub(super) fn model(context: &Context<'_>, root: &DeTable<'_>) -> Model {
    let place = Place {
        path: String::new(),
        label: "model file".into(),
        element: 0,
    };
    let mut file = TableReader::new(context, root, place);
    // First, because it says how many components a point has.
    let info = if file.has("model") {
        section(&mut file, "model", settings::info).unwrap_or_default()
    } else {
        // Asked for nevertheless: the list of sections that help texts name must be whole.
        file.item("model");
        context.report(
            Diagnostic::error(
                "missing-key",
                "",
                "model file: the section `[model]` is missing",
            )
            .help("start the file with `[model]` and `name = \"...\"`"),
        );
        Default::default()
    };
    let model = Model {
        info,
        parameters: parameters::lower(&mut file),
        tables: elements(&mut file, "table", "table", table::lower),
        bodies: elements(&mut file, "body", "body", body::lower),
        joints: elements(&mut file, "joint", "joint", joint::lower),
        constraints: elements(&mut file, "constraint", "constraint", constraint::lower),
        drivers: elements(&mut file, "driver", "driver", driver::lower),
        forces: elements(&mut file, "force", "force", force::lower),
        initial: elements(&mut file, "initial", "initial condition", initial::lower),
        traces: elements(&mut file, "trace", "trace", trace::lower),
        analysis: section(&mut file, "analysis", settings::analysis).unwrap_or_default(),
        output: section(&mut file, "output", settings::output).unwrap_or_default(),
    };
    let absent = file.finish();
    // Every use of a parameter or table of such a section would be blamed again.
    if absent.iter().any(|s| matches!(*s, "parameters" | "table")) {
        context.lost.set(true);
    }
    context.absent.borrow_mut().extend(absent);
    model
}

/// Reads a section that is there once, like `[analysis]`.
fn section<'a, T>(
    file: &mut TableReader<'a>,
    key: &'static str,
    lower: impl FnOnce(TableReader<'a>) -> T,
) -> Option<T> {
    let mut item = file.item(key)?;
    item.place = element_place(item.place.path, format!("section [{key}]"));
    item.table().map(lower)
}

/// Reads the elements of a list of tables, like `[[body]]`.
fn elements<'a, T>(
    file: &mut TableReader<'a>,
    key: &'static str,
    word: &str,
    lower: impl for<'b> Fn(TableReader<'b>) -> T,
) -> Vec<T> {
    let Some(mut list) = file.item(key) else {
        return Vec::new();
    };
    list.place = element_place(list.place.path, format!("section [[{key}]]"));
    let entries = if let DeValue::Table(_) = list.value {
        let help = format!("write [[{key}]] with two brackets above each {word}");
        list.error(
            "wrong-type",
            "expected a list of tables, found a table",
            help,
        );
        list.place.path.push_str("[0]");
        vec![list]
    } else if let Some(entries) = list.entries("a list of tables") {
        entries
    } else {
        file.context().lost.set(true);
        file.context().absent.borrow_mut().push(key);
        return Vec::new();
    };
    let one = |(k, mut item): (usize, Item<'a>)| {
        let label = match name_of(item.value) {
            Some(name) => format!("{word} \"{name}\""),
            None => format!("{word} number {}", k + 1),
        };
        item.place = element_place(item.place.path, label);
        match item.table() {
            Some(table) => lower(table),
            None => unknown_kind::silently(&lower),
        }
    };
    entries.into_iter().enumerate().map(one).collect()
}

fn element_place(path: String, label: String) -> Place {
    Place {
        element: path.len() + 1,
        path,
        label: label.into(),
    }
}

fn name_of<'a>(value: &'a DeValue<'_>) -> Option<&'a str> {
    match value.as_table()?.get("name")?.get_ref() {
        DeValue::String(name) if !name.trim().is_empty() => Some(name),
        _ => None,
    }
}

/// Reads a table whose keys depend on its `kind`, and reports its unknown keys.
fn table_of<'a, T>(
    item: &Item<'a>,
    lower: impl FnOnce(&mut TableReader<'a>) -> Option<T>,
) -> Option<T> {
    let mut table = item.table()?;
    let result = lower(&mut table)?;
    table.finish();
    Some(result)
}
