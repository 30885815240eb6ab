//! Ranges, ticks, labels.

use crate::plot::label;
use crate::plot::range::Range;
use crate::plot::text;
use crate::plot::ticks::Ticks;

fn range(low: f64, high: f64) -> Range {
    Range { low, high }
}

fn labels(ticks: &Ticks) -> Vec<&str> {
    ticks
        .marks
        .iter()
        .map(|(_, label)| label.as_str())
        .collect()
}

#[test]
fn ticks_are_at_steps_of_one_two_and_five() {
    let cases: [(f64, f64, f64, &[&str]); 6] = [
        (0.0, 1.0, 5.0, &["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]),
        (
            -0.3,
            0.31,
            6.0,
            &["−0.3", "−0.2", "−0.1", "0.0", "0.1", "0.2", "0.3"],
        ),
        (0.0, 25.0, 5.0, &["0", "5", "10", "15", "20", "25"]),
        (3.0, 1004.0, 5.0, &["200", "400", "600", "800", "1000"]),
        (0.012, 0.049, 4.0, &["0.02", "0.03", "0.04"]),
        (
            -0.04,
            0.04,
            3.0,
            &["−0.04", "−0.02", "0.00", "0.02", "0.04"],
        ),
    ];
    for (low, high, wanted, expected) in cases {
        let ticks = Ticks::new(range(low, high), wanted);
        assert_eq!(labels(&ticks), expected, "{low} to {high}");
        assert_eq!((ticks.exponent, &ticks.offset), (0, &None));
    }
}

#[test]
fn small_and_large_numbers_share_an_exponent_of_three() {
    let ticks = Ticks::new(range(-3.3e-13, 3.3e-13), 4.0);
    assert_eq!(labels(&ticks), ["−200", "0", "200"]);
    assert_eq!(ticks.exponent, -15);
    let ticks = Ticks::new(range(0.0, 2.5e6), 5.0);
    assert_eq!(labels(&ticks), ["0.0", "0.5", "1.0", "1.5", "2.0", "2.5"]);
    assert_eq!(ticks.exponent, 6);
}

#[test]
fn ranges_far_from_zero_count_from_a_round_number() {
    let ticks = Ticks::new(range(1234.5 - 1.1e-5, 1234.5 + 1.1e-5), 4.0);
    assert_eq!(labels(&ticks), ["−10", "−5", "0", "5", "10"]);
    assert_eq!(ticks.exponent, -6);
    assert_eq!(ticks.offset.as_deref(), Some("1234.5"));
    let ticks = Ticks::new(range(-2.000_000_3, -1.999_999_7), 3.0);
    assert_eq!(ticks.offset.as_deref(), Some("−2"));
    // Labels, exponent and offset together are the tick values.
    for (value, label) in &ticks.marks {
        let number: f64 = label.replace('−', "-").parse().unwrap();
        let read = -2.0 + number * 10f64.powi(ticks.exponent);
        assert!((read - value).abs() < 1e-15, "{label} is not {value}");
    }
}

#[test]
fn tick_labels_read_back_as_the_tick_values_in_any_range() {
    for low in [-7.3, -1e-3, 0.0, 0.9, 12.0, 4e5] {
        for power in -9..12 {
            for wanted in [2.0, 5.0, 12.0] {
                let r = range(low, low + 3.7 * 10f64.powi(power));
                let ticks = Ticks::new(r, wanted);
                if ticks.offset.is_some() {
                    continue;
                }
                let count = ticks.marks.len() as f64;
                assert!(
                    count >= 0.5 * wanted && count <= 2.0 * wanted + 1.0,
                    "{r:?} {count}"
                );
                for (value, label) in &ticks.marks {
                    let number: f64 = label.replace('−', "-").parse().unwrap();
                    let read = number * 10f64.powi(ticks.exponent);
                    assert!((read - value).abs() <= 1e-9 * r.length(), "{r:?}: {label}");
                    assert!(label.len() <= 12, "{r:?}: {label}");
                }
            }
        }
    }
}

#[test]
fn constants_get_a_range_around_them() {
    let of = |values: &[f64]| Range::of(values.iter().copied()).unwrap().opened();
    assert_eq!(of(&[0.0, 0.0]), range(-1.0, 1.0));
    assert_eq!(of(&[5.0]), range(4.5, 5.5));
    assert_eq!(of(&[-5.0, -5.0]), range(-5.5, -4.5));
    // Differences in the last bits are rounding, not motion.
    let nearly = of(&[1.0, 1.0 + 1e-15]);
    assert!((nearly.low - 0.9).abs() < 1e-12 && (nearly.high - 1.1).abs() < 1e-12);
    // A small spread about zero is real.
    assert_eq!(of(&[-1e-17, 1e-17]), range(-1e-17, 1e-17));
    assert_eq!(Range::of([f64::NAN, f64::INFINITY]), None);
    assert_eq!(of(&[f64::NAN, 1.0, 2.0]), range(1.0, 2.0));
    let huge = of(&[-f64::MAX, f64::MAX]);
    assert!(huge.padded(0.05).length().is_finite());
}

#[test]
fn axis_labels_say_what_the_curves_share() {
    assert_eq!(label::common(&["crank.angle"]), "crank.angle");
    assert_eq!(label::common(&["crank.angle", "rod.angle"]), "angle");
    assert_eq!(label::common(&["slider.x", "slider.y"]), "slider");
    assert_eq!(label::common(&["A.force_x", "A.force_y"]), "A.force");
    assert_eq!(label::common(&["A.force_x", "B.force_y"]), "");
    assert_eq!(label::common(&["größe_1", "größe_2"]), "größe");
    assert_eq!(label::common(&["ä", "ö"]), "");
    assert_eq!(label::common(&[]), "");
    assert_eq!(label::with_unit("x", "m"), "x [m]");
    assert_eq!(label::with_unit("", "m"), "[m]");
    assert_eq!(label::with_unit("x", ""), "x");
}

#[test]
fn long_text_is_shortened_in_its_middle() {
    let name = "a_body_with_a_very_long_name.angular_velocity";
    assert_eq!(text::fit(name, 12.0, 1000.0), name);
    let short = text::fit(name, 12.0, 120.0);
    assert!(text::width(&short, 12.0) <= 120.0);
    assert!(short.starts_with("a_body") && short.ends_with("locity") && short.contains('…'));
    assert_eq!(text::fit(name, 12.0, 0.0), "…");
}
