//! Other words for kinds of elements, which help texts understand.

/// The kinds that a word from elsewhere usually means, in different kinds of elements.
pub(super) fn other_words(word: &str) -> impl Iterator<Item = &'static str> {
    let word = word.to_lowercase();
    WORDS
        .iter()
        .filter(move |(words, _)| words.contains(&word.as_str()))
        .map(|(_, kind)| *kind)
}

/// Words in lower case, and the kind of joint, force, driver or shape.
const WORDS: &[(&[&str], &str)] = &[
    (
        &["pin", "hinge", "pivot", "rotary", "rotational"],
        "revolute",
    ),
    (
        &["slider", "slide", "sliding", "translational", "linear"],
        "prismatic",
    ),
    (&["fixed", "rigid", "welded"], "weld"),
    (&["link", "rod"], "distance"),
    (
        &["ball", "ball-joint", "ball-and-socket", "socket"],
        "spherical",
    ),
    (&["cardan", "hooke", "u-joint", "gimbal"], "universal"),
    (&["cv", "cv-joint", "homokinetic"], "constant-velocity"),
    (&["sleeve"], "cylindrical"),
    (&["helical", "thread"], "screw"),
    (&["plane"], "planar"),
    (&["bevel-gear", "worm"], "gear-pair"),
    (&["ball"], "sphere"),
    (&["cuboid", "block", "brick"], "box"),
    (&["pipe"], "tube"),
    (&["disc"], "disk"),
    (&["stl", "obj"], "mesh"),
    (&["slot"], "pin-slot"),
    (&["gears"], "gear"),
    (&["spring", "damper"], "spring-damper"),
    (&["torque"], "moment"),
    (&["rotation"], "angle"),
    (&["translation", "position"], "displacement"),
    (&["disk", "disc"], "circle"),
    (&["box", "square"], "rectangle"),
];
