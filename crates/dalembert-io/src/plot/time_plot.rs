//! Channels over time or over one other channel.

use super::axis::Axis;
use super::curve::Curve;
use super::panel::{Panel, tick_width};
use super::range::Range;
use super::svg::{Anchor, Svg};
use super::ticks::Ticks;
use super::{Series, label, legend, palette, text};
use dalembert::results::Channel;

/// Space above the first panel without and with a title, and below the last one (px).
const TOP: f64 = 24.0;
const TITLE: f64 = 26.0;
const BOTTOM: f64 = 46.0;
/// Space between two panels: the upper one's lowest and the lower one's highest tick label fit.
const BETWEEN: f64 = 26.0;
const RIGHT: f64 = 24.0;
/// A panel is never lower or narrower than this.
const LEAST: f64 = 60.0;

/// Channels over one common x: time, or another channel.
///
/// Channels of one unit share a panel; panels are stacked in the order in which their units come.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// Heading; empty for none.
    pub title: String,
    /// What is laid to the right.
    pub x: Series,
    /// What is laid upward, each as long as `x` (the shorter of the two counts).
    pub ys: Vec<Series>,
    /// Width of the picture (px).
    pub width: f64,
    /// Height of the picture (px); `None` gives every panel the height that it needs.
    pub height: Option<f64>,
}

impl Plot {
    /// A plot of usual size.
    pub fn new(title: impl Into<String>, x: Series, ys: Vec<Series>) -> Self {
        Self {
            title: title.into(),
            x,
            ys,
            width: 860.0,
            height: None,
        }
    }

    /// Channels over another one; the channel `x` itself is left out of `ys` (patterns often catch it).
    pub fn of_channels(title: impl Into<String>, x: &Channel, ys: &[&Channel]) -> Self {
        Self::new(
            title,
            Series::from(x),
            ys.iter()
                .filter(|y| y.name != x.name)
                .map(|y| Series::from(*y))
                .collect(),
        )
    }

    /// The picture as SVG text.
    pub fn to_svg(&self) -> String {
        let groups = self.groups();
        let top = TOP + if self.title.is_empty() { 0.0 } else { TITLE };
        let heights = self.panel_heights(&groups, top);
        let between = BETWEEN * groups.len().saturating_sub(1) as f64;
        let height = top + heights.iter().sum::<f64>() + between + BOTTOM;
        let width = self.width.clamp(200.0, 20000.0);

        let legend_width = groups
            .iter()
            .map(|g| legend::width(&g.curves, 0.35 * width))
            .fold(0.0, f64::max);
        let right = if legend_width > 0.0 {
            width - legend_width - 14.0 - 10.0
        } else {
            width - RIGHT
        };
        let y_ranges: Vec<Range> = groups.iter().map(|g| y_range(&g.curves)).collect();
        let tick_width = y_ranges
            .iter()
            .zip(&heights)
            .map(|(range, height)| tick_width(&Ticks::new(*range, height / Y_SPACING)))
            .fold(0.0, f64::max);
        let left = 34.0 + tick_width;
        let right = right.max(left + LEAST);

        let mut svg = Svg::new(width, height, self.heading());
        if !self.title.is_empty() {
            let title = text::fit(&self.title, 15.0, width - left - 20.0);
            let style = " class=\"title\" font-size=\"15\" font-weight=\"600\"";
            svg.text(left, 26.0, Anchor::Start, style, &title);
        }
        let x_axis = Axis::new(self.x_range(), left, right, X_SPACING);
        let mut y = top;
        let last = groups.len() - 1;
        for (k, group) in groups.into_iter().enumerate() {
            let labels: Vec<&str> = group.curves.iter().map(|c| c.label).collect();
            let panel = Panel {
                x: x_axis.clone(),
                y: Axis::new(y_ranges[k], y + heights[k], y, Y_SPACING),
                x_label: (k == last).then(|| label::with_unit(&self.x.label, &self.x.unit)),
                y_label: label::with_unit(label::common(&labels), group.unit),
                legend_width,
                y_label_at: 18.0,
                curves: group.curves,
            };
            panel.draw(&mut svg);
            y += heights[k] + BETWEEN;
        }
        svg.finish()
    }

    fn heading(&self) -> &str {
        if self.title.is_empty() {
            "Plot"
        } else {
            &self.title
        }
    }

    /// Curves by unit; at least one group.
    fn groups(&self) -> Vec<Group<'_>> {
        let mut groups: Vec<Group> = Vec::new();
        for y in &self.ys {
            let place = groups.iter().position(|g| g.unit == y.unit);
            let k = place.unwrap_or_else(|| {
                groups.push(Group {
                    unit: &y.unit,
                    curves: Vec::new(),
                });
                groups.len() - 1
            });
            let look = palette::look(groups[k].curves.len());
            groups[k].curves.push(Curve {
                label: &y.label,
                x: &self.x.values,
                y: &y.values,
                look,
            });
        }
        if groups.is_empty() {
            groups.push(Group {
                unit: "",
                curves: Vec::new(),
            });
        }
        groups
    }

    fn panel_heights(&self, groups: &[Group], top: f64) -> Vec<f64> {
        let between = BETWEEN * (groups.len() - 1) as f64;
        match self.height {
            Some(height) => {
                let each = (height - top - BOTTOM - between) / groups.len() as f64;
                vec![each.max(LEAST); groups.len()]
            }
            None => {
                let usual = if groups.len() == 1 { 360.0 } else { 190.0 };
                groups
                    .iter()
                    .map(|g| legend::height(&g.curves).max(usual))
                    .collect()
            }
        }
    }

    /// Time fills the width; an x that goes back and forth gets some air.
    fn x_range(&self) -> Range {
        let Some(range) = Range::of(self.x.values.iter().copied()) else {
            return UNIT_RANGE;
        };
        let rising = self.x.values.windows(2).all(|w| w[0] <= w[1]);
        let open = range.opened();
        if rising || open != range {
            open
        } else {
            range.padded(0.03)
        }
    }
}

/// Pixels between two ticks, about.
pub(super) const X_SPACING: f64 = 75.0;
pub(super) const Y_SPACING: f64 = 38.0;

/// Range of an axis without values.
pub(super) const UNIT_RANGE: Range = Range {
    low: 0.0,
    high: 1.0,
};

/// Curves of one unit.
struct Group<'a> {
    unit: &'a str,
    curves: Vec<Curve<'a>>,
}

/// The range of all values with some air; constants lie in the middle.
fn y_range(curves: &[Curve]) -> Range {
    let Some(range) = Range::of(curves.iter().flat_map(|c| c.finite().map(|p| p.1))) else {
        return UNIT_RANGE;
    };
    let open = range.opened();
    if open == range {
        range.padded(0.05)
    } else {
        open
    }
}
