//! Nothing is allocated in the step loop: a counting allocator watches every model of the gallery.

use dalembert::analysis::{Assembly, Dynamics, Motion};
use dalembert::integrate::{Integrator, Ode};
use dalembert::model::{Method, Model, SpaceKind};
use dalembert::space::{Planar, Spatial};
use dalembert::system::compile::{ModelSpace, compile};
use dalembert_io::model_file::parse_model;
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::path::{Path, PathBuf};

thread_local! {
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

/// The system allocator, counting the calls of each thread.
struct Counting;

// SAFETY: every call is handed on unchanged to the system allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.with(|count| count.set(count.get() + 1));
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        COUNT.with(|count| count.set(count.get() + 1));
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Steps of a model, counted.
fn steps<S: ModelSpace>(name: &str, model: &Model, method: Method) -> Option<String> {
    let compiled =
        compile::<S>(model, &[]).unwrap_or_else(|wrong| panic!("{name}: not valid: {wrong:?}"));
    let (state, _) = Assembly::default()
        .run(&compiled.system)
        .unwrap_or_else(|why| panic!("{name}: {why}"));
    let system = compiled.system.running();
    let mut motion = Motion::new(&system, &Dynamics::new(&compiled.options));
    let mut y = state.q.clone();
    y.extend_from_slice(&state.v);
    y.push(0.0);
    let mut out = y.clone();
    let mut step = |integrator: &mut Integrator| {
        integrator
            .step(&mut motion, 10.0)
            .unwrap_or_else(|why| panic!("{name}: {why}"));
        let inside = integrator.t() - 1e-9;
        integrator
            .interpolate(&mut motion, inside, &mut out)
            .expect("a state");
    };
    let mut start = Motion::new(&system, &Dynamics::new(&compiled.options));
    assert_eq!(start.dim(), y.len());
    let largest = if method.has_fixed_steps() {
        1e-4
    } else {
        f64::INFINITY
    };
    let mut integrator = Integrator::start(method, &mut start, 0.0, &y, 1e-8, largest)
        .unwrap_or_else(|why| panic!("{name}: {why}"));
    // The first step may still size something.
    step(&mut integrator);
    let before = COUNT.with(Cell::get);
    for _ in 0..50 {
        if integrator.t() < 1.0 {
            step(&mut integrator);
        }
    }
    let allocated = COUNT.with(Cell::get) - before;
    assert!(
        integrator.t() > 1e-3,
        "{name}: the steps are real: t = {}",
        integrator.t()
    );
    (allocated > 0).then(|| format!("{name}, {method:?}: {allocated} allocations"))
}

fn text(name: &str, text: &str, folder: &Path, method: Method) -> Option<String> {
    let model = parse_model(text, Some(folder)).draft.expect("a model");
    match model.info.space {
        SpaceKind::Planar => steps::<Planar>(name, &model, method),
        SpaceKind::Spatial => steps::<Spatial>(name, &model, method),
    }
}

#[test]
fn the_steps_of_the_gallery_allocate_nothing() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut files: Vec<PathBuf> = std::fs::read_dir(&folder)
        .expect("the gallery")
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|end| end == "toml"))
        .collect();
    files.sort();
    assert!(files.len() > 40, "{} models", files.len());
    let mut found = Vec::new();
    for path in files {
        let read = std::fs::read_to_string(&path).expect("a readable model");
        for (_, method) in Method::NAMES {
            found.extend(text(&path.display().to_string(), &read, &folder, method));
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

/// A slider crank with a spring and a brake (a user's function of the state); the rod and the drive are added.
const SLIDER_CRANK: &str = r#"
[model]
name = "slider crank"

[[body]]
name = "crank"
mass = 0.5
inertia = 0.001
position = [0.065, 0.0375]
angle = "30 deg"

[[body]]
name = "slider"
mass = 0.6
inertia = 0.0004
position = [0.47, 0]

[[joint]]
name = "O"
kind = "revolute"
bodies = ["ground", "crank"]
at = [[0, 0], [-0.075, 0]]

[[joint]]
name = "A"
kind = "revolute"
bodies = ["crank", "rod"]
at = [[0.075, 0], [-0.175, 0]]

[[joint]]
name = "B"
kind = "revolute"
bodies = ["rod", "slider"]
at = [[0.175, 0], [0, 0]]

[[joint]]
name = "guide"
kind = "prismatic"
bodies = ["ground", "slider"]
at = [[0, 0], [0, 0]]
direction = [1, 0]

[[force]]
name = "spring"
kind = "spring-damper"
bodies = ["ground", "slider"]
at = [[0.8, 0], [0, 0]]
stiffness = 200
damping = 2
free_length = 0.3

[[force]]
name = "brake"
kind = "moment"
body = "crank"
value = "-0.01 N*m*s * crank.omega"
"#;

const DRIVEN: &str = r#"
[[driver]]
name = "motor"
kind = "angle"
joint = "O"
value = "30 deg + 20*t + 0.1*sin(5*t)"
"#;

const FREE: &str = r#"
[[initial]]
kind = "angle"
joint = "O"
rate = 20
"#;

/// A rod that has mass, none, and so little that it is treated as if it had none.
#[test]
fn steps_with_light_rods_allocate_nothing() {
    for drive in [DRIVEN, FREE] {
        for mass in [0.8, 0.0, 1e-12] {
            let inertia = mass * 0.35 * 0.35 / 12.0;
            let rod = format!(
                "[[body]]\nname = \"rod\"\nmass = {mass:e}\ninertia = {inertia:e}\nposition = [0.3, 0.0375]\nangle = \"-12 deg\"\n"
            );
            let name = format!("a rod of {mass} kg{drive}");
            let found = text(
                &name,
                &format!("{SLIDER_CRANK}{rod}{drive}"),
                Path::new("."),
                Method::Dopri5,
            );
            assert_eq!(found, None);
        }
    }
}
