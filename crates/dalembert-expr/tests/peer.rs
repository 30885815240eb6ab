//! Random expressions against Rust's own arithmetic and against another parser.

mod common;

use common::random::Random;
use common::{compile, free};
use exmex::Express;

const NAMES: [&str; 4] = ["u", "v", "x", "y"];

/// A random text and its value, computed beside it by Rust itself.
///
/// For exmex there are neither functions nor signs in it: version 0.21 gives wrong values for some
/// sums in parentheses behind them, such as `x*((-v) - (-(y + 1.976 + (0.446*1.309))))`.
struct Sample {
    text: String,
    value: f64,
}

fn sample(random: &mut Random, values: &[f64; 4], depth: usize, functions: bool) -> Sample {
    let with = |text: String, value: f64| Sample { text, value };
    if depth == 0 || random.below(6) == 0 {
        if random.below(3) == 0 {
            let text = format!("{:.3}", random.between(0.1, 3.0));
            let value = text.parse().unwrap();
            return with(text, value);
        }
        let k = random.below(4);
        return with(NAMES[k].to_owned(), values[k]);
    }
    type Native = fn(f64) -> f64;
    const FUNCTIONS: [(&str, Native); 12] = [
        ("sin", f64::sin),
        ("cos", f64::cos),
        ("tan", f64::tan),
        ("exp", f64::exp),
        ("sinh", f64::sinh),
        ("cosh", f64::cosh),
        ("tanh", f64::tanh),
        ("atan", f64::atan),
        ("abs", f64::abs),
        ("sqrt", f64::sqrt),
        ("ln", f64::ln),
        ("floor", f64::floor),
    ];
    let mut part = || sample(random, values, depth - 1, functions);
    let (a, b) = (part(), part());
    match random.below(10) {
        0 | 1 => with(format!("{} + ({})", a.text, b.text), a.value + b.value),
        2 => with(format!("{} - ({})", a.text, b.text), a.value - b.value),
        3 | 4 => with(format!("({})*({})", a.text, b.text), a.value * b.value),
        5 => with(format!("({}) / ({})", a.text, b.text), a.value / b.value),
        6 => {
            let power = random.below(4);
            with(
                format!("(({})^{power})", a.text),
                a.value.powi(power as i32),
            )
        }
        7 if functions => with(format!("(-({}))", a.text), -a.value),
        8 | 9 if functions => {
            let (name, function) = random.pick(&FUNCTIONS);
            with(format!("{name}({})", a.text), function(a.value))
        }
        _ => with(
            format!("{} * {}", factor(&a), factor(&b)),
            a.value * b.value,
        ),
    }
}

/// A part of a product: in parentheses where it is not a single word.
fn factor(part: &Sample) -> String {
    match part.text.contains(' ') || part.text.contains('*') {
        true => format!("({})", part.text),
        false => part.text.clone(),
    }
}

#[test]
fn random_expressions_have_the_value_that_rust_and_exmex_give() {
    let mut random = Random::new(20);
    let scope = free(&NAMES);
    let mut compared = [0, 0];
    for count in 0..20_000 {
        let functions = count % 2 == 0;
        let values = std::array::from_fn(|_| random.between(-2.0, 2.0));
        let sample = sample(&mut random, &values, 5, functions);
        let text = &sample.text;
        // A folded constant such as ln(-1) is refused here and a NaN there.
        let Ok(ours) = dalembert_expr::compile(text, &scope, dalembert_expr::Quantity::Free) else {
            continue;
        };
        let needed: Vec<f64> = ours.slots().iter().map(|k| values[*k]).collect();
        let found = ours.eval(&needed);
        let agrees = |other: f64| {
            found == other
                || (found.is_nan() && other.is_nan())
                || (found - other).abs() <= tolerance(&ours, &needed, other)
        };
        assert!(
            agrees(sample.value),
            "{text} at {values:?}: {found}, rust {}",
            sample.value
        );
        compared[0] += usize::from(found.is_finite());
        if functions {
            continue;
        }
        let peer = exmex::parse::<f64>(text).unwrap_or_else(|e| panic!("{text}: {e}"));
        let find = |name: &String| values[NAMES.iter().position(|n| n == name).unwrap()];
        let arguments: Vec<f64> = peer.var_names().iter().map(find).collect();
        let theirs = peer.eval(&arguments).unwrap();
        assert!(
            agrees(theirs),
            "{text} at {values:?}: {found}, exmex {theirs}"
        );
        compared[1] += usize::from(found.is_finite());
    }
    println!("finite values compared with rust and with exmex: {compared:?}");
    assert!(compared[0] > 10_000 && compared[1] > 5_000, "{compared:?}");
}

/// What rounding may do: some units in the last place of the value, and of the arguments as far
/// as they move it.
fn tolerance(program: &dalembert_expr::Program, values: &[f64], value: f64) -> f64 {
    let mut gradient = vec![0.0; values.len()];
    program.gradient(values, &mut gradient);
    let moved = gradient.iter().zip(values).map(|(g, x)| (g * x).abs());
    1e-13 * (1.0 + value.abs() + moved.sum::<f64>())
}

#[test]
fn the_language_of_both_agrees_on_precedence() {
    let scope = free(&["x"]);
    for text in [
        "1+2*x-4/5*6",
        "2*x^2+x",
        "1-2-3+x",
        "8/4/2*x",
        "(1+x)*(2-x)/x^2",
    ] {
        let peer = exmex::parse::<f64>(text).unwrap().eval(&[0.7]).unwrap();
        assert!(
            (compile(text, &scope).eval(&[0.7]) - peer).abs() < 1e-15 * 8.0,
            "{text}"
        );
    }
}
