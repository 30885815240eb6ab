//! The mass matrix made regular: a little inertia is lent to bodies that have none.

use super::{System, Workspace};
use crate::network::UnionFind;
use crate::space::Space;
use nalgebra::Matrix3;

/// Part of the mass of the bodies around it that a body is lent.
///
/// The solver refines against the true mass, and each sweep gains this part: two or three sweeps reach rounding. The
/// factors lose as many digits, far from the least pivot that they tell from a dependent row.
const LOAN: f64 = 1e-5;

/// Pivot ratios below this part are suspected to come from light bodies.
const DOUBTFUL: f64 = 1e-7;

/// Bodies below this part of the heaviest one that they are joined to say nothing about the masses around them.
const LIGHT: f64 = 1e-6;

/// Arms below this part of the machine's size are rounding.
const LEAST_ARM: f64 = 1e-6;

/// Positive definite blocks near the mass matrix, laid out like it, and their inverses.
///
/// [`Saddle`](crate::solve::Saddle) factors the inverse of these blocks and refines its solutions against the mass
/// itself, so accelerations do not depend on what was lent. As a metric of projections the blocks serve as they are.
#[derive(Clone, Debug, Default)]
pub struct Metric {
    /// The blocks.
    pub blocks: Vec<f64>,
    /// Their inverses.
    pub inverse: Vec<f64>,
    bodies: Vec<Loan>,
    /// Velocity coordinates of a body, and the linear ones among them.
    dof: usize,
    linear: usize,
    /// Is there a body that has little and was not lent yet?
    can_lend: bool,
}

/// What a body is lent in need.
#[derive(Clone, Copy, Debug)]
struct Loan {
    mass: f64,
    inertia: f64,
    /// Does the body have less than that, but something?
    possible: bool,
    taken: bool,
}

impl Metric {
    /// The metric of a machine: bodies without mass or inertia are lent some.
    pub(super) fn new<S: Space>(system: &System<S>) -> Self {
        let mut metric = Self {
            blocks: system.mass.clone(),
            inverse: vec![0.0; system.mass.len()],
            bodies: loans(system),
            dof: S::NV,
            linear: S::LINEAR,
            can_lend: false,
        };
        metric.can_lend = metric.bodies.iter().any(|loan| loan.possible);
        for (b, body) in system.bodies.iter().enumerate() {
            if body.massless {
                metric.raise(b);
            }
            metric.invert(b);
        }
        metric
    }

    /// Factors the equations of motion with the Jacobian of the workspace.
    ///
    /// Beside a body that is held by neighbours heavier by many orders, rows look dependent that are not, and digits are
    /// lost: such bodies are lent inertia as soon as that happens. Allocates nothing.
    pub fn factor<S: Space>(&mut self, system: &System<S>, ws: &mut Workspace<S>) {
        loop {
            let factored = ws.factor(&self.inverse);
            let regular = factored.vanished.is_empty() && factored.smallest > DOUBTFUL;
            if regular || !self.can_lend {
                return;
            }
            let mut lent = false;
            for (row, &ratio) in system.row_refs().iter().zip(factored.pivot_ratio) {
                if ratio <= DOUBTFUL {
                    for &body in &system.elements[row.element].bodies {
                        lent |= self.lend(body);
                    }
                }
            }
            if !lent {
                return;
            }
        }
    }

    /// Bodies that have mass and inertia, but so little that they were lent some.
    pub fn borrowers(&self) -> impl Iterator<Item = usize> {
        let lent = |(b, loan): (usize, &Loan)| loan.taken.then_some(b);
        self.bodies.iter().enumerate().filter_map(lent)
    }

    /// Lends to a body that has little; false where it has enough or was lent before.
    fn lend(&mut self, body: usize) -> bool {
        let loan = &mut self.bodies[body];
        if !loan.possible || loan.taken {
            return false;
        }
        loan.taken = true;
        self.can_lend = self.bodies.iter().any(|loan| loan.possible && !loan.taken);
        self.raise(body);
        self.invert(body);
        true
    }

    fn raise(&mut self, body: usize) {
        let Loan { mass, inertia, .. } = self.bodies[body];
        let (n, linear) = (self.dof, self.linear);
        let block = &mut self.blocks[n * n * body..n * n * (body + 1)];
        let missing = inertia - least_inertia(block, linear);
        for k in 0..n {
            let x = &mut block[(n + 1) * k];
            if k < linear {
                *x = x.max(mass);
            } else if missing > 0.0 {
                *x += missing;
            }
        }
    }

