//! Sections that are there once: `[model]`, `[analysis]`, `[output]`.

use crate::model_file::item::{Item, type_name};
use crate::model_file::table_reader::TableReader;
use dalembert::model::{
    AnalysisOptions, Info, Method, OutputOptions, Point, SpaceKind, Stabilization,
};
use dalembert::space::orientation::OrientationSet;
use toml::de::DeValue;

/// Reads `[model]`.
pub(super) fn info(mut table: TableReader<'_>) -> Info {
    let name = table.required("name", Item::text).unwrap_or_default();
    let description = table.optional("description", Item::text);
    let spaces = [
        ("planar", SpaceKind::Planar),
        ("spatial", SpaceKind::Spatial),
    ];
    let space = table
        .optional("space", |item| item.choice(&spaces))
        .unwrap_or_default();
    let components = match space {
        SpaceKind::Planar => 2,
        SpaceKind::Spatial => 3,
    };
    table.context().dimension.set(components);
    let info = Info {
        name,
        description,
        space,
        gravity: table.optional("gravity", gravity),
    };
    table.finish();
    info
}

/// Reads the vector of gravity; a single number is its size.
fn gravity(item: &Item<'_>) -> Option<Point> {
    if let DeValue::Array(_) = item.value {
        return item.point();
    }
    let (expected, help) = if item.context.dimension.get() == 2 {
        ("2", "write [0, -9.81] for gravity along -y")
    } else {
        ("3", "write [0, 0, -9.81] for gravity along -z")
    };
    let found = type_name(item.value);
    let text = format!("expected a list of {expected} numbers, found {found}");
    item.error("wrong-type", &text, help);
    None
}

/// Reads `[analysis]`.
pub(super) fn analysis(mut table: TableReader<'_>) -> AnalysisOptions {
    let stabilizations = [
        ("projection", Stabilization::Projection),
        ("baumgarte", Stabilization::Baumgarte),
    ];
    let options = AnalysisOptions {
        start: table.value("start"),
        end: table.value("end"),
        step: table.value("step"),
        tolerance: table.value("tolerance"),
        integrator: table.optional("integrator", |item| item.choice(&Method::NAMES)),
        fixed_step: table.value("fixed_step"),
        max_step: table.value("max_step"),
        max_steps: table.optional("max_steps", Item::count),
        stabilization: table.optional("stabilization", |item| item.choice(&stabilizations)),
        baumgarte: table.optional("baumgarte", |item| item.pair(Item::value)),
        max_iterations: table.optional("max_iterations", Item::count),
        actuators: table.list("actuators", Item::joint),
        independent: table.list("independent", Item::text),
    };
    table.finish();
    options
}

/// Reads the name of a set of orientation coordinates.
fn orientation_set(item: &Item<'_>) -> Option<String> {
    let text = item.text()?;
    if text.parse::<OrientationSet>().is_err() {
        item.error(
            "unknown-word",
            &format!("`{text}` is not known here"),
            "allowed here: `euler-parameters`, `axis-angle`, `rodriguez`, `direction-cosines`, and \
             Euler angles like `euler-zxz` or `euler-xyz-space`",
        );
    }
    Some(text)
}

/// Reads `[output]`.
pub(super) fn output(mut table: TableReader<'_>) -> OutputOptions {
    let options = OutputOptions {
        channels: table.list("channels", Item::text),
        momentum_about: table.point("momentum_about"),
        orientation: table.of_space(SpaceKind::Spatial, "orientation", orientation_set),
    };
    table.finish();
    options
}
