//! Where results come from.

use sha2::{Digest, Sha256};
use std::fmt::Write;

/// Origin of results: which model text and which program made them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Meta {
    /// SHA-256 of the model file's text, 64 lower-case hexadecimal digits.
    pub model_sha256: Option<String>,
    /// Program and version that computed the results.
    pub generator: Option<String>,
}

impl Default for Meta {
    /// No model text, this version of dalembert.
    fn default() -> Self {
        Self {
            model_sha256: None,
            generator: Some(concat!("dalembert ", env!("CARGO_PKG_VERSION")).to_owned()),
        }
    }
}

impl Meta {
    /// Origin in a model text, which is remembered by its hash.
    pub fn of_model_text(text: &str) -> Self {
        let mut hex = String::with_capacity(64);
        for byte in Sha256::digest(text.as_bytes()) {
            // Writing to a String cannot fail.
            let _ = write!(hex, "{byte:02x}");
        }
        Self {
            model_sha256: Some(hex),
            ..Self::default()
        }
    }
}
