//! Numbers for people.

/// A number with six significant digits, as C's %.6g writes it; zero is a point.
pub(super) fn short(x: f64) -> String {
    if x == 0.0 {
        return ".".to_owned();
    }
    if !x.is_finite() {
        return x.to_string();
    }
    let text = format!("{x:.5e}");
    // The exponent after rounding: 999999.7 is 1e6.
    let Some((mantissa, exponent)) = text.split_once('e') else {
        return text;
    };
    let Ok(exponent) = exponent.parse::<i32>() else {
        return text;
    };
    if (-4..6).contains(&exponent) {
        let decimals = usize::try_from(5 - exponent).unwrap_or(0);
        trimmed(&format!("{x:.decimals$}")).to_owned()
    } else {
        format!("{}e{exponent}", trimmed(mantissa))
    }
}

fn trimmed(text: &str) -> &str {
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn numbers_have_six_digits() {
        for (x, text) in [
            (0.0, "."),
            (-0.0, "."),
            (1.0, "1"),
            (-2.5, "-2.5"),
            (1.0 / 3.0, "0.333333"),
            (123_456.7, "123457"),
            (999_999.7, "1e6"),
            (0.000_123_456_78, "0.000123457"),
            (0.000_012_345_678, "1.23457e-5"),
            (-1.5e20, "-1.5e20"),
            (100_000.0, "100000"),
        ] {
            assert_eq!(short(x), text);
        }
    }
}
