//! What a caller gets besides the model: a draft, places in the file, and reports.

use dalembert::diagnostic::Diagnostic;
use dalembert::system::compile::compile;
use dalembert_io::model_file::{line_column, parse_model, render, to_json};

#[test]
fn a_model_with_mistakes_is_a_draft_with_all_its_elements() {
    let text =
        "[model]\nname = \"m\"\n[[body]]\nname = \"a\"\n[[body]]\nname = \"b\"\nmass = [1]\n";
    let parsed = parse_model(text, None);
    assert_eq!(parsed.model, None);
    assert_eq!(parsed.draft.unwrap().bodies.len(), 2);
}

#[test]
fn without_a_list_of_elements_there_is_no_draft() {
    let start = "[model]\nname = \"m\"\n";
    for text in [format!("body = 3\n{start}"), format!("{start}[[")] {
        let parsed = parse_model(&text, None);
        assert!(parsed.draft.is_none() && parsed.model.is_none(), "{text}");
        assert_eq!(parsed.diagnostics.len(), 1, "{text}");
    }
}

#[test]
fn elements_of_which_nothing_is_known_keep_their_place() {
    let text = "body = [1, { name = \"b\", shape = [{ kind = \"blob\" }, { kind = \"circle\", radius = 1 }] }]\n\
        joint = [{ name = \"A\", kind = \"xyz\" }, { name = \"B\", kind = \"revolute\", bodies = [\"ground\", \"b\"], point = [0, 0] }]\n\
        driver = [{ name = \"D\" }]\n\
        force = [3, { name = \"F\", kind = \"pull\" }]\n\
        constraint = [{ name = \"C\", kind = \"fixed\", quantity = { kind = \"q\" } }, { name = \"E\", kind = \"coupler\", terms = [{ factor = 1 }] }]\n\
        initial = [{}]\n\
        [model]\nname = \"m\"\n";
    let parsed = parse_model(text, None);
    let draft = parsed.draft.unwrap();
    assert_eq!(draft.bodies.len(), 2);
    assert_eq!(draft.bodies[1].name, "b");
    assert_eq!(draft.bodies[1].shape.len(), 2);
    assert_eq!((draft.joints.len(), draft.drivers.len()), (2, 1));
    assert_eq!((draft.forces.len(), draft.constraints.len()), (2, 2));
    assert_eq!(draft.initial.len(), 1);
    // One mistake for each of them, and what the placeholders make the engine say is left out.
    let codes = codes_with_engine(text);
    let places: Vec<&str> = codes.iter().map(|c| c.split(' ').next().unwrap()).collect();
    assert_eq!(
        places,
        [
            "wrong-type",
            "unknown-kind",
            "unknown-kind",
            "missing-key",
            "wrong-type",
            "unknown-kind",
            "unknown-kind",
            "missing-key",
            "missing-key",
            "wrong-combination",
        ],
        "{codes:?}"
    );
}

#[test]
fn a_section_with_single_brackets_is_read_all_the_same() {
    let text = "[model]\nname = \"m\"\n[body]\nname = \"a\"\nmas = 1\ninertia = \"2 kg\"\n\
        [[joint]]\nname = \"A\"\nkind = \"revolute\"\nbodies = [\"ground\", \"a\"]\npoint = [0, 0]\n";
    assert_eq!(
        codes_with_engine(text),
        ["wrong-type 3:1", "unknown-key 5:1", "unit-mismatch 6:12"]
    );
}

#[test]
fn names_of_a_misspelt_section_are_not_missed() {
    let text = "[model]\nname = \"m\"\n[[bodyy]]\nname = \"a\"\n\
        [[trace]]\nname = \"p\"\nbody = \"a\"\n";
    assert_eq!(codes_with_engine(text), ["unknown-key 3:3"]);
}

#[test]
fn what_follows_from_a_mistake_is_not_reported() {
    let start = "[model]\nname = \"m\"\n[parameters]\nr = \"2 * s\"\ns = \"r\"\n\
        [[body]]\nname = \"a\"\nmass = \"r - 1 kg\"\ninertia = 0\n";
    assert_eq!(codes_with_engine(start), ["parameter-cycle 4:5"]);
    // The spring is spoilt, and so is what is said of its length.
    let text = start.replace("2 * s", "2").replace("\"r - 1 kg\"", "1")
        + "[[force]]\nname = \"s1\"\nkind = \"sprig-damper\"\nbodies = [\"ground\", \"x\"]\nat = [[0, 0], [0, 1]]\n\
           [[force]]\nname = \"s2\"\nkind = \"moment\"\nbody = \"a\"\nvalue = \"-s1.length * 1 N + 1 N*kg\"\n";
    assert_eq!(
        codes_with_engine(&text),
        [
            "unknown-kind 12:8",
            "unknown-body 13:21",
            "unit-mismatch 19:10"
        ]
    );
}

/// Codes after the findings of the engine are added.
fn codes_with_engine(text: &str) -> Vec<String> {
    let mut parsed = parse_model(text, None);
    let findings = match compile::<dalembert::space::Planar>(parsed.draft.as_ref().unwrap(), &[]) {
        Ok(compiled) => compiled.warnings,
        Err(errors) => errors.0,
    };
    parsed.add(findings);
    assert_eq!(
        parsed.model.is_none(),
        parsed.diagnostics.iter().any(Diagnostic::is_error)
    );
    let place = |d: &Diagnostic| {
        let (line, column) = line_column(text, parsed.source.locate_diagnostic(d).start);
        format!("{} {line}:{column}", d.code)
    };
    parsed.diagnostics.iter().map(place).collect()
}

