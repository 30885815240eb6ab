//! The double parallelogram of the examples: all commands give the same set of reactions.

mod common;

use common::{dalembert, folder};
use std::path::Path;

fn example() -> String {
    let path =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/double-parallelogram.toml");
    path.display().to_string()
}

/// Forces of the pins in the first row of the results of a command, and what it says of them.
fn pins(command: &str) -> (Vec<f64>, String) {
    let file = folder(&format!("redundant-{command}")).join("results.csv");
    let run = dalembert(&[command, &example(), "--out", file.to_str().unwrap()]);
    assert_eq!(run.code, 0, "{}", run.err);
    let text = std::fs::read_to_string(&file).unwrap();
    let mut lines = text.lines().filter(|l| !l.starts_with('#'));
    let [names, row] = [lines.next().unwrap(), lines.next().unwrap()];
    let names: Vec<&str> = names.split(',').collect();
    let values: Vec<&str> = row.split(',').collect();
    let forces = ["A", "B", "C", "D", "E", "F"]
        .iter()
        .flat_map(|pin| ["x", "y"].map(|axis| format!("{pin}.force_{axis}")));
    let of = |name: String| {
        let at = names
            .iter()
            .position(|n| n.trim_matches('"').split(' ').next() == Some(&name));
        values[at.unwrap_or_else(|| panic!("no {name}: {names:?}"))]
            .parse()
            .unwrap()
    };
    let told = run.out.lines().find(|l| l.contains("are not unique"));
    (
        forces.map(of).collect(),
        told.unwrap_or_else(|| panic!("{}", run.out))
            .trim()
            .to_owned(),
    )
}

#[test]
fn all_commands_give_the_same_set_and_say_which() {
    let (inverse, note) = pins("inverse");
    let (kinematics, same) = pins("kinematics");
    assert_eq!(note, same);
    assert_eq!(
        note,
        "warning: redundant constraints: the reactions of A, B, C, D, E and F are not unique; the least set is \
         given (least sum of squares, forces times the size of the machine)"
    );
    let (simulate, same) = pins("simulate");
    assert_eq!(note, same);
    let run = dalembert(&["equations", &example(), "--json"]);
    let report = run.json();
    let multipliers = report["multipliers"]["values"].as_array().unwrap();
    let notes = report["notes"].as_array().unwrap();
    assert!(notes.iter().any(|n| n.as_str() == Some(&note)), "{notes:?}");
    // A pin's multiplier is its reaction; the motor's comes last.
    for (k, force) in inverse.iter().enumerate() {
        for (what, other) in [
            ("kinematics", kinematics[k]),
            ("simulate", simulate[k]),
            ("equations", multipliers[k].as_f64().unwrap()),
        ] {
            assert!(
                (force - other).abs() < 1e-9 * 6.0,
                "{what}, {k}: {other}, not {force}"
            );
        }
    }
}
