//! A small writer of SVG text.

use std::fmt::Write;

/// A point in pixels.
pub(super) type Point = (f64, f64);

/// SVG under construction.
pub(super) struct Svg {
    text: String,
}

/// How text sits at its point.
#[derive(Clone, Copy)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

impl Svg {
    /// A picture of a size in pixels, on a white ground, with a title for screen readers.
    pub fn new(width: f64, height: f64, title: &str) -> Self {
        let (w, h) = (px(width), px(height));
        let mut svg = Self {
            text: format!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}\" height=\"{h}\" \
                 viewBox=\"0 0 {w} {h}\" role=\"img\" \
                 font-family=\"system-ui, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif\" \
                 font-size=\"12\" fill=\"#222222\">\n"
            ),
        };
        svg.title(title);
        svg.raw(&format!(
            "<rect width=\"{w}\" height=\"{h}\" fill=\"#ffffff\"/>\n"
        ));
        svg
    }

    /// A name for the element that is open; browsers show it as a tip.
    pub fn title(&mut self, title: &str) {
        self.text.push_str("<title>");
        escape(title, &mut self.text);
        self.text.push_str("</title>\n");
    }

    /// Markup as it stands.
    pub fn raw(&mut self, markup: &str) {
        self.text.push_str(markup);
    }

    /// Text at a point, with further attributes.
    pub fn text(&mut self, x: f64, y: f64, anchor: Anchor, attributes: &str, text: &str) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        self.put(format_args!(
            "<text x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\"{attributes}>",
            px(x),
            px(y)
        ));
        escape(text, &mut self.text);
        self.text.push_str("</text>\n");
    }

    /// One path of many straight pieces, each from one point to another.
    pub fn lines(&mut self, pieces: &[(Point, Point)], attributes: &str) {
        if pieces.is_empty() {
            return;
        }
        self.text.push_str("<path d=\"");
        for ((x1, y1), (x2, y2)) in pieces {
            self.put(format_args!(
                "M{} {}L{} {}",
                px(*x1),
                px(*y1),
                px(*x2),
                px(*y2)
            ));
        }
        self.put(format_args!("\" {attributes}/>\n"));
    }

    /// A polyline through points.
    pub fn polyline(&mut self, points: &[Point]) {
        self.text.push_str("<polyline points=\"");
        for (k, (x, y)) in points.iter().enumerate() {
            let gap = if k == 0 { "" } else { " " };
            self.put(format_args!("{gap}{},{}", px(*x), px(*y)));
        }
        self.text.push_str("\"/>\n");
    }

    /// The finished text.
    pub fn finish(mut self) -> String {
        self.text.push_str("</svg>\n");
        self.text
    }

    fn put(&mut self, arguments: std::fmt::Arguments) {
        // Writing to a String cannot fail.
        let _ = self.text.write_fmt(arguments);
    }
}

/// A coordinate with two decimals at most.
pub(super) fn px(value: f64) -> String {
    let mut text = format!("{value:.2}");
    if text.contains('.') {
        text.truncate(text.trim_end_matches('0').trim_end_matches('.').len());
    }
    if text == "-0" { "0".to_owned() } else { text }
}

/// Appends text with the signs of markup escaped; characters that XML forbids become U+FFFD.
pub(super) fn escape(text: &str, into: &mut String) {
    for c in text.chars() {
        match c {
            '&' => into.push_str("&amp;"),
            '<' => into.push_str("&lt;"),
            '>' => into.push_str("&gt;"),
            '"' => into.push_str("&quot;"),
            '\'' => into.push_str("&#39;"),
            '\t' | '\n' | '\r' => into.push(' '),
            '\0'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => into.push('\u{fffd}'),
            c => into.push(c),
        }
    }
}
