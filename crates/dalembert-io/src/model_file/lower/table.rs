//! Functions given by points.

use crate::model_file::csv_table::{self, CsvError};
use crate::model_file::item::Item;
use crate::model_file::names::Section;
use crate::model_file::table_reader::TableReader;
use dalembert::model::{Interpolation, Table};
use dalembert_expr::is_identifier;

const INTERPOLATIONS: [(&str, Interpolation); 3] = [
    ("cubic", Interpolation::Cubic),
    ("quintic", Interpolation::Quintic),
    ("linear", Interpolation::Linear),
];

/// Reads a `[[table]]`, and the CSV file that it names.
pub(super) fn lower(mut reader: TableReader<'_>) -> Table {
    let mut table = Table {
        name: reader.name(Section::Table),
        interpolation: reader
            .optional("interpolation", |item| item.choice(&INTERPOLATIONS))
            .unwrap_or_default(),
        periodic: reader.flag("periodic"),
        x: reader.optional("x", Item::values).unwrap_or_default(),
        y: reader.optional("y", Item::values).unwrap_or_default(),
        file: reader.optional("file", Item::text),
        columns: reader
            .optional("columns", |item| {
                item.pair(|item| item.count().map(|n| n as usize))
            })
            // Columns count from 1: a zero stands for one that cannot be read.
            .filter(|columns| !columns.contains(&0)),
        x_unit: reader.optional("x_unit", Item::text),
        y_unit: reader.optional("y_unit", Item::text),
    };
    // Every use of a table that has no name for expressions would be blamed again.
    if !is_identifier(&table.name) {
        reader.context().lost.set(true);
        if let Some(item) = reader.item("name").filter(|_| !table.name.is_empty()) {
            item.error(
                "bad-name",
                "a name for expressions starts with a letter and has letters (a to z, A to Z), \
                 digits and underscores only",
                "choose another name, such as `lift_curve`",
            );
        }
    }
    let inline = reader.has("x") || reader.has("y");
    let help = "give `x` and `y`, or the name of a CSV `file` beside the model file";
    match (inline, reader.has("file")) {
        (true, true) => {
            reader.combination("file", "`file` excludes `x` and `y`", help);
        }
        (false, false) => reader.combination("x", "the points are missing", help),
        (true, false) => {
            check_points(&mut reader, help);
            for key in ["columns", "x_unit", "y_unit"] {
                if reader.has(key) {
                    reader.combination(key, &format!("`{key}` speaks of a CSV `file`"), help);
                }
            }
        }
        (false, true) => {
            if let (Some(item), Some(file)) = (reader.item("file"), table.file.clone()) {
                // The engine may speak of the points, which the model file does not have.
                let mut aliases = item.context.aliases.borrow_mut();
                for key in ["x", "y"] {
                    let points = format!("{}.{key}", reader.place().path);
                    aliases.push((points, item.place.path.clone()));
                }
                drop(aliases);
                match csv_table::read(item.context.folder, &file, &table) {
                    Ok((x, y)) => (table.x, table.y) = (x, y),
                    Err(error) => {
                        // A column that is not there is asked for where the columns are named.
                        let asked = match error {
                            CsvError::NoColumn { entry, .. } => reader
                                .item("columns")
                                .and_then(|i| i.entries("a list of 2")?.into_iter().nth(entry)),
                            _ => None,
                        };
                        let blamed = asked.as_ref().unwrap_or(&item);
                        blamed.error("csv", &error.to_string(), error.help());
                    }
                }
            }
        }
    }
    reader.finish();
    table
}

fn check_points(reader: &mut TableReader<'_>, help: &str) {
    if !(reader.has("x") && reader.has("y")) {
        let there = if reader.has("x") { "x" } else { "y" };
        reader.combination(there, "`x` and `y` need each other", help);
        return;
    }
    let mut length = |key| -> Option<(Item<'_>, usize)> {
        let item = reader.item(key)?;
        let length = item.value.as_array()?.len();
        Some((item, length))
    };
    let (Some((x, arguments)), Some((y, values))) = (length("x"), length("y")) else {
        return;
    };
    if arguments < 2 {
        x.wrong_length("at least 2", arguments, "add points");
    } else if values != arguments {
        let expected = format!("{arguments} (as many as `x`)");
        y.wrong_length(&expected, values, "give every point both numbers");
    }
}
