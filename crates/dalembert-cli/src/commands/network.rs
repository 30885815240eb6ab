//! `dalembert network`: the linear graph.

use crate::arguments::NetworkArgs;
use crate::failure::Failure;
use crate::load::{Loaded, in_its_space, load};
use crate::output::write_text;
use dalembert::network::{Formulation, Network, SpanningTree, TerminalGraph};
use dalembert::space::Space;

/// Prints the graph, its trees, cut-sets and circuits, and the size of each formulation.
pub fn run(args: &NetworkArgs) -> Result<(), Failure> {
    in_its_space!(load(&args.model, |_| {})?, loaded => network(args, &loaded))
}

fn network<S: Space>(args: &NetworkArgs, loaded: &Loaded<S>) -> Result<(), Failure> {
    let network = Network::new(&loaded.compiled.system.running(), TerminalGraph::default());
    let trees: Vec<SpanningTree> = [Formulation::Absolute, Formulation::Joint]
        .into_iter()
        .map(|f| SpanningTree::new(&network, f))
        .collect::<Result<_, _>>()
        .map_err(|e| Failure::Usage(e.to_string()))?;
    if let Some(path) = &args.dot {
        write_text(path, &network.to_dot(trees.first()))?;
        say!("written: {}", path.display());
        return Ok(());
    }
    if args.model.json {
        let sizes: Vec<_> = trees.iter().map(|t| t.size(&network)).collect();
        say!(
            "{:#}",
            loaded.with_warnings(serde_json::json!({
                "network": network,
                "incidence": network.incidence(),
                "trees": trees,
                "sizes": sizes,
                "loops": network.loops(),
            }))
        );
        return Ok(());
    }
    say_on!("{}", network.to_text());
    for tree in &trees {
        say_on!("\n{}", tree.to_text(&network));
    }
    Ok(())
}
