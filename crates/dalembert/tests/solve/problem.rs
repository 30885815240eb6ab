//! Saddle problems with their dense form.

use crate::random::Random;
use dalembert::solve::{ElementShape, Pattern, Residual, Rhs, Saddle, SaddleShape};
use nalgebra::{DMatrix, DVector};

/// Values on a pattern and a right-hand side.
pub struct Problem {
    pub pattern: Pattern,
    pub mass: Vec<f64>,
    pub mass_inverse: Vec<f64>,
    pub jac: Vec<f64>,
    pub jac_aux: Vec<f64>,
    pub f: Vec<f64>,
    pub g: Vec<f64>,
    pub h: Vec<f64>,
}

/// A solution of a problem.
pub struct Answer {
    pub a: DVector<f64>,
    pub l: DVector<f64>,
    pub s: DVector<f64>,
    pub residual: Residual,
}

impl Problem {
    /// Random positive definite masses, random Jacobians and right-hand sides.
    pub fn random(shape: SaddleShape, random: &mut Random) -> Self {
        let pattern = Pattern::new(shape);
        let (bodies, dof) = (pattern.shape().bodies, pattern.shape().dof);
        let (mut mass, mut mass_inverse) = (Vec::new(), Vec::new());
        for _ in 0..bodies {
            let root = DMatrix::from_vec(dof, dof, random.values(dof * dof));
            let block = &root * root.transpose() + DMatrix::identity(dof, dof) * 0.5;
            let inverse = block.clone().try_inverse().unwrap();
            let inverse = (&inverse + inverse.transpose()) * 0.5;
            mass.extend(block.iter());
            mass_inverse.extend(inverse.iter());
        }
        Self {
            mass,
            mass_inverse,
            jac: random.values(pattern.jac_len()),
            jac_aux: random.values(pattern.jac_aux_len()),
            f: random.values(pattern.coordinates()),
            g: random.values(pattern.rows()),
            h: random.values(pattern.aux()),
            pattern,
        }
    }

    /// Bodies with diagonal masses (mass, mass, inertia) and the rows of revolute joints in the plane.
    ///
    /// A joint is (body i, point on i, body j, point on j); bodies are None for the ground. Row: A-point difference.
    pub fn planar(bodies: &[(f64, f64, f64)], joints: &[PlanarRevolute]) -> Self {
        let elements = joints
            .iter()
            .map(|joint| ElementShape {
                rows: 2,
                bodies: joint.ends().map(|(body, _, _)| body).collect(),
                aux: 0,
            })
            .collect();
        let shape = SaddleShape {
            bodies: bodies.len(),
            dof: 3,
            elements,
        };
        let pattern = Pattern::new(shape);
        let (mut mass, mut mass_inverse) =
            (vec![0.0; 9 * bodies.len()], vec![0.0; 9 * bodies.len()]);
        for (i, &(m, inertia, _)) in bodies.iter().enumerate() {
            for (k, value) in [m, m, inertia].into_iter().enumerate() {
                mass[9 * i + 4 * k] = value;
                mass_inverse[9 * i + 4 * k] = 1.0 / value;
            }
        }
        let mut jac = Vec::new();
        for joint in joints {
            for (body, (x, y), sign) in joint.ends() {
                let (s, c) = bodies[body].2.sin_cos();
                jac.extend([
                    sign,
                    0.0,
                    sign * (-s * x - c * y),
                    0.0,
                    sign,
                    sign * (c * x - s * y),
                ]);
            }
        }
        let f = (0..3 * bodies.len())
            .map(|i| [0.3, -9.81, 0.7][i % 3] * (1.0 + i as f64 * 0.1))
            .collect();
        let g = vec![0.0; pattern.rows()];
        Self {
            mass,
            mass_inverse,
            jac,
            jac_aux: Vec::new(),
            f,
            g,
            h: Vec::new(),
            pattern,
        }
    }

    pub fn dense_mass(&self) -> DMatrix<f64> {
        let (n, dof) = (self.pattern.coordinates(), self.pattern.shape().dof);
        let mut m = DMatrix::zeros(n, n);
        for body in 0..self.pattern.shape().bodies {
            for i in 0..dof {
                for j in 0..dof {
                    m[(body * dof + i, body * dof + j)] = self.mass[(body * dof + i) * dof + j];
                }
            }
        }
        m
    }

    pub fn dense_jac(&self) -> DMatrix<f64> {
        let dof = self.pattern.shape().dof;
        let mut jac = DMatrix::zeros(self.pattern.rows(), self.pattern.coordinates());
        for (e, element) in self.pattern.shape().elements.iter().enumerate() {
            for (slot, &body) in element.bodies.iter().enumerate() {
                if body >= self.pattern.shape().bodies {
                    continue;
                }
                for i in 0..element.rows {
                    for c in 0..dof {
                        jac[(self.pattern.row_offset(e) + i, body * dof + c)] +=
                            self.jac[self.pattern.jac_offset(e, slot) + i * dof + c];
                    }
                }
            }
        }
        jac
    }

