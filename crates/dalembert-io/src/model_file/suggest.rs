//! "Did you mean": the nearest of the allowed words.

/// Returns the candidate that a person most likely meant, if one is near enough.
pub(super) fn nearest<'a>(
    word: &str,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    let word = normal(word);
    // A third of the word may be wrong; a word of one or two letters is too short to guess from.
    let limit = word.chars().count() / 3;
    candidates
        .into_iter()
        .map(|c| (strsim::damerau_levenshtein(&word, &normal(c)), c))
        .filter(|(distance, _)| *distance <= limit)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, c)| c)
}

/// Writes words as a person lists them: `a`, `b`, `c`.
pub(super) fn listed<'a>(words: impl IntoIterator<Item = &'a str>) -> String {
    let quoted: Vec<String> = words.into_iter().map(|w| format!("`{w}`")).collect();
    quoted.join(", ")
}

/// Case and the choice of hyphen, underscore or space do not count as mistakes of spelling.
/// Only the start counts: a very long word is like none of ours, and the comparison is quadratic.
fn normal(word: &str) -> String {
    word.chars()
        .take(64)
        .flat_map(char::to_lowercase)
        .map(|c| if c == '_' || c == ' ' { '-' } else { c })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn near_words_are_found_and_far_ones_are_not() {
        let allowed = ["mass", "inertia", "free_length"];
        assert_eq!(nearest("maas", allowed), Some("mass"));
        assert_eq!(nearest("Free-Length", allowed), Some("free_length"));
        assert_eq!(nearest("colour", allowed), None);
        assert_eq!(nearest("", allowed), None);
    }
}
