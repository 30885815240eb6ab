//! The machines.

use super::{pin, rod};
use serde_json::{Value, json};

fn named(name: &str, rest: Value) -> (String, Value) {
    let mut model = rest;
    model["model"] = json!({"name": name});
    (name.to_owned(), model)
}

/// Machines of many kinds with consistent starts and non-zero velocities.
pub fn all() -> Vec<(String, Value)> {
    vec![
        named("pendulum", pendulum()),
        named("double pendulum", double_pendulum()),
        named("slider-crank", slider_crank()),
        named("four-bar with spring", four_bar()),
        named("cam with roller", cam()),
        named("planetary gear", planetary()),
        named("disk on an incline", rolling_line()),
        named("disk in a track", rolling_circle()),
        named("rack and pinion", rack()),
        named("double parallelogram", double_parallelogram()),
        named("pin in slot with moving base", moving_base()),
        named("massless link", massless_link()),
    ]
}

fn pendulum() -> Value {
    json!({
        // The frame sits at the pin, the centre of mass elsewhere.
        "body": [{"name": "bob", "mass": 1.5, "inertia": 0.2, "center": [0.6, 0.1],
                  "position": [0, 0], "angle": 0.4}],
        "joint": [pin("O", ["ground", "bob"], [[0.0, 0.0], [0.0, 0.0]])],
        "force": [{"name": "motor", "kind": "actuator", "joint": "O", "value": 2.5}],
        "initial": [{"kind": "angle", "joint": "O", "value": 0.4, "rate": 3.0}]
    })
}

fn double_pendulum() -> Value {
    json!({
        "body": [rod("a", 2.0, 1.0, [0.5, 0.0], 0.3), rod("b", 1.0, 0.8, [1.2, 0.4], -0.6)],
        "joint": [pin("O", ["ground", "a"], [[0.0, 0.0], [-0.5, 0.0]]),
                  pin("A", ["a", "b"], [[0.5, 0.0], [-0.4, 0.0]])],
        "initial": [{"kind": "angle", "joint": "O", "value": 0.3, "rate": 2.0},
                    {"kind": "angle", "joint": "A", "value": -0.9, "rate": -5.0}]
    })
}

fn slider_crank() -> Value {
    let (l2, l3) = (0.2_f64, 0.4_f64);
    let t2 = std::f64::consts::FRAC_PI_4;
    let t3 = -(l2 * t2.sin() / l3).asin();
    let x = l2 * t2.cos();
    json!({
        "body": [
            rod("crank", 0.5, l2, [0.5 * x, 0.5 * l2 * t2.sin()], t2),
            rod("rod", 1.0, l3, [x + 0.5 * l3 * t3.cos(), 0.5 * l2 * t2.sin()], t3),
            {"name": "slider", "mass": 0.2, "inertia": 0.0001,
             "position": [x + l3 * t3.cos(), 0.0], "angle": 0.0}
        ],
        "joint": [
            pin("O", ["ground", "crank"], [[0.0, 0.0], [-0.5 * l2, 0.0]]),
            pin("A", ["crank", "rod"], [[0.5 * l2, 0.0], [-0.5 * l3, 0.0]]),
            pin("B", ["rod", "slider"], [[0.5 * l3, 0.0], [0.0, 0.0]]),
            {"name": "guide", "kind": "prismatic", "bodies": ["ground", "slider"],
             "at": [[0, 0], [0, 0]], "angles": [0, 0]}
        ],
        "force": [
            {"name": "M2", "kind": "moment", "body": "crank", "value": 10.0},
            {"name": "F4", "kind": "force", "body": "slider", "value": [15.0, 0.0]}
        ],
        "initial": [{"kind": "angle", "joint": "O", "value": t2, "rate": 150.0}]
    })
}

