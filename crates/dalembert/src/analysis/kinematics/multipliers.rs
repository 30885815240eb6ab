//! Multipliers of a known motion.

use crate::analysis::weights::Weights;
use crate::space::Space;
use crate::system::{System, Workspace};

/// Solves C_q^T lambda = Q_e - M a in the metric of the weights, with the last factors, for the
/// accelerations in the workspace; keeps them. Returns the part of the forces that the rows cannot
/// carry, relative to all of them.
pub(in crate::analysis) fn solve_multipliers<S: Space>(
    system: &System<S>,
    ws: &mut Workspace<S>,
    weights: &Weights,
) -> f64 {
    // [W C_q^T; C_q 0] [x; lambda] = [Q_e - M a; 0]: with C_q of full column rank x = 0.
    let a = ws.a.clone();
    let mut f = ws.force.clone();
    let mut inertia = vec![0.0; system.body_nv()];
    system.mass_mul(&a, &mut inertia);
    for (f, i) in f.iter_mut().zip(&inertia) {
        *f -= i;
    }
    ws.rhs.fill(0.0);
    ws.solve(&weights.blocks, &f);
    ws.a.copy_from_slice(&a);
    let mut left = f.clone();
    system.jac_transpose_add(ws, -1.0, &ws.lambda, &mut left);
    let scale = |x: &[f64]| -> f64 {
        let bodies = x[..system.body_nv()].chunks_exact(S::NV);
        let force = bodies.map(|x| {
            let (linear, angular) = x.split_at(S::LINEAR);
            let sum = |x: &[f64]| x.iter().map(|x| x.abs()).sum::<f64>();
            sum(linear) * system.size + sum(angular)
        });
        force.fold(0.0, f64::max)
    };
    let all = scale(&f);
    if all > 0.0 { scale(&left) / all } else { 0.0 }
}