    pub fn dense_jac_aux(&self) -> DMatrix<f64> {
        let mut jac = DMatrix::zeros(self.pattern.rows(), self.pattern.aux());
        for (e, element) in self.pattern.shape().elements.iter().enumerate() {
            for i in 0..element.rows {
                for k in 0..element.aux {
                    jac[(
                        self.pattern.row_offset(e) + i,
                        self.pattern.aux_offset(e) + k,
                    )] = self.jac_aux[self.pattern.jac_aux_offset(e) + i * element.aux + k];
                }
            }
        }
        jac
    }

    /// The whole matrix and right-hand side.
    pub fn dense(&self) -> (DMatrix<f64>, DVector<f64>) {
        let (n, m, p) = (
            self.pattern.coordinates(),
            self.pattern.rows(),
            self.pattern.aux(),
        );
        let mut k = DMatrix::zeros(n + m + p, n + m + p);
        let (jac, jac_aux) = (self.dense_jac(), self.dense_jac_aux());
        k.view_mut((0, 0), (n, n)).copy_from(&self.dense_mass());
        k.view_mut((n, 0), (m, n)).copy_from(&jac);
        k.view_mut((0, n), (n, m)).copy_from(&jac.transpose());
        k.view_mut((n, n + m), (m, p)).copy_from(&jac_aux);
        k.view_mut((n + m, n), (p, m))
            .copy_from(&jac_aux.transpose());
        let rhs = [&self.f[..], &self.g, &self.h].concat();
        (k, DVector::from_vec(rhs))
    }

    /// The solver, factored.
    pub fn factored(&self) -> Saddle {
        let mut saddle = Saddle::new(self.pattern.shape().clone());
        saddle.factor(&self.mass_inverse, &self.jac, &self.jac_aux);
        saddle
    }

    /// Solves with a factored solver.
    pub fn solve_with(&self, saddle: &mut Saddle) -> Answer {
        let mut a = vec![f64::NAN; self.pattern.coordinates()];
        let mut l = vec![f64::NAN; self.pattern.rows()];
        let mut s = vec![f64::NAN; self.pattern.aux()];
        let rhs = Rhs {
            f: &self.f,
            g: &self.g,
            h: &self.h,
        };
        let residual = saddle.solve(&self.mass, rhs, &mut a, &mut l, &mut s);
        Answer {
            a: a.into(),
            l: l.into(),
            s: s.into(),
            residual,
        }
    }
}

/// A revolute joint in the plane; None is the ground.
#[derive(Clone, Copy)]
pub struct PlanarRevolute {
    pub i: Option<usize>,
    pub at_i: (f64, f64),
    pub j: Option<usize>,
    pub at_j: (f64, f64),
}

impl PlanarRevolute {
    /// The ends on bodies: body, point, sign.
    fn ends(&self) -> impl Iterator<Item = (usize, (f64, f64), f64)> + use<> {
        let i = self.i.map(|body| (body, self.at_i, 1.0));
        let j = self.j.map(|body| (body, self.at_j, -1.0));
        i.into_iter().chain(j)
    }
}

/// Double parallelogram: three parallel rockers 0.5 long with pivots at x = 0, 1, 2 and one coupler of length 2.
///
/// 12 coordinates, 12 rows, rank 11. Bodies 0 to 2 are the rockers, 3 is the coupler.
pub fn double_parallelogram(angle: f64) -> Problem {
    let bodies = [
        (1.0, 0.02, angle),
        (1.5, 0.03, angle),
        (0.7, 0.02, angle),
        (3.0, 1.0, 0.0),
    ];
    let mut joints = Vec::new();
    for rocker in 0..3 {
        let pivot = (rocker as f64, 0.0);
        joints.push(PlanarRevolute {
            i: None,
            at_i: pivot,
            j: Some(rocker),
            at_j: (-0.25, 0.0),
        });
    }
    for rocker in 0..3 {
        let at = (rocker as f64 - 1.0, 0.0);
        joints.push(PlanarRevolute {
            i: Some(rocker),
            at_i: (0.25, 0.0),
            j: Some(3),
            at_j: at,
        });
    }
    Problem::planar(&bodies, &joints)
}

/// A chain of pinned bars of length 1 in a bent pose, hanging from the ground.
pub fn chain(bars: usize) -> Problem {
    let bodies: Vec<_> = (0..bars)
        .map(|i| (2.0, 2.0 / 12.0, 0.7 * i as f64))
        .collect();
    let joints: Vec<_> = (0..bars)
        .map(|j| PlanarRevolute {
            i: j.checked_sub(1),
            at_i: (0.5, 0.0),
            j: Some(j),
            at_j: (-0.5, 0.0),
        })
        .collect();
    Problem::planar(&bodies, &joints)
}

/// The norm of a difference over the norm of what is right.
pub fn relative(found: &DVector<f64>, right: &DVector<f64>) -> f64 {
    (found - right).norm() / right.norm().max(f64::MIN_POSITIVE)
}
