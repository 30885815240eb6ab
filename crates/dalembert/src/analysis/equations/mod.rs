//! The equations of motion themselves, with names on rows and columns.

mod body_frame;
mod coordinates;
mod in_set;
mod independent;
mod labelled;
mod notes;
mod number;
mod report;
mod scalars;
#[cfg(test)]
mod spatial_test;
mod text;

pub use labelled::{LabelledMatrix, LabelledVector};
pub use report::{EquationsReport, IndependentEquations, Scalars};

use super::AnalysisError;
use super::least_reactions::LeastReactions;
use crate::formulation::{Basis, Formulation};
use crate::space::orientation::OrientationSet;
use crate::space::{Space, Tuple};
use crate::system::{State, System, Workspace};
use coordinates::CoordinateTerms;
use independent::Independent;
use nalgebra::DVector;
use notes::Notes;
use scalars::scalars;
use serde::{Deserialize, Serialize};

/// In which coordinates the equations are written beside the absolute ones.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum EquationBasis {
    /// In none: absolute coordinates and multipliers only.
    Absolute,
    /// In independent coordinates, named by the user or chosen by full pivoting (Shabana 6.5).
    #[default]
    Partition,
    /// In orthonormal quasi-velocities by QR (Shabana 6.9).
    Qr,
    /// In orthonormal quasi-velocities by singular values (Shabana 6.9).
    Svd,
}

/// Whose reference points the coordinates are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ReferenceFrame {
    /// The user's body frames, wherever they sit.
    #[default]
    User,
    /// Frames at the centres of mass: M is constant, and Q_v holds only the gyroscopic moments of bodies in space.
    Center,
}

/// Writes down the equations of motion at a state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Equations {
    /// Independent coordinates or quasi-velocities.
    pub basis: EquationBasis,
    /// Preferred independent coordinates, like "crank.angle", for [`EquationBasis::Partition`]; others are added by
    /// pivoting where these are too few.
    pub independent: Vec<String>,
    /// Whose reference points.
    pub frame: ReferenceFrame,
    /// Generalized coordinates of the orientations (in space); none: turns about the axes of the frames.
    pub orientation: Option<OrientationSet>,
}

