//! Models to start from.

/// A complete model file that a person can start from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Template {
    /// Name, as a person types it.
    pub name: &'static str,
    /// What it is, in one line.
    pub description: &'static str,
    /// The text of the model file.
    pub text: &'static str,
}

const TEMPLATES: [Template; 8] = [
    Template {
        name: "slider-crank",
        description: "a driven crank moves a slider through a rod",
        text: include_str!("../../templates/slider-crank.toml"),
    },
    Template {
        name: "four-bar",
        description: "crank, coupler and rocker, with a coupler curve",
        text: include_str!("../../templates/four-bar.toml"),
    },
    Template {
        name: "pendulum",
        description: "one bar on a pin, released at rest",
        text: include_str!("../../templates/pendulum.toml"),
    },
    Template {
        name: "double-pendulum",
        description: "two bars, released at rest; chaotic",
        text: include_str!("../../templates/double-pendulum.toml"),
    },
    Template {
        name: "mass-spring",
        description: "a block on a slide with a spring and a damper",
        text: include_str!("../../templates/mass-spring.toml"),
    },
    Template {
        name: "cam-follower",
        description: "a cam lifts a follower with a roller",
        text: include_str!("../../templates/cam-follower.toml"),
    },
    Template {
        name: "planetary-gear",
        description: "sun, planet, carrier and a fixed ring",
        text: include_str!("../../templates/planetary-gear.toml"),
    },
    Template {
        name: "spatial-slider-crank",
        description: "a machine in space: pin, ball, universal joint and guide",
        text: include_str!("../../templates/spatial-slider-crank.toml"),
    },
];

/// The models to start from.
pub fn templates() -> &'static [Template] {
    &TEMPLATES
}
