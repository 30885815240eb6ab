//! Orientations in space.

use crate::model_file::item::Item;
use crate::model_file::table_reader::TableReader;
use dalembert::model::{EulerAxes, Orientation};
use dalembert::space::orientation::EulerSequence;
use toml::de::DeValue;

const AXES: [(&str, EulerAxes); 2] = [("body", EulerAxes::Body), ("space", EulerAxes::Space)];

/// The ways of writing an orientation, by the key that says which it is.
#[derive(Clone, Copy, PartialEq)]
enum Form {
    Euler,
    AxisAngle,
    EulerParameters,
    Rodriguez,
    Matrix,
    Points,
    Axes,
}

const FORMS: [(&str, Form); 9] = [
    ("euler", Form::Euler),
    ("axis", Form::AxisAngle),
    ("euler_parameters", Form::EulerParameters),
    ("rodriguez", Form::Rodriguez),
    ("matrix", Form::Matrix),
    ("points", Form::Points),
    ("x", Form::Axes),
    ("y", Form::Axes),
    ("z", Form::Axes),
];

const VECTOR: &str = "write [x, y, z]";

const HELP: &str = "write { axis = [0, 0, 1], angle = \"30 deg\" }, or { euler = \"zxz\", angles = [...] }, \
                    or one of `euler_parameters`, `rodriguez`, `matrix`, `points`, or two of `x`, `y`, `z`";

/// Reads an orientation.
pub(super) fn lower(item: &Item<'_>) -> Option<Orientation> {
    if !matches!(item.value, DeValue::Table(_)) {
        item.wrong_type("a table like { axis = [0, 0, 1], angle = \"30 deg\" }");
        return None;
    }
    let mut table = item.table()?;
    let given: Vec<(&'static str, Form)> = FORMS
        .into_iter()
        .filter(|(key, _)| table.has(key))
        .collect();
    let Some(&(first, form)) = given.first() else {
        for (key, _) in FORMS {
            table.item(key);
        }
        if table.finish().is_empty() {
            item.error("wrong-combination", "an orientation says nothing", HELP);
        }
        return None;
    };
    if let Some((other, _)) = given.iter().find(|(_, f)| *f != form) {
        let text = format!("`{first}` and `{other}` exclude each other");
        table.combination(other, &text, HELP);
        return None;
    }
    let orientation = of_form(&mut table, form);
    table.finish();
    Some(orientation)
}

fn of_form(table: &mut TableReader<'_>, form: Form) -> Orientation {
    let vector = |item: &Item<'_>| item.numbers::<3>(VECTOR);
    match form {
        Form::Euler => Orientation::Euler {
            euler: table.required("euler", sequence).unwrap_or_default(),
            angles: table
                .required("angles", |item| {
                    item.numbers("write the three angles in the order of the axes")
                })
                .unwrap_or_default(),
            axes: table.optional("axes", |item| item.choice(&AXES)),
        },
        Form::AxisAngle => Orientation::AxisAngle {
            axis: table.required("axis", vector).unwrap_or_default(),
            angle: table.need_value("angle"),
        },
        Form::EulerParameters => Orientation::EulerParameters {
            euler_parameters: table
                .required("euler_parameters", |item| {
                    item.numbers("write the scalar first, then the vector")
                })
                .unwrap_or_default(),
        },
        Form::Rodriguez => Orientation::Rodriguez {
            rodriguez: table.required("rodriguez", vector).unwrap_or_default(),
        },
        Form::Matrix => Orientation::Matrix {
            matrix: table
                .required("matrix", |item| {
                    item.rows("write three rows of three numbers")
                })
                .unwrap_or_default(),
        },
        Form::Points => Orientation::Points {
            points: table
                .required("points", |item| {
                    item.rows("write three points: the origin, one on x, one on the side of y")
                })
                .unwrap_or_default(),
        },
        Form::Axes => {
            let [x, y, z] = ["x", "y", "z"].map(|key| table.optional(key, vector));
            let given = ["x", "y", "z"].into_iter().filter(|key| table.has(key));
            if let (1, Some(only)) = (given.clone().count(), given.clone().next()) {
                let text = "one axis leaves the turn about it open";
                table.combination(only, text, "give two of `x`, `y`, `z`");
            }
            Orientation::Axes { x, y, z }
        }
    }
}

/// Reads the axes of Euler angles.
fn sequence(item: &Item<'_>) -> Option<String> {
    let text = item.text()?;
    // The axes of which body they are is said by a key of its own.
    let letters = !text.contains('-');
    if !letters || text.parse::<EulerSequence>().is_err() {
        item.error(
            "unknown-word",
            &format!("\"{text}\" is not a sequence of axes"),
            "write three of x, y and z with different neighbours, like \"zxz\" or \"xyz\"",
        );
    }
    Some(text)
}
