//! The linear graph of machines.

mod machines;

use dalembert::network::{
    EdgeClass, Formulation, Loop, Network, NetworkError, SpanningTree, TerminalGraph,
};
use machines::{
    Machine, double_parallelogram, four_bar, peaucellier, ring, slider_crank, tracked_vehicle,
};
use serde_json::json;

fn network(machine: Machine) -> Network {
    Network::new(&machine.system(), TerminalGraph::Arms)
}

/// A planar machine with the topology of the double spherical pendulum with spring and torque.
fn double_pendulum() -> Machine {
    Machine::default()
        .bar("1", [0.0, 0.0], [0.0, -0.5])
        .bar("2", [0.0, -0.5], [0.3, -1.0])
        .pin("J1", "1", "ground", [0.0, 0.0])
        .pin("J2", "1", "2", [0.0, -0.5])
        .force(json!({
            "name": "spring", "kind": "spring-damper", "bodies": ["2", "ground"],
            "at": [[0.2, 0.0], [0.8, -0.6]], "stiffness": 120, "damping": 3, "free_length": 0.5
        }))
        .force(json!({ "name": "torque", "kind": "moment", "body": "2", "value": 0.1 }))
}

fn all() -> Vec<(&'static str, Machine)> {
    vec![
        ("slider crank", slider_crank(0.2, 0.5, 0.6)),
        ("four-bar", four_bar()),
        ("double parallelogram", double_parallelogram(1.0)),
        ("Peaucellier", peaucellier()),
        ("ring", ring(Machine::default(), 6, [0.0, 0.0], 1.0)),
        ("tracked vehicle", tracked_vehicle()),
        ("double pendulum", double_pendulum()),
        ("gears", gears()),
    ]
}

/// Two gears on a turning arm.
fn gears() -> Machine {
    Machine::default()
        .bar("arm", [0.0, 0.0], [0.3, 0.0])
        .body(json!({ "name": "sun", "mass": 1, "inertia": 0.1 }))
        .body(json!({ "name": "planet", "mass": 1, "inertia": 0.1, "position": [0.3, 0.0] }))
        .pin("O", "ground", "arm", [0.0, 0.0])
        .pin("P", "ground", "sun", [0.0, 0.0])
        .pin("Q", "arm", "planet", [0.3, 0.0])
        .joint(json!({
            "name": "mesh", "kind": "gear", "bodies": ["sun", "planet"], "carrier": "arm",
            "radii": [0.2, 0.1]
        }))
}

#[test]
fn circuits_are_orthogonal_to_the_incidence() {
    for (name, machine) in all() {
        let system = machine.system();
        for terminals in [TerminalGraph::Arms, TerminalGraph::Star] {
            let network = Network::new(&system, terminals);
            let a = network.incidence();
            for formulation in [Formulation::Absolute, Formulation::Joint] {
                let tree = match SpanningTree::new(&network, formulation) {
                    Ok(tree) => tree,
                    Err(NetworkError::NeedsArms { .. }) => {
                        assert_eq!(terminals, TerminalGraph::Star);
                        continue;
                    }
                };
                // Inertia edges reach every body, so that one tree spans all.
                assert_eq!(tree.branches.len(), network.vertices.len() - 1, "{name}");
                assert_eq!(
                    tree.chords.len(),
                    network.edges.len() + 1 - network.vertices.len(),
                    "{name}"
                );
                for circuit in tree.circuit_matrix(&network) {
                    for row in &a {
                        let sum: i32 = row
                            .iter()
                            .zip(&circuit)
                            .map(|(x, y)| i32::from(*x) * i32::from(*y))
                            .sum();
                        assert_eq!(sum, 0, "{name}, {formulation}");
                    }
                }
                // Cut-sets and circuits are written from the same matrix.
                let matrix = tree.cut_set_matrix();
                for (row, cut) in matrix.iter().zip(tree.cut_sets()) {
                    assert_eq!(cut.len(), row.iter().filter(|x| **x != 0).count());
                    assert!(cut.iter().all(|&(chord, sign)| row[chord] == sign));
                }
            }
        }
    }
}

