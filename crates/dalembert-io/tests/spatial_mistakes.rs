//! Mistakes in model files of spatial machines, and keys and kinds in the wrong space.

use dalembert::model::SpaceKind;
use dalembert::space::{Planar, Spatial};
use dalembert::system::compile::compile;
use dalembert_io::model_file::{Parsed, line_column, parse_model};

fn findings(parsed: &Parsed, text: &str) -> Vec<String> {
    let one = |d: &dalembert::diagnostic::Diagnostic| {
        let (line, column) = line_column(text, parsed.source.locate_diagnostic(d).start);
        let help = d.help.as_deref().unwrap_or("-");
        format!("{} {line}:{column} {} | {help}", d.code, d.message)
    };
    parsed.diagnostics.iter().map(one).collect()
}

/// Checks the findings of the reader behind three lines of `[model]`.
#[track_caller]
fn check(text: &str, expected: &[&str]) {
    let text = format!("[model]\nname = \"m\"\nspace = \"spatial\"\n{text}");
    let parsed = parse_model(&text, None);
    assert_eq!(findings(&parsed, &text), expected);
}

/// Checks what reader and engine say together, as the program reports it.
#[track_caller]
fn check_all(text: &str, expected: &[&str]) {
    let mut parsed = parse_model(text, None);
    let draft = parsed.draft.clone().unwrap();
    let said = match draft.info.space {
        SpaceKind::Planar => compile::<Planar>(&draft, &[]).map(|_| ()),
        SpaceKind::Spatial => compile::<Spatial>(&draft, &[]).map(|_| ()),
    };
    parsed.add(said.unwrap_err().0);
    assert_eq!(findings(&parsed, text), expected);
}

const BODY: &str = "[[body]]\nname = \"a\"\n";

#[test]
fn orientations() {
    let forms = "write { axis = [0, 0, 1], angle = \"30 deg\" }, or { euler = \"zxz\", angles = [...] }, or one of `euler_parameters`, `rodriguez`, `matrix`, `points`, or two of `x`, `y`, `z`";
    for (value, expected) in [
        ("\"30 deg\"", "wrong-type 6:15 body \"a\": `orientation`: expected a table like { axis = [0, 0, 1], angle = \"30 deg\" }, found a text | write a table like { axis = [0, 0, 1], angle = \"30 deg\" }".to_owned()),
        ("{}", format!("wrong-combination 6:15 body \"a\": `orientation`: an orientation says nothing | {forms}")),
        ("{ eulr = \"zxz\" }", "unknown-key 6:17 body \"a\": `orientation`: unknown key `eulr` | did you mean `euler`? allowed here: `euler`, `axis`, `euler_parameters`, `rodriguez`, `matrix`, `points`, `x`, `y`, `z`".to_owned()),
        ("{ axis = [0, 0, 1] }", "missing-key 6:15 body \"a\": `orientation`: the key `angle` is missing | add `angle = ...`".to_owned()),
        ("{ axis = [0, 1], angle = 1 }", "wrong-length 6:24 body \"a\": `orientation.axis`: expected 3 entries, found 2 | write [x, y, z]".to_owned()),
        ("{ axis = [0, 0, 1], angle = 1, x = [1, 0, 0] }", format!("wrong-combination 6:46 body \"a\": `orientation`: `axis` and `x` exclude each other | {forms}")),
        ("{ x = [1, 0, 0] }", "wrong-combination 6:17 body \"a\": `orientation`: one axis leaves the turn about it open | give two of `x`, `y`, `z`".to_owned()),
        ("{ euler = \"zzx\", angles = [1, 2, 3] }", "unknown-word 6:25 body \"a\": `orientation.euler`: \"zzx\" is not a sequence of axes | write three of x, y and z with different neighbours, like \"zxz\" or \"xyz\"".to_owned()),
        ("{ matrix = [[1, 0, 0], [0, 1, 0]] }", "wrong-length 6:26 body \"a\": `orientation.matrix`: expected 3 entries, found 2 | write three rows of three numbers".to_owned()),
        ("{ euler_parameters = [1, 0, 0] }", "wrong-length 6:36 body \"a\": `orientation.euler_parameters`: expected 4 entries, found 3 | write the scalar first, then the vector".to_owned()),
    ] {
        check(&format!("{BODY}orientation = {value}\n"), &[&expected]);
    }
}

