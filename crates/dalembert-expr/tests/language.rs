//! What expressions mean.

mod common;

use common::{compile, compile_for, free, machine, value};
use dalembert_expr::{Dim, EmptyScope, Quantity, names, parse_quantity, parse_unit};
use std::f64::consts::PI;

#[test]
fn operators_bind_as_in_mathematics() {
    assert_eq!(value("1 + 2*3"), 7.0);
    assert_eq!(value("-2^2"), -4.0);
    assert_eq!(value("2^3^2"), 512.0);
    assert_eq!(value("2^-1"), 0.5);
    assert_eq!(value("10 - 4 - 3"), 3.0);
    assert_eq!(value("12/2/3"), 2.0);
    assert_eq!(value("2*-3"), -6.0);
    assert_eq!(value("--3"), 3.0);
    assert_eq!(value("(1 + 2)*3"), 9.0);
    assert_eq!(value(".5e1 + 1.5E-3"), 5.0015);
    assert_eq!(value("1 < 2 and not 3 < 2"), 1.0);
    assert_eq!(value("0 and 0 or 1"), 1.0);
    assert_eq!(value("1 + 1 == 2"), 1.0);
    assert_eq!(value("1 != 1"), 0.0);
    assert_eq!(value("if(2 > 1, 5, 1/0)"), 5.0);
    assert_eq!(value("tau - 2*pi"), 0.0);
}

#[test]
fn functions_have_their_usual_values() {
    let cases = [
        ("sin(pi/2)", 1.0),
        ("cos(0)", 1.0),
        ("tan(0.5)", 0.5_f64.tan()),
        ("asin(1)", PI / 2.0),
        ("acos(1)", 0.0),
        ("atan(1)", PI / 4.0),
        ("atan2(1, -1)", 0.75 * PI),
        ("sinh(1)", 1_f64.sinh()),
        ("cosh(1)", 1_f64.cosh()),
        ("tanh(1)", 1_f64.tanh()),
        ("exp(1)", std::f64::consts::E),
        ("ln(2)", std::f64::consts::LN_2),
        ("log10(1000)", 3.0),
        ("sqrt(16)", 4.0),
        ("abs(-3)", 3.0),
        ("sign(-3) + sign(0) + 10*sign(2)", 9.0),
        ("min(3, 1, 2)", 1.0),
        ("max(3, 1, 4, 2)", 4.0),
        ("hypot(3, 4)", 5.0),
        ("floor(-1.5)", -2.0),
        ("mod(-1, 3)", 2.0),
        ("mod(370 deg, 360 deg)", 370.0 * PI / 180.0 - 2.0 * PI),
        ("step(-1) + step(0)", 1.0),
        ("blend(1, 0, 4)", 0.103515625),
        ("blend(5, 0, 4)", 1.0),
        ("blend(-5, 0, 4)", 0.0),
        ("blend(1, 2, 2)", 0.0),
    ];
    for (text, expected) in cases {
        assert_eq!(value(text), expected, "{text}");
    }
}

#[test]
fn units_stand_after_numbers() {
    let si = |text: &str| parse_quantity(text, Quantity::Free).unwrap();
    assert_eq!(si("30 deg"), 30.0 * PI / 180.0);
    assert_eq!(si("150mm"), 0.15);
    assert_eq!(si("1200 rpm"), 40.0 * PI);
    assert_eq!(si("5 lbf"), 5.0 * 4.4482216152605);
    assert_eq!(si("9.81 m/s^2"), 9.81);
    assert_eq!(si("0.1 kg*m^2"), si("0.1 kg m^2"));
    assert_eq!(si("72 km/h"), 20.0);
    assert_eq!(si("2 m s^-1"), 2.0);
    assert_eq!(si("-5 mm^2"), -5e-6);
    assert_eq!(si("(2 mm)^3"), 2e-3_f64.powi(3));
    assert_eq!(si("10 mm / 2 mm"), 5.0);
    assert_eq!(si("5 min"), 300.0);
    assert_eq!(si("1 N m + 1 J"), 2.0);
    assert_eq!(si("2 N*min(1, 3)"), 2.0);
    assert_eq!(si("3 in"), 3.0 * 254.0 / 10000.0);
    assert_eq!(parse_unit("kg m^2").unwrap().dim(), Dim::INERTIA);
    assert_eq!(parse_unit("mm").unwrap().to_si(250.0), 0.25);
    assert_eq!(parse_unit(" ").unwrap().to_si(2.0), 2.0);
    assert_eq!(parse_unit("mm 3").unwrap_err()[0].span, 3..4);
    assert_eq!(parse_unit("mmm").unwrap_err()[0].code, "unknown-unit");
}

