//! Expressions with units and exact derivatives.
