//! What the program prints after an analysis.

use dalembert::analysis::AssemblyReport;
use dalembert::results::{Channel, Results};
use dalembert::space::Space;
use dalembert::words::counted;
pub use dalembert::words::readable as number;
use std::path::PathBuf;

/// What the assembly changed, in words; empty where it changed nothing.
pub fn assembly(report: &AssemblyReport) -> Vec<String> {
    let mut lines = Vec::new();
    for m in report.moved.iter().take(4) {
        let mut parts = Vec::new();
        if m.distance > 1e-9 {
            parts.push(format!("{} m", number(m.distance)));
        }
        if m.turn > 1e-9 {
            parts.push(format!("{} deg", number(m.turn.to_degrees())));
        }
        lines.push(format!(
            "assembly moved {} by {}",
            m.body,
            parts.join(" and ")
        ));
    }
    if report.moved.len() > 4 {
        lines.push(match report.moved.len() - 4 {
            1 => "assembly moved 1 more body".to_owned(),
            more => format!("assembly moved {more} more bodies"),
        });
    }
    lines.extend(
        report
            .rates_changed
            .iter()
            .map(|rate| format!("warning: {rate}")),
    );
    lines.extend(
        report
            .velocity_conflict
            .iter()
            .map(|t| format!("warning: {t}")),
    );
    lines
}

/// Most channels of a summary.
const MOST_ROWS: usize = 24;

/// Smallest and largest value of a channel.
fn extent(c: &Channel) -> (f64, f64) {
    c.values
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(*x), high.max(*x))
        })
}

/// A table of the most telling channels: first and last value, smallest and largest.
pub fn table(results: &Results) -> String {
    let own = |name: &str| name.matches('.').count() == 1 && !name.starts_with("momentum");
    let last = |name: &str| name.rsplit('.').next().unwrap_or(name).to_owned();
    let telling = |c: &Channel| {
        let places = ["displacement", "moment", "force", "length", "x", "y", "z"];
        own(&c.name) && (c.unit == "rad" || places.contains(&last(&c.name).as_str()))
    };
    let mut out = String::new();
    // Channels that stay zero say nothing here; values that are rounding beside them are zero.
    let largest = |c: &Channel| c.values.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    let mut rows: Vec<_> = results
        .channels
        .iter()
        .filter(|c| telling(c) && largest(c) > 1e-12)
        .collect();
    if rows.is_empty() {
        // Bodies that only turn.
        let spins = |c: &&Channel| own(&c.name) && last(&c.name).starts_with("omega");
        let turning = results.channels.iter().filter(spins);
        rows = turning.filter(|c| largest(c) > 1e-12).collect();
    }
    let all = rows.len();
    if all > MOST_ROWS {
        // Of many, places that stay where they are say least, and then places at all.
        let place = |c: &Channel| {
            c.name.ends_with(".x") || c.name.ends_with(".y") || c.name.ends_with(".z")
        };
        let stays = |c: &Channel| {
            let (low, high) = extent(c);
            high - low <= 1e-10 * largest(c)
        };
        rows.retain(|c| !(place(c) && stays(c)));
        // Who asks for the inverse problem asks for efforts.
        let effort = |c: &Channel| {
            results.analysis == "inverse"
                && (c.name.ends_with(".force") || c.name.ends_with(".moment"))
        };
        rows.sort_by_key(|c| (!effort(c), place(c)));
        rows.truncate(MOST_ROWS);
    }
    let shown = rows.len();
    let width = rows
        .iter()
        .map(|c| c.name.chars().count())
        .max()
        .unwrap_or(8)
        .max(8);
    out.push_str(&format!(
        "  {:width$}  {:>13} {:>13} {:>13} {:>13}  unit\n",
        "channel", "start", "end", "smallest", "largest"
    ));
    for c in rows {
        let (Some(first), Some(last)) = (c.values.first(), c.values.last()) else {
            continue;
        };
        let rounding = 1e-10 * largest(c);
        let number = |x: f64| number(if x.abs() < rounding { 0.0 } else { x });
        let (low, high) = extent(c);
        out.push_str(&format!(
            "  {:width$}  {:>13} {:>13} {:>13} {:>13}  {}\n",
            c.name,
            number(*first),
            number(*last),
            number(low),
            number(high),
            c.unit
        ));
    }
    if all > shown {
        out.push_str(&format!("  and {} more\n", all - shown));
    }
    out
}

/// The channels that measure the error of a run, each with its largest size.
pub fn errors(results: &Results) -> Vec<(&Channel, f64)> {
    ["energy.balance", "violation.position", "violation.velocity"]
        .into_iter()
        .filter_map(|name| results.channel(name))
        .map(|c| (c, c.values.iter().fold(0.0_f64, |a, b| a.max(b.abs()))))
        .collect()
}

/// Prints a note, or a warning as such.
pub fn tell(note: &str) {
    if note.starts_with("warning: ") {
        say!("  {note}");
    } else {
        say!("  note: {note}");
    }
}

/// "written: a.csv, b.svg".
pub fn files(written: &[PathBuf]) -> String {
    let names: Vec<String> = written.iter().map(|p| p.display().to_string()).collect();
    format!("written: {}", names.join(", "))
}

/// Prints the summary of a run over time, writes its files; a run that stopped early keeps what it
/// has and fails.
pub fn report<S: Space>(
    args: &crate::arguments::RunArgs,
    loaded: &crate::load::Loaded<S>,
    mut results: Results,
    assembled: &AssemblyReport,
    stopped: Option<dalembert::analysis::AnalysisError>,
) -> Result<(), crate::failure::Failure> {
    results.notes.extend(assembly(assembled));
    if let Some(error) = &stopped {
        results.notes.push(format!("error: {error}"));
    }
    let written = crate::output::write_all(args, loaded, &results)?;
    if args.model.json {
        say!(
            "{:#}",
            loaded.with_warnings(serde_json::json!({
                "model": results.model,
                "analysis": results.analysis,
                "instants": results.len(),
                "statistics": results.statistics,
                "notes": results.notes,
                "completed": stopped.is_none(),
                "error": stopped.as_ref().map(ToString::to_string),
                "files": written,
                "last": results.channels.iter().filter_map(|c| Some((c.name.clone(), *c.values.last()?))).collect::<std::collections::BTreeMap<_, _>>(),
            }))
        );
    } else {
        let time = results.channel("time").map_or(&[][..], |c| &c.values[..]);
        if let (Some(first), Some(last)) = (time.first(), time.last()) {
            say!(
                "{}: {}, {} from {} s to {} s",
                results.model,
                results.analysis,
                counted(time.len(), "instant"),
                number(*first),
                number(*last)
            );
        }
        say_on!("{}", table(&results));
        for (channel, worst) in errors(&results) {
            say!(
                "  largest |{}|: {} {}",
                channel.name,
                number(worst),
                channel.unit
            );
        }
        let statistics: Vec<String> = results
            .statistics
            .iter()
            .map(|(k, v)| format!("{k} {}", number(*v)))
            .collect();
        say!("  {}", statistics.join(", "));
        // Why the run stopped is told at the end, as its error.
        let reason = stopped.as_ref().map(|error| format!("error: {error}"));
        let told = results.notes.iter().filter(|n| Some(*n) != reason.as_ref());
        for note in told {
            tell(note);
        }
        if !written.is_empty() {
            say!("{}", files(&written));
        }
    }
    match stopped {
        Some(error) => Err(crate::failure::Failure::Stopped(error)),
        None => Ok(()),
    }
}
