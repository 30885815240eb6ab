//! Other words for kinds of elements, which help texts understand.

/// The kind that a word from elsewhere usually means.
pub(super) fn other_word(word: &str) -> Option<&'static str> {
    let word = word.to_lowercase();
    let found = WORDS
        .iter()
        .find(|(words, _)| words.contains(&word.as_str()));
    found.map(|(_, kind)| *kind)
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
    (&["slot"], "pin-slot"),
    (&["gears"], "gear"),
    (&["spring", "damper"], "spring-damper"),
    (&["torque"], "moment"),
    (&["rotation"], "angle"),
    (&["translation", "position"], "displacement"),
    (&["disk", "disc"], "circle"),
    (&["box", "square"], "rectangle"),
];
