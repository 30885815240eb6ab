//! Channels by name or pattern.

use dalembert::results::{Channel, Results};
use thiserror::Error;

/// Most suggestions that an error gives.
const MAX_SUGGESTIONS: usize = 5;

/// A pattern that no channel matches.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("no channel matches {pattern:?}{}", hint(suggestions))]
pub struct UnknownChannel {
    /// The pattern as given.
    pub pattern: String,
    /// Names of channels that come close, the closest first.
    pub suggestions: Vec<String>,
}

/// The channels that match any of the patterns, in order of the patterns, each once.
///
/// A pattern is a channel's name, or holds `*` (any text) and `?` (any one character):
/// `crank.*`, `*.angle`. A name that equals the pattern is taken literally.
pub fn select<'a>(
    results: &'a Results,
    patterns: &[String],
) -> Result<Vec<&'a Channel>, UnknownChannel> {
    let mut chosen: Vec<&Channel> = Vec::new();
    for pattern in patterns {
        let matching: Vec<&Channel> = match results.channel(pattern) {
            Some(channel) => vec![channel],
            None => results
                .channels
                .iter()
                .filter(|c| distance(pattern, &c.name) == 0)
                .collect(),
        };
        if matching.is_empty() {
            return Err(UnknownChannel {
                pattern: pattern.clone(),
                suggestions: suggestions(results, pattern),
            });
        }
        for channel in matching {
            if !chosen.iter().any(|c| std::ptr::eq(*c, channel)) {
                chosen.push(channel);
            }
        }
    }
    Ok(chosen)
}

/// Names within a third of the pattern's length (two edits at least), closest first.
fn suggestions(results: &Results, pattern: &str) -> Vec<String> {
    let limit = (pattern.chars().filter(|c| *c != '*').count() / 3).max(2);
    let lower = pattern.to_lowercase();
    let mut close: Vec<(usize, &str)> = results
        .channels
        .iter()
        .map(|c| (distance(&lower, &c.name.to_lowercase()), c.name.as_str()))
        .filter(|(edits, _)| *edits <= limit)
        .collect();
    // The sort is stable: equally close names keep the order of the results.
    close.sort_by_key(|(edits, _)| *edits);
    close
        .into_iter()
        .take(MAX_SUGGESTIONS)
        .map(|(_, name)| name.to_owned())
        .collect()
}

/// Fewest edits (insert, delete, replace, swap two neighbours) that make a name match a pattern,
/// in which `*` stands for any text and `?` for any character. Zero means that it matches.
fn distance(pattern: &str, name: &str) -> usize {
    let p: Vec<char> = pattern.chars().collect();
    let n: Vec<char> = name.chars().collect();
    // d[i][j]: edits between the first i characters of the pattern and the first j of the name.
    let mut d = vec![vec![0; n.len() + 1]; p.len() + 1];
    d[0] = (0..=n.len()).collect();
    for i in 1..=p.len() {
        let star = p[i - 1] == '*';
        d[i][0] = d[i - 1][0] + usize::from(!star);
        for j in 1..=n.len() {
            d[i][j] = if star {
                d[i - 1][j].min(d[i][j - 1])
            } else {
                let same = p[i - 1] == n[j - 1] || p[i - 1] == '?';
                let replace = d[i - 1][j - 1] + usize::from(!same);
                let edit = replace.min(d[i - 1][j] + 1).min(d[i][j - 1] + 1);
                let swapped = i > 1 && j > 1 && p[i - 1] == n[j - 2] && p[i - 2] == n[j - 1];
                if swapped {
                    edit.min(d[i - 2][j - 2] + 1)
                } else {
                    edit
                }
            };
        }
    }
    d[p.len()][n.len()]
}

fn hint(suggestions: &[String]) -> String {
    if suggestions.is_empty() {
        String::new()
    } else {
        format!("; did you mean {}?", suggestions.join(", "))
    }
}
