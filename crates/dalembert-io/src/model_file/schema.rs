//! The JSON Schema of model files.

use dalembert::model::Model;
use schemars::generate::SchemaSettings;
use serde_json::{Value, json};

/// The JSON Schema (2020-12) of model files, for editors: it completes keys, shows what they
/// mean, and marks unknown ones.
pub fn schema() -> Value {
    let generator = SchemaSettings::draft2020_12().into_generator();
    let mut schema = generator.into_root_schema_for::<Model>().to_value();
    schema["title"] = json!("dalembert model");
    schema["$id"] = json!("dalembert-model.schema.json");
    without_null(&mut schema);
    let definitions = schema["$defs"].as_object_mut();
    for definition in definitions.into_iter().flat_map(|d| d.values_mut()) {
        // Types that are put together from parts allow the keys of all their parts, and no others.
        let put_together = definition.get("oneOf").is_some() || definition.get("anyOf").is_some();
        if put_together && definition.get("additionalProperties").is_none() {
            definition["unevaluatedProperties"] = json!(false);
        }
    }
    // The file may have one shape without a list around it.
    let shape = &mut schema["$defs"]["Body"]["properties"]["shape"];
    let (one, list, description) = (
        shape["items"].clone(),
        json!({ "type": "array", "items": shape["items"] }),
        shape["description"].clone(),
    );
    *shape = json!({ "description": description, "anyOf": [one, list] });
    schema
}

/// TOML has no null: a key that may be left out has the type that it has when it is there.
fn without_null(schema: &mut Value) {
    match schema {
        Value::Object(keywords) => {
            if let Some(Value::Array(types)) = keywords.get_mut("type") {
                types.retain(|t| t != "null");
                if let [only] = types.as_slice() {
                    let only = only.clone();
                    keywords.insert("type".to_owned(), only);
                }
            }
            if let Some(Value::Array(choices)) = keywords.get_mut("anyOf") {
                choices.retain(|c| *c != json!({ "type": "null" }));
                if let [Value::Object(only)] = choices.as_slice() {
                    let only = only.clone();
                    keywords.remove("anyOf");
                    keywords.extend(only);
                }
            }
            keywords.values_mut().for_each(without_null);
        }
        Value::Array(items) => items.iter_mut().for_each(without_null),
        _ => {}
    }
}