#[test]
fn places_and_axes_of_joints() {
    let axis = "`axis = [x, y, z]` is the joint's z axis in ground axes at the initial estimate, `axes = [[x, y, z], [x, y, z]]` the axis in each body's frame";
    let joint = |kind: &str, keys: &str| {
        format!(
            "{BODY}[[joint]]\nname = \"j\"\nkind = \"{kind}\"\nbodies = [\"ground\", \"a\"]\n{keys}"
        )
    };
    check(
        &joint("revolute", "point = [0, 0, 0]\n"),
        &[&format!(
            "wrong-combination 6:1 joint \"j\": the kind `revolute` needs an axis: `axis` or `axes` | {axis}"
        )],
    );
    check(
        &joint(
            "cylindrical",
            "point = [0, 0, 0]\naxis = [0, 0, 1]\naxes = [0, 0, 1]\n",
        ),
        &[
            &format!(
                "wrong-combination 11:1 joint \"j\": `axes` and `axis` exclude each other | {axis}"
            ),
            "wrong-type 12:8 joint \"j\": `axes`: expected two axes, [[x, y, z], [x, y, z]], found one | write [[x, y, z], [x, y, z]]: the axis [x, y, z] in the frame of each body",
        ],
    );
    check(&joint("parallel-axes", "axis = [0, 0, 1]\n"), &[]);
    check(
        &joint("universal", "point = [0, 0, 0]\naxis = [0, 0, 1]\n"),
        &[
            "wrong-combination 11:1 joint \"j\": the kind `universal` has two axes: `second_axis` is missing | `axis` and `second_axis` are the axes of the two bodies in ground axes at the initial estimate, `axes = [[x, y, z], [x, y, z]]` those in each body's frame",
        ],
    );
    check(
        "[[joint]]\nname = \"j\"\nkind = \"gear-pair\"\njoints = [\"k\", \"j\"]\nratio = 2\n",
        &["unknown-joint 7:11 joint \"j\": `joints[0]`: there is no joint \"k\" | known: `j`"],
    );
}

#[test]
fn masses_of_solids() {
    let shape = |keys: &str| format!("{BODY}shape = {{ {keys} }}\n");
    check(&shape("kind = \"sphere\", radius = 1, density = 1000"), &[]);
    check(
        &shape("kind = \"disk\", radius = 1, density = 1000"),
        &[
            "wrong-combination 6:38 body \"a\": `shape[0]`: `density` needs `thickness` | give `mass`, or `density` together with `thickness`, or none of them",
        ],
    );
    check(
        &shape("kind = \"rod\", length = 1, density = 1000"),
        &[
            "wrong-combination 6:37 body \"a\": `shape[0]`: `density` needs `radius` | give `mass`, or `density` together with `radius`, or none of them",
        ],
    );
    check(
        &shape("kind = \"torus\", radius = 1, tube = 0.1, mass = 1"),
        &[
            "wrong-combination 6:51 body \"a\": `shape[0]`: a `torus` has no `mass` | give the mass to another shape: this one is for the picture only",
        ],
    );
    check(
        &shape("kind = \"ball\", radius = 1"),
        &[
            "unknown-kind 6:18 body \"a\": `shape[0].kind`: there is no kind `ball` | write `sphere`; allowed here: `box`, `cylinder`, `tube`, `sphere`, `shell`, `hemisphere`, `cone`, `rod`, `disk`, `plate`, `ellipsoid`, `mesh`, `torus`, `lump`",
        ],
    );
}

#[test]
fn words_of_one_space_are_not_offered_in_the_other() {
    check(
        "[output]\norientation = \"euler-zz\"\n",
        &[
            "unknown-word 5:15 section [output]: `orientation`: `euler-zz` is not known here | allowed here: `euler-parameters`, `axis-angle`, `rodriguez`, `direction-cosines`, and Euler angles like `euler-zxz` or `euler-xyz-space`",
        ],
    );
    check(
        &format!("{BODY}hold = [\"w\"]\n"),
        &[
            "unknown-word 6:9 body \"a\": `hold[0]`: `w` is not known here | allowed here: `x`, `y`, `z`, `orientation`",
        ],
    );
    check(
        "[[trace]]\nname = \"p\"\nbody = \"ground\"\norientatoin = 1\n",
        &[
            "unknown-key 7:1 trace \"p\": unknown key `orientatoin` | did you mean `orientation`? allowed here: `name`, `body`, `at`, `orientation`, `relative_to`",
        ],
    );
    check(
        "[[driver]]\nname = \"d\"\nkind = \"relative-angle\"\nbodies = [\"ground\", \"ground\"]\nvalue = 1\n",
        &["missing-key 4:1 driver \"d\": the key `axis` is missing | add `axis = ...`"],
    );
}

