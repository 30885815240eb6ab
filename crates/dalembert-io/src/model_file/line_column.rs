//! From a byte of a text to its line and column.

/// Returns line and column of a byte, both counted from 1; columns count characters.
///
/// A byte behind the end counts as the end; a byte inside a character counts as its start.
pub fn line_column(text: &str, byte: usize) -> (usize, usize) {
    Lines::new(text).line_column(byte)
}

/// Where the lines of a text start: for many places of one text.
pub(super) struct Lines<'a> {
    text: &'a str,
    starts: Vec<usize>,
}

impl<'a> Lines<'a> {
    /// Finds the lines.
    pub fn new(text: &'a str) -> Self {
        let starts = text.match_indices('\n').map(|(k, _)| k + 1);
        Self {
            text,
            starts: std::iter::once(0).chain(starts).collect(),
        }
    }

    /// The nearest byte at or before the given one at which a character starts, or the end.
    pub fn boundary(&self, byte: usize) -> usize {
        let mut byte = byte.min(self.text.len());
        while !self.text.is_char_boundary(byte) {
            byte -= 1;
        }
        byte
    }

    /// Line and column of a byte, both counted from 1.
    pub fn line_column(&self, byte: usize) -> (usize, usize) {
        let byte = self.boundary(byte);
        // The first line starts at 0, so at least one start is not behind the byte.
        let line = self.starts.partition_point(|start| *start <= byte);
        let start = self.starts[line - 1];
        (line, self.text[start..byte].chars().count() + 1)
    }

    /// First byte and text of a line, without its end; lines count from 1.
    pub fn line(&self, line: usize) -> (usize, &'a str) {
        let start = self.starts.get(line.saturating_sub(1)).copied();
        let start = start.unwrap_or(self.text.len());
        let text = self.text[start..].lines().next().unwrap_or_default();
        (start, text)
    }
}

#[cfg(test)]
mod tests {
    use super::{Lines, line_column};

    #[test]
    fn counts_from_one_and_in_characters() {
        let text = "a = 1\nµ = \"α\"\r\n";
        assert_eq!(line_column(text, 0), (1, 1));
        assert_eq!(line_column(text, 5), (1, 6));
        assert_eq!(line_column(text, 6), (2, 1));
        assert_eq!(line_column(text, 7), (2, 1));
        assert_eq!(line_column(text, text.find('α').unwrap()), (2, 6));
        assert_eq!(line_column(text, 1000), (3, 1));
        assert_eq!(line_column("", 0), (1, 1));
        assert_eq!(Lines::new(text).line(2), (6, "µ = \"α\""));
        assert_eq!(Lines::new(text).line(3), (text.len(), ""));
    }
}
