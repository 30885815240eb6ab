//! One curve of a panel.

use super::axis::Axis;
use super::decimate;
use super::palette::Look;
use super::svg::{Point, Svg, px};

/// Width of a curve (px).
const LINE: f64 = 1.5;

/// Width of the columns in which a curve over time is thinned (px).
const COLUMN: f64 = 0.5;

/// One curve: two rows of numbers, a label and a look.
#[derive(Clone, Debug)]
pub(super) struct Curve<'a> {
    pub label: &'a str,
    pub x: &'a [f64],
    pub y: &'a [f64],
    pub look: Look,
}

impl Curve<'_> {
    /// The points that are finite in both directions.
    pub fn finite(&self) -> impl Iterator<Item = Point> {
        self.x
            .iter()
            .copied()
            .zip(self.y.iter().copied())
            .filter(|(x, y)| x.is_finite() && y.is_finite())
    }

    /// Attributes of the line.
    pub fn stroke(&self) -> String {
        let dash = match self.look.dash {
            Some(dash) => format!(" stroke-dasharray=\"{dash}\""),
            None => String::new(),
        };
        format!(
            "fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"{dash}",
            self.look.color,
            px(LINE)
        )
    }

    /// Draws the curve: a polyline for every run of finite points, a dot for a lone point.
    pub fn draw(&self, svg: &mut Svg, x: &Axis, y: &Axis) {
        svg.raw(&format!("<g class=\"curve\" {}>", self.stroke()));
        svg.title(self.label);
        for run in self.runs(x, y) {
            if let [(cx, cy)] = run[..] {
                svg.raw(&format!(
                    "<circle cx=\"{}\" cy=\"{}\" r=\"3\" fill=\"{}\" stroke=\"none\"/>\n",
                    px(cx),
                    px(cy),
                    self.look.color
                ));
                continue;
            }
            let rising = run.windows(2).all(|w| w[0].0 <= w[1].0);
            let thinned = if rising {
                decimate::by_column(&run, COLUMN)
            } else {
                decimate::by_distance(&run)
            };
            svg.polyline(&decimate::straighten(&thinned));
        }
        svg.raw("</g>\n");
    }

    /// Runs of finite points, in pixels.
    fn runs(&self, x: &Axis, y: &Axis) -> Vec<Vec<Point>> {
        let points: Vec<Point> = self.x.iter().copied().zip(self.y.iter().copied()).collect();
        points
            .split(|(px, py)| !px.is_finite() || !py.is_finite())
            .filter(|run| !run.is_empty())
            .map(|run| run.iter().map(|p| (x.pixel(p.0), y.pixel(p.1))).collect())
            .collect()
    }
}
