//! Labels of axes.

/// A label with its unit in brackets.
pub(super) fn with_unit(label: &str, unit: &str) -> String {
    match (label.is_empty(), unit.is_empty()) {
        (_, true) => label.to_owned(),
        (true, false) => format!("[{unit}]"),
        (false, false) => format!("{label} [{unit}]"),
    }
}

/// What several channel names have in common: the one name; or the last part that all share
/// ("angle" of "crank.angle" and "rod.angle"); or whole words at their beginning ("A.force" of
/// "A.force_x" and "A.force_y"); or nothing.
pub(super) fn common<'a>(labels: &[&'a str]) -> &'a str {
    let last = |label: &'a str| label.rsplit_once('.').map_or("", |(_, last)| last);
    let [first, rest @ ..] = labels else {
        return "";
    };
    if rest.is_empty() {
        return first;
    }
    let shared = last(first);
    if !shared.is_empty() && rest.iter().all(|l| last(l) == shared) {
        return shared;
    }
    let alike = rest.iter().fold(first.len(), |length, label| {
        let same = first.bytes().zip(label.bytes()).take_while(|(a, b)| a == b);
        same.count().min(length)
    });
    // The separators are ASCII: cutting there never splits a character.
    match first.as_bytes()[..alike]
        .iter()
        .rposition(|b| matches!(b, b'.' | b'_'))
    {
        Some(end) => &first[..end],
        None => "",
    }
}
