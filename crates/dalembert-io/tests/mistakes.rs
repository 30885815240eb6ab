//! Every kind of mistake in a model file: what is said, where, and what to do.

use dalembert_io::model_file::{line_column, parse_model};

const START: &str = "[model]\nname = \"m\"\n";

/// A finding as text: code, line:column, message, help.
fn findings(text: &str) -> Vec<String> {
    let parsed = parse_model(text, None);
    assert_eq!(
        parsed.model.is_none(),
        parsed.diagnostics.iter().any(|d| d.is_error())
    );
    let one = |d: &dalembert::diagnostic::Diagnostic| {
        let (line, column) = line_column(text, parsed.source.locate_diagnostic(d).start);
        let help = d.help.as_deref().unwrap_or("-");
        format!("{} {line}:{column} {} | {help}", d.code, d.message)
    };
    parsed.diagnostics.iter().map(one).collect()
}

/// Checks the findings of a file that starts with a good `[model]` of two lines.
#[track_caller]
fn check(text: &str, expected: &[&str]) {
    assert_eq!(findings(&format!("{START}{text}")), expected);
}

const BODIES: &str = "[[body]]\nname = \"a\"\n[[body]]\nname = \"b\"\n";

/// As `check`, behind two bodies: the text starts at line 7.
#[track_caller]
fn check_behind_bodies(text: &str, expected: &[&str]) {
    check(&format!("{BODIES}{text}"), expected);
}

#[test]
fn good_files_have_no_findings() {
    check("", &[]);
    check_behind_bodies("", &[]);
}

#[test]
fn all_syntax_errors() {
    let text =
        "[model]\nname = \"x\nspace = \n\n[[body]]\nmass = 1 kg\nname = \"a\"\nname = \"b\"\n";
    assert_eq!(
        findings(text),
        [
            "toml-syntax 2:10 not valid TOML: invalid basic string, expected `\"` | texts, units and expressions stand in quotes, for example \"30 deg\"",
            "toml-syntax 3:9 not valid TOML: string values must be quoted, expected literal string | texts, units and expressions stand in quotes, for example \"30 deg\"",
            "toml-syntax 6:8 not valid TOML: string values must be quoted, expected literal string | texts, units and expressions stand in quotes, for example \"30 deg\"",
            "toml-syntax 8:1 not valid TOML: duplicate key | a key stands only once in a section: remove one of the lines, or begin a new section above",
        ]
    );
}

#[test]
fn an_unclosed_list_is_one_mistake() {
    check(
        "[[body]]\nname = \"a\"\nposition = [0, 1\nmass = 1\nangle = 2\n",
        &[
            "toml-syntax 6:1 not valid TOML: missing comma between array elements, expected `,` | a list stands in brackets with commas, for example [0, \"30 mm\"]",
        ],
    );
}

#[test]
fn missing_model_section() {
    assert_eq!(
        findings(""),
        [
            "missing-key 1:1 model file: the section `[model]` is missing | start the file with `[model]` and `name = \"...\"`"
        ]
    );
}

#[test]
fn unknown_section() {
    check(
        "[paramters]\nr = 1\n",
        &[
            "unknown-key 3:2 model file: unknown key `paramters` | did you mean `parameters`? allowed here: `model`, `parameters`, `table`, `body`, `joint`, `constraint`, `driver`, `force`, `initial`, `trace`, `analysis`, `output`",
        ],
    );
}

#[test]
fn unknown_key() {
    check(
        "[[trace]]\nname = \"p\"\nbody = \"ground\"\n  angel = 1\n",
        &[
            "unknown-key 6:3 trace \"p\": unknown key `angel` | did you mean `angle`? allowed here: `name`, `body`, `at`, `angle`, `relative_to`",
        ],
    );
    check(
        "[output]\nchannels = [\"a.*\"]\nzzz = 1\n",
        &[
            "unknown-key 5:1 section [output]: unknown key `zzz` | allowed here: `channels`, `momentum_about`",
        ],
    );
}

