//! The JSON document behind result files and sidecars.

use super::Meta;
use dalembert::results::{Channel, Results};
use indexmap::IndexMap;
use serde::{Deserialize, Deserializer, Serialize};
use std::borrow::Cow;

/// Format tag of a JSON result file.
pub(super) const RESULTS_FORMAT: &str = "dalembert-results/1";
/// Format tag of a sidecar.
pub(super) const SIDECAR_FORMAT: &str = "dalembert-sidecar/1";

/// A JSON result file; without the values also a sidecar.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Document<'a> {
    pub format: Cow<'a, str>,
    /// Name of the data file that a sidecar belongs to.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub data: Option<Cow<'a, str>>,
    pub model: Cow<'a, str>,
    pub analysis: Cow<'a, str>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub generator: Option<Cow<'a, str>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub model_sha256: Option<Cow<'a, str>>,
    pub statistics: Cow<'a, IndexMap<String, f64>>,
    pub notes: Cow<'a, [String]>,
    pub channels: Vec<Entry<'a>>,
}

/// One channel of a document.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Entry<'a> {
    pub name: Cow<'a, str>,
    pub unit: Cow<'a, str>,
    pub meaning: Cow<'a, str>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[serde(deserialize_with = "values")]
    pub values: Option<Cow<'a, [f64]>>,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub gaps: bool,
}

/// Reads values; null, which JSON has instead of NaN, is a gap.
fn values<'de, 'a, D: Deserializer<'de>>(from: D) -> Result<Option<Cow<'a, [f64]>>, D::Error> {
    let read: Option<Vec<Option<f64>>> = Option::deserialize(from)?;
    let number = |x: Option<f64>| x.unwrap_or(f64::NAN);
    Ok(read.map(|list| list.into_iter().map(number).collect()))
}

impl<'a> Document<'a> {
    /// The whole of some results.
    pub fn of_results(results: &'a Results, meta: &'a Meta) -> Self {
        Self::new(RESULTS_FORMAT, results, meta, true)
    }

    /// The description of the results in the file named `data`.
    pub fn sidecar(data: String, results: &'a Results, meta: &'a Meta) -> Self {
        Self {
            data: Some(Cow::Owned(data)),
            ..Self::new(SIDECAR_FORMAT, results, meta, false)
        }
    }

    fn new(format: &'static str, results: &'a Results, meta: &'a Meta, values: bool) -> Self {
        let entry = |c: &'a Channel| Entry {
            name: Cow::Borrowed(c.name.as_str()),
            unit: Cow::Borrowed(c.unit.as_str()),
            meaning: Cow::Borrowed(c.meaning.as_str()),
            values: values.then_some(Cow::Borrowed(c.values.as_slice())),
            gaps: c.gaps,
        };
        Self {
            format: Cow::Borrowed(format),
            data: None,
            model: Cow::Borrowed(&results.model),
            analysis: Cow::Borrowed(&results.analysis),
            generator: meta.generator.as_deref().map(Cow::Borrowed),
            model_sha256: meta.model_sha256.as_deref().map(Cow::Borrowed),
            statistics: Cow::Borrowed(&results.statistics),
            notes: Cow::Borrowed(&results.notes),
            channels: results.channels.iter().map(entry).collect(),
        }
    }

    /// Origin as the document states it.
    pub fn meta(&self) -> Meta {
        Meta {
            model_sha256: self.model_sha256.as_deref().map(str::to_owned),
            generator: self.generator.as_deref().map(str::to_owned),
        }
    }
}
