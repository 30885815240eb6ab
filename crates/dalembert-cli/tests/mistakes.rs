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

/// A pendulum of 18 lines, into which tests write their mistakes.
const PENDULUM: &str = r#"[model]
name = "P"
[parameters]
l = "0.5 m"
[[body]]
name = "rod"
mass = "1 kg"
inertia = "0.1 kg*m^2"
position = ["l", 0]
[[joint]]
name = "pin"
kind = "revolute"
bodies = ["ground", "rod"]
at = [[0, 0], ["-l", 0]]
[analysis]
end = "0.1 s"
step = "10 ms"
"#;

/// One thing that a new user gets wrong: text in the pendulum, what stands there instead, then
/// code, line and column of the only message.
type Mistake = (
    &'static str,
    &'static str,
    &'static str,
    &'static str,
    u64,
    u64,
);

const OF_NEW_USERS: [Mistake; 26] = [
    ("key", "inertia =", "intertia =", "unknown-key", 8, 1),
    ("word", "\"1 kg\"", "\"heavy\"", "unknown-name", 7, 9),
    ("truth", "\"1 kg\"", "true", "wrong-type", 7, 8),
    ("no quotes", "\"1 kg\"", "1 kg", "toml-syntax", 7, 8),
    ("other unit", "\"1 kg\"", "\"1 m\"", "unit-mismatch", 7, 9),
    ("infinite", "\"1 kg\"", "inf", "not-finite", 7, 8),
    ("no number", "\"1 kg\"", "nan", "not-finite", 7, 8),
    ("too large", "\"1 kg\"", "1e400", "not-finite", 7, 8),
    ("empty", "\"1 kg\"", "\"\"", "empty-text", 7, 8),
    (
        "tabs",
        "mass = \"1 kg\"",
        "\tmass\t=\t\"1 kgg\"",
        "unknown-unit",
        7,
        12,
    ),
    (
        "same body",
        "\"ground\", \"rod\"",
        "\"rod\", \"rod\"",
        "same-body",
        13,
        10,
    ),
    (
        "ground twice",
        "\"ground\", \"rod\"",
        "\"ground\", \"ground\"",
        "same-body",
        13,
        10,
    ),
    ("space", "[[0, 0],", "[[0, 0, 0],", "wrong-length", 14, 7),
    (
        "flat",
        "[[0, 0], [\"-l\", 0]]",
        "[[0, 0], 0]",
        "wrong-type",
        14,
        15,
    ),
    ("circle", "\"0.5 m\"", "\"l + 1\"", "parameter-cycle", 4, 5),
    ("zero", "\"0.5 m\"", "\"1/0\"", "division-by-zero", 4, 6),
    ("decimal comma", "\"0.5 m\"", "0,5", "toml-syntax", 4, 6),
    (
        "twice",
        "mass =",
        "name = \"x\"\nmass =",
        "toml-syntax",
        7,
        1,
    ),
    ("brackets", "[[body]]", "[body]", "wrong-type", 5, 1),
    (
        "section",
        "[parameters]",
        "[parameter]",
        "unknown-key",
        3,
        2,
    ),
    ("kind", "kind = \"revolute\"\n", "", "missing-key", 10, 1),
    ("backwards", "\"0.1 s\"", "\"-1 s\"", "bad-option", 16, 7),
    ("no step", "\"10 ms\"", "0", "bad-option", 17, 8),
    (
        "degrees",
        "mass =",
        "angle = \"30°\"\nmass =",
        "unexpected-character",
        7,
        12,
    ),
    (
        "unknown method",
        "step =",
        "method = \"euler\"\nstep =",
        "unknown-key",
        17,
        1,
    ),
    (
        "part of a mass",
        "[\"l\", 0]",
        "[\"1 kg/1 m/2\", 0]",
        "doubtful-unit",
        9,
        14,
    ),
];

