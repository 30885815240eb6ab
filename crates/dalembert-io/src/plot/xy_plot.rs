//! Curves in a plane, each with its own x: paths of points, phase portraits.

use super::axis::Axis;
use super::curve::Curve;
use super::panel::{Panel, tick_width};
use super::range::Range;
use super::svg::{Anchor, Svg};
use super::ticks::Ticks;
use super::time_plot::{UNIT_RANGE, X_SPACING, Y_SPACING};
use super::{label, legend, palette, text};
use dalembert::results::Channel;

const TOP: f64 = 24.0;
const TITLE: f64 = 26.0;
const BOTTOM: f64 = 46.0;
const RIGHT: f64 = 24.0;

/// One curve in a plane.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct XyCurve {
    /// Label in the legend.
    pub label: String,
    /// What is laid to the right.
    pub x: Vec<f64>,
    /// What is laid upward, as long as `x` (the shorter of the two counts).
    pub y: Vec<f64>,
}

impl XyCurve {
    /// One channel over another.
    pub fn of_channels(label: impl Into<String>, x: &Channel, y: &Channel) -> Self {
        Self {
            label: label.into(),
            x: x.values.clone(),
            y: y.values.clone(),
        }
    }
}

/// Curves in a plane: paths of points, phase portraits.
#[derive(Clone, Debug, PartialEq)]
pub struct XyPlot {
    /// Heading; empty for none.
    pub title: String,
    /// Label of the x axis.
    pub x_label: String,
    /// Unit of the x axis; empty for plain numbers.
    pub x_unit: String,
    /// Label of the y axis.
    pub y_label: String,
    /// Unit of the y axis; empty for plain numbers.
    pub y_unit: String,
    /// Curves.
    pub curves: Vec<XyCurve>,
    /// Is a unit as long upward as to the right? Paths of points then keep their form.
    pub equal_aspect: bool,
    /// Width of the picture (px).
    pub width: f64,
    /// Height of the picture (px); `None` lets the form of the curves decide.
    pub height: Option<f64>,
}

impl Default for XyPlot {
    fn default() -> Self {
        Self {
            title: String::new(),
            x_label: "x".to_owned(),
            x_unit: String::new(),
            y_label: "y".to_owned(),
            y_unit: String::new(),
            curves: Vec::new(),
            equal_aspect: false,
            width: 860.0,
            height: None,
        }
    }
}

impl XyPlot {
    /// The picture as SVG text.
    pub fn to_svg(&self) -> String {
        let curves: Vec<Curve> = self
            .curves
            .iter()
            .enumerate()
            .map(|(k, c)| Curve {
                label: &c.label,
                x: &c.x,
                y: &c.y,
                look: palette::look(k),
            })
            .collect();
        let width = self.width.clamp(200.0, 20000.0);
        let top = TOP + if self.title.is_empty() { 0.0 } else { TITLE };
        let mut x = range(&curves, |p| p.0);
        let mut y = range(&curves, |p| p.1);

        let legend_width = legend::width(&curves, 0.35 * width);
        let beside = if legend_width > 0.0 {
            legend_width + 24.0
        } else {
            RIGHT
        };
        // The tick labels decide the left margin, the margin the size, and the size the ticks: a
        // second pass settles it.
        let mut left = 60.0;
        let (mut across, mut upward) = self.size(&curves, (x, y), width - left - beside, top);
        for _ in 0..2 {
            let (_, y) = self.ranges((x, y), across, upward);
            left = 34.0 + tick_width(&Ticks::new(y, upward / Y_SPACING));
            (across, upward) = self.size(&curves, (x, y), width - left - beside, top);
        }
        (x, y) = self.ranges((x, y), across, upward);

        let title = if self.title.is_empty() {
            "Plot"
        } else {
            &self.title
        };
        let mut svg = Svg::new(width, top + upward + BOTTOM, title);
        if !self.title.is_empty() {
            let title = text::fit(&self.title, 15.0, width - left - 20.0);
            let style = " class=\"title\" font-size=\"15\" font-weight=\"600\"";
            svg.text(left, 26.0, Anchor::Start, style, &title);
        }
        let panel = Panel {
            x: Axis::new(x, left, left + across, X_SPACING),
            y: Axis::new(y, top + upward, top, Y_SPACING),
            x_label: Some(label::with_unit(&self.x_label, &self.x_unit)),
            y_label: label::with_unit(&self.y_label, &self.y_unit),
            legend_width,
            y_label_at: 18.0,
            curves,
        };
        panel.draw(&mut svg);
        svg.finish()
    }

    /// Width and height of the panel.
    fn size(&self, curves: &[Curve], (x, y): (Range, Range), room: f64, top: f64) -> (f64, f64) {
        let across = room.max(60.0);
        let upward = match self.height {
            Some(height) => (height - top - BOTTOM).max(60.0),
            None => {
                let form = if self.equal_aspect {
                    (y.length() / x.length()).clamp(0.25, 1.0)
                } else {
                    0.65
                };
                (form * across).max(legend::height(curves))
            }
        };
        (across, upward)
    }

    /// Ranges as they are drawn; with equal aspect the shorter one is widened about its middle.
    fn ranges(&self, (x, y): (Range, Range), across: f64, upward: f64) -> (Range, Range) {
        if !self.equal_aspect {
            return (x, y);
        }
        let units = (x.length() / across).max(y.length() / upward);
        (x.widened_to(units * across), y.widened_to(units * upward))
    }
}

fn range(curves: &[Curve], part: impl Fn((f64, f64)) -> f64) -> Range {
    Range::of(curves.iter().flat_map(|c| c.finite().map(&part)))
        .map_or(UNIT_RANGE, |r| r.opened().padded(0.05))
}
