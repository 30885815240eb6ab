//! Any text at all: an answer, never a panic.

use dalembert_io::model_file::{parse_model, render, templates, to_json, write_model};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// The texts are the same in every run; another seed gives others. A failure prints its text.
const SEED: u64 = 20261121;

/// Reads the text and everything that can be done with the answer.
fn read(text: &str) {
    let parsed = parse_model(text, None);
    render(&parsed.diagnostics, &parsed.source, "x.toml", text, true);
    to_json(&parsed.diagnostics, &parsed.source, "x.toml", text);
    if let Some(model) = parsed.model {
        let written = write_model(&model);
        assert_eq!(parse_model(&written, None).model, Some(model), "{written}");
    }
    if let Some(draft) = parsed.draft {
        write_model(&draft);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, rng_seed: RngSeed::Fixed(SEED), ..Default::default() })]

    #[test]
    fn noise(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        read(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn toml_like_noise(words in prop::collection::vec(word(), 0..60)) {
        read(&words.concat());
    }

    /// Good files with pieces cut out, doubled or put elsewhere.
    #[test]
    fn damaged_files(
        which in 0..templates().len(),
        cuts in prop::collection::vec((any::<prop::sample::Index>(), 0..30usize, any::<prop::sample::Index>(), word()), 1..4),
    ) {
        let mut text = templates()[which].text.to_owned();
        for (from, length, to, word) in cuts {
            let mut start = from.index(text.len());
            while !text.is_char_boundary(start) { start -= 1; }
            let mut end = (start + length).min(text.len());
            while !text.is_char_boundary(end) { end += 1; }
            text.replace_range(start..end, "");
            let mut place = to.index(text.len() + 1);
            while !text.is_char_boundary(place) { place -= 1; }
            text.insert_str(place, &word);
        }
        read(&text);
    }
}

fn word() -> impl Strategy<Value = String> {
    prop::sample::select(vec![
        "[",
        "]",
        "[[",
        "]]",
        "{",
        "}",
        "=",
        " = ",
        ",",
        ".",
        "\n",
        "\r\n",
        "\"",
        "'",
        "\"\"\"",
        "'''",
        "#",
        "\\",
        "model",
        "name",
        "body",
        "[[body]]\n",
        "[model]\nname = \"m\"\n",
        "[[joint]]\n",
        "kind",
        "\"revolute\"",
        "at",
        "shape",
        "bodies",
        "[\"a\", \"ground\"]",
        "[[0, 0], [0, 0]]",
        "1",
        "-0.0",
        "1e400",
        "nan",
        "0x",
        "true",
        "1979-05-27",
        "\u{feff}",
        "α",
        "\u{0}",
        "\"\\u0000\"",
        "parameters",
        "[parameters]\n",
        "a",
        "a.b",
        "table",
        "[[force]]\nkind = \"bushing\"\n",
        "stiffness = ",
        "[analysis]\n",
        "\"\"",
        "''",
        "\t",
    ])
    .prop_map(str::to_owned)
}

#[test]
fn deep_nesting() {
    let deep = 100_000;
    read(&format!("a = {}", "[".repeat(deep)));
    read(&format!("a = {}{}", "[".repeat(deep), "]".repeat(deep)));
    read(&format!("a = {}", "{a = ".repeat(deep)));
    read(&format!("{}a = 1", "a.".repeat(deep)));
    read(&format!("[{}a]", "a.".repeat(deep)));
    // As deep as the TOML reader goes by nesting and by dots together.
    let key = "a.".repeat(70) + "a";
    let nested = format!("{key} = {}", format!("{{ {key} = ").repeat(70)) + "1" + &" }".repeat(70);
    read(&nested);
}

#[test]
fn many_mistakes_do_not_take_long() {
    let mut text = String::from("[model]\nname = \"m\"\n");
    for k in 0..3000 {
        text += &format!("[[body]]\nname = \"a rather long name of body {k}\"\n");
        text += &format!(
            "[[trace]]\nname = \"trace {k}\"\nbody = \"a rather long name of bodi {k}\"\n"
        );
    }
    let start = std::time::Instant::now();
    read(&text);
    assert_eq!(parse_model(&text, None).diagnostics.len(), 3000);
    assert!(start.elapsed().as_secs() < 20, "{:?}", start.elapsed());
}
