//! From a byte of a text to its line and column.

/// Returns line and column of a byte, both counted from 1; columns count characters.
///
/// A byte behind the end counts as the end; a byte inside a character counts as its start.
pub fn line_column(text: &str, byte: usize) -> (usize, usize) {
    let mut end = byte.min(text.len());
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    let before = &text[..end];
    let line_start = before.rfind('\n').map_or(0, |k| k + 1);
    let line = before.bytes().filter(|b| *b == b'\n').count() + 1;
    (line, before[line_start..].chars().count() + 1)
}

#[cfg(test)]
mod tests {
    use super::line_column;

    #[test]
    fn counts_from_one_and_in_characters() {
        let text = "a = 1\nµ = \"α\"\r\n";
        assert_eq!(line_column(text, 0), (1, 1));
        assert_eq!(line_column(text, 6), (2, 1));
        assert_eq!(line_column(text, 7), (2, 1));
        assert_eq!(line_column(text, text.find('α').unwrap()), (2, 6));
        assert_eq!(line_column(text, 1000), (3, 1));
        assert_eq!(line_column("", 0), (1, 1));
    }
}
