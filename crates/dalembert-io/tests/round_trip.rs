//! Writing a model and reading it again gives the same model.

use dalembert::model::*;
use dalembert_io::model_file::{parse_model, render, write_model};
use std::path::{Path, PathBuf};

/// Models with every kind of element and every key, and the folder of their files.
const EVERYTHING: [&str; 2] = [
    include_str!("data/everything.toml"),
    include_str!("data/everything_spatial.toml"),
];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data")
}

#[test]
fn everything_survives() {
    for text in EVERYTHING {
        let parsed = parse_model(text, Some(&folder()));
        let report = render(
            &parsed.diagnostics,
            &parsed.source,
            "everything",
            text,
            false,
        );
        assert_eq!(report, "");
        let model = parsed.model.unwrap();
        let written = write_model(&model);
        let again = parse_model(&written, Some(&folder()));
        let report = render(
            &again.diagnostics,
            &again.source,
            "written",
            &written,
            false,
        );
        assert_eq!(report, "", "{written}");
        assert_eq!(again.model.as_ref(), Some(&model), "{written}");
        assert_eq!(write_model(&model), written);
    }
}

#[test]
fn the_reader_reads_what_serde_reads() {
    // The derived reader knows the types; ours must read the same from every kind and key.
    for text in EVERYTHING {
        let mut model = parse_model(text, Some(&folder())).model.unwrap();
        let by_serde: Model = toml::from_str(&write_model(&model)).unwrap();
        // Only our reader opens the files of meshes.
        for shape in model.bodies.iter_mut().flat_map(|b| &mut b.shape) {
            if let ShapeKind::Mesh {
                vertices,
                triangles,
                ..
            } = &mut shape.kind
            {
                assert_eq!((vertices.len(), triangles.len()), (4, 4));
                vertices.clear();
                triangles.clear();
            }
        }
        assert_eq!(model, by_serde);
    }
}

#[test]
fn every_kind_is_in_the_example() {
    let schema = dalembert_io::model_file::schema().to_string();
    let mut kinds: Vec<&str> = schema
        .split("\"const\":\"")
        .skip(1)
        .filter_map(|rest| rest.split('"').next())
        .collect();
    kinds.sort_unstable();
    kinds.dedup();
    assert!(kinds.len() > 40, "{kinds:?}");
    let missing = |kind: &&&str| !EVERYTHING.concat().contains(&format!("\"{kind}\""));
    // These are what a model has that says nothing else; they are tested by the templates.
    let defaults = ["cubic", "projection"];
    // A file names one method of integration; all of them are read by one list.
    let methods = dalembert::model::Method::NAMES.map(|(name, _)| name);
    let missing = |kind: &&&str| missing(kind) && !methods.contains(*kind);
    let missing: Vec<&&str> = kinds.iter().filter(missing).collect();
    let missing: Vec<&&&str> = missing.iter().filter(|k| !defaults.contains(k)).collect();
    assert_eq!(missing, Vec::<&&&str>::new());
}

#[test]
fn every_key_is_in_the_example() {
    let mut keys = Vec::new();
    collect_keys(&dalembert_io::model_file::schema(), &mut keys);
    assert!(keys.len() > 60, "{keys:?}");
    // The keys of CSV files have tests of their own.
    let elsewhere = ["columns", "x_unit", "y_unit"];
    let text = EVERYTHING.concat();
    for key in keys.iter().filter(|k| !elsewhere.contains(&k.as_str())) {
        let there = text.contains(&format!("{key} = ")) || text.contains(&format!("[{key}]"));
        assert!(there, "{key}");
    }
}

fn collect_keys(schema: &serde_json::Value, keys: &mut Vec<String>) {
    if let Some(properties) = schema["properties"].as_object() {
        keys.extend(properties.keys().cloned());
    }
    match schema {
        serde_json::Value::Object(entries) => entries.values().for_each(|v| collect_keys(v, keys)),
        serde_json::Value::Array(items) => items.iter().for_each(|v| collect_keys(v, keys)),
        _ => {}
    }
}

#[test]
fn spatial_models_have_three_components() {
    let model = Model {
        info: Info {
            name: "s".to_owned(),
            space: SpaceKind::Spatial,
            gravity: Some(vec![0.0.into(), 0.0.into(), (-9.81).into()]),
            ..Info::default()
        },
        ..Model::default()
    };
    assert_eq!(parse_model(&write_model(&model), None).model, Some(model));
}

#[test]
fn difficult_texts_and_numbers_survive() {
    let mut model = Model {
        info: Info {
            name: "quotes \" ' \\ and\nlines\t\u{1}\u{7f} α \u{1f600}".to_owned(),
            description: Some("\"\"\"'''".to_owned()),
            ..Info::default()
        },
        ..Model::default()
    };
    let numbers = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        0.1,
        1e15,
        1e16,
        1e22,
        1e300,
        -1e-300,
        5e-324,
        f64::MAX,
        f64::EPSILON,
        9007199254740993.0,
        1.0 / 3.0,
    ];
    for (k, number) in numbers.into_iter().enumerate() {
        model.parameters.insert(format!("p{k}"), number.into());
    }
    model.parameters.insert("groesse".to_owned(), "2*p1".into());
    // The order of the parameters is kept, not sorted.
    model.parameters.insert("a".to_owned(), 1.0.into());
    let written = write_model(&model);
    let read = parse_model(&written, None).model.unwrap();
    assert_eq!(read, model, "{written}");
    assert!(
        read.parameters.keys().eq(model.parameters.keys()),
        "{written}"
    );
    let sign = |m: &Model| match m.parameters["p1"] {
        Value::Number(n) => n.is_sign_negative(),
        Value::Text(_) => false,
    };
    assert!(sign(&read));
}

#[test]
fn what_is_written_is_readable() {
    let text = "[model]\nname = \"m\"\nspace = \"planar\"\ngravity = [0, -9.81]\n\n[parameters]\nr = \"10 mm\"\n\n[[body]]\nname = \"a\"\nposition = [\"r\", 0.5]\nshape = [{ kind = \"circle\", radius = \"r\" }]\n";
    assert_eq!(write_model(&parse_model(text, None).model.unwrap()), text);
}
