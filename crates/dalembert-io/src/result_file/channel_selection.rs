//! Channels by name or pattern.

use dalembert::results::{Channel, Results};
use dalembert_expr::{matches, nearest_to_pattern};
use thiserror::Error;

/// Most channels that an error lists.
const MOST_LISTED: usize = 8;

/// A pattern that no channel matches.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("no channel matches {pattern:?}{}", hint(self))]
pub struct UnknownChannel {
    /// The pattern as given.
    pub pattern: String,
    /// Names of channels that come close, the closest first.
    pub suggestions: Vec<String>,
    /// Channels that there are, listed.
    pub known: String,
}

/// The channels that match any of the patterns, in order of the patterns, each once.
///
/// A pattern is a channel's name, or holds `*` (any text) and `?` (any one character):
/// `crank.*`, `*.angle`. A name that equals the pattern is taken literally.
pub fn select<'a>(
    results: &'a Results,
    patterns: &[String],
) -> Result<Vec<&'a Channel>, UnknownChannel> {
    let names = || results.channels.iter().map(|c| c.name.as_str());
    let mut chosen: Vec<&Channel> = Vec::new();
    for pattern in patterns {
        let matching: Vec<&Channel> = match results.channel(pattern) {
            Some(channel) => vec![channel],
            None => results
                .channels
                .iter()
                .filter(|c| matches(pattern, &c.name))
                .collect(),
        };
        if matching.is_empty() {
            return Err(UnknownChannel {
                pattern: pattern.clone(),
                suggestions: nearest_to_pattern(pattern, names())
                    .into_iter()
                    .map(str::to_owned)
                    .collect(),
                known: some_of(&names().collect::<Vec<&str>>()),
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

fn hint(error: &UnknownChannel) -> String {
    if !error.suggestions.is_empty() {
        return format!("; did you mean {}?", error.suggestions.join(", "));
    }
    if error.known.is_empty() {
        return "; there are no channels".to_owned();
    }
    format!("; the channels are: {}", error.known)
}

/// Names as a list, of which a long one tells only the first.
pub fn some_of(names: &[&str]) -> String {
    match names.len().saturating_sub(MOST_LISTED) {
        0 => names.join(", "),
        more => format!("{} and {more} more", names[..MOST_LISTED].join(", ")),
    }
}