#[test]
fn unknown_key_in_a_single_shape_and_in_a_list_of_them() {
    let help = "did you mean `radius`? allowed here: `kind`, `radius`, `at`, `angle`, `mass`, `density`, `thickness`, `cut`, `color`";
    check(
        "[[body]]\nname = \"a\"\nshape = { kind = \"circle\", radus = 1 }\n",
        &[&format!(
            "unknown-key 5:28 body \"a\": `shape[0]`: unknown key `radus` | {help}"
        )],
    );
    check(
        "[[body]]\nname = \"a\"\nshape = [{ kind = \"lump\" }, { kind = \"circle\", radus = 1 }]\n",
        &[&format!(
            "unknown-key 5:48 body \"a\": `shape[1]`: unknown key `radus` | {help}"
        )],
    );
}

#[test]
fn a_misspelt_needed_key_is_one_mistake() {
    check(
        "[[trace]]\nname = \"p\"\nbdy = \"ground\"\n",
        &[
            "unknown-key 5:1 trace \"p\": unknown key `bdy` | did you mean `body`? allowed here: `name`, `body`, `at`, `angle`, `relative_to`",
        ],
    );
}

#[test]
fn unknown_kind() {
    check(
        "[[constraint]]\nname = \"c\"\nkind = \"coupeler\"\nzzz = 1\n",
        &[
            "missing-key 3:1 constraint \"c\": the key `terms` is missing | add `terms = ...`",
            "unknown-kind 5:8 constraint \"c\": `kind`: there is no kind `coupeler` | did you mean `coupler`? allowed here: `fixed`, `coupler`, `expression`, `velocity`",
            "unknown-key 6:1 constraint \"c\": unknown key `zzz` | allowed here: `name`, `kind`, `terms`, `value`",
        ],
    );
    // Nothing is known of this kind: only keys that mean the same in every kind are read.
    check(
        "[[joint]]\nname = \"A\"\nkind = \"hook\"\nbodies = [\"a\", \"ground\"]\nat = [[0], [0, 0]]\nzzz = 1\n",
        &[
            "unknown-kind 5:8 joint \"A\": `kind`: there is no kind `hook` | allowed here: `revolute`, `prismatic`, `weld`, `distance`, `pin-slot`, `gear`, `rack`, `cam`, `rolling-on-line`, `rolling-on-circle`",
            "unknown-body 6:11 joint \"A\": `bodies[0]`: there is no body \"a\" | known: `ground`",
            "wrong-length 7:7 joint \"A\": `at[0]`: expected 2 entries, found 1 | write [x, y]: the model is planar",
        ],
    );
}

#[test]
fn missing_kind() {
    check(
        "[[constraint]]\nname = \"c\"\n",
        &[
            "missing-key 3:1 constraint \"c\": the key `kind` is missing | one of `fixed`, `coupler`, `expression`, `velocity`",
        ],
    );
}

#[test]
fn missing_keys() {
    check(
        "[[trace]]\nat = [0, 0]\n",
        &[
            "missing-key 3:1 trace number 1: the key `name` is missing | add `name = ...`",
            "missing-key 3:1 trace number 1: the key `body` is missing | add `body = ...`",
        ],
    );
}

#[test]
fn unknown_words() {
    assert_eq!(
        findings("[model]\nname = \"m\"\nspace = \"plane\"\n"),
        [
            "unknown-word 3:9 section [model]: `space`: `plane` is not known here | allowed here: `planar`, `spatial`"
        ]
    );
    check(
        "[[body]]\nname = \"a\"\nhold = [\"x\", \"angel\"]\n",
        &[
            "unknown-word 5:14 body \"a\": `hold[1]`: `angel` is not known here | did you mean `angle`? allowed here: `x`, `y`, `angle`",
        ],
    );
}

