//! All mistakes of a model file are reported in one run, for people and for programs.

mod common;

use common::{dalembert, model};

/// Code, line and column of every mistake in the model, in the order of the file.
const MISTAKES: [(&str, u64, u64); 10] = [
    ("parameter-cycle", 6, 5),
    ("negative-mass", 12, 8),
    ("unit-mismatch", 13, 12),
    ("unknown-unit", 14, 17),
    ("unknown-key", 18, 1),
    ("unknown-kind", 23, 8),
    ("unknown-body", 24, 21),
    ("wrong-length", 25, 15),
    ("unknown-joint", 36, 9),
    ("unexpected-end", 37, 31),
];

#[test]
fn every_mistake_is_told_to_people() {
    let run = dalembert(&["simulate", &model("mistakes.toml")]);
    assert_eq!(run.code, 3);
    assert_eq!(run.out, "");
    let told = run.err.matches("error[").count();
    assert_eq!(told, MISTAKES.len(), "{}", run.err);
    for (code, line, column) in MISTAKES {
        assert!(
            run.err.contains(&format!("error[{code}]")),
            "{code}: {}",
            run.err
        );
        let place = format!("mistakes.toml:{line}:{column}");
        assert!(run.err.contains(&place), "{code} at {place}: {}", run.err);
    }
    for remedy in [
        "did you mean `mass`?",
        "did you mean `revolute`?",
        "did you mean \"rod\"?",
        "a -> b -> a",
    ] {
        assert!(run.err.contains(remedy), "{remedy}: {}", run.err);
    }
}

#[test]
fn every_mistake_is_told_to_programs() {
    let run = dalembert(&["kinematics", &model("mistakes.toml"), "--json"]);
    assert_eq!(run.code, 3);
    assert_eq!(run.err, "");
    let answer = run.json();
    assert_eq!(answer["completed"], false);
    let found: Vec<(&str, u64, u64)> = answer["diagnostics"]
        .as_array()
        .unwrap()
        .iter()
        .map(|d| {
            let number = |key: &str| d[key].as_u64().unwrap();
            (
                d["code"].as_str().unwrap(),
                number("line"),
                number("column"),
            )
        })
        .collect();
    assert_eq!(found, MISTAKES);
}

#[test]
fn other_failures_are_json_too() {
    let run = dalembert(&["simulate", &model("nowhere.toml"), "--json"]);
    assert_eq!((run.code, run.err.as_str()), (4, ""));
    let error = run.json()["error"].as_str().unwrap().to_owned();
    assert!(
        error.contains("nowhere.toml") && !error.starts_with("error"),
        "{error}"
    );

    let run = dalembert(&[
        "simulate",
        &model("pendulum.toml"),
        "--json",
        "--set",
        "length",
    ]);
    assert_eq!((run.code, run.err.as_str()), (2, ""));
    assert!(run.json()["error"].as_str().unwrap().contains("--set"));

    // A pendulum is not driven: kinematics cannot move it.
    let run = dalembert(&["kinematics", &model("pendulum.toml"), "--json"]);
    assert_eq!((run.code, run.err.as_str()), (1, ""));
    assert_eq!(run.json()["completed"], false);

    let run = dalembert(&["simulate", &model("nowhere.toml")]);
    assert_eq!((run.code, run.out.as_str()), (4, ""));
    assert!(run.err.starts_with("error: "), "{}", run.err);
}

#[test]
fn warnings_are_in_the_results() {
    let run = dalembert(&["simulate", &model("pendulum.toml"), "--json"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let answer = run.json();
    assert_eq!(answer["completed"], true);
    assert_eq!(answer["error"], serde_json::Value::Null);
    assert_eq!(answer["diagnostics"][0]["code"], "no-effect");
    assert_eq!(answer["diagnostics"][0]["severity"], "warning");
}