impl Equations {
    /// The equations of a system at a state, with the rows that always hold.
    ///
    /// # Errors
    /// An independent coordinate has an unknown name, an element gives a value that is not finite, or orientation
    /// coordinates are asked for in the plane or at a singular pose.
    pub fn run<S: Space>(
        &self,
        system: &System<S>,
        state: &State,
    ) -> Result<EquationsReport, AnalysisError> {
        let system = &system.running();
        let mut names = system.coordinate_names();
        let mut position_names = system.position_names();
        let mut rows: Vec<String> = (0..system.rows).map(|row| system.row_name(row)).collect();
        let mut ws = Workspace::new(system);
        system.update_markers(&state.q, &state.v, &mut ws);
        system.evaluate_constraints(state.t, &mut ws);
        system.evaluate_forces(state.t, &mut ws);
        let mut at = CoordinateTerms::new(system, state, &ws, self.frame);
        if at.terms.check().is_err() {
            return Err(not_finite(system, &ws, state.t));
        }
        let mut residual = ws.value.clone();
        let mut time = ws.time.clone();
        if let Some(set) = self.orientation {
            at = at.in_set(system, &ws, self.frame, set)?;
        }
        if let Some(x) = &at.in_set {
            names.clone_from(&x.names);
            position_names.clone_from(&x.names);
            rows.extend_from_slice(&x.rows);
            residual.extend(x.value.iter());
            time.resize(rows.len(), 0.0);
        }
        let preferred = self.preferred(&names)?;
        let (residual, time) = (DVector::from_vec(residual), DVector::from_vec(time));
        let mut notes = Notes::default();
        notes.violation(system, &ws, state);
        notes.moving(&time);

        let solution = Formulation::AugmentedDense.solve_terms(&at.terms);
        let mut least = LeastReactions::new(system);
        if let Ok(found) = &solution {
            ws.lambda.copy_from_slice(&found.lambda[..system.rows]);
        }
        least.settle(system, &mut ws);
        notes.redundant(&least.not_unique(system));
        let not_unique = (0..system.rows).filter(|&row| !least.unique(row));
        let not_unique: Vec<String> = not_unique.map(|row| rows[row].clone()).collect();
        notes.solution(&solution, &names);
        if let Ok(found) = &solution {
            notes.contradiction(system, &at.terms, &found.a, at.velocities.as_slice());
        }
        let solution = solution.ok();
        let acceleration = solution.as_ref().map(|s| s.a.as_slice());

        let basis = match self.basis {
            EquationBasis::Absolute => None,
            EquationBasis::Partition => Some(Basis::Partition(preferred.clone())),
            EquationBasis::Qr => Some(Basis::Qr),
            EquationBasis::Svd => Some(Basis::Svd),
        };
        let independent = basis.and_then(|basis| {
            Independent::new(&at, basis, &time)
                .inspect_err(|e| notes.no_basis(e))
                .ok()
        });
        if let Some(found) = &independent {
            notes.partition(&found.motion, &preferred, &names);
        }
        let velocities = independent.as_ref().map(Independent::velocities);
        let values = scalars(system, &ws, state.t, &at, velocities.as_ref(), acceleration);
        let over = |v: &DVector<f64>| LabelledVector::new(v, &names);
        let along = |v: &DVector<f64>| LabelledVector::new(v, &rows);
        // The conditions among coordinates are independent of the other rows: their multipliers are as they were found.
        let multipliers = solution.as_ref().map(|found| {
            let own = found.lambda[system.rows..].iter();
            let all: Vec<f64> = ws.lambda.iter().chain(own).copied().collect();
            along(&DVector::from_vec(all))
        });
        Ok(EquationsReport {
            model: system.name.clone(),
            time: state.t,
            frame: self.frame,
            orientation: self.orientation.map(|set| set.to_string()),
            positions: LabelledVector::new(&at.positions, &position_names),
            velocities: over(&at.velocities),
            mass: LabelledMatrix::new(&at.terms.mass, &names, &names),
            residual: along(&residual),
            jacobian: LabelledMatrix::new(&at.terms.jacobian, &rows, &names),
            time_derivative: along(&time),
            applied: over(&at.applied),
            centrifugal: over(&at.inertial),
            qd: along(&at.terms.qd),
            accelerations: solution
                .as_ref()
                .map(|s| over(&DVector::from_column_slice(&s.a))),
            multipliers,
            not_unique,
            momenta: over(&(&at.terms.mass * &at.velocities)),
            independent: independent.map(|found| found.equations(&at, self.basis, &names)),
            scalars: values,
            notes: notes.lines,
        })
    }

    /// Numbers of the named independent coordinates.
    fn preferred(&self, names: &[String]) -> Result<Vec<usize>, AnalysisError> {
        let find = |name: &String| {
            names.iter().position(|n| n == name).ok_or_else(|| {
                let near = dalembert_expr::nearest(name, names.iter().map(String::as_str));
                AnalysisError::BadName {
                    what: "independent coordinate",
                    name: name.clone(),
                    detail: match near.first() {
                        Some(near) => format!("did you mean '{near}'?"),
                        None => format!("the coordinates are: {}", names.join(", ")),
                    },
                }
            })
        };
        self.independent.iter().map(find).collect()
    }
}

/// Names what is not finite.
fn not_finite<S: Space>(system: &System<S>, ws: &Workspace<S>, t: f64) -> AnalysisError {
    let bad = |k: &usize| !(ws.value[*k] + ws.time[*k] + ws.qd[*k]).is_finite();
    let element = match (0..system.rows).find(bad) {
        Some(row) => system.row_name(row),
        None => {
            let broken = system.forces.iter().find(|f| {
                let markers: Vec<_> = f.markers.iter().map(|&m| ws.markers[m]).collect();
                let mut wrenches = vec![S::Twist::zero(); markers.len()];
                f.element.wrenches(t, &markers, &mut wrenches);
                wrenches
                    .iter()
                    .flat_map(|w| w.as_slice())
                    .any(|x| !x.is_finite())
            });
            broken.map_or_else(
                || "the state".to_owned(),
                |f| format!("{} ({})", f.name, f.kind),
            )
        }
    };
    AnalysisError::NotFinite { element, time: t }
}