#[test]
fn wrong_types() {
    check(
        "[[body]]\nname = 1\nmass = [1]\ninertia = 1979-05-27\nangle = true\nposition = \"a\"\nfixed = \"yes\"\nhold = [1]\nshape = 3\n",
        &[
            "wrong-type 4:8 body number 1: `name`: expected a text, found a number | write a text",
            "wrong-type 5:8 body number 1: `mass`: expected a number or a text like \"30 deg\", found a list | write a number or a text like \"30 deg\"",
            "wrong-type 6:11 body number 1: `inertia`: expected a number or a text like \"30 deg\", found a date or time | texts stand in quotes",
            "wrong-type 7:9 body number 1: `angle`: expected a number or a text like \"30 deg\", found `true` or `false` | write a number or a text like \"30 deg\"",
            "wrong-type 8:12 body number 1: `position`: expected a list of 2 numbers, found a text | write a list of 2 numbers",
            "wrong-type 9:9 body number 1: `fixed`: expected `true` or `false`, found a text | write `true` or `false`",
            "wrong-type 10:9 body number 1: `hold[0]`: expected one of `x`, `y`, `angle`, found a number | write one of `x`, `y`, `angle`",
            "wrong-type 11:9 body number 1: `shape`: expected a table or a list of tables, found a number | write a table or a list of tables",
        ],
    );
    check(
        "[body]\nname = \"a\"\n",
        &[
            "wrong-type 3:1 section [[body]]: expected a list of tables, found a table | write [[body]] with two brackets above each body",
        ],
    );
    assert_eq!(
        findings("model = 3\nbody = [1]\nparameters = []\n"),
        [
            "wrong-type 1:9 section [model]: expected a table, found a number | write a table",
            "wrong-type 2:9 body number 1: expected a table, found a number | write a table",
            "wrong-type 3:14 section [parameters]: expected a table, found a list | write a table",
        ]
    );
}

#[test]
fn wrong_lengths() {
    assert_eq!(
        findings("[model]\nname = \"m\"\ngravity = [0, 0, -9.81]\n"),
        [
            "wrong-length 3:11 section [model]: `gravity`: expected 2 entries, found 3 | write [x, y]: the model is planar"
        ]
    );
    assert_eq!(
        findings("[model]\nname = \"m\"\nspace = \"spatial\"\ngravity = [0, -9.81]\n"),
        [
            "wrong-length 4:11 section [model]: `gravity`: expected 3 entries, found 2 | write [x, y, z]"
        ]
    );
    check_behind_bodies(
        "[[joint]]\nname = \"A\"\nkind = \"revolute\"\nbodies = [\"a\", \"b\", \"ground\"]\nat = [[0, 0], [1]]\n",
        &[
            "wrong-length 10:10 joint \"A\": `bodies`: expected 2 entries, found 3 | write [first, second]",
            "wrong-length 11:15 joint \"A\": `at[1]`: expected 2 entries, found 1 | write [x, y]: the model is planar",
        ],
    );
    check_behind_bodies(
        "[[force]]\nname = \"B\"\nkind = \"bushing\"\nbodies = [\"a\", \"b\"]\npoint = [0, 0]\nstiffness = [1, 2]\ndamping = [[1, 0, 0], [0, 1], [0, 0, 1]]\n",
        &[
            "wrong-length 12:13 force \"B\": `stiffness`: expected 3 entries, found 2 | give the diagonal, or all rows",
            "wrong-length 13:23 force \"B\": `damping[1]`: expected 3 entries, found 2 | complete the row",
        ],
    );
    check(
        "[[body]]\nname = \"a\"\nshape = { kind = \"polygon\", points = [[0, 0], [1, 0]] }\n[[constraint]]\nname = \"c\"\nkind = \"coupler\"\nterms = []\n",
        &[
            "wrong-length 5:38 body \"a\": `shape[0].points`: expected at least 3 entries, found 2 | give the corners [[x, y], ...]",
            "wrong-length 9:9 constraint \"c\": `terms`: expected at least 1 entry, found 0 | write [{ factor = 1, kind = \"angle\", ... }]",
        ],
    );
}

#[test]
fn numbers_must_be_finite() {
    check(
        "[parameters]\na = inf\nb = -nan\nc = 1e999\nd = 123456789012345678901234567890\ne = 0x10\nf = -3\n",
        &[
            "not-finite 4:5 parameter \"a\": the number must be finite and not too large | give a number of a usual size; a limit that does not exist is left out",
            "not-finite 5:5 parameter \"b\": the number must be finite and not too large | give a number of a usual size; a limit that does not exist is left out",
            "not-finite 6:5 parameter \"c\": the number must be finite and not too large | give a number of a usual size; a limit that does not exist is left out",
            "not-finite 7:5 parameter \"d\": the number must be finite and not too large | give a number of a usual size; a limit that does not exist is left out",
        ],
    );
}

#[test]
fn whole_numbers() {
    check(
        "[analysis]\nmax_iterations = 1.5\n[[table]]\nname = \"f\"\nfile = \"f.csv\"\ncolumns = [0, 1]\n",
        &[
            "wrong-type 4:18 section [analysis]: `max_iterations`: expected a whole number, found a number | write a whole number",
            "csv 7:8 table \"f\": `file`: the model was not read from a folder, so \"f.csv\" cannot be found | give `x` and `y` in the model file",
            "out-of-range 8:12 table \"f\": `columns[0]`: expected a whole number from 1 to 4294967295 | give a number from this range",
        ],
    );
}

