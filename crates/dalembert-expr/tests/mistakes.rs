//! Every mistake with its place.

mod common;

use common::{errors, machine};
use dalembert_expr::{Dim, EmptyScope, Quantity, compile};

/// Code, start and end of each mistake.
fn found(text: &str) -> Vec<(&'static str, usize, usize)> {
    let errors = errors(text, &machine());
    errors
        .iter()
        .map(|e| (e.code, e.span.start, e.span.end))
        .collect()
}

#[test]
fn every_mistake_has_its_code_and_place() {
    let cases: &[(&str, &str, usize, usize)] = &[
        ("", "empty-expression", 0, 0),
        ("  ", "empty-expression", 0, 2),
        ("1 + $", "unexpected-character", 4, 5),
        ("30°", "unexpected-character", 2, 4),
        ("2**3", "unexpected-character", 1, 3),
        ("t = 3", "unexpected-character", 2, 3),
        ("`crank", "bad-name", 0, 6),
        ("`` + 1", "bad-name", 0, 2),
        ("crank. + 1", "missing-property", 5, 6),
        ("1 +", "unexpected-end", 3, 3),
        ("1 + * 2", "unexpected-word", 4, 5),
        ("sin(1", "missing-parenthesis", 3, 4),
        ("2*(1 + 3", "missing-parenthesis", 2, 3),
        ("1 + 2) * 3", "unexpected-word", 5, 6),
        ("2 t", "missing-operator", 0, 3),
        ("2 sin(t*1)", "missing-operator", 0, 5),
        ("(1)(2)", "missing-operator", 0, 4),
        ("2 (3)", "missing-operator", 0, 3),
        ("t 5 s", "missing-operator", 0, 3),
        ("5 mmm", "unknown-unit", 2, 5),
        ("5 m^1.5", "unit-exponent", 3, 7),
        ("5 m^2^2", "unit-exponent", 3, 6),
        ("1/2 in", "ambiguous-fraction", 0, 6),
        ("5 N*g", "ambiguous-name", 4, 5),
        ("0 < t < 1", "comparison-chain", 6, 7),
        ("crunk*2", "unknown-name", 0, 5),
        ("slider.y", "unknown-name", 0, 8),
        ("3*mm", "loose-unit", 2, 4),
        ("sin + 1", "function-without-arguments", 0, 3),
        ("sine(1)", "unknown-function", 0, 4),
        ("crank(2)", "unknown-function", 0, 5),
        ("crank.angle(2)", "unknown-function", 0, 11),
        ("atan2(1)", "argument-count", 0, 8),
        ("sin()", "argument-count", 0, 5),
        ("crank + 30 deg", "unit-mismatch", 0, 14),
        ("1 + (crank - load)", "unit-mismatch", 4, 18),
        ("crank < t", "unit-mismatch", 0, 9),
        ("sin(crank)", "unit-mismatch", 4, 9),
        ("2^crank", "unit-mismatch", 2, 7),
        ("crank^0.3", "unit-mismatch", 0, 9),
        ("crank^crank.angle", "unit-mismatch", 0, 17),
        ("sqrt(sqrt(crank))", "unit-mismatch", 0, 17),
        ("min(crank, t)", "unit-mismatch", 0, 13),
        ("if(t, 1, 2)", "unit-mismatch", 3, 4),
        ("if(1 < t, crank, t)", "unit-mismatch", 0, 19),
        ("not crank", "unit-mismatch", 4, 9),
        ("((crank^8)^8)^8", "unit-mismatch", 0, 15),
        ("1/0", "division-by-zero", 0, 3),
        ("crank/ratio", "division-by-zero", 0, 11),
        ("t/(1 - 1)", "division-by-zero", 0, 9),
        ("mod(t, 0)", "division-by-zero", 0, 9),
        ("ln(-1)", "not-finite", 0, 6),
        ("1e999", "not-finite", 0, 5),
        ("10^400", "not-finite", 0, 6),
    ];
    for &(text, code, start, end) in cases {
        assert_eq!(found(text), [(code, start, end)], "{text}");
    }
    assert_eq!(found(&"(".repeat(1000))[0].0, "expression-too-deep");
    assert_eq!(found(&"-".repeat(1000))[0].0, "expression-too-deep");
    assert_eq!(found(&"2^".repeat(1000))[0].0, "expression-too-deep");
    assert_eq!(found(&"1+".repeat(40_000))[0].0, "expression-too-long");
    let tall = format!("{}1{}", "blend(1, crank.angle, ".repeat(60), ")".repeat(60));
    assert_eq!(found(&tall)[0].0, "expression-too-deep");
}