#[test]
fn sizes_of_all_formulations_have_the_same_difference() {
    for (name, machine) in all() {
        let system = machine.system();
        let network = Network::new(&system, TerminalGraph::Arms);
        let size = |f| SpanningTree::new(&network, f).unwrap().size(&network);
        let (absolute, joint) = (size(Formulation::Absolute), size(Formulation::Joint));
        assert_eq!(absolute.coordinates, system.nv(), "{name}");
        assert_eq!(absolute.rows, system.rows, "{name}");
        assert_eq!(
            absolute.coordinates - absolute.rows,
            joint.coordinates - joint.rows,
            "{name}"
        );
        assert!(joint.coordinates <= absolute.coordinates, "{name}");
    }
}

#[test]
fn joint_coordinates_of_a_slider_crank() {
    let network = network(slider_crank(0.2, 0.5, 0.6));
    let tree = SpanningTree::new(&network, Formulation::Joint).unwrap();
    let size = tree.size(&network);
    // Three joints of one freedom in the tree, one joint with two rows cut.
    assert_eq!((size.coordinates, size.rows), (3, 2));
    let cut: Vec<EdgeClass> = tree
        .chords
        .iter()
        .map(|&c| network.edges[c].class)
        .collect();
    assert_eq!(cut.iter().filter(|c| **c == EdgeClass::Joint).count(), 1);
    assert_eq!(cut.iter().filter(|c| **c == EdgeClass::Inertia).count(), 3);
}

#[test]
fn cut_set_matrix_of_the_double_pendulum() {
    // Tokad's terminal graph T; branches and chords as in the worked system B1, here with the
    // anchored ground frame of J1 and the port of the torque as vertices of their own.
    let network = Network::new(&double_pendulum().system(), TerminalGraph::Star);
    let tree = SpanningTree::new(&network, Formulation::Absolute).unwrap();
    let matrix = tree.cut_set_matrix();
    let entry = |branch: &str, chord: &str| {
        let find = |list: &[usize], name: &str| {
            list.iter()
                .position(|&e| network.edges[e].name == name)
                .unwrap_or_else(|| panic!("{name}"))
        };
        matrix[find(&tree.branches, branch)][find(&tree.chords, chord)]
    };
    let chords = ["J1", "J2", "spring", "torque"];
    let expected = [
        ("anchor ground@spring", [0, 0, -1, 0]),
        ("anchor ground@J1", [-1, 0, 0, 0]),
        ("inertia 1", [0, 0, 0, 0]),
        ("inertia 2", [0, 0, 0, 0]),
        ("port 1@J1", [1, 0, 0, 0]),
        ("port 1@J2", [0, 1, 0, 0]),
        ("port 2@J2", [0, -1, 0, 0]),
        ("port 2@spring", [0, 0, 1, 0]),
        ("port 2@torque", [0, 0, 0, 1]),
    ];
    assert_eq!(tree.branches.len(), expected.len());
    assert_eq!(tree.chords.len(), chords.len());
    for (branch, row) in expected {
        for (chord, value) in chords.into_iter().zip(row) {
            assert_eq!(entry(branch, chord), value, "{branch}, {chord}");
        }
    }
}

#[test]
fn arms_move_entries_from_ports_to_inertia_edges() {
    // Tokad's terminal graph T': the inertia edge of a body carries all that acts on it.
    let network = network(double_pendulum());
    let tree = SpanningTree::new(&network, Formulation::Absolute).unwrap();
    let branch = tree
        .branches
        .iter()
        .position(|&e| network.edges[e].name == "inertia 2")
        .unwrap();
    let mut cut: Vec<(&str, i8)> = tree
        .cut_sets()
        .swap_remove(branch)
        .into_iter()
        .map(|(chord, sign)| (network.edges[tree.chords[chord]].name.as_str(), sign))
        .collect();
    cut.sort_unstable();
    assert_eq!(cut, [("J2", -1), ("spring", 1), ("torque", 1)]);
}

#[test]
fn loops_are_counted_and_named() {
    let count = |machine| network(machine).loops().len();
    assert_eq!(count(four_bar()), 1);
    assert_eq!(count(double_parallelogram(1.0)), 2);
    assert_eq!(count(peaucellier()), 3);
    assert_eq!(count(double_pendulum()), 0);
    assert_eq!(count(tracked_vehicle()), 1);
    assert_eq!(
        network(slider_crank(0.2, 0.5, 0.6)).loops(),
        [Loop {
            joints: ["O", "A", "B", "S"].map(String::from).to_vec(),
            bodies: ["crank", "rod", "slider", "ground"]
                .map(String::from)
                .to_vec(),
        }]
    );
}

