//! Poses in which the rows of an element hold, but not as they are meant.

use super::AnalysisError;
use crate::joint::{ConstraintInput, ContactFault, sum_of};
use crate::space::Space;
use crate::system::{State, System, Workspace};

/// Cosine below which axes that should stand alike do not. Where rows hold it is 1, 0 (axes exchanged) or -1 (opposite).
const ALIKE: f64 = 0.5;

/// Refuses a pose in which the rows of an element hold with other axes than those that are meant.
pub(super) fn right_sides<S: Space>(
    system: &System<S>,
    ws: &mut Workspace<S>,
    state: &State,
) -> Result<(), AnalysisError> {
    system.update_markers(&state.q, &state.v, ws);
    let wrong = system.elements.iter().filter(|e| {
        let alike = e.element.alike();
        let apart =
            |markers: &[S::Marker]| alike.iter().any(|terms| sum_of(terms, markers) < ALIKE);
        !alike.is_empty() && apart(&ws.seen(&e.markers))
    });
    let names: Vec<String> = wrong
        .map(|e| format!("'{}' ({})", e.name, e.kind))
        .collect();
    if names.is_empty() {
        return match fitting(system, ws, state.t) {
            // At a pole rounding decides to which side the normal points.
            Err(pole @ AnalysisError::SurfacePole { .. }) => Err(pole),
            fit => facing(system, ws, state.t).and(fit),
        };
    }
    Err(AnalysisError::WrongSide {
        time: state.t,
        elements: crate::words::listed(&names),
    })
}

/// Refuses a pose in which surfaces touch from the wrong side, or behind a pole.
pub(super) fn facing<S: Space>(
    system: &System<S>,
    ws: &Workspace<S>,
    t: f64,
) -> Result<(), AnalysisError> {
    let wrong = system.elements.iter().filter(|e| {
        let input = ConstraintInput {
            t,
            markers: &ws.seen(&e.markers),
            s: &ws.s[e.aux.clone()],
            s_rate: &ws.s_rate[e.aux.clone()],
        };
        e.element.facing(&input).is_some_and(|cosine| cosine <= 0.0)
    });
    let names: Vec<String> = wrong
        .map(|e| format!("'{}' ({})", e.name, e.kind))
        .collect();
    if names.is_empty() {
        return Ok(());
    }
    Err(AnalysisError::WrongSurface {
        time: t,
        elements: crate::words::listed(&names),
    })
}

/// Refuses a pose in which a contact lies at a pole of a surface's parameters, where its rows hold for any tilt, or in which
/// surfaces run into each other beside it.
pub(super) fn fitting<S: Space>(
    system: &System<S>,
    ws: &Workspace<S>,
    t: f64,
) -> Result<(), AnalysisError> {
    for e in &system.elements {
        let input = ConstraintInput {
            t,
            markers: &ws.seen(&e.markers),
            s: &ws.s[e.aux.clone()],
            s_rate: &ws.s_rate[e.aux.clone()],
        };
        let Some(fault) = e.element.fault(&input) else {
            continue;
        };
        let element = format!("'{}' ({})", e.name, e.kind);
        return Err(match fault {
            ContactFault::Pole(k) => AnalysisError::SurfacePole {
                element,
                surface: ["first", "second"][k],
                time: t,
                remedy: "move or turn the estimates of the bodies nearer to the pose that is meant, give `parameters` of the \
                         contact, or take a surface without poles (sphere, ellipsoid), or one whose poles lie elsewhere \
                         (other expressions, another z axis of its frame)",
            },
            ContactFault::Crossing(curvatures) => AnalysisError::CrossingSurfaces {
                time: t,
                element,
                curvatures,
            },
        });
    }
    Ok(())
}
