//! The graph and how it follows from a system.

use super::{Edge, EdgeClass, EdgeSource, Vertex, VertexKind};
use crate::model::GROUND;
use crate::space::Space;
use crate::system::{Phase, Role, System};
use serde::Serialize;
use std::collections::HashMap;

/// Which tree spans the terminals of a body (Tokad, end of section 2.3).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum TerminalGraph {
    /// T: every frame of a body -> O.
    Star,
    /// T': every frame of a body -> its centre, the centre -> O.
    #[default]
    Arms,
}

/// The linear graph of a system, with the maps between edges and the system's parts.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Network {
    /// Name of the model.
    pub name: String,
    /// Terminal graph of the bodies.
    pub terminals: TerminalGraph,
    /// Components of a twist: 3 in the plane, 6 in space.
    pub dimension: usize,
    /// Vertices; 0 is the origin O.
    pub vertices: Vec<Vertex>,
    /// Edges.
    pub edges: Vec<Edge>,
    /// Names of the bodies.
    pub bodies: Vec<String>,
    /// Inertia edge of each body.
    pub body_edge: Vec<usize>,
    /// Edges of each constraint element of the system; none for elements of the start.
    pub element_edges: Vec<Vec<usize>>,
    /// Edges of each force element.
    pub force_edges: Vec<Vec<usize>>,
    /// Vertex of each marker; none where no component is attached.
    pub marker_vertex: Vec<Option<usize>>,
    /// Rows of each constraint element.
    pub(super) element_rows: Vec<usize>,
    /// Auxiliary coordinates of each constraint element.
    pub(super) element_aux: Vec<usize>,
    /// How often the name of a terminal was given.
    #[serde(skip)]
    names: HashMap<String, usize>,
    /// For each element that is a joint its name and the bodies of its first two markers.
    #[serde(skip)]
    pub(super) joint_bodies: Vec<Option<(String, [Option<usize>; 2])>>,
}

/// The origin's vertex.
const ORIGIN: usize = 0;

impl Network {
    /// Builds the graph of a system. Initial conditions are no components.
    pub fn new<S: Space>(system: &System<S>, terminals: TerminalGraph) -> Self {
        let mut network = Self {
            name: system.name.clone(),
            terminals,
            dimension: S::NV,
            vertices: vec![Vertex {
                name: "O".to_owned(),
                kind: VertexKind::Origin,
                body: None,
            }],
            edges: Vec::new(),
            bodies: system.bodies.iter().map(|b| b.name.clone()).collect(),
            body_edge: Vec::new(),
            element_edges: vec![Vec::new(); system.elements.len()],
            force_edges: vec![Vec::new(); system.forces.len()],
            marker_vertex: vec![None; system.markers.len()],
            element_rows: system.elements.iter().map(|e| e.rows.len()).collect(),
            element_aux: system.elements.iter().map(|e| e.aux.len()).collect(),
            names: HashMap::new(),
            joint_bodies: vec![None; system.elements.len()],
        };
        // Marker 0 is the ground's own frame.
        if let Some(first) = network.marker_vertex.first_mut() {
            *first = Some(ORIGIN);
        }
        for (number, body) in system.bodies.iter().enumerate() {
            network.vertices.push(Vertex {
                name: format!("{}.G", body.name),
                kind: VertexKind::Center,
                body: Some(number),
            });
            network.marker_vertex[body.center_marker] = Some(number + 1);
            network.body_edge.push(network.edges.len());
            network.edges.push(Edge {
                name: format!("inertia {}", body.name),
                component: body.name.clone(),
                kind: "inertia".to_owned(),
                class: EdgeClass::Inertia,
                tail: number + 1,
                head: ORIGIN,
                source: EdgeSource::Body(number),
                freedoms: S::NV,
            });
        }
        for (number, e) in system.elements.iter().enumerate() {
            if e.phase != Phase::Always {
                continue;
            }
            let class = match e.role {
                Role::Joint => EdgeClass::Joint,
                Role::Constraint | Role::Start => EdgeClass::Constraint,
                Role::Driver => EdgeClass::Driver,
            };
            if let (Role::Joint, [a, b, ..]) = (e.role, &e.markers[..]) {
                let ends = [*a, *b].map(|m| system.markers[m].body);
                network.joint_bodies[number] = Some((e.name.clone(), ends));
            }
            let held = e.rows.len().saturating_sub(e.aux.len());
            network.component(
                system,
                &e.markers,
                Edge {
                    name: e.name.clone(),
                    component: e.name.clone(),
                    kind: e.kind.clone(),
                    class,
                    tail: ORIGIN,
                    head: ORIGIN,
                    source: EdgeSource::Element(number),
                    freedoms: S::NV.saturating_sub(held),
                },
            );
        }
        for (number, f) in system.forces.iter().enumerate() {
            let acting = f.element.terminals().min(f.markers.len());
            network.component(
                system,
                &f.markers[..acting],
                Edge {
                    name: f.name.clone(),
                    component: f.name.clone(),
                    kind: f.kind.clone(),
                    class: if acting > 1 {
                        EdgeClass::Spring
                    } else {
                        EdgeClass::Force
                    },
                    tail: ORIGIN,
                    head: ORIGIN,
                    source: EdgeSource::Force(number),
                    freedoms: S::NV,
                },
            );
        }
        network
    }