    /// Inverts the block of a body: masses on the diagonal, and the inertia tensor.
    fn invert(&mut self, body: usize) {
        let (n, linear) = (self.dof, self.linear);
        let block = &self.blocks[n * n * body..n * n * (body + 1)];
        let inverse = &mut self.inverse[n * n * body..n * n * (body + 1)];
        for k in 0..linear {
            inverse[(n + 1) * k] = 1.0 / block[(n + 1) * k];
        }
        if n == linear + 1 {
            inverse[(n + 1) * linear] = 1.0 / block[(n + 1) * linear];
            return;
        }
        let tensor = Matrix3::from_fn(|i, j| block[(linear + i) * n + linear + j]);
        // The tensor is positive definite: given so, or raised above.
        let tensor = tensor.try_inverse().unwrap_or_else(Matrix3::zeros);
        for i in 0..3 {
            for j in 0..3 {
                inverse[(linear + i) * n + linear + j] = tensor[(i, j)];
            }
        }
    }
}

/// Least moment of inertia of a mass block about any axis.
fn least_inertia(block: &[f64], linear: usize) -> f64 {
    let n = if linear == 2 { 3 } else { 6 };
    if n == linear + 1 {
        return block[(n + 1) * linear];
    }
    let tensor = Matrix3::from_fn(|i, j| block[(linear + i) * n + linear + j]);
    tensor.symmetric_eigenvalues().min()
}

/// What each body may be lent: a part of the mass around it, and that on the longest arm of its joints.
fn loans<S: Space>(system: &System<S>) -> Vec<Loan> {
    let masses = masses_around(system);
    let mut arms = vec![0.0_f64; system.bodies.len()];
    for &m in system.elements.iter().flat_map(|e| &e.markers) {
        let marker = &system.markers[m];
        if let Some(b) = marker.body {
            arms[b] = arms[b].max(S::arm(&marker.frame));
        }
    }
    let loan = |(b, mass): (usize, f64)| {
        // An arm of rounding size, like that of cos(90 deg), is none.
        let real = arms[b] > LEAST_ARM * system.size;
        let arm = if real { arms[b] } else { system.size };
        let (mass, inertia) = (LOAN * mass, LOAN * mass * arm * arm);
        let own = [
            system.mass_block(b)[0],
            least_inertia(system.mass_block(b), S::LINEAR),
        ];
        Loan {
            mass,
            inertia,
            possible: !system.bodies[b].massless && (own[0] < mass || own[1] < inertia),
            taken: false,
        }
    };
    masses.into_iter().enumerate().map(loan).collect()
}

/// For each body its own mass, or, where that is zero or tiny, the geometric mean of the masses around it.
fn masses_around<S: Space>(system: &System<S>) -> Vec<f64> {
    let n = system.bodies.len();
    let mut joined = UnionFind::new(n);
    for e in &system.elements {
        for pair in e.bodies.windows(2) {
            joined.join(pair[0], pair[1]);
        }
    }
    let mut heaviest = vec![0.0_f64; n];
    for b in 0..n {
        let root = joined.root(b);
        heaviest[root] = heaviest[root].max(system.mass_block(b)[0]);
    }
    let mut known: Vec<Option<f64>> = (0..n)
        .map(|b| {
            let mass = system.mass_block(b)[0];
            (mass > LIGHT * heaviest[joined.root(b)]).then_some(mass)
        })
        .collect();
    loop {
        let mut sums = vec![(0.0, 0.0); n];
        for e in &system.elements {
            for &b in e.bodies.iter().filter(|b| known[**b].is_none()) {
                for mass in e.bodies.iter().filter_map(|other| known[*other]) {
                    sums[b] = (sums[b].0 + mass.ln(), sums[b].1 + 1.0);
                }
            }
        }
        let mut found = false;
        for (known, (sum, count)) in known.iter_mut().zip(sums) {
            if count > 0.0 {
                *known = Some((sum / count).exp());
                found = true;
            }
        }
        if !found {
            break;
        }
    }
    // Where nothing has mass, any scale will do.
    known.into_iter().map(|mass| mass.unwrap_or(1.0)).collect()
}
