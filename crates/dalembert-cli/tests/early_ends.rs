//! Runs that end early, and starts that were changed: what the user sees, and the exit code.

mod common;

use common::{Run, dalembert, folder};
use std::path::PathBuf;

const BLOCK: &str = r#"
[model]
name = "block"
gravity = [0, 0]
[[body]]
name = "block"
mass = 1
inertia = 0.1
position = [0.3, 0]
[[joint]]
name = "guide"
kind = "prismatic"
bodies = ["ground", "block"]
at = [[0, 0], [0, 0]]
angles = [0, 0]
"#;

/// Runs a command on a model of the given text.
fn run(test: &str, text: &str, command: &[&str]) -> (Run, PathBuf) {
    let folder = folder(test);
    let file = folder.join("model.toml");
    std::fs::write(&file, text).unwrap();
    let mut arguments = vec![command[0], file.to_str().unwrap()];
    let results = folder.join("results.csv");
    arguments.extend(["--out", results.to_str().unwrap()]);
    arguments.extend(&command[1..]);
    (dalembert(&arguments), results)
}

fn lines(file: &PathBuf) -> usize {
    std::fs::read_to_string(file).unwrap().lines().count()
}

#[test]
fn the_steps_of_a_model_file_end_a_simulation_with_its_results() {
    let text = format!(
        "{BLOCK}{}",
        r#"
[[force]]
name = "bumper"
kind = "spring-damper"
bodies = ["ground", "block"]
at = [[-1, 0], [0, 0]]
stiffness = 1e6
free_length = 1.29
[analysis]
end = 1
step = 0.001
max_steps = 300
"#
    );
    let (ended, results) = run("max-steps", &text, &["simulate"]);
    assert_eq!(ended.code, 1, "{}", ended.err);
    for part in [
        "after 300 steps",
        "'bumper' (spring-damper)",
        "max_steps, now 300",
    ] {
        assert!(ended.err.contains(part), "{part}: {}", ended.err);
    }
    let kept = lines(&results);
    assert!((10..1000).contains(&kept), "{kept} lines");

    let enough = text.replace("max_steps = 300", "max_steps = 30000");
    let (ended, results) = run("max-steps", &enough, &["simulate"]);
    assert_eq!((ended.code, ended.err.as_str()), (0, ""));
    assert!(lines(&results) > 1000);

    for (bad, told) in [
        ("max_steps = 0", "whole number from 1"),
        ("max_steps = \"many\"", "whole number"),
    ] {
        let (ended, _) = run(
            "max-steps",
            &text.replace("max_steps = 300", bad),
            &["simulate"],
        );
        assert_eq!(ended.code, 3);
        assert!(ended.err.contains(told), "{}", ended.err);
    }
}

#[test]
fn a_hopeless_stiff_run_ends_soon() {
    let text = format!(
        "{BLOCK}{}",
        r#"
[[force]]
name = "dashpot"
kind = "spring-damper"
bodies = ["ground", "block"]
at = [[-1, 0], [0, 0]]
damping = 1e9
"#
    ) + "[[force]]\nname = \"push\"\nkind = \"force\"\nbody = \"block\"\nvalue = [3, 0]\n[analysis]\nend = 10\n";
    let (ended, results) = run("stiff", &text, &["simulate", "--json"]);
    assert_eq!(ended.code, 1);
    let answer = ended.json();
    assert_eq!(answer["completed"], false);
    let error = answer["error"].as_str().unwrap();
    assert!(
        error.contains("stiff") && error.contains("'dashpot'"),
        "{error}"
    );
    assert!(results.exists());
}

#[test]
fn a_tiny_largest_step_is_refused() {
    let text = format!("{BLOCK}[analysis]\nend = 1\nmax_step = \"1e-9 s\"\n");
    let (ended, _) = run("max-step", &text, &["simulate"]);
    assert_eq!(ended.code, 1);
    assert!(
        ended.err.contains("max_step = 1e-9 s takes at least"),
        "{}",
        ended.err
    );
}

