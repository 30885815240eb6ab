//! Runs the program on a model of the gallery and compares channels of its results.

use dalembert::results::Results;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Results of one run.
pub struct Run {
    label: String,
    results: Results,
}

/// The channels at one instant.
#[derive(Clone, Copy)]
pub struct Instant<'a> {
    run: &'a Run,
    index: usize,
}

impl Instant<'_> {
    /// Value of a channel.
    pub fn get(&self, channel: &str) -> f64 {
        self.run.channel(channel)[self.index]
    }

    /// Time [s].
    pub fn time(&self) -> f64 {
        self.get("time")
    }
}

impl Run {
    /// Runs `dalembert COMMAND examples/MODEL.toml OPTIONS` and reads the results.
    pub fn new(command: &str, model: &str, options: &[&str]) -> Self {
        let label = format!("{command} {model} {options:?}");
        let out = scratch_file(model);
        let answer = Command::new(env!("CARGO_BIN_EXE_dalembert"))
            .arg(command)
            .arg(example(model))
            .args(options)
            .arg("--out")
            .arg(&out)
            .output()
            .expect("the program starts");
        assert!(
            answer.status.success(),
            "{label}\n{}{}",
            String::from_utf8_lossy(&answer.stdout),
            String::from_utf8_lossy(&answer.stderr)
        );
        let results = dalembert_io::result_file::read(&out).expect("the results can be read");
        for file in [&out, &out.with_extension("json")] {
            let _ = std::fs::remove_file(file);
        }
        assert!(!results.is_empty(), "{label}: no results");
        Self { label, results }
    }

    /// All values of a channel.
    pub fn channel(&self, name: &str) -> &[f64] {
        let channel = self.results.channel(name);
        &channel
            .unwrap_or_else(|| panic!("{}: no channel '{name}'", self.label))
            .values
    }

    /// Every instant.
    pub fn instants(&self) -> impl Iterator<Item = Instant<'_>> {
        (0..self.results.len()).map(|index| Instant { run: self, index })
    }

    /// One instant, counted from the start.
    pub fn instant(&self, index: usize) -> Instant<'_> {
        assert!(
            index < self.results.len(),
            "{}: no instant {index}",
            self.label
        );
        Instant { run: self, index }
    }

    /// The last instant.
    pub fn last(&self) -> Instant<'_> {
        self.instant(self.results.len() - 1)
    }

    /// The instant at a time.
    pub fn at(&self, time: f64) -> Instant<'_> {
        let index = self
            .channel("time")
            .iter()
            .position(|t| (t - time).abs() <= 1e-12 * (1.0 + time.abs()))
            .unwrap_or_else(|| panic!("{}: no instant {time}", self.label));
        self.instant(index)
    }

    /// Something must hold at every instant, to an absolute tolerance.
    pub fn always(&self, what: &str, tolerance: f64, pair: impl Fn(Instant<'_>) -> (f64, f64)) {
        let (mut worst, mut report) = (0.0, String::new());
        for instant in self.instants() {
            let (found, expected) = pair(instant);
            let error = (found - expected).abs();
            assert!(
                error.is_finite(),
                "{}: {what}: found {found}, expected {expected}",
                self.label
            );
            if error > worst {
                worst = error;
                report = format!("at {} s found {found}, expected {expected}", instant.time());
            }
        }
        assert!(
            worst <= tolerance,
            "{}: {what}: {report}, off by {worst:.2e}, allowed {tolerance:.0e}",
            self.label
        );
    }

    /// A channel must follow a function of time.
    pub fn follows(&self, channel: &str, tolerance: f64, expected: impl Fn(f64) -> f64) {
        self.always(channel, tolerance, |i| (i.get(channel), expected(i.time())));
    }

    /// Largest size of a channel.
    pub fn largest(&self, channel: &str) -> f64 {
        self.channel(channel)
            .iter()
            .fold(0.0, |a, b| f64::max(a, b.abs()))
    }

    /// Smallest and largest value of a channel.
    pub fn range(&self, channel: &str) -> (f64, f64) {
        let values = self.channel(channel);
        (
            values.iter().copied().fold(f64::INFINITY, f64::min),
            values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        )
    }
}

/// Two numbers must agree to an absolute tolerance.
#[track_caller]
pub fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs();
    assert!(
        error <= tolerance,
        "{what}: found {found}, expected {expected}, off by {error:.2e}, allowed {tolerance:.0e}"
    );
}

/// Runs `dalembert COMMAND examples/MODEL.toml --json OPTIONS` and reads what it prints.
pub fn answer(command: &str, model: &str, options: &[&str]) -> serde_json::Value {
    let text = said(command, model, &[&["--json"], options].concat());
    serde_json::from_str(&text).expect("JSON")
}

/// What `dalembert COMMAND examples/MODEL.toml OPTIONS` prints.
pub fn said(command: &str, model: &str, options: &[&str]) -> String {
    let answer = Command::new(env!("CARGO_BIN_EXE_dalembert"))
        .arg(command)
        .arg(example(model))
        .args(options)
        .output()
        .expect("the program starts");
    assert!(
        answer.status.success(),
        "{command} {model}\n{}",
        String::from_utf8_lossy(&answer.stderr)
    );
    String::from_utf8(answer.stdout).expect("text")
}

/// Names of the gallery's models.
pub fn models() -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(examples())
        .expect("the folder of the examples")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .filter_map(|path| Some(path.file_stem()?.to_string_lossy().into_owned()))
        .collect();
    names.sort_unstable();
    names
}

/// Folder of the gallery's models.
pub fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

/// Path of a model of the gallery.
pub fn example(model: &str) -> PathBuf {
    examples().join(format!("{model}.toml"))
}

fn scratch_file(model: &str) -> PathBuf {
    // Tests run at the same time, and some of them run a model twice.
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join(format!("{model}-{}-{number}.csv", std::process::id()))
}