fn four_bar() -> Value {
    let (l1, l2, l3, l4) = (0.35_f64, 0.2_f64, 0.4_f64, 0.3_f64);
    let (t2, t3, t4) = (
        70_f64.to_radians(),
        0.232_276_418_925_485_5_f64,
        4.345_328_481_925_324_f64,
    );
    let at = |x: f64, y: f64, l: f64, t: f64| [x + 0.5 * l * t.cos(), y + 0.5 * l * t.sin()];
    let a = [l2 * t2.cos(), l2 * t2.sin()];
    let b = [a[0] + l3 * t3.cos(), a[1] + l3 * t3.sin()];
    json!({
        "body": [
            rod("crank", 0.5, l2, at(0.0, 0.0, l2, t2), t2),
            rod("coupler", 1.0, l3, at(a[0], a[1], l3, t3), t3),
            rod("rocker", 0.75, l4, at(b[0], b[1], l4, t4), t4)
        ],
        "joint": [
            pin("O", ["ground", "crank"], [[0.0, 0.0], [-0.5 * l2, 0.0]]),
            pin("A", ["crank", "coupler"], [[0.5 * l2, 0.0], [-0.5 * l3, 0.0]]),
            pin("B", ["coupler", "rocker"], [[0.5 * l3, 0.0], [-0.5 * l4, 0.0]]),
            pin("C", ["rocker", "ground"], [[0.5 * l4, 0.0], [l1, 0.0]])
        ],
        "force": [{"name": "spring", "kind": "spring-damper", "bodies": ["crank", "rocker"],
                   "at": [[0.03, 0.0], [-0.05, 0.0]],
                   "stiffness": 250.0, "damping": 10.0, "free_length": 0.35}],
        "initial": [{"kind": "angle", "joint": "O", "value": t2, "rate": 150.0}]
    })
}

fn cam() -> Value {
    json!({
        "body": [
            {"name": "cam", "mass": 2.0, "inertia": 0.01, "center": [0.01, 0.005],
             "position": [0, 0], "angle": 0.5},
            {"name": "follower", "mass": 0.5, "inertia": 0.001, "position": [0.0, 0.13], "angle": 0}
        ],
        "joint": [
            pin("O", ["ground", "cam"], [[0.0, 0.0], [0.0, 0.0]]),
            {"name": "guide", "kind": "prismatic", "bodies": ["ground", "follower"],
             "at": [[0, 0], [0, 0]], "angles": ["90 deg", "90 deg"]},
            {"name": "contact", "kind": "cam", "bodies": ["cam", "follower"],
             "at": [[0, 0], [0, 0]], "profile": {"radius": "0.1 m + 0.02 m * cos(2*phi)"},
             "follower": {"kind": "roller", "radius": 0.02}}
        ],
        "force": [{"name": "spring", "kind": "spring-damper", "bodies": ["ground", "follower"],
                   "at": [[0.0, 0.4], [0.0, 0.0]], "stiffness": 500.0, "free_length": 0.4}],
        "initial": [{"kind": "angle", "joint": "O", "value": 0.5, "rate": 10.0}]
    })
}

fn planetary() -> Value {
    // Ring fixed; sun and planet on a carrier: radii 0.1 and 0.05, ring 0.2.
    json!({
        "body": [
            {"name": "sun", "mass": 2.0, "inertia": 0.01, "position": [0, 0], "angle": 0},
            {"name": "carrier", "mass": 1.0, "inertia": 0.008, "position": [0, 0], "angle": 0.2},
            {"name": "planet", "mass": 0.5, "inertia": 0.0006,
             "position": [0.15 * 0.2_f64.cos(), 0.15 * 0.2_f64.sin()], "angle": 0}
        ],
        "joint": [
            pin("S", ["ground", "sun"], [[0.0, 0.0], [0.0, 0.0]]),
            pin("C", ["ground", "carrier"], [[0.0, 0.0], [0.0, 0.0]]),
            pin("P", ["carrier", "planet"], [[0.15, 0.0], [0.0, 0.0]]),
            {"name": "sun mesh", "kind": "gear", "bodies": ["sun", "planet"], "carrier": "carrier",
             "radii": [0.1, 0.05]},
            {"name": "ring mesh", "kind": "gear", "bodies": ["ground", "planet"],
             "carrier": "carrier", "radii": [0.2, 0.05], "internal": true}
        ],
        "force": [{"name": "drive", "kind": "moment", "body": "sun", "value": 1.0},
                  {"name": "load", "kind": "moment", "body": "carrier", "value": -2.0}],
        "initial": [{"kind": "angle", "joint": "C", "rate": 4.0}]
    })
}

fn rolling_line() -> Value {
    json!({
        "body": [{"name": "disk", "mass": 3.0, "inertia": 0.05, "center": [0.03, 0.02],
                  "position": [0.2_f64 * 0.25_f64.cos() + 0.3, 0.3], "angle": 0.1}],
        "joint": [{"name": "roll", "kind": "rolling-on-line", "bodies": ["ground", "disk"],
                   "at": [[0, 0], [0, 0]], "angles": ["-20 deg", 0], "radius": 0.2, "side": "left"}],
        "initial": [{"kind": "coordinate", "body": "disk", "coordinate": "angle", "rate": -6.0}]
    })
}

