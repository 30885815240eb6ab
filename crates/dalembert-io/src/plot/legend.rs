//! The legend: beside the curves, so that it never covers one.

use super::curve::Curve;
use super::svg::{Anchor, Svg, px};
use super::text;

const FONT: f64 = 12.0;
const ROW: f64 = 17.0;
const SAMPLE: f64 = 22.0;
const GAP: f64 = 6.0;

/// Width that the legend of these curves needs, no more than `room`; 0 where no legend is needed.
pub(super) fn width(curves: &[Curve], room: f64) -> f64 {
    if curves.len() < 2 {
        return 0.0;
    }
    let widest = curves
        .iter()
        .map(|c| text::width(c.label, FONT))
        .fold(0.0, f64::max);
    (SAMPLE + GAP + widest).min(room)
}

/// Height that the legend needs to show every curve.
pub(super) fn height(curves: &[Curve]) -> f64 {
    if curves.len() < 2 {
        0.0
    } else {
        ROW * curves.len() as f64
    }
}

/// Draws the legend from a top left corner; what does not fit into the height is counted in its last row.
pub(super) fn draw(svg: &mut Svg, curves: &[Curve], left: f64, top: f64, width: f64, height: f64) {
    if curves.len() < 2 {
        return;
    }
    let rows = ((height / ROW).floor() as usize).max(1);
    let shown = if curves.len() <= rows {
        curves.len()
    } else {
        rows - 1
    };
    for (k, curve) in curves.iter().take(shown).enumerate() {
        let middle = top + ROW * (k as f64 + 0.5);
        svg.raw("<g class=\"legend\">");
        svg.title(curve.label);
        svg.lines(
            &[((left, middle), (left + SAMPLE, middle))],
            &curve.stroke(),
        );
        let room = width - SAMPLE - GAP;
        let label = text::fit(curve.label, FONT, room);
        svg.text(left + SAMPLE + GAP, middle + 4.0, Anchor::Start, "", &label);
        svg.raw("</g>\n");
    }
    if shown < curves.len() {
        let middle = top + ROW * (shown as f64 + 0.5);
        let rest = format!("and {} more", curves.len() - shown);
        let attributes = format!(" font-style=\"italic\" font-size=\"{}\"", px(FONT - 1.0));
        svg.text(left, middle + 4.0, Anchor::Start, &attributes, &rest);
    }
}
