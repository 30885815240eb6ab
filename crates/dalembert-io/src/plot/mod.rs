//! Plots as SVG text: channels over time (stacked panels, one a unit) and curves in a plane.
//!
//! Every plot is one self-contained picture on a white ground, with ticks at steps of 1, 2 or 5,
//! units at the axes and a legend beside the curves. Long channels are thinned to what the pixels
//! can show, without losing an extreme value.

mod axis;
mod curve;
mod decimate;
mod label;
mod legend;
mod palette;
mod panel;
mod range;
mod rounding;
mod series;
mod svg;
mod text;
mod ticks;
mod time_plot;
mod xy_plot;

#[cfg(test)]
mod tests;

pub use rounding::rounding_as_zero;
pub use series::Series;
pub use time_plot::Plot;
pub use xy_plot::{XyCurve, XyPlot};
