//! Named numbers.

use crate::model_file::item::Item;
use crate::model_file::names::{NameOf, Section};
use crate::model_file::source_map::child;
use crate::model_file::table_reader::TableReader;
use dalembert::diagnostic::Diagnostic;
use dalembert::model::Value;
use dalembert_expr::is_identifier;
use indexmap::IndexMap;
use toml::de::DeValue;

/// Reads `[parameters]`, in the order of the file.
pub(super) fn lower(file: &mut TableReader<'_>) -> IndexMap<String, Value> {
    let mut parameters = IndexMap::new();
    let Some(mut section) = file.item("parameters") else {
        return parameters;
    };
    section.place = super::element_place(section.place.path, "section [parameters]".to_owned());
    let DeValue::Table(table) = section.value else {
        section.wrong_type("a table");
        return parameters;
    };
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    for (key, value) in entries {
        let name = key.get_ref().to_string();
        let path = child(&section.place.path, &name);
        let item = Item {
            context: section.context,
            value: value.get_ref(),
            place: super::element_place(path, format!("parameter \"{name}\"")),
        };
        if is_identifier(&name) {
            item.context.names.borrow_mut().push(NameOf {
                section: Section::Parameter,
                name: name.clone(),
                place: item.place.clone(),
            });
        } else {
            let text = "a name for expressions starts with a letter and has letters (a to z, A to Z), \
                        digits and underscores only";
            let message = item.place.message(text);
            item.context.report_key(
                Diagnostic::error("bad-name", item.place.path.clone(), message)
                    .help("choose another name, such as `crank_length`"),
            );
        }
        // A number that is none keeps the engine from judging what follows from it.
        parameters.insert(name, item.value().unwrap_or(Value::Number(f64::NAN)));
    }
    parameters
}
