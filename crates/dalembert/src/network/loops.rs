//! Independent closed loops of bodies and joints.

use super::Network;
use super::union_find::UnionFind;
use crate::model::GROUND;
use serde::Serialize;
use std::collections::VecDeque;

/// A closed loop: joints and the bodies between them.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Loop {
    /// Names of the joints on the way around.
    pub joints: Vec<String>,
    /// Names of the bodies: `bodies[k]` lies between `joints[k]` and the next one.
    pub bodies: Vec<String>,
}

/// Beyond this many candidates the loops of one tree are taken instead of the shortest ones.
const CANDIDATES: usize = 200_000;

/// A joint as an edge between bodies.
struct Link {
    ends: [usize; 2],
    name: String,
}

/// A set of links, one bit each.
type Bits = Vec<u64>;

impl Network {
    /// A basis of the closed loops of the joints, the shortest loops where the machine is not
    /// large. A component with more than two terminals closes a loop between its first two.
    pub fn loops(&self) -> Vec<Loop> {
        let links = self.links();
        let nodes = self.bodies.len() + 1;
        let mut sets = UnionFind::new(nodes);
        let closing: Vec<usize> = (0..links.len())
            .filter(|&k| !sets.join(links[k].ends[0], links[k].ends[1]))
            .collect();
        if closing.is_empty() {
            return Vec::new();
        }
        let mut candidates: Vec<Vec<usize>> = Vec::new();
        if nodes * links.len() <= CANDIDATES {
            for root in 0..nodes {
                let tree = Descent::new(root, nodes, &links, |_| true);
                candidates.extend((0..links.len()).filter_map(|k| tree.cycle(k, &links)));
            }
        } else {
            let tree_links: Vec<bool> = (0..links.len()).map(|k| !closing.contains(&k)).collect();
            for &k in &closing {
                let tree = Descent::new(links[k].ends[0], nodes, &links, |l| tree_links[l]);
                candidates.extend(tree.cycle(k, &links));
            }
        }
        candidates.sort_by_key(Vec::len);
        let mut basis: Vec<(usize, Bits)> = Vec::new();
        let mut loops = Vec::new();
        for cycle in candidates {
            if loops.len() == closing.len() {
                break;
            }
            if extends(&mut basis, &cycle, links.len()) {
                loops.push(self.name_loop(&cycle, &links));
            }
        }
        loops
    }

    fn links(&self) -> Vec<Link> {
        let ground = self.bodies.len();
        let joints = self.joint_bodies.iter().flatten();
        joints
            .map(|(name, ends)| Link {
                ends: ends.map(|body| body.unwrap_or(ground)),
                name: name.clone(),
            })
            .collect()
    }

    /// Puts the links of a cycle in order.
    fn name_loop(&self, cycle: &[usize], links: &[Link]) -> Loop {
        let body = |node: usize| {
            self.bodies
                .get(node)
                .cloned()
                .unwrap_or_else(|| GROUND.to_owned())
        };
        // Start at the ground where the loop passes it, so that it reads from there.
        let start = cycle
            .iter()
            .flat_map(|&k| links[k].ends)
            .find(|&n| n == self.bodies.len())
            .unwrap_or(links[cycle[0]].ends[0]);
        let mut rest: Vec<usize> = cycle.to_vec();
        rest.sort_unstable();
        let mut at = start;
        let mut own = Loop {
            joints: Vec::new(),
            bodies: Vec::new(),
        };
        while let Some(position) = rest.iter().position(|&k| links[k].ends.contains(&at)) {
            let link = &links[rest.remove(position)];
            at = if link.ends[0] == at {
                link.ends[1]
            } else {
                link.ends[0]
            };
            own.joints.push(link.name.clone());
            own.bodies.push(body(at));
        }
        own
    }
}

/// Shortest ways from a root.
struct Descent {
    /// Previous node and link.
    from: Vec<Option<(usize, usize)>>,
    seen: Vec<bool>,
}

impl Descent {
    fn new(root: usize, nodes: usize, links: &[Link], allowed: impl Fn(usize) -> bool) -> Self {
        let mut neighbours: Vec<Vec<(usize, usize)>> = vec![Vec::new(); nodes];
        for (k, link) in links.iter().enumerate().filter(|(k, _)| allowed(*k)) {
            let [a, b] = link.ends;
            neighbours[a].push((b, k));
            neighbours[b].push((a, k));
        }
        let mut own = Self {
            from: vec![None; nodes],
            seen: vec![false; nodes],
        };
        own.seen[root] = true;
        let mut queue = VecDeque::from([root]);
        while let Some(node) = queue.pop_front() {
            for &(next, link) in &neighbours[node] {
                if !std::mem::replace(&mut own.seen[next], true) {
                    own.from[next] = Some((node, link));
                    queue.push_back(next);
                }
            }
        }
        own
    }

    fn way(&self, mut node: usize) -> Vec<(usize, usize)> {
        let mut way = Vec::new();
        while let Some((previous, link)) = self.from[node] {
            way.push((node, link));
            node = previous;
        }
        way
    }

    /// The cycle of a link and the shortest ways from its ends to the root, where these share nothing.
    fn cycle(&self, link: usize, links: &[Link]) -> Option<Vec<usize>> {
        let [a, b] = links[link].ends;
        if !self.seen[a] || !self.seen[b] {
            return None;
        }
        let (x, y) = (self.way(a), self.way(b));
        let shares = |way: &[(usize, usize)], other: &[(usize, usize)]| {
            way.iter()
                .any(|(n, l)| *l == link || other.iter().any(|(m, k)| m == n || k == l))
        };
        if shares(&x, &y) || shares(&y, &x) {
            return None;
        }
        let mut cycle = vec![link];
        cycle.extend(x.iter().chain(&y).map(|(_, l)| *l));
        Some(cycle)
    }
}

/// Adds a cycle to a basis over the integers modulo 2; false where it follows from it.
fn extends(basis: &mut Vec<(usize, Bits)>, cycle: &[usize], links: usize) -> bool {
    let mut bits: Bits = vec![0; links.div_ceil(64)];
    for &k in cycle {
        bits[k / 64] ^= 1 << (k % 64);
    }
    for (pivot, row) in basis.iter() {
        if bits[pivot / 64] >> (pivot % 64) & 1 == 1 {
            for (x, y) in bits.iter_mut().zip(row) {
                *x ^= y;
            }
        }
    }
    let pivot = (0..links).find(|k| bits[k / 64] >> (k % 64) & 1 == 1);
    match pivot {
        Some(pivot) => {
            basis.push((pivot, bits));
            true
        }
        None => false,
    }
}