#[test]
fn mistakes_of_expressions_are_reported_together_with_the_others() {
    let text = "[model]\nname = \"m\"\n[parameters]\nm = \"2 kg\"\n[[body]]\nname = \"a\"\nmass = \"2 * mm\"\ninertia = 1\n[[body]]\nname = \"b\"\nmas = 1\n";
    let codes = codes_with_engine(text);
    // The body without a mass has a misspelt one: that is said once.
    assert_eq!(codes.len(), 2, "{codes:?}");
    assert!(codes[0].ends_with(" 7:13"), "{codes:?}");
    assert_eq!(codes[1], "unknown-key 11:1");
    // A lost parameter has no value: what is wrong whatever the value is reported, no more.
    let text = text.replace("m = \"2 kg\"", "m = []");
    assert_eq!(
        codes_with_engine(&text),
        ["wrong-type 4:5", "loose-unit 7:13", "unknown-key 11:1"]
    );
}

#[test]
fn places_for_the_engine() {
    let text = "[model]\nname = \"m\"\ngravity = [0, \"-9.81 m/s^2\"]\n[parameters]\nr = '''a + bb'''\ne = \"\\u0061 + b\"\n[[body]]\nname = \"w\"\nshape = { kind = \"circle\", radius = \"2 * q\" }\n";
    let parsed = parse_model(text, None);
    assert_eq!(parsed.diagnostics, []);
    let source = &parsed.source;
    let at = |path: &str| source.locate(path).map(|span| &text[span]);
    assert_eq!(at("model.gravity[1]"), Some("\"-9.81 m/s^2\""));
    assert_eq!(at("parameters.r"), Some("'''a + bb'''"));
    assert_eq!(at("body[0].shape[0].radius"), Some("\"2 * q\""));
    assert_eq!(at("body[0].mass"), Some("[[body]]"));
    assert_eq!(at("joint[0].at"), None);
    assert_eq!(
        source.locate_key("parameters.r").map(|s| &text[s]),
        Some("r")
    );
    let inside = |path: &str, span: std::ops::Range<usize>| {
        let diagnostic = Diagnostic::error("c", path, "m").span(span);
        &text[source.locate_diagnostic(&diagnostic)]
    };
    assert_eq!(inside("parameters.r", 4..6), "bb");
    assert_eq!(inside("body[0].shape[0].radius", 4..5), "q");
    assert_eq!(inside("model.gravity[1]", 6..11), "m/s^2");
    // With an escape in the text its bytes are not those of the file: the whole value is shown.
    assert_eq!(inside("parameters.e", 4..5), "\"\\u0061 + b\"");
    // A span outside of the text is not believed.
    assert_eq!(inside("parameters.r", 4..60), "'''a + bb'''");
}

const BAD: &str = "\
[model]
name = \"bad\"

[[body]]
name = \"crank\"
maas = \"1 kg\"

[[joint]]
name = \"O\"
kind = \"revolut\"
bodies = [\"ground\", \"crank\"]
point = [0, 0]

[[joint]]
name = \"A\"
kind = \"revolute\"
bodies = [\"crnk\", \"ground\"]
at = [[0, 0], [0, 0]]
";

#[test]
fn all_mistakes_of_a_file_are_rendered_at_once() {
    let parsed = parse_model(BAD, None);
    let text = render(&parsed.diagnostics, &parsed.source, "bad.toml", BAD, false);
    let expected = "\
error[unknown-key]: body \"crank\": unknown key `maas`
 --> bad.toml:6:1
  |
6 | maas = \"1 kg\"
  | ^^^^
  |
  = help: did you mean `mass`? allowed here: `name`, `mass`, `inertia`, `center`, `position`, `angle`, `velocity`, `angular_velocity`, `hold`, `fixed`, `shape`

error[unknown-kind]: joint \"O\": `kind`: there is no kind `revolut`
  --> bad.toml:10:8
   |
10 | kind = \"revolut\"
   |        ^^^^^^^^^
   |
   = help: did you mean `revolute`? allowed here: `revolute`, `prismatic`, `weld`, `distance`, `pin-slot`, `gear`, `rack`, `cam`, `rolling-on-line`, `rolling-on-circle`

error[unknown-body]: joint \"A\": `bodies[0]`: there is no body \"crnk\"
  --> bad.toml:17:11
   |
17 | bodies = [\"crnk\", \"ground\"]
   |           ^^^^^^
   |
   = help: did you mean \"crank\"?

";
    assert_eq!(text, expected);
    let colored = render(&parsed.diagnostics, &parsed.source, "bad.toml", BAD, true);
    assert!(colored.contains("\u{1b}["));
}

#[test]
fn mistakes_as_json_have_line_and_column() {
    let parsed = parse_model(BAD, None);
    let json = to_json(&parsed.diagnostics, &parsed.source, "bad.toml", BAD);
    assert_eq!(json.as_array().map(Vec::len), Some(3));
    assert_eq!(
        json[2],
        serde_json::json!({
            "severity": "error",
            "code": "unknown-body",
            "message": "joint \"A\": `bodies[0]`: there is no body \"crnk\"",
            "help": "did you mean \"crank\"?",
            "path": "joint[1].bodies[0]",
            "file": "bad.toml",
            "line": 17,
            "column": 11,
            "end_line": 17,
            "end_column": 17,
        })
    );
}
