//! Names of parameters and tables, and the dimensions of tables.

use dalembert::diagnostic::Diagnostic;
use dalembert::model::Model;
use dalembert::system::compile::{Compiled, compile};
use serde_json::{Value, json};

/// A machine of one body whose mass is an expression.
fn model(mass: &str, parameters: Value, tables: Value) -> Model {
    let machine = json!({
        "model": { "name": "machine" },
        "parameters": parameters,
        "table": tables,
        "body": [{ "name": "disc", "mass": mass, "inertia": 1 }],
    });
    serde_json::from_value(machine).unwrap()
}

fn compiled(mass: &str, tables: Value) -> Compiled {
    compile::<dalembert::space::Planar>(&model(mass, json!({ "mm": 7 }), tables), &[])
        .unwrap_or_else(|e| panic!("{e:?}"))
}

fn mistakes(mass: &str, parameters: Value, tables: Value) -> Vec<Diagnostic> {
    let result = compile::<dalembert::space::Planar>(&model(mass, parameters, tables), &[]);
    result.map(|_| ()).expect_err("a mistake").0
}

/// Code and place of every mistake.
fn places(mistakes: &[Diagnostic]) -> Vec<(&str, &str)> {
    mistakes
        .iter()
        .map(|d| (d.code.as_str(), d.path.as_str()))
        .collect()
}

fn table(name: &str) -> Value {
    json!({ "name": name, "interpolation": "linear", "x": [0, 1], "y": [0, 2] })
}

#[test]
fn reserved_names_are_refused() {
    for name in ["t", "ground", "pi", "sin", "if", "and"] {
        let found = mistakes("1", json!({ name: 2 }), json!([]));
        assert_eq!(
            places(&found),
            [("reserved-name", format!("parameters.{name}").as_str())]
        );
        assert!(found[0].message.contains(&format!("'{name}'")) && found[0].help.is_some());
        let found = mistakes("1", json!({}), json!([table("fine"), table(name)]));
        assert_eq!(places(&found), [("reserved-name", "table[1].name")]);
    }
}

#[test]
fn names_that_expressions_cannot_write_are_refused() {
    for name in ["", "2r", "crank length", "a-b", "a.b", "`a`", "größe"] {
        let found = mistakes("1", json!({ name: 2 }), json!([table(name)]));
        let parameter = format!("parameters.{name}");
        let expected = [
            ("bad-name", parameter.as_str()),
            ("bad-name", "table[0].name"),
        ];
        assert_eq!(places(&found), expected);
    }
    // Names of units and of measures are free.
    let fine = json!({ "m": 2, "_x1": 3, "sinus": 4, "T": 5 });
    assert!(
        compile::<dalembert::space::Planar>(
            &model("m + _x1 + sinus + T + Phi(0)", fine, json!([table("Phi")])),
            &[]
        )
        .is_ok()
    );
}

#[test]
fn two_tables_of_one_name_are_refused() {
    let found = mistakes("1", json!({}), json!([table("f"), table("f")]));
    assert_eq!(places(&found), [("duplicate-name", "table[1].name")]);
}

fn lift() -> Value {
    json!([{
        "name": "lift",
        "interpolation": "linear",
        "x": [0, "90 deg", "pi"],
        "y": ["0", "10 * 1 mm", "3 cm"],
    }])
}

#[test]
fn points_with_units_give_a_table_dimensions() {
    let mass = compiled("lift(135 deg) * 100 kg/m", lift()).system.mass;
    assert!(mass.iter().any(|m| (m - 2.0).abs() < 1e-15), "{mass:?}");
    for wrong in [
        "lift(90 deg)",
        "lift(1 s) * 1 kg/m",
        "1 kg + lift(0) * 1 N/m",
    ] {
        let found = mistakes(wrong, json!({}), lift());
        assert_eq!(
            places(&found),
            [("unit-mismatch", "body[0].mass")],
            "{wrong}"
        );
    }
    // Without units a table fits everywhere.
    let mass = compiled("lift(0.5 s)", json!([table("lift")])).system.mass;
    assert!(mass.contains(&1.0), "{mass:?}");
}

#[test]
fn points_of_several_dimensions_are_refused() {
    let mixed = json!([{ "name": "f", "x": [0, "1 s", "2 s"], "y": [0, "1 m", "2 kg"] }]);
    let found = mistakes("1", json!({}), mixed);
    assert_eq!(places(&found), [("unit-mismatch", "table[0].y[2]")]);
    assert_eq!(
        found[0].message,
        "table 'f': y[2] is a mass (kg), but y[1] is a length (m)"
    );
}

/// As a reader of files fills it in.
fn from_file(x_unit: &str) -> Value {
    json!([{
        "name": "lift",
        "interpolation": "linear",
        "file": "lift.csv",
        "x_unit": x_unit,
        "x": [format!("0 {x_unit}"), format!("90 {x_unit}")],
        "y": [0, 2],
    }])
}

#[test]
fn the_unit_of_a_file_holds_whatever_the_parameters_are_called() {
    // The parameter `mm` is 7.
    let mass = compiled("lift(45 mm)", from_file("mm")).system.mass;
    assert!(mass.contains(&1.0), "{mass:?}");
    let found = mistakes("lift(45 s)", json!({}), from_file("mm"));
    assert_eq!(places(&found), [("unit-mismatch", "body[0].mass")]);
}

#[test]
fn a_wrong_unit_of_a_file_is_one_mistake() {
    let found = mistakes("1", json!({}), from_file("mmm"));
    assert_eq!(places(&found), [("unknown-unit", "table[0].x_unit")]);
}
