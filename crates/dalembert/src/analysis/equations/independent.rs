//! The equations in independent velocities.

use super::coordinates::CoordinateTerms;
use super::report::IndependentEquations;
use super::scalars::Velocities;
use super::{EquationBasis, LabelledMatrix, LabelledVector};
use crate::formulation::{Basis, FormulationError, MotionBasis, embedding};
use nalgebra::DVector;

/// v = B u + g at a state, with its momenta.
pub(super) struct Independent {
    pub motion: MotionBasis,
    basis: Basis,
    u: DVector<f64>,
    g: DVector<f64>,
    p: DVector<f64>,
}

impl Independent {
    /// The basis at a state; `time` is C_t.
    pub fn new(
        at: &CoordinateTerms,
        basis: Basis,
        time: &DVector<f64>,
    ) -> Result<Self, FormulationError> {
        let terms = &at.terms;
        let motion = MotionBasis::new(terms, &basis)?;
        Ok(Self {
            u: motion.independent_velocities(&at.velocities, &terms.column_scale),
            g: motion.particular(&-time),
            p: motion.b.transpose() * (&terms.mass * &at.velocities),
            motion,
            basis,
        })
    }

    /// What the energies need.
    pub fn velocities(&self) -> Velocities<'_> {
        Velocities {
            b: &self.motion.b,
            u: &self.u,
            g: &self.g,
            p: &self.p,
        }
    }

    /// The equations with names.
    pub fn equations(
        &self,
        at: &CoordinateTerms,
        basis: EquationBasis,
        names: &[String],
    ) -> IndependentEquations {
        let terms = &at.terms;
        let b = &self.motion.b;
        let gamma = self.motion.particular(&terms.qd);
        let split = self.motion.partition.as_ref();
        let named = |list: &[usize]| list.iter().map(|&k| names[k].clone()).collect();
        let labels: Vec<String> = match split {
            Some(split) => named(&split.independent),
            None => (1..=b.ncols()).map(|k| format!("u{k}")).collect(),
        };
        let own = |v: &DVector<f64>| LabelledVector::new(v, &labels);
        IndependentEquations {
            basis,
            dependent: split.map_or_else(Vec::new, |split| named(&split.dependent)),
            condition: split.map(|split| split.condition),
            motions: LabelledMatrix::new(b, names, &labels),
            velocity_offset: LabelledVector::new(&self.g, names),
            mass: LabelledMatrix::new(&(b.transpose() * &terms.mass * b), &labels, &labels),
            force: own(&(b.transpose() * (&terms.force - &terms.mass * &gamma))),
            acceleration_offset: LabelledVector::new(&gamma, names),
            velocities: own(&self.u),
            accelerations: embedding(terms, &self.basis)
                .ok()
                .map(|e| own(&e.acceleration)),
            momenta: own(&self.p),
        }
    }
}