#[test]
fn empty_texts() {
    check(
        "[parameters]\nr = \" \"\n[analysis]\nindependent = [\"\"]\n",
        &[
            "empty-text 4:5 parameter \"r\": expected a number or a text like \"30 deg\", found an empty text | give the value, or remove the key",
            "empty-text 6:16 section [analysis]: `independent[0]`: the text must not be empty | give the text, or remove the key",
        ],
    );
}

#[test]
fn bad_names() {
    let rule = "a name must not be empty, start or end with a space, or contain a dot, a quote or a line break";
    check(
        "[[body]]\nname = \"\"\n[[body]]\nname = \"a.b\"\n",
        &[
            &format!(
                "bad-name 4:8 body number 1: `name`: {rule} | choose another name, such as `crank_2`"
            ),
            &format!(
                "bad-name 6:8 body \"a.b\": `name`: {rule} | choose another name, such as `crank_2`"
            ),
        ],
    );
    check(
        "[parameters]\n\"2 r\" = 1\n",
        &[
            "bad-name 4:1 parameter \"2 r\": a name for expressions starts with a letter and has letters (a to z, A to Z), digits and underscores only | choose another name, such as `crank_length`",
        ],
    );
}

#[test]
fn names_are_unique_over_all_sections() {
    let help = "choose another name: all elements share one name space";
    check(
        "[parameters]\ncrank = 1\nt = 2\n[[body]]\nname = \"crank\"\n[[body]]\nname = \"ground\"\n[[body]]\nname = \"B\"\n[[trace]]\nname = \"B\"\nbody = \"B\"\n",
        &[
            &format!(
                "reserved-name 5:1 parameter \"t\": the name \"t\" belongs to the time | {help}"
            ),
            &format!(
                "reserved-name 9:8 body \"ground\": the name \"ground\" belongs to the fixed body that always exists | {help}"
            ),
            &format!(
                "duplicate-name 13:8 trace \"B\": the name \"B\" is already taken by a body (body[2]) | {help}"
            ),
        ],
    );
}

#[test]
fn unknown_bodies_and_joints() {
    check(
        "[[body]]\nname = \"crank\"\n[[joint]]\nname = \"pin\"\nkind = \"gear\"\nbodies = [\"crnk\", \"ground\"]\ncarrier = \"pin\"\nradii = [1, 2]\n[[driver]]\nname = \"motor\"\nkind = \"angle\"\njoint = \"pni\"\nvalue = \"t\"\n[analysis]\nactuators = [\"lever\"]\n",
        &[
            "unknown-body 8:11 joint \"pin\": `bodies[0]`: there is no body \"crnk\" | did you mean \"crank\"?",
            "unknown-body 9:11 joint \"pin\": `carrier`: there is no body \"pin\" | \"pin\" is a joint",
            "unknown-joint 14:9 driver \"motor\": `joint`: there is no joint \"pni\" | did you mean \"pin\"?",
            "unknown-joint 17:14 section [analysis]: `actuators[0]`: there is no joint \"lever\" | known: `pin`",
        ],
    );
    check(
        "[[force]]\nname = \"f\"\nkind = \"actuator\"\njoint = \"O\"\nvalue = 1\n",
        &[
            "unknown-joint 6:9 force \"f\": `joint`: there is no joint \"O\" | the model has no joint",
        ],
    );
}

