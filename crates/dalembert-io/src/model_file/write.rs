//! Writing model files.

use dalembert::model::Model;
use toml::{Table, Value};

/// Writes a model as the text of a model file.
///
/// Reading the text gives the same model. Points that came from a CSV file are not written: the
/// file is named instead, and is read from the folder of the model file again.
pub fn write_model(model: &Model) -> String {
    let mut model = model.clone();
    for table in &mut model.tables {
        // TOML has no larger numbers; no file has as many columns either.
        table.columns = table.columns.map(|c| c.map(|n| n.min(u32::MAX as usize)));
    }
    // This cannot fail: every type of the model serializes to texts, booleans, floats, whole
    // numbers of 32 bits, lists and tables with texts as keys, and `None` is skipped everywhere.
    let mut root = Table::try_from(&model).expect("a model is TOML");
    for table in root
        .get_mut("table")
        .and_then(Value::as_array_mut)
        .into_iter()
        .flatten()
    {
        if let Value::Table(table) = table
            && table.contains_key("file")
        {
            table.remove("x");
            table.remove("y");
        }
    }
    let mut text = String::new();
    for (key, value) in &root {
        match value {
            Value::Array(elements) => {
                for element in elements {
                    section(&mut text, &format!("[[{key}]]"), element);
                }
            }
            // Sections without a word, like an empty `[analysis]`, say nothing.
            Value::Table(table) if table.is_empty() => {}
            table => section(&mut text, &format!("[{key}]"), table),
        }
    }
    text
}

/// Lines longer than this are broken where they are lists of tables.
const LINE: usize = 100;

fn section(text: &mut String, header: &str, value: &Value) {
    if !text.is_empty() {
        text.push('\n');
    }
    text.push_str(header);
    text.push('\n');
    for (key, value) in value.as_table().into_iter().flatten() {
        let (key, short) = (bare_or_quoted(key), inline(value));
        let long_list = value
            .as_array()
            .filter(|_| key.len() + 3 + short.len() > LINE);
        match long_list {
            Some(items) => {
                text.push_str(&format!("{key} = [\n"));
                for item in items {
                    text.push_str(&format!("    {},\n", inline(item)));
                }
                text.push_str("]\n");
            }
            None => text.push_str(&format!("{key} = {short}\n")),
        }
    }
}

/// A value on one line.
fn inline(value: &Value) -> String {
    match value {
        Value::String(text) => quoted(text),
        Value::Integer(number) => number.to_string(),
        Value::Float(number) => float(*number),
        Value::Boolean(flag) => flag.to_string(),
        Value::Datetime(date) => date.to_string(),
        Value::Array(items) => {
            let items: Vec<String> = items.iter().map(inline).collect();
            format!("[{}]", items.join(", "))
        }
        Value::Table(table) => {
            let entry = |(key, value): (&String, &Value)| {
                format!("{} = {}", bare_or_quoted(key), inline(value))
            };
            let entries: Vec<String> = table.iter().map(entry).collect();
            format!("{{ {} }}", entries.join(", "))
        }
    }
}

/// The shortest digits that give the same number; whole numbers without a point.
fn float(number: f64) -> String {
    // Reading accepts whole numbers; minus zero would lose its sign.
    let whole = number.fract() == 0.0 && number.abs() < 1e15;
    if whole && !(number == 0.0 && number.is_sign_negative()) {
        format!("{number}")
    } else if number.is_nan() {
        "nan".to_owned()
    } else {
        format!("{number:?}")
    }
}

fn bare_or_quoted(key: &str) -> String {
    let bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !key.is_empty() && key.chars().all(bare) {
        key.to_owned()
    } else {
        quoted(key)
    }
}

fn quoted(text: &str) -> String {
    let mut result = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => result.push_str("\\\""),
            '\\' => result.push_str("\\\\"),
            '\n' => result.push_str("\\n"),
            '\t' => result.push_str("\\t"),
            '\r' => result.push_str("\\r"),
            c if c.is_control() => result.push_str(&format!("\\u{:04X}", u32::from(c))),
            c => result.push(c),
        }
    }
    result.push('"');
    result
}
