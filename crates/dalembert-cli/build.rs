//! Builds the animated page with npm and hands it to the program (feature `viewer`).
//!
//! Everything happens in a copy of `viewer/` below OUT_DIR. Cargo never runs two builds on one
//! OUT_DIR at a time, so two builds can never disturb each other's `node_modules`, and the source
//! tree stays clean.

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

const NO_NPM: &str = "npm was not found. The animated page needs it: \
    install Node.js 18 or newer (https://nodejs.org), of which npm is a part.";

const WITHOUT: &str =
    "To build the program without the animated page: cargo build --no-default-features";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if env::var_os("CARGO_FEATURE_VIEWER").is_none() {
        return;
    }
    if let Err(error) = build_page() {
        for line in error.to_string().lines() {
            println!("cargo::error={line}");
        }
        println!("cargo::error={WITHOUT}");
        exit(1);
    }
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
    fs::copy(work.join("dist/viewer.html"), out.join("viewer.html"))?;
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
    let program = if cfg!(windows) { "npm.cmd" } else { "npm" };
    let command = format!("npm {}", arguments.join(" "));
    let output = Command::new(program)
        .args(arguments)
        .current_dir(work)
        .output()
        .map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => NO_NPM.to_owned(),
            _ => format!("cannot run {command}: {error}"),
        })?;
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
