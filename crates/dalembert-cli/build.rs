//! Builds the animated pages with npm and hands them to the program (feature `viewer`).
//!
//! Everything happens in a copy of `viewer/` below OUT_DIR. Cargo never runs two builds on one
//! OUT_DIR at a time, so two builds can never disturb each other's `node_modules`, and the source
//! tree stays clean. Without Node.js the program is built all the same, with a warning; it then says
//! what is missing where the page is asked for.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, exit};
use std::{env, io};

/// What of `viewer/` the page is made of.
const SOURCES: [&str; 6] = [
    "package.json",
    "package-lock.json",
    ".npmrc",
    "build.mjs",
    "tsconfig.json",
    "src",
];

/// The oldest major version of Node.js that the page is built with.
const OLDEST_NODE: u32 = 18;

/// The pages that the build of the viewer writes: for planar and for spatial machines.
const PAGES: [&str; 2] = ["viewer.html", "viewer-spatial.html"];

const REMEDY: &str = "install Node.js 18 or newer with npm (https://nodejs.org), then run \
    `cargo clean -p dalembert-cli` and build again";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=PATH");
    println!("cargo::rustc-check-cfg=cfg(viewer_page)");
    if env::var_os("CARGO_FEATURE_VIEWER").is_none() {
        without_page(
            "the feature \"viewer\" was off; build it with `cargo build --features viewer`",
        );
        return;
    }
    // A machine without Node.js still gets the program: only the page is missing.
    if let Some(missing) = missing_tools() {
        let reason = format!("{missing}; {REMEDY}");
        println!("cargo::warning=the program is built without the animated page: {reason}");
        without_page(&reason);
        return;
    }
    match build_page() {
        Ok(()) => println!("cargo::rustc-cfg=viewer_page"),
        Err(error) => {
            for line in error.to_string().lines() {
                println!("cargo::error={line}");
            }
            println!(
                "cargo::error=To build the program without the animated page: \
                 cargo build --no-default-features"
            );
            exit(1);
        }
    }
}

/// Tells the program why it has no page; it says so where the page is asked for.
fn without_page(reason: &str) {
    println!("cargo::rustc-env=DALEMBERT_NO_PAGE={reason}");
}

/// What is missing to build the page, in one sentence; `None` if nothing is.
fn missing_tools() -> Option<String> {
    let Some(node) = version("node") else {
        return Some("Node.js was not found".to_owned());
    };
    let major = node
        .trim_start_matches('v')
        .split('.')
        .next()?
        .parse::<u32>();
    if major.is_ok_and(|major| major < OLDEST_NODE) {
        return Some(format!("Node.js {node} is too old"));
    }
    if version(NPM).is_none() {
        return Some("npm was not found".to_owned());
    }
    None
}

const NPM: &str = if cfg!(windows) { "npm.cmd" } else { "npm" };

/// The version that a program says it has; `None` if it cannot be run.
fn version(program: &str) -> Option<String> {
    let output = Command::new(program).arg("--version").output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).trim().to_owned();
    (output.status.success() && !text.is_empty()).then_some(text)
}

fn build_page() -> Result<(), Box<dyn Error>> {
    let out = PathBuf::from(env::var("OUT_DIR")?);
    let viewer = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?).join("../../viewer");
    let work = out.join("viewer");
    for source in SOURCES {
        let from = viewer.join(source);
        println!("cargo::rerun-if-changed={}", from.display());
        copy(&from, &work.join(source))
            .map_err(|error| format!("cannot copy {}: {error}", from.display()))?;
    }
    install(&work)?;
    npm(&work, &["run", "build"])?;
    for page in PAGES {
        fs::copy(work.join("dist").join(page), out.join(page))?;
    }
    Ok(())
}

/// Installs the packages of the lock file, unless exactly these are installed already.
fn install(work: &Path) -> Result<(), Box<dyn Error>> {
    let lock = fs::read(work.join("package-lock.json"))?;
    let installed = work.join("node_modules/.installed-lock.json");
    if fs::read(&installed).is_ok_and(|done| done == lock) {
        return Ok(());
    }
    // The development packages only check types and run tests.
    npm(
        work,
        &[
            "ci",
            "--omit=dev",
            "--prefer-offline",
            "--no-audit",
            "--no-fund",
        ],
    )?;
    // Written last: an installation that was cut off is done again.
    fs::write(&installed, lock)?;
    Ok(())
}

fn npm(work: &Path, arguments: &[&str]) -> Result<(), Box<dyn Error>> {
    let command = format!("npm {}", arguments.join(" "));
    let output = Command::new(NPM)
        .args(arguments)
        .current_dir(work)
        .output()
        .map_err(|error| format!("cannot run {command}: {error}"))?;
    if output.status.success() {
        return Ok(());
    }
    let said = [output.stdout, output.stderr].concat();
    Err(format!(
        "{command} failed in {}:\n{}",
        work.display(),
        String::from_utf8_lossy(&said)
    )
    .into())
}

/// Makes `to` the same as `from`; a file that was removed from a folder is removed from its copy.
fn copy(from: &Path, to: &Path) -> io::Result<()> {
    if !from.is_dir() {
        if let Some(folder) = to.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::copy(from, to)?;
        return Ok(());
    }
    if to.exists() {
        fs::remove_dir_all(to)?;
    }
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        copy(&entry.path(), &to.join(entry.file_name()))?;
    }
    Ok(())
}
