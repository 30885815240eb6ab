//! "Did you mean": names near a mistyped one, and names that match a pattern.

/// Longer words are like none of ours, and comparing them is slow: only their start counts.
const LONGEST: usize = 64;
/// Most names that come equally close to a word.
const MOST_NAMES: usize = 3;
/// Most names that come close to a pattern.
const MOST_MATCHES: usize = 5;

/// One place of a pattern.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    /// This character.
    Letter(char),
    /// Any one character.
    One,
    /// Any text.
    Any,
}

/// The candidates that a mistyped word most likely means: the nearest by edits, if they are near,
/// at most three.
///
/// A third of the word may be wrong. Case, and the choice of hyphen, underscore or space, do not
/// count; a word of one or two letters is too short to guess from.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    let wanted: Vec<Part> = letters(word).map(Part::Letter).collect();
    let limit = wanted.len() / 3;
    let mut found = near(&wanted, limit, candidates);
    let best = found.first().map(|(edits, _)| *edits);
    found.retain(|(edits, name)| Some(*edits) == best && *name != word);
    names(found, MOST_NAMES)
}

/// The candidates that come close to a pattern that none matches, the closest first, at most five.
///
/// In a pattern `*` stands for any text and `?` for any one character.
pub fn nearest_to_pattern<'a>(
    pattern: &str,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Vec<&'a str> {
    let wanted: Vec<Part> = letters(pattern).map(part).collect();
    let fixed = wanted.iter().filter(|p| **p != Part::Any).count();
    names(near(&wanted, (fixed / 3).max(2), candidates), MOST_MATCHES)
}

/// Does a name match a pattern, in which `*` stands for any text and `?` for any one character?
pub fn matches(pattern: &str, name: &str) -> bool {
    let pattern: Vec<Part> = pattern.chars().map(part).collect();
    let name: Vec<char> = name.chars().collect();
    edits(&pattern, &name) == 0
}

fn part(letter: char) -> Part {
    match letter {
        '*' => Part::Any,
        '?' => Part::One,
        letter => Part::Letter(letter),
    }
}

/// The start of a word as words are compared.
fn letters(word: &str) -> impl Iterator<Item = char> + '_ {
    word.chars()
        .take(LONGEST)
        .flat_map(char::to_lowercase)
        .map(|c| if c == '_' || c == ' ' { '-' } else { c })
}

/// Candidates within so many edits, the closest first; equally close ones keep their order.
fn near<'a>(
    wanted: &[Part],
    limit: usize,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Vec<(usize, &'a str)> {
    let mut found: Vec<(usize, &str)> = candidates
        .into_iter()
        .map(|name| (edits(wanted, &letters(name).collect::<Vec<char>>()), name))
        .filter(|(edits, _)| *edits <= limit)
        .collect();
    found.sort_by_key(|(edits, _)| *edits);
    found
}

/// Names that stay.
pub(crate) fn owned(names: Vec<&str>) -> Vec<String> {
    names.into_iter().map(str::to_owned).collect()
}

fn names(found: Vec<(usize, &str)>, most: usize) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for (_, name) in found {
        if names.len() < most && !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// Fewest edits (insert, delete, replace, swap of neighbours) that make a name match a pattern.
fn edits(pattern: &[Part], name: &[char]) -> usize {
    let mut before = vec![0; name.len() + 1];
    let mut above: Vec<usize> = (0..=name.len()).collect();
    for (i, &wanted) in pattern.iter().enumerate() {
        let mut row = vec![above[0] + usize::from(wanted != Part::Any); name.len() + 1];
        for (j, &letter) in name.iter().enumerate() {
            row[j + 1] = if wanted == Part::Any {
                above[j + 1].min(row[j])
            } else {
                let same = wanted == Part::Letter(letter) || wanted == Part::One;
                let replace = above[j] + usize::from(!same);
                let best = replace.min(above[j + 1] + 1).min(row[j] + 1);
                let swapped = i > 0
                    && j > 0
                    && wanted == Part::Letter(name[j - 1])
                    && pattern[i - 1] == Part::Letter(letter);
                if swapped {
                    best.min(before[j - 1] + 1)
                } else {
                    best
                }
            };
        }
        before = above;
        above = row;
    }
    above[name.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_names_are_found_and_far_ones_are_not() {
        let names = ["crank", "rod", "slider", "rank", "free_length"];
        assert_eq!(nearest("carnk", names), ["crank"]);
        assert_eq!(nearest("drank", names), ["crank", "rank"]);
        assert_eq!(nearest("CRANK", names), ["crank"]);
        assert_eq!(nearest("Free-Lenght", names), ["free_length"]);
        assert!(nearest("zebra", names).is_empty());
        assert!(nearest("x", ["y", "t"]).is_empty());
        assert!(nearest("", names).is_empty());
        assert_eq!(nearest("KG", ["kg", "g"]), ["kg"]);
        // A star in a word is a mistake, not a pattern.
        assert!(nearest("*", names).is_empty());
        let long = "a".repeat(1 << 20);
        assert!(nearest(&long, names).is_empty());
    }

    #[test]
    fn patterns_match_and_have_near_names() {
        assert!(matches("crank.*", "crank.angle"));
        assert!(matches("*.ang?e", "crank.angle"));
        assert!(!matches("crank.*", "Crank.angle"));
        assert!(!matches("crank.?", "crank.angle"));
        let names = ["crank.angle", "crank.omega", "rod.angle"];
        assert_eq!(nearest_to_pattern("crnak.omega", names), ["crank.omega"]);
        assert_eq!(
            nearest_to_pattern("carnk.*", names),
            ["crank.angle", "crank.omega"]
        );
    }
}
