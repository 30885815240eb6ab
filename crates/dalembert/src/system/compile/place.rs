//! Where in the model the compiler is.

/// An element in words and its path in the model.
#[derive(Clone, Debug)]
pub(super) struct Place {
    /// "joint 'A'".
    pub owner: String,
    /// "joint[2]".
    pub path: String,
}

impl Place {
    pub fn new(section: &str, index: usize, kind: &str, name: &str) -> Self {
        Self {
            owner: format!("{kind} '{name}'"),
            path: format!("{section}[{index}]"),
        }
    }

    /// Path of a key of the element.
    pub fn key(&self, key: &str) -> String {
        format!("{}.{key}", self.path)
    }
}
