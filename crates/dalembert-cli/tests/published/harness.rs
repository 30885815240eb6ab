//! Runs the program on a model file and compares channels of its results at given instants.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Results of one run, and what missed its expected value so far.
pub struct Run {
    columns: HashMap<String, Vec<f64>>,
    compared: usize,
    misses: Vec<String>,
}

/// Runs `dalembert COMMAND cases/MODEL OPTIONS` and lets `check` compare; fails with the list of
/// every value that missed.
///
/// Options are separated by `;`: `crank=2` sets a parameter, `--end 3` is an option of the program.
pub fn published(command: &str, model: &str, options: &str, check: impl FnOnce(&mut Run)) {
    let mut run = Run {
        columns: results(command, model, options),
        compared: 0,
        misses: Vec::new(),
    };
    check(&mut run);
    assert!(run.compared > 0, "{model}: nothing was compared");
    assert!(
        run.misses.is_empty(),
        "{model}: {} of {} values missed\n{}",
        run.misses.len(),
        run.compared,
        run.misses.join("\n")
    );
}

impl Run {
    /// Value of a channel at an instant of the results.
    pub fn at(&self, time: f64, channel: &str) -> f64 {
        let times = self.channel("time");
        let row = times
            .iter()
            .position(|t| (t - time).abs() <= 1e-12 * (1.0 + time.abs()))
            .unwrap_or_else(|| panic!("no instant {time} among {times:?}"));
        self.channel(channel)[row]
    }

    /// All values of a channel.
    pub fn channel(&self, name: &str) -> &[f64] {
        self.columns.get(name).unwrap_or_else(|| {
            let mut names: Vec<&str> = self.columns.keys().map(String::as_str).collect();
            names.sort_unstable();
            panic!("no channel '{name}'; there are: {}", names.join(", "))
        })
    }

    /// A channel must have a value to an absolute tolerance.
    pub fn near(&mut self, time: f64, channel: &str, expected: f64, tolerance: f64) {
        let found = self.at(time, channel);
        self.same(
            &format!("{channel} at {time} s"),
            found,
            expected,
            tolerance,
        );
    }

    /// A channel must have a value in the first row.
    pub fn first(&mut self, channel: &str, expected: f64, tolerance: f64) {
        let found = self.channel(channel)[0];
        self.same(
            &format!("{channel} in the first row"),
            found,
            expected,
            tolerance,
        );
    }

    /// Channels of one owner at one instant, all to the same absolute tolerance.
    pub fn all(&mut self, time: f64, owner: &str, expected: &[(&str, f64)], tolerance: f64) {
        for (suffix, value) in expected {
            self.near(time, &format!("{owner}.{suffix}"), *value, tolerance);
        }
    }

    /// A number made of channels must have a value to an absolute tolerance.
    pub fn same(&mut self, what: &str, found: f64, expected: f64, tolerance: f64) {
        self.compared += 1;
        let error = (found - expected).abs();
        // Written so that a NaN is a miss.
        if error.is_nan() || error > tolerance {
            self.misses.push(format!(
                "  {what}: found {found}, expected {expected}, off by {error:.3e}, allowed {tolerance:.1e}"
            ));
        }
    }
}

fn arguments(options: &str) -> Vec<String> {
    let mut arguments = Vec::new();
    for option in options.split(';').map(str::trim).filter(|o| !o.is_empty()) {
        if option.starts_with("--") {
            arguments.extend(option.splitn(2, ' ').map(str::to_owned));
        } else {
            arguments.extend(["--set".to_owned(), option.to_owned()]);
        }
    }
    arguments
}

fn results(command: &str, model: &str, options: &str) -> HashMap<String, Vec<f64>> {
    let out = scratch_file(model);
    let mut arguments = arguments(options);
    arguments.extend(["--out".to_owned(), out.display().to_string()]);
    succeeded(command, &model_file(model), &arguments);
    let text = std::fs::read_to_string(&out).expect("the results were written");
    // One file a run; nothing else reads it.
    for file in [&out, &out.with_extension("json")] {
        let _ = std::fs::remove_file(file);
    }
    columns(&text)
}

/// What the program answers with `--json`.
pub fn answer(command: &str, model: &str, options: &str) -> serde_json::Value {
    answer_about(command, &model_file(model), options)
}

/// The same for any model file.
pub fn answer_about(command: &str, file: &Path, options: &str) -> serde_json::Value {
    let mut arguments = arguments(options);
    arguments.push("--json".to_owned());
    let text = succeeded(command, file, &arguments);
    serde_json::from_str(&text).expect("the answer is JSON")
}

/// What the program prints for people.
pub fn told(command: &str, model: &str, options: &str) -> String {
    succeeded(command, &model_file(model), &arguments(options))
}

/// What the program says where it must fail.
pub fn refused(command: &str, model: &str, options: &str) -> String {
    let output = run(command, &model_file(model), &arguments(options));
    assert!(
        !output.status.success(),
        "dalembert {command} {model} {options} should fail\n{}",
        String::from_utf8_lossy(&output.stdout)
    );
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn succeeded(command: &str, file: &Path, arguments: &[String]) -> String {
    let output = run(command, file, arguments);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(
        output.status.success(),
        "dalembert {command} {} {arguments:?}\n{text}{}",
        file.display(),
        String::from_utf8_lossy(&output.stderr)
    );
    text
}

fn run(command: &str, file: &Path, arguments: &[String]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_dalembert"))
        .arg(command)
        .arg(file)
        .args(arguments)
        .output()
        .expect("the program starts")
}

/// Path of a model file of the cases.
fn model_file(model: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/cases")
        .join(model)
}

/// A file of this run alone, for the time of a test.
pub fn scratch_file(model: &str) -> PathBuf {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join(format!("{model}-{}-{number}.csv", std::process::id()))
}

/// Columns of a CSV file by name, without the units in the headings.
fn columns(text: &str) -> HashMap<String, Vec<f64>> {
    let mut lines = text.lines();
    let names: Vec<String> = lines
        .next()
        .expect("a heading")
        .split(',')
        .map(|h| h.split(" [").next().unwrap_or(h).to_owned())
        .collect();
    let mut columns = vec![Vec::new(); names.len()];
    for line in lines {
        for (column, field) in columns.iter_mut().zip(line.split(',')) {
            column.push(field.parse().expect("a number"));
        }
    }
    names.into_iter().zip(columns).collect()
}

/// Numbers of a table of expected values; its first line says what the columns are.
pub fn table<const N: usize>(name: &str) -> Vec<[f64; N]> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/published/tables")
        .join(name);
    let text = std::fs::read_to_string(&path).expect("the table is there");
    text.lines()
        .skip(1)
        .map(|line| {
            let row: Vec<f64> = line
                .split(',')
                .map(|field| field.parse().expect("a number"))
                .collect();
            row.try_into().expect("as many numbers as the heading says")
        })
        .collect()
}