#[test]
fn mistakes_of_new_users_have_a_place_and_a_remedy() {
    let folder = common::folder("new-users");
    for (what, good, bad, code, line, column) in OF_NEW_USERS {
        assert!(PENDULUM.contains(good), "{what}");
        let file = folder.join(format!("{what}.toml"));
        // The other line ends of another system change nothing.
        let ends = if what.len() % 2 == 0 { "\n" } else { "\r\n" };
        let text = PENDULUM.replacen(good, bad, 1).replace('\n', ends);
        std::fs::write(&file, text).unwrap();
        for command in [
            "check",
            "simulate",
            "kinematics",
            "statics",
            "equations",
            "network",
        ] {
            // A warning does not stop an analysis, and a pendulum without motor has no kinematics.
            if code == "doubtful-unit" && command == "kinematics" {
                continue;
            }
            let run = dalembert(&[command, &file.display().to_string(), "--json"]);
            let diagnostics = run.json()["diagnostics"].clone();
            let list = diagnostics
                .as_array()
                .unwrap_or_else(|| panic!("{what}: {}", run.out));
            assert_eq!(list.len(), 1, "{what}: {list:?}");
            let d = &list[0];
            assert_eq!(d["code"], code, "{what}: {d}");
            assert_eq!(
                (d["line"].as_u64(), d["column"].as_u64()),
                (Some(line), Some(column)),
                "{what}: {d}"
            );
            assert!(
                d["help"].as_str().is_some_and(|h| !h.is_empty()),
                "{what}: {d}"
            );
            if d["severity"] == "error" {
                assert_eq!(run.code, 3, "{what}");
            }
        }
    }
}

#[test]
fn files_that_are_no_text_are_refused_with_the_place() {
    let folder = common::folder("no-text");
    let file = folder.join("latin.toml");
    std::fs::write(&file, b"[model]\nname = \"Pr\xfcfung\"\n").unwrap();
    let run = dalembert(&["check", &file.display().to_string()]);
    assert_eq!(run.code, 4);
    assert!(
        run.err.contains("line 2, column 11 holds the byte 0xfc"),
        "{}",
        run.err
    );

    // A mark of byte order is no mistake.
    let file = folder.join("mark.toml");
    std::fs::write(&file, format!("\u{feff}{PENDULUM}")).unwrap();
    assert_eq!(dalembert(&["check", &file.display().to_string()]).code, 0);
}

#[test]
fn a_parameter_keeps_its_dimension() {
    let folder = common::folder("set");
    let file = folder.join("p.toml");
    let text = PENDULUM.replace(
        "l = \"0.5 m\"",
        "l = \"2*half\"\nhalf = \"0.25 m\"\nfree = 3",
    );
    std::fs::write(&file, text).unwrap();
    let file = file.display().to_string();
    let set = |value: &str| dalembert(&["check", &file, "--set", value]);
    for value in ["half=3 kg", "half=30 deg", "half=3 kg/2"] {
        let run = set(value);
        let told = "--set half: parameter 'half': this must be a length (m), but it";
        if value.ends_with("/2") {
            // Only likely to be a mistake: a warning.
            assert_eq!(run.code, 0, "{}", run.err);
            assert!(run.err.contains("doubtful-unit"), "{}", run.err);
        } else {
            assert_eq!(run.code, 2, "{value}: {}", run.err);
            assert!(run.err.contains(told), "{value}: {}", run.err);
        }
    }
    for value in [
        "half=300 mm",
        "half=0.3",
        "half=0.1 + 0.2",
        "free=2 kg",
        "l=1",
    ] {
        let run = set(value);
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{value}");
    }
    // A bare number becomes a length here, and is seen as one.
    let text = PENDULUM.replace("mass = \"1 kg\"", "mass = \"l\"");
    std::fs::write(&file, text).unwrap();
    let run = set("l=2");
    assert!(
        run.err
            .contains("this must be a mass (kg), but it is a length (m)"),
        "{}",
        run.err
    );
}

#[test]
fn tables_are_blamed_where_they_are_wrong() {
    let folder = common::folder("tables");
    std::fs::write(folder.join("lift.csv"), "x,y\n0,0\n1,1\n2,3\n").unwrap();
    let driver =
        "[[driver]]\nname = \"m\"\nkind = \"angle\"\njoint = \"pin\"\nvalue = \"lift(t)\"\n";
    let file = folder.join("t.toml");
    for (table, code, line, column) in [
        (
            "[[table]]\nname = \"lift\"\nfile = \"lift.csv\"\ncolumns = [1, 5]\n",
            "csv",
            21,
            15,
        ),
        (
            "[[table]]\nname = \"lift\"\nfile = \"nowhere.csv\"\n",
            "csv",
            20,
            8,
        ),
        (
            "[[table]]\nname = \"lift\"\nx = [0, 1]\ny = [0]\n",
            "wrong-length",
            21,
            5,
        ),
        ("[[table]]\nx = [0, 1]\ny = [0, 2]\n", "missing-key", 18, 1),
        (
            "[[table]]\nname = \"li-ft\"\nx = [0, 1]\ny = [0, 2]\n",
            "bad-name",
            19,
            8,
        ),
        (
            "[[tables]]\nname = \"lift\"\nx = [0, 1]\ny = [0, 2]\n",
            "unknown-key",
            18,
            3,
        ),
    ] {
        std::fs::write(&file, format!("{PENDULUM}{table}{driver}")).unwrap();
        let run = dalembert(&["check", &file.display().to_string(), "--json"]);
        assert_eq!(run.code, 3);
        let answer = run.json();
        let list = answer["diagnostics"].as_array().unwrap();
        assert_eq!(list.len(), 1, "{table}: {list:?}");
        let d = &list[0];
        assert_eq!(d["code"], code, "{d}");
        assert_eq!(
            (d["line"].as_u64(), d["column"].as_u64()),
            (Some(line), Some(column)),
            "{d}"
        );
        assert!(d["help"].is_string(), "{d}");
    }
}

