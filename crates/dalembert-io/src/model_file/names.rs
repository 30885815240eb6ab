//! Names of elements: each only once, and every used name must exist.

use super::context::Context;
use super::item::Place;
use super::listed::listed;
use dalembert::diagnostic::Diagnostic;
use dalembert::model::GROUND;
use dalembert_expr::nearest;
use std::collections::{BTreeSet, HashMap};

/// The sections whose elements have names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Section {
    Parameter,
    Table,
    Body,
    Joint,
    Constraint,
    Driver,
    Force,
    Trace,
}

impl Section {
    /// The word for one of its elements.
    pub fn word(self) -> &'static str {
        match self {
            Self::Parameter => "parameter",
            Self::Table => "table",
            Self::Body => "body",
            Self::Joint => "joint",
            Self::Constraint => "constraint",
            Self::Driver => "driver",
            Self::Force => "force",
            Self::Trace => "trace",
        }
    }
}

/// A name that an element has.
pub(super) struct NameOf {
    pub section: Section,
    pub name: String,
    pub place: Place,
}

/// A name that an element uses.
pub(super) struct Reference {
    pub section: Section,
    pub name: String,
    pub place: Place,
}

/// Can the name not be used in channels and expressions?
pub(super) fn is_bad_name(name: &str) -> bool {
    name.is_empty()
        || name.trim() != name
        || name.contains(['.', '"', '\'', '`'])
        || name.chars().any(char::is_control)
}

/// Checks that no name is used twice or reserved, and that every used name exists.
pub(super) fn check(context: &Context<'_>) {
    check_unique(context);
    check_references(context);
}

/// All elements share one name space: channels and expressions speak of all of them. Parameters
/// have their own: `crank` is the parameter, `crank.angle` a quantity of the body.
fn check_unique(context: &Context<'_>) {
    let names = context.names.borrow();
    let mut first: HashMap<&str, &NameOf> = HashMap::new();
    for name in names.iter() {
        let mistake = if name.name == GROUND {
            Some((
                "reserved-name",
                "the name \"ground\" belongs to the fixed body that always exists".to_owned(),
            ))
        } else if name.name == "t" {
            Some((
                "reserved-name",
                "the name \"t\" belongs to the time".to_owned(),
            ))
        } else if name.section == Section::Parameter {
            None
        } else {
            first.get(name.name.as_str()).map(|other| {
                (
                    "duplicate-name",
                    format!(
                        "the name \"{}\" is already taken by a {} ({})",
                        name.name,
                        other.section.word(),
                        other.place.path.trim_end_matches(".name"),
                    ),
                )
            })
        };
        if name.section != Section::Parameter {
            first.entry(&name.name).or_insert(name);
        }
        let Some((code, text)) = mistake else {
            continue;
        };
        let message = format!("{}: {text}", name.place.label);
        let diagnostic = Diagnostic::error(code, name.place.path.clone(), message)
            .help("choose another name: all elements share one name space");
        if name.section == Section::Parameter {
            context.report_key(diagnostic);
        } else {
            context.report(diagnostic);
        }
    }
}

/// A file with more mistakes than this has one mistake that repeats; comparing every unknown name
/// with every known one would take long in a large file.
const MOST_SUGGESTIONS: usize = 100;

fn check_references(context: &Context<'_>) {
    let names = context.names.borrow();
    let of = |section: Section| -> BTreeSet<&str> {
        let ground = (section == Section::Body).then_some(GROUND);
        names
            .iter()
            .filter(|n| n.section == section)
            .map(|n| n.name.as_str())
            .chain(ground)
            .collect()
    };
    let (bodies, joints) = (of(Section::Body), of(Section::Joint));
    let sections: HashMap<&str, Section> =
        names.iter().map(|n| (n.name.as_str(), n.section)).collect();
    let mut suggestions = MOST_SUGGESTIONS;
    for used in context.references.borrow().iter() {
        let known = if used.section == Section::Body {
            &bodies
        } else {
            &joints
        };
        let word = used.section.word();
        // Where a section cannot be read, nobody knows its names.
        if known.contains(used.name.as_str()) || context.absent.borrow().contains(&word) {
            continue;
        }
        let text = format!("there is no {word} \"{}\"", used.name);
        let near = if suggestions > 0 {
            nearest(&used.name, known.iter().copied()).first().copied()
        } else {
            None
        };
        suggestions = suggestions.saturating_sub(1);
        let help = match (sections.get(used.name.as_str()), near) {
            (Some(other), _) => format!("\"{}\" is a {}", used.name, other.word()),
            (None, Some(near)) => format!("did you mean \"{near}\"?"),
            (None, None) if known.is_empty() => format!("the model has no {word}"),
            (None, None) => format!("known: {}", listed(known.iter().copied().take(20))),
        };
        let code = format!("unknown-{word}");
        context.report(
            Diagnostic::error(&code, used.place.path.clone(), used.place.message(&text)).help(help),
        );
    }
}
