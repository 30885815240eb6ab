//! One panel: frame, grid, ticks, axis labels, curves and legend.

use super::axis::Axis;
use super::curve::Curve;
use super::legend;
use super::svg::{Anchor, Svg, px};
use super::text;
use super::ticks::Ticks;

/// Font size of tick labels (px).
const TICK_FONT: f64 = 11.0;
/// Font size of axis labels (px).
const LABEL_FONT: f64 = 12.0;

/// One panel, ready to draw; its place is that of its axes.
pub(super) struct Panel<'a> {
    pub curves: Vec<Curve<'a>>,
    pub x: Axis,
    pub y: Axis,
    /// Label below; `None` leaves out the tick labels too (the panel below has them).
    pub x_label: Option<String>,
    pub y_label: String,
    /// Width for the legend, right of the panel.
    pub legend_width: f64,
    /// Centre line of the rotated y label (px).
    pub y_label_at: f64,
}

impl Panel<'_> {
    /// Draws the panel.
    pub fn draw(mut self, svg: &mut Svg) {
        let empty = self.curves.iter().all(|c| c.finite().next().is_none());
        if empty {
            // Numbers at an axis without values would be invented.
            self.y.ticks.marks.clear();
        }
        let (left, right) = (self.x.from, self.x.to);
        let (bottom, top) = (self.y.from, self.y.to);
        svg.raw("<g class=\"panel\">\n");
        self.grid(svg);
        // Curves never leave the panel: the ranges cover all values.
        for curve in &self.curves {
            curve.draw(svg, &self.x, &self.y);
        }
        if empty {
            svg.text(
                0.5 * (left + right),
                0.5 * (top + bottom),
                Anchor::Middle,
                " fill=\"#777777\"",
                "no values",
            );
        }
        let frame = [
            ((left, top), (left, bottom)),
            ((left, bottom), (right, bottom)),
        ];
        svg.lines(
            &frame,
            "class=\"frame\" fill=\"none\" stroke=\"#555555\" stroke-linecap=\"square\"",
        );
        self.labels(svg);
        legend::draw(
            svg,
            &self.curves,
            right + 14.0,
            top,
            self.legend_width,
            bottom - top,
        );
        svg.raw("</g>\n");
    }

    fn grid(&self, svg: &mut Svg) {
        let (left, right) = (self.x.from, self.x.to);
        let (bottom, top) = (self.y.from, self.y.to);
        let mut lines = Vec::new();
        for (value, _) in &self.x.ticks.marks {
            let x = self.x.pixel(*value);
            lines.push(((x, top), (x, bottom)));
        }
        for (value, _) in &self.y.ticks.marks {
            let y = self.y.pixel(*value);
            lines.push(((left, y), (right, y)));
        }
        svg.lines(&lines, "class=\"grid\" fill=\"none\" stroke=\"#e4e4e4\"");
        let mut zero = Vec::new();
        if self.y.holds(0.0) && !self.y.ticks.marks.is_empty() {
            let y = self.y.pixel(0.0);
            zero.push(((left, y), (right, y)));
        }
        if self.x.holds(0.0) {
            let x = self.x.pixel(0.0);
            zero.push(((x, top), (x, bottom)));
        }
        svg.lines(&zero, "class=\"zero\" fill=\"none\" stroke=\"#a0a0a0\"");
    }

    fn labels(&self, svg: &mut Svg) {
        let (left, right) = (self.x.from, self.x.to);
        let (bottom, top) = (self.y.from, self.y.to);
        let font = format!(" class=\"tick\" font-size=\"{}\"", px(TICK_FONT));
        for (value, label) in &self.y.ticks.marks {
            let y = self.y.pixel(*value);
            svg.text(left - 6.0, y + 4.0, Anchor::End, &font, label);
        }
        scale_note(svg, &self.y.ticks, left, top - 6.0, Anchor::Start);
        if !self.y_label.is_empty() {
            let x = self.y_label_at;
            let y = 0.5 * (top + bottom);
            let turn = format!(
                " class=\"axis\" transform=\"rotate(-90 {} {})\"",
                px(x),
                px(y)
            );
            // A label may reach a little past its panel, not into the next one's label.
            let label = text::fit(&self.y_label, LABEL_FONT, bottom - top + 20.0);
            svg.text(x, y, Anchor::Middle, &turn, &label);
        }
        let Some(x_label) = &self.x_label else {
            return;
        };
        for (value, label) in &self.x.ticks.marks {
            let x = self.x.pixel(*value);
            svg.text(x, bottom + 16.0, Anchor::Middle, &font, label);
        }
        scale_note(svg, &self.x.ticks, right, bottom + 34.0, Anchor::End);
        let label = text::fit(x_label, LABEL_FONT, right - left);
        svg.text(
            0.5 * (left + right),
            bottom + 34.0,
            Anchor::Middle,
            " class=\"axis\"",
            &label,
        );
    }
}

/// Width of the widest tick label.
pub(super) fn tick_width(ticks: &Ticks) -> f64 {
    let widths = ticks
        .marks
        .iter()
        .map(|(_, label)| text::width(label, TICK_FONT));
    widths.fold(0.0, f64::max)
}

/// What the tick labels are to be multiplied by and added to.
fn scale_note(svg: &mut Svg, ticks: &Ticks, x: f64, y: f64, anchor: Anchor) {
    let mut note = String::new();
    if ticks.exponent != 0 {
        note.push_str("×10");
        for c in ticks.exponent.to_string().chars() {
            note.push(superscript(c));
        }
    }
    if let Some(offset) = &ticks.offset {
        let (sign, digits) = match offset.strip_prefix(['−', '-']) {
            Some(digits) => ('−', digits),
            None => ('+', offset.as_str()),
        };
        let gap = if note.is_empty() { "" } else { " " };
        note.push_str(&format!("{gap}{sign} {digits}"));
    }
    if !note.is_empty() {
        let font = format!(" class=\"scale\" font-size=\"{}\"", px(TICK_FONT));
        svg.text(x, y, anchor, &font, &note);
    }
}

fn superscript(c: char) -> char {
    match c {
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        '-' => '⁻',
        _ => '⁰',
    }
}
