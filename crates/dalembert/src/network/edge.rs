//! Edges of the linear graph.

use serde::Serialize;

/// What an edge is: decides its place in a formulation's tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum EdgeClass {
    /// A frame fixed on the ground -> O: an across driver, its motion is given.
    Anchor,
    /// Centre of mass -> O.
    Inertia,
    /// A frame on a body -> its centre (arm), or -> O (port).
    Arm,
    /// A joint between two frames.
    Joint,
    /// A constraint, or one edge of a component with more than two terminals.
    Constraint,
    /// A driver. It prescribes one component of its across variable, so it is a constraint with a
    /// given right side and stays in the cotree, where its multiplier is.
    Driver,
    /// A spring, damper or bushing between two frames.
    Spring,
    /// A force or moment against the ground: a through driver.
    Force,
}

/// Where an edge comes from in the system.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum EdgeSource {
    /// The body of an inertia edge.
    Body(usize),
    /// The marker of an arm or anchor.
    Marker(usize),
    /// The constraint element (joint, constraint, driver).
    Element(usize),
    /// The force element.
    Force(usize),
}

/// An edge. Across variable: twist of the tail minus twist of the head. Through variable: the
/// wrench exerted on the component at its tail (Tokad 28).
///
/// A component whose two points separate (a slide) hands its wrench on with the moment of the
/// distance: that is in its terminal equations, the topology is the same.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Edge {
    /// Name: that of the component, numbered where the component has several edges.
    pub name: String,
    /// Name of the component.
    pub component: String,
    /// Kind in words: "revolute", "spring-damper", "inertia".
    pub kind: String,
    /// Class.
    pub class: EdgeClass,
    /// Vertex from which it goes.
    pub tail: usize,
    /// Vertex to which it goes.
    pub head: usize,
    /// Where it comes from.
    pub source: EdgeSource,
    /// Components of the across variable that stay free along the edge (scalar rows of the plane: 0 to 3).
    pub freedoms: usize,
}