#[test]
fn all_mistakes_come_at_once() {
    assert_eq!(
        found("crunk + 1/0 + sin(load) + 2 t"),
        [
            ("unknown-name", 0, 5),
            ("division-by-zero", 8, 11),
            ("unit-mismatch", 18, 22),
            ("missing-operator", 26, 29),
        ]
    );
    let two = found("1 ? 2 ; 3");
    assert_eq!(two.len(), 2);
}

#[test]
fn branches_that_are_never_taken_may_divide_by_zero() {
    let scope = machine();
    let text = "if(ratio == 0, 1, 1/ratio)";
    let program = compile(text, &scope, Quantity::Free).unwrap();
    assert_eq!(program.constant(), Some(1.0));
    assert_eq!(
        found("if(ratio != 0, 1, 1/ratio)"),
        [("division-by-zero", 18, 25)]
    );
}

#[test]
fn help_says_what_to_write() {
    let help = |text: &str| errors(text, &machine())[0].help.clone();
    assert_eq!(help("2 t"), "for a product write `2*t`");
    assert_eq!(help("5 mmm"), "did you mean `mm`?");
    assert_eq!(help("5 KG"), "did you mean `kg`?");
    assert_eq!(help("5 Nm"), "write `N m`");
    assert_eq!(help("slidr.x"), "did you mean `slider.x`?");
    assert_eq!(help("sine(1)"), "did you mean `sin` or `sinh`?");
    assert_eq!(help("sin + 1"), "write `sin(...)`");
    assert_eq!(help("30°"), "write `deg`");
    assert_eq!(help("0 < t < 1"), "write `a < b and b < c`");
    assert_eq!(
        help("crank(2)"),
        "`crank` is a value; for a product write `crank*(...)`"
    );
    assert_eq!(help("log(2)"), "write `ln` or `log10`");
    for (text, unit) in [
        ("200 Newton", "N"),
        ("3 meters", "m"),
        ("3 metre", "m"),
        ("90 degrees", "deg"),
        ("2 seconds", "s"),
        ("5 Kilograms", "kg"),
        ("2 feet", "ft"),
    ] {
        assert_eq!(help(text), format!("write `{unit}`"), "{text}");
    }
}

#[test]
fn habits_from_elsewhere_are_one_mistake_with_a_remedy() {
    let only = |text: &str| match errors(text, &machine()).as_slice() {
        [one] => (one.code, one.help.clone()),
        more => panic!("{text}: {more:?}"),
    };
    let choice = only("t > 1 ? 2 : 3");
    assert_eq!(choice.1, "write `if(condition, a, b)` for a choice");
    let comma = only("0,5 kg");
    assert!(
        comma.1.contains("decimal point, as in `0.5 kg`"),
        "{comma:?}"
    );
    let spaced = only("-3 * return spring.length + 2 mm");
    let written = "write `return spring`.length".to_owned();
    assert_eq!(spaced, ("bad-name", written));
    // Two known names side by side are still a product.
    assert_eq!(only("2 * crank load").0, "missing-operator");
    let rate = |text: &str, expected: Dim| {
        compile(text, &machine(), expected.into()).unwrap_err()[0]
            .help
            .clone()
    };
    assert!(rate("360 deg * t", Dim::NONE).ends_with("write `deg/s`"));
    assert!(rate("3 mm * t", Dim::LENGTH).ends_with("write `mm/s`"));
    assert!(rate("3 mm * t", Dim::NONE).starts_with("check the terms"));
}

#[test]
fn mismatches_name_both_sides_in_words() {
    let message = |text: &str| errors(text, &machine())[0].message.clone();
    assert_eq!(
        message("crank + 30 deg"),
        "`crank + 30 deg` adds a length (m) and an angle or plain number"
    );
    assert_eq!(
        message("sin(load)"),
        "`sin` takes an angle or plain number, but this is a force (N)"
    );
    let place = Quantity::Known(Dim::STIFFNESS);
    let wrong = compile("5 N", &EmptyScope, place).unwrap_err();
    assert_eq!(
        wrong[0].message,
        "this must be a stiffness (N/m), but it is a force (N)"
    );
    assert_eq!(wrong[0].span, 0..3);
    assert_eq!(wrong[0].to_string(), wrong[0].message);
}