#[test]
fn keys_of_the_other_space_are_found_all_at_once() {
    let spatial = "; if the machine is spatial: space = \"spatial\" in [model]";
    check_all(
        "[model]\nname = \"m\"\n[[body]]\nname = \"a\"\norientation = { axis = [0, 0, 1], angle = 1 }\ninertia = [1, 2, 3]\n[[joint]]\nname = \"j\"\nkind = \"sphericl\"\nbodies = [\"ground\", \"a\"]\n[[joint]]\nname = \"k\"\nkind = \"spherical\"\nbodies = [\"ground\", \"a\"]\naxis = [0, 0, 1]\n",
        &[
            &format!(
                "wrong-space 5:15 body 'a': `orientation` belongs to spatial models | a planar body has `angle`: write angle = ...{spatial}"
            ),
            &format!(
                "wrong-space 6:11 body 'a': an inertia of several numbers belongs to spatial models | write the one moment of inertia about the axis across the plane{spatial}"
            ),
            "unknown-kind 9:8 joint \"j\": `kind`: there is no kind `sphericl` | allowed here: `revolute`, `prismatic`, `weld`, `distance`, `pin-slot`, `gear`, `rack`, `cam`, `rolling-on-line`, `rolling-on-circle`",
            &format!(
                "wrong-space 13:8 joint 'k': the kind `spherical` belongs to spatial models | in the plane `revolute` holds two points together{spatial}"
            ),
        ],
    );
    check_all(
        "[model]\nname = \"m\"\nspace = \"spatial\"\n[[body]]\nname = \"a\"\nangle = 1\nhold = [\"angle\"]\nshape = { kind = \"bar\", length = 1 }\n[[joint]]\nname = \"j\"\nkind = \"prismatic\"\nbodies = [\"ground\", \"a\"]\npoint = [0, 0, 0]\ndirection = [1, 0]\n",
        &[
            "wrong-space 6:9 body 'a': `angle` belongs to planar models | a spatial body has `orientation`: write orientation = { axis = [0, 0, 1], angle = ... }",
            "wrong-space 7:9 body 'a': \"angle\" belongs to planar models | a spatial body holds \"x\", \"y\", \"z\" and \"orientation\"",
            "wrong-space 8:18 body 'a', shape 1: the kind `bar` belongs to planar models | in space write a `rod`, a `cylinder` or a `box`",
            "wrong-space 14:13 joint 'j': `direction` belongs to planar models | in space `axis = [x, y, z]` is the joint's z axis in ground axes at the initial estimate, `axes` the same in each body's frame",
        ],
    );
}

/// Mistakes in contacts and rolling wheels: what the reader finds by itself.
#[test]
fn words_of_contacts() {
    let joint = |kind: &str, keys: &str| {
        format!(
            "{BODY}[[joint]]\nname = \"j\"\nkind = \"{kind}\"\nbodies = [\"ground\", \"a\"]\n{keys}"
        )
    };
    let on = |surface: &str| {
        let at = "at = [[0, 0, 0], [0, 0, 0]]";
        joint("point-on-surface", &format!("{at}\nsurface = {surface}\n"))
    };
    check(&on("{ kind = \"plane\" }"), &[]);
    check(
        &on("{ kind = \"bal\", radius = 1 }"),
        &[
            "unknown-kind 11:20 joint \"j\": `surface.kind`: there is no kind `bal` | allowed here: `plane`, `sphere`, `cylinder`, `cone`, `ellipsoid`, `torus`, `revolved`, `expression`",
        ],
    );
    check(
        &on("{ kind = \"sphere\" }"),
        &[
            "missing-key 11:11 joint \"j\": `surface`: the key `radius` is missing | add `radius = ...`",
        ],
    );
    check(
        &on("{ kind = \"torus\", radius = 1 }"),
        &["missing-key 11:11 joint \"j\": `surface`: the key `tube` is missing | add `tube = ...`"],
    );
    check(
        &on("{ kind = \"ellipsoid\", semi_axes = [1, 2] }"),
        &[
            "wrong-length 11:45 joint \"j\": `surface.semi_axes`: expected 3 entries, found 2 | write the half axes along x, y and z",
        ],
    );
    check(
        &on("{ kind = \"plane\", insid = true }"),
        &[
            "unknown-key 11:29 joint \"j\": `surface`: unknown key `insid` | did you mean `inside`? allowed here: `kind`, `inside`",
        ],
    );
    check(
        &joint("surface-contact", "surfaces = [{ kind = \"plane\" }]\n"),
        &[
            "wrong-length 10:12 joint \"j\": `surfaces`: expected 2 entries, found 1 | write [first, second]",
        ],
    );
    check(
        &joint(
            "rolling-ball",
            "at = [[0, 0, 0], [0, 0, 0]]\naxis = [0, 0, 1]\n",
        ),
        &["missing-key 6:1 joint \"j\": the key `radius` is missing | add `radius = ...`"],
    );
    check(
        &joint("knife-edge", "point = [0, 0, 0]\n"),
        &[
            "wrong-combination 6:1 joint \"j\": the kind `knife-edge` needs an axis: `axis` or `axes` | `axis = [x, y, z]` is the joint's z axis in ground axes at the initial estimate, `axes = [[x, y, z], [x, y, z]]` the axis in each body's frame",
        ],
    );
}

