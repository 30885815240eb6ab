//! Numbers and names in sentences.

/// A number of things: "1 driver", "2 drivers".
pub fn counted(count: usize, thing: &str) -> String {
    if count == 1 {
        format!("1 {thing}")
    } else {
        format!("{count} {thing}s")
    }
}

/// A number with the six digits that a person reads.
pub fn readable(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let magnitude = x.abs();
    if !(1e-4..1e7).contains(&magnitude) {
        return format!("{x:.4e}");
    }
    let digits = (5 - magnitude.log10().floor() as i32).clamp(0, 9) as usize;
    let text = format!("{x:.digits$}");
    if text.contains('.') {
        return text.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    text
}

/// "A, B and C", shortened where the list is long.
pub fn listed<T: AsRef<str>>(names: &[T]) -> String {
    const MOST: usize = 10;
    let joined = |part: &[T]| {
        part.iter()
            .map(AsRef::as_ref)
            .collect::<Vec<_>>()
            .join(", ")
    };
    match names {
        [] => "nothing".to_owned(),
        [only] => only.as_ref().to_owned(),
        _ if names.len() > MOST => {
            format!("{} and {} more", joined(&names[..MOST]), names.len() - MOST)
        }
        [rest @ .., last] => format!("{} and {}", joined(rest), last.as_ref()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_thing_is_not_many() {
        assert_eq!(counted(0, "row"), "0 rows");
        assert_eq!(counted(1, "row"), "1 row");
        assert_eq!(counted(2, "row"), "2 rows");
    }

    #[test]
    fn digits_are_few() {
        assert_eq!(readable(0.1 + 0.2), "0.3");
        assert_eq!(readable(-1234.56789), "-1234.57");
        assert_eq!(readable(1.0 / 3.0), "0.333333");
        assert_eq!(readable(2e-5), "2.0000e-5");
        assert_eq!(readable(f64::INFINITY), "inf");
    }
}
