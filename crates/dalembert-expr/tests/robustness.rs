//! Nonsense of every sort is refused or computed, never a panic.

mod common;

use common::machine;
use common::random::Random;
use dalembert_expr::{Jet2, Quantity, compile, names, parse_unit};

const WORDS: &[&str] = &[
    "t",
    "crank",
    "crank.angle",
    "slider.x",
    "`return spring`.length",
    "ratio",
    "load",
    "zz",
    "pi",
    "1",
    "0",
    "2.5",
    "1e308",
    ".5e-3",
    "mm",
    "deg",
    "N",
    "s",
    "m",
    "+",
    "-",
    "*",
    "/",
    "^",
    "(",
    ")",
    ",",
    "<",
    ">=",
    "==",
    "!=",
    "and",
    "or",
    "not",
    "if(",
    "sin(",
    "atan2(",
    "min(",
    "blend(",
    "mod(",
    "sqrt(",
    "ln(",
    "5 mm",
    "3 rad/s",
    ".",
    "`",
    "$",
    "é",
    "²",
    " ",
    "\n",
];

#[test]
fn random_words_never_panic() {
    let mut random = Random::new(30);
    let scope = machine();
    let mut compiled = 0;
    for _ in 0..60_000 {
        let count = 1 + random.below(9);
        let words: Vec<&str> = (0..count).map(|_| *random.pick(WORDS)).collect();
        let joint = *random.pick(&["", " "]);
        let text = words.join(joint);
        let _ = (names(&text), parse_unit(&text));
        match compile(&text, &scope, Quantity::Free) {
            Ok(program) => {
                compiled += 1;
                let values = vec![0.7; program.slots().len()];
                let mut gradient = values.clone();
                let value = program.eval(&values);
                let again = program.gradient(&values, &mut gradient);
                assert!(
                    value == again || (value.is_nan() && again.is_nan()),
                    "{text}"
                );
                let jets: Vec<Jet2> = values.iter().map(|v| Jet2::time(*v)).collect();
                let again = program.eval_jet(&jets).v;
                assert!(
                    value == again || (value.is_nan() && again.is_nan()),
                    "{text}"
                );
            }
            Err(errors) => {
                assert!(!errors.is_empty(), "{text}");
                for error in errors {
                    assert!(text.get(error.span.clone()).is_some(), "{text}: {error:?}");
                    assert!(!error.message.is_empty() && !error.code.is_empty());
                }
            }
        }
    }
    println!("{compiled} texts compile");
    assert!(compiled > 2000, "{compiled}");
}

#[test]
fn hostile_lengths_are_quick() {
    let scope = machine();
    let started = std::time::Instant::now();
    for piece in [
        "(", "-", "not ", "a.", "2^", "if(", "1+", "5 m ", "zz ", "`", "t*", "<", "^", "sin(1)+",
    ] {
        let text = piece.repeat(60_000 / piece.len());
        let _ = compile(&text, &scope, Quantity::Free);
    }
    assert!(started.elapsed().as_secs() < 20, "{:?}", started.elapsed());
}