#[test]
fn dimensions_follow_the_operations() {
    let scope = machine();
    let dim = |text: &str| compile(text, &scope).quantity();
    let known = Quantity::Known;
    assert_eq!(dim("crank * load"), known(Dim::MOMENT));
    assert_eq!(dim("slider.x / t"), known(Dim::VELOCITY));
    assert_eq!(dim("crank^2"), known(Dim::AREA));
    assert_eq!(dim("sqrt(crank*slider.x)"), known(Dim::LENGTH));
    assert_eq!(dim("(slider.x^2)^1.5"), known(Dim::VOLUME));
    assert_eq!(dim("2 * crank"), Quantity::Free);
    assert_eq!(dim("1 + crank"), known(Dim::LENGTH));
    assert_eq!(dim("sin(crank.angle)"), Quantity::Free);
    assert_eq!(dim("30 deg + 150*t"), known(Dim::NONE));
    assert_eq!(dim("hypot(crank, slider.x)"), known(Dim::LENGTH));
    assert_eq!(dim("atan2(crank, slider.x)"), known(Dim::NONE));
    assert_eq!(dim("if(t > 1 s, crank, slider.x)"), known(Dim::LENGTH));
    assert_eq!(dim("t > 1"), known(Dim::NONE));
    assert_eq!(dim("`return spring`.length"), known(Dim::LENGTH));
    assert_eq!(dim("load + 5 kg m s^-2"), known(Dim::FORCE));
    let place = known(Dim::FORCE);
    assert_eq!(compile_for("5 * t", &scope, place).quantity(), place);
}

#[test]
fn programs_know_their_variables() {
    let scope = machine();
    let program = compile(
        "slider.x + 2*t + if(1 > 2, `return spring`.length, 3)",
        &scope,
    );
    assert_eq!(program.slots(), [0, 3]);
    assert_eq!(program.constant(), None);
    assert_eq!(program.eval(&[10.0, 1.0]), 24.0);
    assert_eq!(
        program.text(),
        "slider.x + 2*t + if(1 > 2, `return spring`.length, 3)"
    );
    assert_eq!(compile("crank*2", &scope).constant(), Some(0.3));
    assert!(compile("crank*2", &scope).slots().is_empty());
}

#[test]
fn long_sums_stay_shallow_and_deep_texts_work() {
    let scope = free(&["x"]);
    let sum = vec!["x"; 5000].join(" + ");
    let program = compile(&sum, &scope);
    assert!(program.stack_depth() <= 2);
    assert_eq!(program.eval(&[1.0]), 5000.0);
    let deep = format!("{}x{}", "(1 - ".repeat(60), ")".repeat(60));
    assert_eq!(compile(&deep, &scope).eval(&[0.25]), 0.25);
    // A stack deeper than the small one.
    let tall = format!("{}x{}", "(x*x - sin(x))/(x - ".repeat(12), ")".repeat(12));
    let deep = compile(&tall, &scope);
    let mut expected = 0.7_f64;
    for _ in 0..12 {
        expected = (0.49 - 0.7_f64.sin()) / (0.7 - expected);
    }
    assert!((deep.eval(&[0.7]) / expected - 1.0).abs() < 1e-12);
}

#[test]
fn branches_and_conditions_follow_their_values() {
    let scope = free(&["x", "y"]);
    let program = compile(
        "1 + if(x < 0, if(y < 0, -3, -x), if(not y, 7, x*y)) * 2",
        &scope,
    );
    assert_eq!(program.eval(&[-2.0, -1.0]), -5.0);
    assert_eq!(program.eval(&[-2.0, 1.0]), 5.0);
    assert_eq!(program.eval(&[2.0, 0.0]), 15.0);
    assert_eq!(program.eval(&[2.0, 3.0]), 13.0);
    let both = compile("(x > 1 and y > 1) + 10*(x > 1 or y > 1)", &scope);
    assert_eq!(both.eval(&[2.0, 2.0]), 11.0);
    assert_eq!(both.eval(&[2.0, 0.0]), 10.0);
    assert_eq!(both.eval(&[0.0, 0.0]), 0.0);
}

#[test]
fn the_first_part_without_a_value_is_found() {
    let scope = free(&["x"]);
    let program = compile("1 + sqrt(x)*2", &scope);
    assert_eq!(program.first_non_finite(&[-1.0]), Some(4..11));
    assert_eq!(program.first_non_finite(&[1.0]), None);
}

#[test]
fn free_names_are_listed_in_order() {
    let found = names("sin(b*t) + `a b`.x.y - pi + 5 mm").unwrap();
    let plain: Vec<_> = found
        .iter()
        .map(|(p, s)| (p.join("/"), s.clone()))
        .collect();
    let expected = [("b", 4..5), ("t", 6..7), ("a b/x/y", 11..20)];
    let expected = expected.map(|(n, s)| (n.to_owned(), s));
    assert_eq!(plain, expected);
    assert!(names("1 +").is_err());
    assert!(dalembert_expr::compile("x", &EmptyScope, Quantity::Free).is_err());
}

#[test]
fn parts_that_can_jump_are_named() {
    for (text, expected) in [
        ("sign(x) + 2*x", vec!["sign(x)"]),
        ("3*floor(2*x) - step(x)", vec!["floor(2*x)", "step(x)"]),
        ("mod(x, 2)", vec!["mod(x, 2)"]),
        ("if(x > 1, x, 0)", vec!["x > 1"]),
        ("abs(x) + min(x, 1) + tanh(x) + blend(x, 0, 1)", vec![]),
    ] {
        let program = compile(text, &free(&["x"]));
        assert_eq!(program.jumps().collect::<Vec<_>>(), expected, "{text}");
    }
}
