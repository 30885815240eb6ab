//! A labelled row of numbers to plot.

use dalembert::results::Channel;

/// A labelled row of numbers with its unit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// Label in legends and at axes.
    pub label: String,
    /// Unit; empty for plain numbers.
    pub unit: String,
    /// Numbers; places that are not finite are left out and interrupt the curve.
    pub values: Vec<f64>,
}

impl From<&Channel> for Series {
    fn from(channel: &Channel) -> Self {
        Self {
            label: channel.name.clone(),
            unit: channel.unit.clone(),
            values: channel.values.clone(),
        }
    }
}