fn rolling_circle() -> Value {
    json!({
        "body": [
            {"name": "disk", "mass": 3.0, "inertia": 0.09375, "position": [0.375, -0.649], "angle": 0},
            // The track itself swings on a pin.
            {"name": "track", "mass": 10.0, "inertia": 2.0, "position": [0, 0], "angle": 0}
        ],
        "joint": [
            pin("O", ["ground", "track"], [[0.0, 0.0], [0.0, 0.2]]),
            {"name": "roll", "kind": "rolling-on-circle", "bodies": ["track", "disk"],
             "at": [[0, 0], [0, 0]], "radii": [1.0, 0.25], "internal": true}
        ],
        "initial": [{"kind": "coordinate", "body": "disk", "coordinate": "angle", "rate": -2.0},
                    {"kind": "angle", "joint": "O", "rate": 0.7}]
    })
}

fn rack() -> Value {
    json!({
        "body": [
            {"name": "pinion", "mass": 2.0, "inertia": 0.01, "position": [0, 0.1], "angle": 0},
            {"name": "bar", "mass": 4.0, "inertia": 0.5, "position": [0.05, 0.0], "angle": 0}
        ],
        "joint": [
            pin("O", ["ground", "pinion"], [[0.0, 0.1], [0.0, 0.0]]),
            {"name": "guide", "kind": "prismatic", "bodies": ["ground", "bar"],
             "at": [[0, 0], [0, 0]], "angles": [0, 0]},
            {"name": "mesh", "kind": "rack", "bodies": ["pinion", "bar"],
             "at": [[0, 0], [0, 0]], "angles": [0, 0], "radius": 0.1}
        ],
        "force": [{"name": "motor", "kind": "actuator", "joint": "O", "value": "3 N*m - 0.1 N*m*s * O.angle_rate"},
                  {"name": "spring", "kind": "joint-spring", "joint": "guide", "stiffness": 80.0, "damping": 2.0}],
        "initial": [{"kind": "angle", "joint": "O", "rate": 5.0}]
    })
}

/// Three equal parallel rockers on one coupler: one redundant row.
pub fn double_parallelogram() -> Value {
    let (l, t) = (0.5_f64, 0.9_f64);
    let (c, s) = (t.cos(), t.sin());
    let rocker = |name: &str, x: f64| rod(name, 0.8, l, [x + 0.5 * l * c, 0.5 * l * s], t);
    let low =
        |name: &str, body: &str, x: f64| pin(name, ["ground", body], [[x, 0.0], [-0.5 * l, 0.0]]);
    let high =
        |name: &str, body: &str, x: f64| pin(name, [body, "coupler"], [[0.5 * l, 0.0], [x, 0.0]]);
    json!({
        "body": [rocker("r1", 0.0), rocker("r2", 1.0), rocker("r3", 2.0),
                 rod("coupler", 2.0, 2.0, [1.0 + l * c, l * s], 0.0)],
        "joint": [low("A1", "r1", 0.0), low("A2", "r2", 1.0), low("A3", "r3", 2.0),
                  high("B1", "r1", -1.0), high("B2", "r2", 0.0), high("B3", "r3", 1.0)],
        "force": [{"name": "push", "kind": "force", "body": "coupler", "value": [3.0, -4.0]}],
        "initial": [{"kind": "angle", "joint": "A1", "value": t, "rate": 2.0}]
    })
}

fn moving_base() -> Value {
    json!({
        "body": [{"name": "base", "mass": 2.0, "inertia": 0.02, "position": [0.0, 0.0], "angle": 0},
                 {"name": "arm", "mass": 1.2, "inertia": 0.064, "center": [0.4, 0.0],
                  "position": [0.0, 0.0], "angle": 0.7}],
        "joint": [
            {"name": "guide", "kind": "prismatic", "bodies": ["ground", "base"],
             "at": [[0, 0], [0, 0]], "angles": [0, 0]},
            {"name": "slot", "kind": "pin-slot", "bodies": ["base", "arm"],
             "at": [[0, 0], [0, 0]], "angles": ["30 deg", 0]}
        ],
        "driver": [{"name": "shake", "kind": "displacement", "joint": "guide", "value": "0.1 m * sin(3 rad/s * t + 0.4)"}],
        "force": [{"name": "spring", "kind": "spring-damper", "bodies": ["ground", "arm"],
                   "at": [[0.3, 1.0], [0.8, 0.0]], "stiffness": 30.0, "damping": 0.5, "free_length": 0.5}],
        "initial": [{"kind": "coordinate", "body": "arm", "coordinate": "angle", "value": 0.7, "rate": 2.0},
                    {"kind": "coordinate", "body": "arm", "coordinate": "x", "rate": 0.3}]
    })
}