#[test]
fn places_of_joints() {
    let point = "`at = [[x, y], [x, y]]` is the point in each body's frame, `point = [x, y]` the one point in ground axes at the initial estimate";
    let axis = "`angles = [a, b]` is the angle of the joint's x axis in each body's frame, `direction = [x, y]` the axis in ground axes at the initial estimate";
    check_behind_bodies(
        "[[joint]]\nname = \"A\"\nkind = \"prismatic\"\nbodies = [\"a\", \"b\"]\nat = [[0, 0], [0, 0]]\npoint = [0, 0]\nangles = [0, 0]\ndirection = [1, 0]\n",
        &[
            &format!(
                "wrong-combination 12:1 joint \"A\": `at` and `point` exclude each other | {point}"
            ),
            &format!(
                "wrong-combination 14:1 joint \"A\": `angles` and `direction` exclude each other | {axis}"
            ),
        ],
    );
    check_behind_bodies(
        "[[joint]]\nname = \"A\"\nkind = \"prismatic\"\nbodies = [\"a\", \"b\"]\n",
        &[
            &format!(
                "wrong-combination 7:1 joint \"A\": the kind `prismatic` needs a point: `at` or `point` | {point}"
            ),
            &format!(
                "wrong-combination 7:1 joint \"A\": the kind `prismatic` needs an axis: `angles` or `direction` | {axis}"
            ),
        ],
    );
    check_behind_bodies(
        "[[joint]]\nname = \"A\"\nkind = \"distance\"\nbodies = [\"a\", \"b\"]\npoint = [0, 0]\n",
        &[
            "wrong-combination 11:1 joint \"A\": the kind `distance` needs two points: `at` | `at = [[x, y], [x, y]]` is the point in each body's frame",
        ],
    );
}

#[test]
fn motions_of_drivers() {
    let help = "`value` is the motion as an expression of `t`; `rate` its first derivative, integrated from `start`";
    let driver = |name: &str, rest: &str| {
        format!(
            "[[driver]]\nname = \"{name}\"\nkind = \"relative-angle\"\nbodies = [\"a\", \"b\"]\n{rest}"
        )
    };
    let text = [
        driver("1", "value = 1\nrate = 2\n"),
        driver("2", ""),
        driver("3", "value = 1\nstart = 2\n"),
        driver("4", "rate = 1\nstart = 2\n"),
        "[[driver]]\nname = \"5\"\nkind = \"path\"\nbody = \"a\"\n".to_owned(),
        "[[initial]]\nkind = \"coordinate\"\nbody = \"a\"\ncoordinate = \"x\"\n".to_owned(),
    ];
    check_behind_bodies(
        &text.concat(),
        &[
            &format!(
                "wrong-combination 12:1 driver \"1\": `value` and `rate` exclude each other | {help}"
            ),
            &format!(
                "wrong-combination 13:1 driver \"2\": a motion is missing: `value` or `rate` | {help}"
            ),
            &format!(
                "wrong-combination 22:1 driver \"3\": `start` goes with `rate`, not with `value` | {help}"
            ),
            "wrong-combination 29:1 driver \"5\": a path needs `x` or `y` or both | `x` and `y` are expressions of `t`; a coordinate that is left out is free",
            "wrong-combination 33:1 initial condition number 1: `value` or `rate` or both are needed | `value` is what the quantity has at the start, `rate` how fast it changes there",
        ],
    );
}

#[test]
fn masses_and_colours_of_shapes() {
    let help = "give `mass`, or `density` together with `thickness`, or none of them";
    check(
        "[[body]]\nname = \"a\"\n[[body.shape]]\nkind = \"lump\"\nmass = 1\ndensity = 1\n[[body.shape]]\nkind = \"lump\"\ndensity = 1\n[[body.shape]]\nkind = \"lump\"\nthickness = 1\ncolor = \"red\"\n",
        &[
            &format!(
                "wrong-combination 8:1 body \"a\": `shape[0]`: `mass` and `density` exclude each other | {help}"
            ),
            &format!(
                "wrong-combination 11:1 body \"a\": `shape[1]`: `density` needs `thickness` | {help}"
            ),
            &format!(
                "wrong-combination 14:1 body \"a\": `shape[2]`: `thickness` needs `density` | {help}"
            ),
            "bad-color 15:9 body \"a\": `shape[2].color`: \"red\" is not a colour | write \"#rrggbb\", for example \"#3070b0\"",
        ],
    );
}