#[test]
fn points_that_meet_are_named_with_their_time() {
    let driver = r#"
[[driver]]
name = "winch"
kind = "distance"
bodies = ["ground", "block"]
at = [[0, 0], [0, 0]]
value = "0.3 m - 0.5 m/s * t"
[analysis]
step = 0.05
"#;
    for command in ["simulate", "kinematics", "inverse"] {
        let (ended, results) = run("winch", &format!("{BLOCK}{driver}"), &[command]);
        assert_eq!(ended.code, 1, "{command}");
        assert!(
            ended
                .err
                .contains("the two points of 'winch' (distance driver) meet")
                && (ended.err.contains("t = 0.6000") || ended.err.contains("t = 0.5999")),
            "{command}: {}",
            ended.err
        );
        assert!(lines(&results) > 10);
    }
    let spring = r#"
[[force]]
name = "rubber"
kind = "spring-damper"
bodies = ["ground", "block"]
at = [[0, 0], [0, 0]]
stiffness = 10
free_length = 0.1
"#;
    let (ended, _) = run("rubber", &format!("{BLOCK}{spring}"), &["simulate"]);
    assert_eq!(ended.code, 1);
    assert!(
        ended
            .err
            .contains("the two points of 'rubber' (spring-damper) meet"),
        "{}",
        ended.err
    );
    let free = spring.replace("free_length = 0.1", "free_length = 0");
    let (ended, _) = run("rubber", &format!("{BLOCK}{free}"), &["simulate"]);
    assert_eq!(ended.code, 0, "{}", ended.err);
}

#[test]
fn rates_that_contradict_are_refused() {
    let rates = "[[initial]]\nkind = \"displacement\"\njoint = \"guide\"\nrate = 2\n[[initial]]\nkind = \"coordinate\"\nbody = \"block\"\ncoordinate = \"x\"\nrate = 1\n";
    let text = format!("{BLOCK}{rates}");
    for command in ["check", "simulate"] {
        let file = folder("rates").join("model.toml");
        std::fs::write(&file, &text).unwrap();
        let ended = dalembert(&[command, file.to_str().unwrap()]);
        assert_eq!(ended.code, 1, "{}{}", ended.out, ended.err);
        let said = format!("{}{}", ended.out, ended.err);
        assert!(
            said.contains("cannot hold: stated ") && said.contains("the nearest that fits"),
            "{said}"
        );
    }
    let fitting = rates.replace("rate = 1", "rate = 2");
    let (ended, _) = run("rates", &format!("{BLOCK}{fitting}"), &["simulate"]);
    assert_eq!(ended.code, 0, "{}", ended.err);
    assert!(!ended.out.contains("warning"), "{}", ended.out);
}

/// Two driven wheels, tied by a gear: their drivers agree at the start only.
#[test]
fn drivers_that_part_ways_are_named() {
    let wheel = |name: &str, x: f64| {
        format!(
            "[[body]]\nname = \"{name}\"\nmass = 1\ninertia = 0.01\nposition = [{x}, 0]\n\
             [[joint]]\nname = \"pin {name}\"\nkind = \"revolute\"\nbodies = [\"ground\", \"{name}\"]\n\
             at = [[{x}, 0], [0, 0]]\n"
        )
    };
    let driver = |name: &str, joint: &str, value: &str| {
        format!(
            "[[driver]]\nname = \"{name}\"\nkind = \"angle\"\njoint = \"pin {joint}\"\nvalue = \"{value}\"\n"
        )
    };
    let gear =
        "[[joint]]\nname = \"mesh\"\nkind = \"gear\"\nbodies = [\"a\", \"b\"]\nradii = [1, 1]\n";
    let model = |second: &str| {
        format!(
            "[model]\nname = \"twice driven\"\n{}{}{gear}{}{}[analysis]\nend = 1\nstep = 0.5\n",
            wheel("a", 0.0),
            wheel("b", 0.3),
            driver("first", "a", "2 rad/s * t"),
            driver("second", "b", second),
        )
    };
    for command in ["kinematics", "simulate"] {
        let parting = model("-2 rad/s * t + 0.1 rad/s^2 * t^2");
        let (ended, results) = run("parting", &parting, &[command]);
        assert_eq!(ended.code, 1, "{}", ended.err);
        assert!(
            ended
                .err
                .contains("mesh, first and second contradict each other after t = 0 s"),
            "{}",
            ended.err
        );
        assert_eq!(lines(&results), 2);
        let (ended, _) = run("agreeing", &model("-2 rad/s * t"), &[command]);
        assert_eq!(ended.code, 0, "{}", ended.err);
    }
}

