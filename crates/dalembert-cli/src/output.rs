//! Writing results and plots.

use crate::arguments::RunArgs;
use crate::failure::Failure;
use crate::load::{Loaded, beside};
use dalembert::results::{Channel, Results};
use dalembert::space::Space;
use dalembert_io::plot::{Plot, rounding_as_zero};
use dalembert_io::result_file::{Meta, select, write};
use std::path::{Path, PathBuf};

/// Writes what `--out`, `--plot` and `--html` ask for; returns the files written.
pub fn write_all<S: Space>(
    args: &RunArgs,
    loaded: &Loaded<S>,
    results: &Results,
) -> Result<Vec<PathBuf>, Failure> {
    let mut written = Vec::new();
    let patterns = if args.channels.is_empty() {
        &loaded.model.output.channels
    } else {
        &args.channels
    };
    let chosen = chosen(results, patterns)?;
    let meta = Meta::of_model_text(&loaded.text);
    for path in &args.out {
        write(path, &chosen, &meta).map_err(|e| Failure::File {
            path: path.clone(),
            cause: e.to_string(),
        })?;
        written.push(path.clone());
    }
    if let Some(patterns) = &args.plot {
        let patterns: Vec<String> = patterns.split(',').map(|p| p.trim().to_owned()).collect();
        let path = args.plot_file.clone().unwrap_or_else(|| {
            // Each command has a file of its own: none overwrites the plot of another.
            beside(&args.model.model, &format!("-{}.svg", results.analysis))
        });
        draw(results, &patterns, &path)?;
        written.push(path);
    }
    if let Some(path) = &args.html {
        crate::page::write(loaded, results, path)?;
        written.push(path.clone());
    }
    Ok(written)
}

/// The time and the chosen channels.
fn chosen(results: &Results, patterns: &[String]) -> Result<Results, Failure> {
    if patterns.is_empty() {
        return Ok(results.clone());
    }
    let picked = select(results, patterns).map_err(|e| Failure::Usage(e.to_string()))?;
    let mut out = results.clone();
    out.channels = results
        .channels
        .iter()
        .enumerate()
        .filter(|(k, c)| *k == 0 || picked.iter().any(|p| p.name == c.name))
        .map(|(_, c)| c.clone())
        .collect();
    Ok(out)
}

fn draw(results: &Results, patterns: &[String], path: &Path) -> Result<(), Failure> {
    let picked = select(results, patterns).map_err(|e| Failure::Usage(e.to_string()))?;
    let Some(time) = results.channels.first() else {
        return Err(Failure::Usage("there are no results to plot".to_owned()));
    };
    let drawn: Vec<Channel> = picked
        .iter()
        .map(|c| rounding_as_zero(c, results))
        .collect();
    let plot = Plot::of_channels(&results.model, time, &drawn.iter().collect::<Vec<_>>());
    write_text(path, &plot.to_svg())
}

/// Writes a text file.
pub fn write_text(path: &Path, text: &str) -> Result<(), Failure> {
    std::fs::write(path, text).map_err(|e| Failure::File {
        path: path.to_owned(),
        cause: format!("cannot be written: {e}"),
    })
}