#[test]
fn loops_are_the_shortest() {
    // Peaucellier: two quadrilaterals with the ground and QP, and both long arms with two sides of
    // the rhombus (where three bars meet, two pins share a body).
    let lengths: Vec<usize> = network(peaucellier())
        .loops()
        .iter()
        .map(|l| l.joints.len())
        .collect();
    assert_eq!(lengths, [4, 4, 5]);
    // Loops of the parallelogram share the coupler and have four joints each.
    for own in network(double_parallelogram(1.0)).loops() {
        assert_eq!(own.joints.len(), 4, "{own:?}");
    }
}

#[test]
fn a_gear_with_a_carrier_closes_one_loop() {
    let network = network(gears());
    let loops = network.loops();
    assert_eq!(loops.len(), 1);
    assert!(loops[0].joints.contains(&"mesh".to_owned()));
    let edges = &network.element_edges[3];
    let names: Vec<&str> = edges
        .iter()
        .map(|&e| network.edges[e].name.as_str())
        .collect();
    assert_eq!(names, ["mesh#1", "mesh#2"]);
}

#[test]
fn disconnected_parts_are_named() {
    let network = network(
        four_bar()
            .body(json!({ "name": "lost", "mass": 1, "inertia": 1, "position": [3, 3] }))
            .body(json!({ "name": "hung", "mass": 1, "inertia": 1, "position": [5, 0] }))
            .bar("p", [7.0, 0.0], [8.0, 0.0])
            .bar("r", [8.0, 0.0], [9.0, 0.0])
            .pin("pr", "p", "r", [8.0, 0.0])
            .force(json!({
                "name": "rope", "kind": "spring-damper", "bodies": ["ground", "hung"],
                "at": [[5, 2], [0, 0]], "stiffness": 10
            })),
    );
    let parts = network.parts();
    let bodies: Vec<Vec<&str>> = parts
        .iter()
        .map(|p| p.bodies.iter().map(String::as_str).collect())
        .collect();
    assert_eq!(
        bodies,
        [
            vec!["crank", "coupler", "rocker"],
            vec!["lost"],
            vec!["hung"],
            vec!["p", "r"]
        ]
    );
    assert!(parts[0].grounded && !parts[1].grounded);
    assert!(parts[1].unconnected() && parts[3].unconnected() && !parts[2].unconnected());
    assert_eq!(parts[2].forces, ["rope"]);
    let text = network.to_text();
    assert!(text.contains("lost: connected to nothing"), "{text}");
}

#[test]
fn maps_lead_both_ways() {
    let system = slider_crank(0.2, 0.5, 0.6).system();
    let network = Network::new(&system, TerminalGraph::Arms);
    for (number, element) in system.elements.iter().enumerate() {
        for &e in &network.element_edges[number] {
            assert_eq!(network.edges[e].component, element.name);
            let ends = [network.edges[e].tail, network.edges[e].head];
            for (end, &marker) in ends.iter().zip(&element.markers) {
                assert_eq!(network.marker_vertex[marker], Some(*end));
            }
        }
    }
    for (number, body) in system.bodies.iter().enumerate() {
        assert_eq!(
            network.edges[network.body_edge[number]].component,
            body.name
        );
    }
}

#[test]
fn the_graph_speaks_text_dot_and_json() {
    let network = network(slider_crank(0.2, 0.5, 0.6));
    let tree = SpanningTree::new(&network, Formulation::Joint).unwrap();
    let text = tree.to_text(&network);
    assert!(text.contains("joint formulation: 3 coordinates, 2 constraint rows"));
    let dot = network.to_dot(Some(&tree));
    assert!(dot.starts_with("digraph \"test\" {") && dot.ends_with("}\n"));
    assert_eq!(dot.matches(" -> ").count(), network.edges.len());
    assert_eq!(dot.matches("penwidth=3").count(), tree.branches.len());
    let value = serde_json::to_value(&network).unwrap();
    assert_eq!(value["vertices"][0]["name"], "O");
    assert_eq!(value["edges"][0]["class"], "inertia");
    let value = serde_json::to_value(&tree).unwrap();
    assert_eq!(value["formulation"], "joint");
    assert_eq!(
        value["circuits"].as_array().unwrap().len(),
        tree.chords.len()
    );
}
