//! How wide text will be; without the reader's font an estimate, on the wide side.

/// Estimated width of text in a sans-serif font of the given size (px).
pub(super) fn width(text: &str, size: f64) -> f64 {
    text.chars().map(em).sum::<f64>() * size
}

/// Shortens text in its middle until it fits; both ends of a channel's name tell something.
pub(super) fn fit(text: &str, size: f64, room: f64) -> String {
    if width(text, size) <= room {
        return text.to_owned();
    }
    let chars: Vec<char> = text.chars().collect();
    let mut kept = chars.len();
    while kept > 2 {
        kept -= 1;
        let head = kept.div_ceil(2);
        let short: String = chars[..head]
            .iter()
            .chain(&['…'])
            .chain(&chars[chars.len() - (kept - head)..])
            .collect();
        if width(&short, size) <= room {
            return short;
        }
    }
    "…".to_owned()
}

/// Width of a character relative to the font size, by class (measured on common sans-serif fonts).
fn em(c: char) -> f64 {
    match c {
        'i' | 'j' | 'l' | '\'' | '|' | '.' | ',' | ':' | ';' | 'I' | '!' => 0.33,
        ' ' | 'f' | 't' | 'r' | '(' | ')' | '[' | ']' | '/' | '-' => 0.40,
        'm' | 'w' | 'M' | 'W' | '@' | '%' => 0.95,
        'A'..='Z' | '_' | '+' | '=' | '<' | '>' | '×' | '−' | '~' => 0.72,
        // Ideographs and other wide signs fill the square.
        c if c >= '\u{1100}' => 1.0,
        _ => 0.61,
    }
}
