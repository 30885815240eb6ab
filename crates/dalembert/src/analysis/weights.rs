//! The metric of the assembly: what counts as a small change.

use crate::space::Space;
use crate::system::System;

/// Weight of a turn where bodies move first.
const TURNS: f64 = 1e6;

/// Diagonal weight blocks, laid out like the mass, and their inverses: a length counts relative to
/// the machine's size, an angle as it is, each by how well its user knows it.
#[derive(Clone, Debug)]
pub(super) struct Weights {
    pub blocks: Vec<f64>,
    pub inverse: Vec<f64>,
    /// A zero right side.
    pub zero: Vec<f64>,
}

impl Weights {
    pub fn new<S: Space>(system: &System<S>, knowledge: &[f64]) -> Self {
        let n = S::NV;
        let linear = S::LINEAR;
        let mut blocks = vec![0.0; system.mass.len()];
        let mut inverse = blocks.clone();
        for b in 0..system.bodies.len() {
            for k in 0..n {
                let scale = if k < linear { system.size } else { 1.0 };
                let w = knowledge[b * n + k] / (scale * scale);
                blocks[(b * n + k) * n + k] = w;
                inverse[(b * n + k) * n + k] = 1.0 / w;
            }
        }
        Self {
            blocks,
            inverse,
            zero: vec![0.0; system.nv()],
        }
    }

    /// As well known as given, the turns of bodies a thousand times better: bodies move rather than turn.
    pub fn moving<S: Space>(system: &System<S>, knowledge: &[f64]) -> Self {
        let turns = |k: usize| k < system.body_nv() && k % S::NV >= S::LINEAR;
        let known = knowledge.iter().enumerate();
        let known = known.map(|(k, w)| if turns(k) { TURNS * w } else { *w });
        Self::new(system, &known.collect::<Vec<_>>())
    }

    /// Every coordinate equally well known.
    pub fn even<S: Space>(system: &System<S>) -> Self {
        Self::new(system, &vec![1.0; system.body_nv()])
    }
}
