//! Tables whose points stand in a CSV file beside the model file.

use dalembert::model::Value;
use dalembert::system::compile::compile;
use dalembert_io::model_file::{Parsed, parse_model, write_model};
use std::fs;
use std::path::{Path, PathBuf};

/// A folder with one CSV file, and the model that names it.
fn read(test: &str, csv: &str, keys: &str) -> (Parsed, PathBuf) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("lift.csv"), csv).unwrap();
    let text =
        format!("[model]\nname = \"m\"\n[[table]]\nname = \"f\"\nfile = \"lift.csv\"\n{keys}");
    (parse_model(&text, Some(&folder)), folder)
}

#[track_caller]
fn check_error(test: &str, csv: &str, keys: &str, message: &str) {
    check_error_at("file", test, csv, keys, message);
}

fn check_error_at(key: &str, test: &str, csv: &str, keys: &str, message: &str) {
    let (parsed, _) = read(test, csv, keys);
    let messages: Vec<&str> = parsed
        .diagnostics
        .iter()
        .map(|d| d.message.as_str())
        .collect();
    assert_eq!(messages, [format!("table \"f\": `{key}`: {message}")]);
    assert_eq!(parsed.diagnostics[0].path, format!("table[0].{key}"));
}

fn numbers(numbers: &[f64]) -> Vec<Value> {
    numbers.iter().copied().map(Value::Number).collect()
}

#[test]
fn headings_comments_and_spaces_are_tolerated() {
    let (parsed, folder) = read("plain", "# measured\nphi, lift\n0, 1.5\n\n 1 ,-2e-3\n", "");
    assert_eq!(parsed.diagnostics, []);
    let model = parsed.model.unwrap();
    assert_eq!(model.tables[0].x, numbers(&[0.0, 1.0]));
    assert_eq!(model.tables[0].y, numbers(&[1.5, -0.002]));
    // The file stays the home of the points.
    let written = write_model(&model);
    assert!(!written.contains("x = "), "{written}");
    assert_eq!(parse_model(&written, Some(&folder)).model, Some(model));
    // What the engine says of the points is shown at the file's name.
    let (points, file) = (
        parsed.source.locate("table[0].y[1]"),
        parsed.source.locate("table[0].file"),
    );
    assert!(points.is_some() && points == file);
}

#[test]
fn columns_units_and_semicolons() {
    let (parsed, _) = read(
        "units",
        "n;phi;lift\n1;0;0\n2;90;-1.5\n",
        "columns = [2, 3]\nx_unit = \"deg\"\ny_unit = \"mm\"\n",
    );
    assert_eq!(parsed.diagnostics, []);
    let table = &parsed.model.unwrap().tables[0];
    assert_eq!(table.x, ["0 deg".into(), "90 deg".into()]);
    assert_eq!(table.y, ["0 mm".into(), "-1.5 mm".into()]);
}

#[test]
fn columns_are_converted_and_keep_their_dimensions() {
    let keys = |mass: &str| {
        format!(
            "interpolation = \"linear\"\nx_unit = \"deg\"\ny_unit = \"mm\"\n\
             [[body]]\nname = \"disc\"\nmass = \"{mass}\"\ninertia = 1\n"
        )
    };
    let csv = "0,0\n90,-1.5\n180,4\n";
    let (parsed, _) = read("converted", csv, &keys("1000 kg/m * f(pi)"));
    let system = compile::<dalembert::space::Planar>(&parsed.model.unwrap(), &[])
        .unwrap()
        .system;
    assert!(system.mass.contains(&4.0), "{:?}", system.mass);
    for wrong in ["f(pi)", "1000 kg/m * f(1 s)"] {
        let (parsed, _) = read("converted", csv, &keys(wrong));
        let mistakes = compile::<dalembert::space::Planar>(&parsed.model.unwrap(), &[])
            .map(|_| ())
            .unwrap_err();
        let codes: Vec<&str> = mistakes.0.iter().map(|d| d.code.as_str()).collect();
        assert_eq!(codes, ["unit-mismatch"], "{wrong}");
    }
}

#[test]
fn a_wrong_unit_of_a_column_is_shown_once() {
    let (parsed, _) = read("wrong-unit", "0,0\n1,1\n2,4\n", "x_unit = \"degg\"\n");
    let model = parsed.model.unwrap();
    let mistakes = compile::<dalembert::space::Planar>(&model, &[])
        .map(|_| ())
        .unwrap_err()
        .0;
    let found: Vec<_> = mistakes
        .iter()
        .map(|d| (d.code.as_str(), d.path.as_str()))
        .collect();
    assert_eq!(found, [("unknown-unit", "table[0].x_unit")]);
    assert!(parsed.source.locate("table[0].x_unit").is_some());
}

#[test]
fn a_field_that_is_no_number() {
    check_error(
        "text",
        "0,1\n1,two\n",
        "",
        "\"lift.csv\", line 2, column 2: \"two\" is not a finite number",
    );
    check_error(
        "half-heading",
        "0,lift\n1,2\n2,3\n",
        "",
        "\"lift.csv\", line 1, column 2: \"lift\" is not a finite number",
    );
    check_error(
        "infinite",
        "0,1\n1,2\n2,inf\n",
        "",
        "\"lift.csv\", line 3, column 2: \"inf\" is not a finite number",
    );
}

#[test]
fn a_column_that_is_not_there() {
    // It is asked for where the columns are named, also below headings.
    for csv in ["0,1\n1,2\n", "phi,lift\n0,1\n1,2\n"] {
        check_error_at(
            "columns[1]",
            "short",
            csv,
            "columns = [1, 3]\n",
            "\"lift.csv\", line 1: there is no column 3, the line has 2",
        );
    }
}

#[test]
fn too_few_lines() {
    check_error(
        "few",
        "x,y\n0,1\n",
        "",
        "\"lift.csv\" has 1 line of numbers; a table needs at least 2",
    );
}

#[test]
fn a_file_that_is_not_there() {
    let text = "[model]\nname = \"m\"\n[[table]]\nname = \"f\"\nfile = \"none.csv\"\n";
    let parsed = parse_model(text, Some(Path::new(env!("CARGO_TARGET_TMPDIR"))));
    assert_eq!(parsed.diagnostics.len(), 1);
    assert!(
        parsed.diagnostics[0]
            .message
            .starts_with("table \"f\": `file`: cannot read \"none.csv\": ")
    );
    assert_eq!(parsed.model, None);
}