#[test]
fn a_constant_divided_by_a_bare_number_is_likely_of_its_own_dimension() {
    let scope = machine();
    let doubts = |text: &str, place: Quantity| -> Vec<(&'static str, String)> {
        let program = compile(text, &scope, place).unwrap_or_else(|e| panic!("{text}: {e:?}"));
        program
            .doubts()
            .iter()
            .map(|d| (d.code, d.message.clone()))
            .collect()
    };
    let mass = Quantity::Known(Dim::MASS);
    let length = Quantity::Known(Dim::LENGTH);
    let doubtful: [(&str, Quantity, &str); 9] = [
        (
            "crank/2",
            mass,
            "this must be a mass (kg), but it seems to be a length (m)",
        ),
        (
            "-(load/(2*pi))",
            length,
            "this must be a length (m), but it seems to be a force (N)",
        ),
        (
            "crank + load/2",
            length,
            "it seems that `crank + load/2` adds a length (m) and a force (N)",
        ),
        (
            "max(crank/2, load/3)",
            Quantity::Free,
            "it seems that `max(crank/2, load/3)` mixes a length (m) and a force (N)",
        ),
        (
            "sin(crank/2)",
            Quantity::Free,
            "`sin` takes an angle or plain number, but this seems to be a length (m)",
        ),
        (
            "crank^2/12",
            length,
            "this must be a length (m), but it seems to be an area (m^2)",
        ),
        (
            "sqrt(crank*load/2)",
            mass,
            "this must be a mass (kg), but it seems to be a quantity (kg^(1/2) m/s)",
        ),
        (
            "crank/cos(slider.x/1 m)",
            mass,
            "this must be a mass (kg), but it seems to be a length (m)",
        ),
        (
            "slider.x*(crank/2)",
            Quantity::Known(Dim::FORCE),
            "this must be a force (N), but it seems to be an area (m^2)",
        ),
    ];
    for (text, place, message) in doubtful {
        let message = message.to_owned();
        assert_eq!(doubts(text, place), [("doubtful-unit", message)], "{text}");
    }
    let inertia = Quantity::Known(Dim::INERTIA);
    let angle = Quantity::Known(Dim::NONE);
    for (text, place) in [
        // The bare number may stand for a mass, a stiffness, a rate, a time.
        ("0.5 * crank^2 / 12", inertia),
        ("250 * slider.x", Quantity::Known(Dim::FORCE)),
        ("30 deg + 150*t", angle),
        ("pi*t/5 + t/0.1", angle),
        ("exp(-t/0.1)", length),
        ("30 deg/0.2*t", angle),
        ("crank*ratio", mass),
        ("crank/1 m*3", mass),
        // Agreement.
        ("crank/2", length),
        ("2*pi*crank/3 + slider.x/2 + 0.3", length),
        ("crank/2 + 0.3 m", length),
        ("if(t > 1, crank/2, slider.x)", length),
        ("sqrt(crank^2/4 + (crank/2)^2)", length),
    ] {
        assert_eq!(doubts(text, place), [], "{text}");
    }
    let quantity = |text: &str| compile(text, &scope, Quantity::Free).unwrap().quantity();
    assert_eq!(quantity("crank/2"), Quantity::Likely(Dim::LENGTH));
    assert_eq!(quantity("crank/2 + 1 m"), length);
    assert_eq!(quantity("crank*ratio/2"), Quantity::Free);
}

#[test]
fn every_mistake_has_a_remedy() {
    let scope = machine();
    for text in [
        "",
        "1 ? 2",
        "1 ** 2",
        "`a",
        "``",
        "crank.",
        "1 +",
        "1 + )",
        "(1",
        "1 )",
        "2 t",
        "5 xyzzy",
        "5 m^1.5",
        "0 < t < 1",
        "qwerty",
        "mm",
        "sin",
        "xyzzy(1)",
        "sin(1, 2)",
        "crank + t",
        "sin(load)",
        "crank^t",
        "crank^100^2",
        "1/0",
        "1e308*10",
        "ln(-1)",
        "1/2 in",
    ] {
        let found = dalembert_expr::compile(text, &scope, Quantity::Free);
        for error in found.expect_err(text) {
            assert!(!error.help.is_empty(), "{text}: {error:?}");
        }
    }
}