/// A four-bar whose coupler has neither mass nor inertia.
fn massless_link() -> Value {
    let mut model = four_bar();
    let coupler = &mut model["body"][1];
    coupler["mass"] = json!(0.0);
    coupler["inertia"] = json!(0.0);
    model
}

/// Andrews' squeezing mechanism: data and accelerations of the IVP Test Set (Mazzia and Magherini) and of the IFToMM
/// benchmark A03; seven bodies, ten pins, a spring and a constant motor moment, at rest.
pub fn andrews() -> Value {
    // Name, mass, inertia, centre of mass, angle.
    let bodies = [
        (
            "K1",
            0.04325,
            2.194e-06,
            [0.0009182485980307614, -5.674074562905483e-05],
            -0.06171389001427645,
        ),
        (
            "K2",
            0.00365,
            4.41e-07,
            [-0.0044914333599330725, 0.0002775362557942899],
            -0.06171389001427645,
        ),
        (
            "K3",
            0.02373,
            5.255e-06,
            [-0.018742186670315457, 0.020485106789073934],
            0.45527981916307037,
        ),
        (
            "K4",
            0.00706,
            5.667e-07,
            [-0.030222939830158887, 0.012071182356663938],
            0.7100333697097284,
        ),
        (
            "K5",
            0.0705,
            1.169e-05,
            [-0.044657585128555194, 0.00044484734633101894],
            0.48736497954384256,
        ),
        (
            "K6",
            0.00706,
            5.667e-07,
            [-0.028543268536783597, -0.010722254707252287],
            1.0078790543839353,
        ),
        (
            "K7",
            0.05498,
            1.912e-05,
            [-0.05626558178575734, -0.002135507029626141],
            1.2305474445498212,
        ),
    ];
    // Name, bodies, points from the centres of mass.
    let pins = [
        ("O", ["ground", "K1"], [[0.0, 0.0], [-0.00092, 0.0]]),
        ("F", ["K1", "K2"], [[0.00608, 0.0], [0.0115, 0.0]]),
        (
            "B",
            ["ground", "K3"],
            [[-0.03635, 0.03273], [-0.01043, 0.01874]],
        ),
        ("E23", ["K3", "K2"], [[-0.01043, -0.01626], [-0.0165, 0.0]]),
        (
            "A5",
            ["ground", "K5"],
            [[-0.06934, -0.00227], [-0.02308, 0.00916]],
        ),
        ("G", ["K5", "K4"], [[0.01692, 0.00916], [0.0, 0.00579]]),
        ("E4", ["K4", "K2"], [[0.0, -0.01421], [-0.0165, 0.0]]),
        (
            "A7",
            ["ground", "K7"],
            [[-0.06934, -0.00227], [-0.00449, 0.01228]],
        ),
        ("H", ["K7", "K6"], [[-0.00449, -0.02772], [-0.00579, 0.0]]),
        ("E6", ["K6", "K2"], [[0.01421, 0.0], [-0.0165, 0.0]]),
    ];
    let bodies: Vec<Value> = bodies
        .iter()
        .map(|(name, mass, inertia, position, angle)| {
            json!({"name": name, "mass": mass, "inertia": inertia, "position": position, "angle": angle})
        })
        .collect();
    let pins: Vec<Value> = pins
        .iter()
        .map(|(name, bodies, at)| pin(name, *bodies, *at))
        .collect();
    json!({
        "model": {"name": "Andrews' mechanism", "gravity": [0, 0]},
        "body": bodies,
        "joint": pins,
        "force": [
            {"name": "motor", "kind": "moment", "body": "K1", "value": 0.033},
            {"name": "spring", "kind": "spring-damper", "bodies": ["ground", "K3"],
             "at": [[0.014, 0.072], [0.00957, 0.00074]], "stiffness": 4530.0, "free_length": 0.07785}
        ],
        "initial": [{"kind": "angle", "joint": "O", "value": -0.061_713_890_014_276_45, "rate": 0.0}]
    })
}
