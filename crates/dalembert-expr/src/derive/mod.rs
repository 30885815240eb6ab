//! Numbers that carry derivatives, and the elementary functions on them.

pub(crate) mod bivariate;
pub(crate) mod dual;
pub(crate) mod hyper_dual;
pub(crate) mod jet2;
pub(crate) mod jet3;
pub(crate) mod scalar;
pub(crate) mod univariate;