#[test]
fn cam_profiles() {
    let joint = |name: &str, profile: &str, follower: &str| {
        format!(
            "[[joint]]\nname = \"{name}\"\nkind = \"cam\"\nbodies = [\"a\", \"b\"]\npoint = [0, 0]\nprofile = {profile}\nfollower = {follower}\n"
        )
    };
    let help = "give `radius` as an expression of `phi`, or both `x` and `y`";
    let text = [
        joint("1", "{ radius = 1, x = 1 }", "{ kind = \"flat\" }"),
        joint("2", "{ y = 1 }", "{ kind = \"roller\" }"),
        joint("3", "{}", "{ kind = \"knife\" }"),
        joint("4", "\"1 + cos(phi)\"", "{ kind = \"flat\", radius = 1 }"),
    ];
    check_behind_bodies(
        &text.concat(),
        &[
            &format!(
                "wrong-combination 12:13 joint \"1\": `profile`: `radius` excludes `x` and `y` | {help}"
            ),
            &format!(
                "wrong-combination 19:13 joint \"2\": `profile`: `x` and `y` need each other | {help}"
            ),
            "missing-key 20:12 joint \"2\": `follower`: the key `radius` is missing | add `radius = ...`",
            &format!(
                "wrong-combination 26:11 joint \"3\": `profile`: a profile needs `radius`, or `x` and `y` | {help}"
            ),
            "unknown-kind 27:21 joint \"3\": `follower.kind`: there is no kind `knife` | allowed here: `knife-edge`, `roller`, `flat`",
            "wrong-type 33:11 joint \"4\": `profile`: expected a table, found a text | write a table",
            "unknown-key 34:29 joint \"4\": `follower`: unknown key `radius` | allowed here: `kind`",
        ],
    );
}

#[test]
fn points_of_tables() {
    let help = "give `x` and `y`, or the name of a CSV `file` beside the model file";
    check(
        "[[table]]\nname = \"t1\"\n[[table]]\nname = \"t2\"\nx = [0, 1]\n[[table]]\nname = \"t3\"\nx = [0, 1]\ny = [0, 1, 2]\nx_unit = \"deg\"\n[[table]]\nname = \"t4\"\nx = [0]\ny = [0]\n[[table]]\nname = \"t5\"\nx = [0]\nfile = \"f\"\n",
        &[
            &format!("wrong-combination 3:1 table \"t1\": the points are missing | {help}"),
            &format!("wrong-combination 7:1 table \"t2\": `x` and `y` need each other | {help}"),
            "wrong-length 11:5 table \"t3\": `y`: expected 2 (as many as `x`) entries, found 3 | give every point both numbers",
            &format!(
                "wrong-combination 12:1 table \"t3\": `x_unit` speaks of a CSV `file` | {help}"
            ),
            "wrong-length 15:5 table \"t4\": `x`: expected at least 2 entries, found 1 | add points",
            &format!("wrong-combination 20:1 table \"t5\": `file` excludes `x` and `y` | {help}"),
        ],
    );
}

#[test]
fn a_single_bracket_beside_double_ones_is_one_mistake() {
    let joints =
        "[joint]\nname = \"p\"\n[[joint]] # second\nname = \"q\"\n[[joint]]\nname = \"r\"\n";
    check_behind_bodies(
        joints,
        &[
            "toml-syntax 7:1 not valid TOML: one [joint] and a list of [[joint]] | write [[joint]] with two brackets here too",
        ],
    );
}

#[test]
fn words_from_elsewhere_are_understood_in_help() {
    for (word, kind) in [
        ("pin", "revolute"),
        ("Slider", "prismatic"),
        ("link", "distance"),
    ] {
        let joint = format!("[[joint]]\nname = \"j\"\nkind = \"{word}\"\n");
        let all = findings(&format!("{START}{BODIES}{joint}"));
        let written = format!("there is no kind `{word}` | write `{kind}`; allowed here");
        assert!(all.iter().any(|f| f.contains(&written)), "{all:?}");
    }
    let force = "[[force]]\nname = \"f\"\nkind = \"pin\"\n";
    let all = findings(&format!("{START}{BODIES}{force}"));
    assert!(
        all.iter().any(|f| f.contains("`pin` | allowed here")),
        "{all:?}"
    );
}

#[test]
fn a_number_for_gravity_and_one_point_for_two_show_what_to_write() {
    check(
        "gravity = 9.81\n",
        &[
            "wrong-type 3:11 section [model]: `gravity`: expected a list of 2 numbers, found a number | write [0, -9.81] for gravity along -y",
        ],
    );
    check_behind_bodies(
        "[[joint]]\nname = \"j\"\nkind = \"revolute\"\nbodies = [\"a\", \"b\"]\nat = [\"1 m\", 0]\n",
        &[
            "wrong-type 11:6 joint \"j\": `at`: expected two points, [[x, y], [x, y]], found one | write [[x, y], [x, y]]: the point [x, y] in the frame of each body",
        ],
    );
}