#[test]
fn files_to_write_and_to_plot_are_looked_at() {
    let folder = common::folder("files");
    let out = folder.join("a.csv").display().to_string();
    let run = dalembert(&["simulate", &model("pendulum.toml"), "-o", &out, "-o", &out]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("named twice"), "{}", run.err);

    let empty = folder.join("empty.csv");
    std::fs::write(&empty, "time,rod.angle\n").unwrap();
    let run = dalembert(&["plot", &empty.display().to_string(), "rod.angle"]);
    assert_eq!(run.code, 4);
    assert!(run.err.contains("no rows"), "{}", run.err);
    assert!(!folder.join("empty.svg").exists());

    let full = folder.join("full.csv");
    std::fs::write(&full, "time,rod.x,rod.y\n0,1,2\n1,2,3\n").unwrap();
    let full = full.display().to_string();
    let run = dalembert(&["plot", &full, "rod.y", "--against", "rod.*"]);
    assert_eq!(run.code, 2);
    assert!(
        run.err.contains("2 channels match") && run.err.contains("rod.x, rod.y"),
        "{}",
        run.err
    );
    let run = dalembert(&[
        "plot",
        &full,
        "rod.y",
        "--against",
        "rod.?",
        "--against",
        "rod.x",
    ]);
    assert_eq!(run.code, 2);
    assert_eq!(
        dalembert(&["plot", &full, "rod.y", "--against", "*.x"]).code,
        0
    );
}

#[test]
fn what_has_mass_but_no_inertia_is_warned_of() {
    let folder = common::folder("no-resistance");
    let file = folder.join("m.toml").display().to_string();
    let check = |inertia: &str| {
        let text = PENDULUM.replace("inertia = \"0.1 kg*m^2\"\n", inertia);
        std::fs::write(&file, text).unwrap();
        dalembert(&["check", &file])
    };
    let run = check("");
    assert_eq!(run.code, 0);
    for told in [
        "warning[no-inertia]: body 'rod': it has mass but no inertia",
        "m.toml:5:1",
        "inertia = 0 if it is meant",
    ] {
        assert!(run.err.contains(told), "{told}: {}", run.err);
    }
    for meant in ["inertia = 0\n", "fixed = true\n"] {
        assert!(!check(meant).err.contains("no-inertia"), "{meant}");
    }
}

#[test]
fn a_body_without_mass_beside_others_is_told_by_check() {
    let folder = common::folder("no-mass");
    let file = folder.join("m.toml").display().to_string();
    let told = |text: &str| {
        std::fs::write(&file, text).unwrap();
        let run = dalembert(&["check", &file]);
        assert_eq!(run.code, 0, "{}", run.err);
        run.out.contains("warning: no mass is given for rod")
    };
    let second = "[[body]]\nname = \"b\"\nmass = 1\ninertia = 1\n";
    let without = PENDULUM.replace("mass = \"1 kg\"\ninertia = \"0.1 kg*m^2\"\n", "");
    assert!(told(&format!("{without}{second}")));
    // Without any mass only the geometry is asked for.
    assert!(!told(&without));
    assert!(!told(&format!("{PENDULUM}{second}")));
}

#[test]
fn statics_says_that_it_has_nothing_to_plot_over() {
    let run = dalembert(&["statics", &model("pendulum.toml"), "--plot", "rod.angle"]);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    assert!(run.err.contains("--out FILE"), "{}", run.err);
}

#[test]
fn plots_of_two_commands_have_two_files() {
    let folder = common::folder("two-plots");
    let file = folder.join("m.toml").display().to_string();
    let driver = "[[driver]]\nname = \"d\"\nkind = \"angle\"\njoint = \"pin\"\nrate = 3\n";
    std::fs::write(&file, format!("{PENDULUM}{driver}")).unwrap();
    for command in ["kinematics", "inverse", "simulate"] {
        let run = dalembert(&[command, &file, "--plot", "rod.angle"]);
        assert_eq!(run.code, 0, "{}", run.err);
        assert!(
            folder.join(format!("m-{command}.svg")).exists(),
            "{command}"
        );
    }
}
