//! The JSON Schema says the same as the reader.

use dalembert_io::model_file::{parse_model, schema, templates};
use serde_json::{Value, json};

const EVERYTHING: [(&str, &str); 2] = [
    ("planar", include_str!("data/everything.toml")),
    ("spatial", include_str!("data/everything_spatial.toml")),
];

fn as_json(toml: &str) -> Value {
    let table: toml::Table = toml.parse().unwrap();
    serde_json::to_value(table).unwrap()
}

#[test]
fn example_files_are_valid() {
    let schema = schema();
    assert!(jsonschema::meta::is_valid(&schema));
    let validator = jsonschema::validator_for(&schema).unwrap();
    let examples = templates().iter().map(|t| (t.name, t.text));
    for (name, text) in examples.chain(EVERYTHING) {
        let errors: Vec<String> = validator
            .iter_errors(&as_json(text))
            .map(|e| format!("{name}: {}: {e}", e.instance_path()))
            .collect();
        assert_eq!(errors, Vec::<String>::new());
    }
}

#[test]
fn the_schema_tells_what_things_are() {
    let schema = schema();
    assert_eq!(schema["title"], "dalembert model");
    assert_eq!(
        schema["$schema"],
        "https://json-schema.org/draft/2020-12/schema"
    );
    assert_eq!(
        schema["$defs"]["Body"]["properties"]["mass"]["description"],
        "Mass [kg]."
    );
    assert!(!schema.to_string().contains("\"null\""));
}

#[test]
fn an_unknown_key_is_refused_at_every_depth() {
    let validator = jsonschema::validator_for(&schema()).unwrap();
    for (name, text) in EVERYTHING {
        let good = as_json(text);
        assert!(validator.is_valid(&good));
        let mut places = 0;
        for pointer in tables(&good, String::new()) {
            if pointer == "/parameters" {
                continue;
            }
            let mut bad = good.clone();
            bad.pointer_mut(&pointer).unwrap()["nonsense"] = json!(1);
            assert!(!validator.is_valid(&bad), "{name}: {pointer}");
            places += 1;
        }
        assert!(places > 50, "{name}: {places}");
    }
}

/// JSON pointers of all tables.
fn tables(value: &Value, pointer: String) -> Vec<String> {
    let mut result = Vec::new();
    match value {
        Value::Object(entries) => {
            for (key, value) in entries {
                result.extend(tables(value, format!("{pointer}/{key}")));
            }
            result.push(pointer);
        }
        Value::Array(items) => {
            for (k, value) in items.iter().enumerate() {
                result.extend(tables(value, format!("{pointer}/{k}")));
            }
        }
        _ => {}
    }
    result
}

#[test]
fn every_kind_of_the_schema_is_known_to_the_reader() {
    let schema = schema();
    for (section, definition, least) in [
        ("joint", "Joint", 23),
        ("constraint", "Constraint", 3),
        ("driver", "Driver", 6),
        ("force", "Force", 8),
        ("initial", "Initial", 6),
    ] {
        let mut kinds = Vec::new();
        collect_kinds(&schema["$defs"][definition], &mut kinds);
        assert!(kinds.len() >= least, "{section}: {kinds:?}");
        for kind in kinds {
            let text = format!("[[{section}]]\nname = \"e\"\nkind = \"{kind}\"\n");
            let parsed = parse_model(&text, None);
            assert!(
                parsed.diagnostics.iter().all(|d| d.code != "unknown-kind"),
                "{section} {kind}"
            );
        }
    }
}

/// Values of `kind` of a definition, not of the definitions that it refers to.
fn collect_kinds(definition: &Value, kinds: &mut Vec<String>) {
    if let Some(kind) = definition["properties"]["kind"]["const"].as_str() {
        kinds.push(kind.to_owned());
    }
    for word in ["oneOf", "anyOf"] {
        for part in definition[word].as_array().into_iter().flatten() {
            collect_kinds(part, kinds);
        }
    }
}
