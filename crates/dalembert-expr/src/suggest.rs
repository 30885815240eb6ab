//! "Did you mean": names near a mistyped one.

/// Names longer than this are not compared, so that hostile input costs nothing.
const LONGEST: usize = 64;

/// The candidates that are nearest to `name` by edit distance, if they are near: at most three.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Vec<String> {
    if name.len() > LONGEST {
        return Vec::new();
    }
    let wanted: Vec<char> = name.to_lowercase().chars().collect();
    let limit = (wanted.len() / 3).max(1);
    let mut found: Vec<(usize, &str)> = candidates
        .into_iter()
        .filter(|candidate| candidate.len() <= LONGEST && *candidate != name)
        .filter_map(|candidate| {
            let letters: Vec<char> = candidate.to_lowercase().chars().collect();
            // A name of one letter is one edit away from every other one.
            let cap = limit.min(letters.len().max(wanted.len()) - 1);
            let distance = distance(&wanted, &letters);
            (distance <= cap).then_some((distance, candidate))
        })
        .collect();
    found.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.cmp(b.1)));
    found.dedup();
    let best = found.first().map(|(distance, _)| *distance);
    found.retain(|(distance, _)| Some(*distance) == best);
    found.truncate(3);
    found.into_iter().map(|(_, name)| name.to_owned()).collect()
}

/// Edits (insert, delete, replace, swap of neighbours) that lead from `a` to `b`.
fn distance(a: &[char], b: &[char]) -> usize {
    let mut before = vec![0; b.len() + 1];
    let mut above: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut row = vec![i; b.len() + 1];
        for j in 1..=b.len() {
            let replace = above[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            row[j] = replace.min(above[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                row[j] = row[j].min(before[j - 2] + 1);
            }
        }
        before = above;
        above = row;
    }
    above[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_names_are_found_in_order() {
        let names = ["crank", "rod", "slider", "rank"];
        assert_eq!(nearest("carnk", names), ["crank"]);
        assert_eq!(nearest("drank", names), ["crank", "rank"]);
        assert_eq!(nearest("CRANK", names), ["crank"]);
        assert!(nearest("zebra", names).is_empty());
        assert!(nearest("x", ["y", "t"]).is_empty());
        assert_eq!(nearest("KG", ["kg", "g"]), ["kg"]);
    }
}