    /// Adds the edges of a component between its markers: one edge between two, a star to the
    /// ground (or to the last marker) between more, an edge to O for a single one.
    fn component<S: Space>(&mut self, system: &System<S>, markers: &[usize], edge: Edge) {
        let vertices: Vec<usize> = markers
            .iter()
            .map(|&m| self.terminal(system, m, &edge.component))
            .collect();
        match vertices[..] {
            [] => {}
            [only] => self.push(Edge { tail: only, ..edge }),
            [tail, head] => self.push(Edge { tail, head, ..edge }),
            _ => {
                let center = vertices
                    .iter()
                    .position(|&v| self.vertices[v].body.is_none())
                    .unwrap_or(vertices.len() - 1);
                let class = match edge.class {
                    EdgeClass::Joint => EdgeClass::Constraint,
                    other => other,
                };
                let ends = vertices.iter().enumerate().filter(|(k, _)| *k != center);
                for (count, (_, &tail)) in ends.enumerate() {
                    self.push(Edge {
                        name: format!("{}#{}", edge.component, count + 1),
                        tail,
                        head: vertices[center],
                        class,
                        ..edge.clone()
                    });
                }
            }
        }
    }

    fn push(&mut self, edge: Edge) {
        let number = self.edges.len();
        match edge.source {
            EdgeSource::Element(e) => self.element_edges[e].push(number),
            EdgeSource::Force(f) => self.force_edges[f].push(number),
            EdgeSource::Body(_) | EdgeSource::Marker(_) => {}
        }
        self.edges.push(edge);
    }

    /// The vertex of a marker, made where a component first needs it, with its arm or anchor.
    fn terminal<S: Space>(&mut self, system: &System<S>, marker: usize, user: &str) -> usize {
        if let Some(vertex) = self.marker_vertex[marker] {
            return vertex;
        }
        let body = system.markers[marker].body;
        let owner = body.map_or(GROUND, |b| system.bodies[b].name.as_str());
        // Two frames of a component on one body are told apart by number.
        let count = self.names.entry(format!("{owner}@{user}")).or_insert(0);
        *count += 1;
        let name = match count {
            1 => format!("{owner}@{user}"),
            n => format!("{owner}@{user}.{n}"),
        };
        let vertex = self.vertices.len();
        let (class, kind, head) = match (body, self.terminals) {
            (None, _) => (EdgeClass::Anchor, "anchor", ORIGIN),
            (Some(_), TerminalGraph::Star) => (EdgeClass::Arm, "port", ORIGIN),
            (Some(b), TerminalGraph::Arms) => (EdgeClass::Arm, "arm", b + 1),
        };
        self.push(Edge {
            name: format!("{kind} {name}"),
            component: owner.to_owned(),
            kind: kind.to_owned(),
            class,
            tail: vertex,
            head,
            source: EdgeSource::Marker(marker),
            freedoms: 0,
        });
        self.vertices.push(Vertex {
            name,
            kind: VertexKind::Terminal,
            body,
        });
        self.marker_vertex[marker] = Some(vertex);
        vertex
    }

    /// Incidence matrix, vertices x edges: +1 at the tail, -1 at the head.
    pub fn incidence(&self) -> Vec<Vec<i8>> {
        let mut a = vec![vec![0; self.edges.len()]; self.vertices.len()];
        for (k, e) in self.edges.iter().enumerate() {
            // An edge from a vertex to itself has no incidence.
            a[e.tail][k] += 1;
            a[e.head][k] -= 1;
        }
        a
    }
}
