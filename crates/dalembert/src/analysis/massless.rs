//! Equations of motion where bodies lack mass or inertia: their block of M is singular, but the
//! constraints may hold them.

use super::AnalysisError;
use crate::space::Planar;
use crate::system::{System, Workspace};
use nalgebra::{DMatrix, DVector};

/// Solves M a + C_q^T lambda = Q_e, C_q a = rhs.
///
/// # Errors
/// A coordinate that neither mass nor constraint holds.
pub(super) fn solve(
    system: &System<Planar>,
    ws: &mut Workspace<Planar>,
) -> Result<(), AnalysisError> {
    let force = std::mem::take(&mut ws.force);
    let result = general(system, ws, &force);
    ws.force = force;
    result
}

/// Factors the projection's matrix where the mass is regular.
pub(super) fn factor(system: &System<Planar>, ws: &mut Workspace<Planar>) {
    if !system.massless {
        ws.factor(&system.mass_inverse);
    }
}

/// Solves with a right side of forces `f`, in the metric of the mass.
pub(super) fn solve_with(
    system: &System<Planar>,
    ws: &mut Workspace<Planar>,
    f: &[f64],
) -> Result<(), AnalysisError> {
    if system.massless {
        return general(system, ws, f);
    }
    ws.solve(&system.mass, f);
    Ok(())
}

/// Dense solution through a basis of the row space: with redundant rows the multipliers are the
/// least ones.
fn general(
    system: &System<Planar>,
    ws: &mut Workspace<Planar>,
    f: &[f64],
) -> Result<(), AnalysisError> {
    let (n, m) = (system.nv(), system.rows);
    let c = system.dense_jacobian(ws);
    let mut k = DMatrix::zeros(n + m, n + m);
    k.view_mut((0, 0), (n, n)).copy_from(&system.dense_mass());
    k.view_mut((n, 0), (m, n)).copy_from(&c);
    k.view_mut((0, n), (n, m)).copy_from(&c.transpose());
    // Symmetric scaling to unit rows: masses and lengths differ by orders of magnitude.
    let mut scale = DVector::from_element(n + m, 1.0);
    for i in 0..n + m {
        let largest = k.row(i).amax();
        if largest > 0.0 {
            scale[i] = 1.0 / largest.sqrt();
        }
    }
    for i in 0..n + m {
        for j in 0..n + m {
            k[(i, j)] *= scale[i] * scale[j];
        }
    }
    let mut b = DVector::zeros(n + m);
    for i in 0..n {
        b[i] = f.get(i).copied().unwrap_or(0.0) * scale[i];
    }
    for i in 0..m {
        b[n + i] = ws.rhs[i] * scale[n + i];
    }
    let lu = k.clone().full_piv_lu();
    let u = lu.u().diagonal();
    let largest = u.amax();
    if u.amin() > 1e-12 * largest
        && let Some(x) = lu.solve(&b)
    {
        store(ws, &x, &scale, n, m);
        return Ok(());
    }
    let svd = k.svd(true, true);
    let largest = svd.singular_values.amax();
    let (Some(v_t), Ok(x)) = (&svd.v_t, svd.solve(&b, 1e-11 * largest)) else {
        return Err(AnalysisError::Massless {
            names: "unknown".to_owned(),
        });
    };
    // A null vector with a part in the accelerations is a motion that nothing holds.
    let names = system.coordinate_names();
    let mut free = Vec::new();
    for (r, value) in svd.singular_values.iter().enumerate() {
        if *value <= 1e-11 * largest {
            for (k, name) in names.iter().enumerate() {
                if v_t[(r, k)].abs() > 1e-6 && !free.contains(name) {
                    free.push(name.clone());
                }
            }
        }
    }
    if !free.is_empty() {
        return Err(AnalysisError::Massless {
            names: free.join(", "),
        });
    }
    store(ws, &x, &scale, n, m);
    Ok(())
}

fn store(ws: &mut Workspace<Planar>, x: &DVector<f64>, scale: &DVector<f64>, n: usize, m: usize) {
    for i in 0..n {
        ws.a[i] = x[i] * scale[i];
    }
    for i in 0..m {
        ws.lambda[i] = x[n + i] * scale[n + i];
    }
}