/// What the engine finds in them.
#[test]
fn contacts_that_cannot_be() {
    let model = |parts: &str| {
        format!(
            "[model]\nname = \"m\"\nspace = \"spatial\"\n[[body]]\nname = \"a\"\nmass = 1\ninertia = [1, 1, 1]\nposition = [0, 0, 1]\norientation = {{ axis = [1, 0, 0], angle = 1 }}\n{parts}"
        )
    };
    let joint = |keys: &str| {
        model(&format!(
            "[[joint]]\nname = \"j\"\nbodies = [\"ground\", \"a\"]\n{keys}"
        ))
    };
    check_all(
        &joint(
            "kind = \"rolling-disc\"\nat = [[0, 0, 0], [0, 0, 0]]\naxes = [[0, 0, 1], [0, 0, 1]]\nradius = 0.1\nrounding = 0.1\n",
        ),
        &[
            "bad-ring 17:12 joint 'j': the rounding is not smaller than the radius of the wheel | use kind = \"rolling-ball\" for a ball, or correct the radii",
        ],
    );
    check_all(
        &joint(
            "kind = \"rolling-disc\"\nat = [[0, 0, 0], [0, 0, 0]]\naxis = [0, 0, 1]\nsecond_axis = [0, 0, 1]\nradius = 0.1\n",
        ),
        &[
            "zero-axis 10:1 joint 'j': the wheel lies flat on its plane in the initial estimate | correct its axle, or the estimate of its orientation",
        ],
    );
    check_all(
        &joint(
            "kind = \"surface-contact\"\nsurfaces = [{ kind = \"sphere\", radius = 0.1, inside = true }, { kind = \"sphere\", radius = 0.2 }]\n",
        ),
        &[
            "no-contact 14:12 joint 'j': these spheres cannot touch | a hollow sphere (inside = true) must be larger than the ball in it",
        ],
    );
    check_all(
        &joint(
            "kind = \"surface-contact\"\nsurfaces = [{ kind = \"sphere\", radius = -0.1 }, { kind = \"plane\" }]\n",
        ),
        &[
            "not-positive 14:41 joint 'j': radius is -0.1, it must be positive | give a positive radius",
        ],
    );
    check_all(
        &joint(
            "kind = \"surface-contact\"\naxis = [0, 0, 1]\nsurfaces = [{ kind = \"plane\" }, { kind = \"plane\" }]\n",
        ),
        &[
            "face-contact 10:1 joint 'j': the surfaces touch everywhere around | use a joint that slides so: kind = \"planar\", \"cylindrical\" or \"spherical\"",
        ],
    );
    check_all(
        &joint(
            "kind = \"surface-contact\"\naxis = [0, 0, 1]\nsurfaces = [{ kind = \"plane\" }, { kind = \"torus\", radius = 1, tube = 2 }]\n",
        ),
        &[
            "crossing-torus 15:70 joint 'j': this torus crosses itself | tube must be less than radius, the radius of the circle on which the tube's centre lies",
        ],
    );
    check_all(
        &joint(
            "kind = \"point-on-surface\"\nat = [[0, 0, 0], [0, 0, 0]]\nsurface = { kind = \"expression\", x = \"1 m * a\", y = \"1 m * c\", z = \"2 kg\" }\n",
        ),
        &[
            "unknown-name 15:60 joint 'j': `c` is not known here | a surface is a function of a, b and parameters",
            "unit-mismatch 15:69 joint 'j': this must be a length (m), but it is a mass (kg) | check the terms; a number without a unit takes any dimension, in SI",
        ],
    );
    check_all(
        &model(
            "[[constraint]]\nname = \"c\"\nkind = \"velocity\"\nexpression = \"a.vx^2 - 1 m/s * a.vy\"\n",
        ),
        &[
            "not-linear 13:14 constraint 'c': the expression is not linear in the velocities | write a sum of velocities times functions of positions and t",
        ],
    );
    check_all(
        &model("[[constraint]]\nname = \"c\"\nkind = \"velocity\"\nexpression = \"a.x - a.y\"\n"),
        &[
            "empty-constraint 13:14 constraint 'c': the expression uses no velocity of the machine | use velocities like body.vx or joint.angle_rate, or kind = \"expression\" for positions",
        ],
    );
}
