//! Checks that several parts of an animation need.

use super::AnimationError;

/// A list has the expected length and only finite numbers.
pub(super) fn list(
    element: &str,
    field: &'static str,
    values: &[f64],
    expected: usize,
) -> Result<(), AnimationError> {
    if values.len() != expected {
        return Err(AnimationError::WrongLength {
            element: element.to_owned(),
            field,
            found: values.len(),
            expected,
        });
    }
    finite(element, field, values)
}

/// Every number is finite.
pub(super) fn finite(
    element: &str,
    field: &'static str,
    values: &[f64],
) -> Result<(), AnimationError> {
    match values.iter().position(|v| !v.is_finite()) {
        Some(index) => Err(AnimationError::NotFinite {
            element: element.to_owned(),
            field,
            index,
        }),
        None => Ok(()),
    }
}

/// Every size of a form is finite and positive.
pub(super) fn positive(
    element: &str,
    form: &'static str,
    sizes: &[(&'static str, f64)],
) -> Result<(), AnimationError> {
    for (index, (size, value)) in sizes.iter().enumerate() {
        if !value.is_finite() {
            return Err(AnimationError::NotFinite {
                element: element.to_owned(),
                field: form,
                index,
            });
        }
        if *value <= 0.0 {
            return Err(AnimationError::NotPositive {
                element: element.to_owned(),
                form,
                size,
                value: *value,
            });
        }
    }
    Ok(())
}

/// The first size is smaller than the second.
pub(super) fn ordered(
    element: &str,
    form: &'static str,
    small: (&'static str, f64),
    large: (&'static str, f64),
) -> Result<(), AnimationError> {
    if small.1 < large.1 {
        return Ok(());
    }
    Err(AnimationError::NotOrdered {
        element: element.to_owned(),
        form,
        small: small.0,
        large: large.0,
    })
}

/// At least so many things are there.
pub(super) fn enough(
    element: &str,
    form: &'static str,
    field: &'static str,
    found: usize,
    least: usize,
) -> Result<(), AnimationError> {
    if found >= least {
        return Ok(());
    }
    Err(AnimationError::TooFew {
        element: element.to_owned(),
        form,
        field,
        found,
        least,
    })
}

/// A list comes in threes, at least `least` of them; gives their number.
pub(super) fn triples(
    element: &str,
    form: &'static str,
    field: &'static str,
    length: usize,
    least: usize,
) -> Result<usize, AnimationError> {
    if !length.is_multiple_of(3) {
        return Err(AnimationError::NotTriples {
            element: element.to_owned(),
            form,
            field,
            found: length,
        });
    }
    enough(element, form, field, length / 3, least)?;
    Ok(length / 3)
}

/// Finite points, at least `least` of them; gives their number.
pub(super) fn points(
    element: &str,
    form: &'static str,
    field: &'static str,
    values: &[f64],
    least: usize,
) -> Result<usize, AnimationError> {
    finite(element, field, values)?;
    triples(element, form, field, values.len(), least)
}
