//! Cams and their followers.

use super::power::G;
#[cfg(feature = "viewer")]
use super::run::example;
use super::run::{Run, close};
use std::f64::consts::{FRAC_PI_2, PI};

/// Cam angle, lift, its rate and second rate, surface parameter: recomputed by scalar root finding from
/// Shabana, Computational Dynamics (2nd ed., 2001), section 3.6.
const KNIFE_EDGE: [[f64; 5]; 6] = [
    [
        0.0,
        0.047814972875861825,
        0.01450338482977632,
        1.3610105946701283,
        1.4666052414062085,
    ],
    [
        0.7,
        0.05124886430695876,
        0.06516961488086352,
        -0.17077059878714132,
        0.7735409869419708,
    ],
    [
        1.6,
        0.05340236348594593,
        -0.03970773022770152,
        -1.56705422092174,
        -0.12256032362279062,
    ],
    [
        2.9,
        0.04386286759886709,
        -0.023109961030791448,
        1.788597793361219,
        -1.442705383103088,
    ],
    [
        4.4,
        0.05295638122018264,
        0.053081886993725264,
        -1.373015944693196,
        -2.923341926870107,
    ],
    [
        5.8,
        0.0487062537266137,
        -0.04851883375707105,
        1.0057121846352457,
        -4.331501551037063,
    ],
];

#[test]
fn knife_edge() {
    let run = Run::new("kinematics", "cam-knife-edge", &[]);
    for [turn, y, rate, second, phi] in KNIFE_EDGE {
        let i = run.at(turn / 10.0);
        close("lift", i.get("follower.y"), y, 2e-14);
        close("velocity", i.get("follower.vy"), rate, 1e-14);
        close("acceleration", i.get("follower.ay"), second, 1e-13);
        close("contact", i.get("contact.phi"), phi, 5e-14);
    }
}

/// The cam was made for a motion; the follower does that motion, and the contact takes the load.
fn made_to_measure(model: &str, mass: f64, lift: impl Fn(f64) -> [f64; 3]) {
    let speed = 10.0 * PI;
    let run = Run::new("inverse", model, &[]);
    let law = |t: f64| {
        let [y, by_angle, second] = lift(speed * t);
        [y, speed * by_angle, speed * speed * second]
    };
    run.follows("follower.y", 2e-14, |t| law(t)[0]);
    run.follows("follower.vy", 1e-13, |t| law(t)[1]);
    run.follows("follower.ay", 1e-11, |t| law(t)[2]);
    run.follows("contact.phi", 3e-13, |t| FRAC_PI_2 - speed * t);
    // Gravity and the spring press the follower down, the cam carries it.
    run.always("contact force", 2e-12, |i| {
        let spring = i.get("return spring.force");
        (
            i.get("contact.force_y"),
            mass * (law(i.time())[2] + G) - spring,
        )
    });
    run.always("motor", 2e-11, |i| {
        let [_, rate, _] = law(i.time());
        (
            speed * i.get("motor.moment"),
            i.get("contact.force_y") * rate,
        )
    });
    let (least, _) = run.range("contact.force_y");
    assert!(
        least > 0.0,
        "the spring keeps the follower on the cam: {least} N"
    );
}

#[test]
fn roller() {
    made_to_measure("cam-roller", 0.15, |turn| {
        let phi = FRAC_PI_2 - turn;
        [
            0.04 + 0.008 * (1.0 - phi.cos()),
            -0.008 * phi.sin(),
            0.008 * phi.cos(),
        ]
    });
}

#[test]
fn flat_face() {
    made_to_measure("cam-flat", 0.2, |turn| {
        let double = 2.0 * (FRAC_PI_2 - turn);
        [
            0.03 + 0.005 * (1.0 - double.cos()),
            -0.01 * double.sin(),
            0.02 * double.cos(),
        ]
    });
}

/// The page draws the cam by its profile: as far as the outline reaches up, so far up is the face.
#[cfg(feature = "viewer")]
#[test]
fn the_page_shows_the_profile() {
    let page = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("cam-flat.html");
    let answer = std::process::Command::new(env!("CARGO_BIN_EXE_dalembert"))
        .arg("view")
        .arg(example("cam-flat"))
        .arg("--html")
        .arg(&page)
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&answer.stderr);
    if said.contains("without the animated page") {
        eprintln!("skipped: {said}");
        return;
    }
    assert!(answer.status.success(), "{said}");
    let text = std::fs::read_to_string(&page).unwrap();
    let start = text.find("\"dalembert-animation/1\"").expect("the data");
    let data = &text[text[..start].rfind('{').unwrap()..];
    let data: serde_json::Value = serde_json::Deserializer::from_str(data)
        .into_iter()
        .next()
        .unwrap()
        .unwrap();
    let contact = data["joints"]
        .as_array()
        .unwrap()
        .iter()
        .find(|joint| joint["name"] == "contact")
        .unwrap();
    let outline = contact["first"]["outline"].as_array().unwrap();
    let top = outline
        .iter()
        .map(|point| point[1].as_f64().unwrap())
        .fold(0.0, f64::max);
    close("reach", top, 0.04, 1e-8);
}