/// The equations at a later time stand at the pose that a rate has led to since the start: 0.2 + t^2 - 1 for 2 t from
/// 1 s on.
#[test]
fn equations_at_a_time_integrate_rates_from_the_start() {
    let text = "[model]\nname = \"rotor\"\ngravity = [0, 0]\n\
         [[body]]\nname = \"rotor\"\nmass = 1\ninertia = 0.1\n\
         [[joint]]\nname = \"axle\"\nkind = \"revolute\"\nbodies = [\"ground\", \"rotor\"]\nat = [[0, 0], [0, 0]]\n\
         [[driver]]\nname = \"motor\"\nkind = \"angle\"\njoint = \"axle\"\nrate = \"2 rad/s^2 * t\"\nstart = 0.2\n\
         [analysis]\nstart = \"1 s\"\nend = \"3 s\"\n";
    let file = folder("equations-at-a-time").join("model.toml");
    std::fs::write(&file, text).unwrap();
    for (time, expected) in [("1", 0.2), ("2 s", 3.2), ("5", 24.2), ("500 ms", -0.55)] {
        let run = dalembert(&[
            "equations",
            file.to_str().unwrap(),
            "--json",
            "--time",
            time,
        ]);
        assert_eq!(run.code, 0, "{}", run.err);
        let report: serde_json::Value = serde_json::from_str(&run.out).unwrap();
        let q: Vec<f64> = serde_json::from_value(report["positions"]["values"].clone()).unwrap();
        assert!((q[2] - expected).abs() < 1e-12, "{time}: {q:?}");
    }
}

/// Options that would do nothing are refused.
#[test]
fn options_without_use_are_refused() {
    let file = folder("no-use").join("model.toml");
    std::fs::write(&file, BLOCK).unwrap();
    for (command, option, value) in [
        ("statics", "--end", "5"),
        ("statics", "--step", "0.1"),
        ("statics", "--tolerance", "1e-3"),
        ("kinematics", "--tolerance", "1e-3"),
        ("inverse", "--tolerance", "1e-3"),
    ] {
        let ended = dalembert(&[command, file.to_str().unwrap(), option, value]);
        assert_eq!(ended.code, 2, "{}", ended.err);
        let expected = format!("{command} has no use for {option}");
        assert!(ended.err.contains(&expected), "{}", ended.err);
    }
}

/// Rodriguez parameters are infinite at half a turn: the run keeps everything else, and says so.
#[test]
fn coordinates_that_are_infinite_leave_gaps() {
    let model = r#"
[model]
name = "half turn"
space = "spatial"
gravity = [0, 0, 0]
[[body]]
name = "b"
mass = 1
inertia = [1, 2, 3]
orientation = { euler_parameters = [0, 1, 0, 0] }
angular_velocity = [1, 0, 0]
[analysis]
end = 1
step = 0.5
[output]
orientation = "rodriguez"
"#;
    let folder = folder("half-turn");
    let file = folder.join("model.toml");
    std::fs::write(&file, model).unwrap();
    for name in ["r.csv", "j.json", "n.npz"] {
        let results = folder.join(name);
        let page = folder.join("page.html");
        let path = |p: &PathBuf| p.to_str().unwrap().to_owned();
        let run = dalembert(&["simulate", &path(&file), "--out", &path(&results)]);
        assert_eq!(run.code, 0, "{}", run.err);
        assert!(run.out.contains("singular in rodriguez"), "{}", run.out);
        let read = dalembert_io::result_file::read(&results).unwrap();
        let g = &read.channel("b.g1").unwrap().values;
        assert!(
            g[0].is_nan() && g[1].is_finite() && g[2].is_finite(),
            "{g:?}"
        );
        // tan of half the turn, half a radian and a radian beyond half a turn.
        assert!((g[2] + 1.0 / 0.5_f64.tan()).abs() < 1e-6, "{g:?}");
        let svg = folder.join("g.svg");
        let plot = dalembert(&["plot", &path(&results), "b.g1", "--out", &path(&svg)]);
        assert_eq!(plot.code, 0, "{}", plot.err);
        let view = dalembert(&["view", &path(&file), "--html", &path(&page)]);
        assert_eq!(view.code, 0, "{}", view.err);
    }
    let csv = std::fs::read_to_string(folder.join("r.csv")).unwrap();
    assert!(csv.lines().nth(1).unwrap().contains(",,"), "{csv}");
}
