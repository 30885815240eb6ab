//! Degrees of freedom, redundant constraints and singular poses of known machines.
//!
//! The ground is no body of the model here: counts of the book that include it are less by 3.

use super::harness::{answer, answer_about, published, refused, scratch_file};
use serde_json::Value;
use std::fmt::Write;

/// Coordinates, rows of joints, their rank, degrees of freedom without drivers.
fn count(answer: &Value) -> [i64; 4] {
    let mobility = &answer["mobility"]["mobility"];
    let number = |v: &Value| v.as_i64().expect("a count");
    [
        number(&answer["mobility"]["coordinates"]),
        number(&mobility["rows"]),
        number(&mobility["rank"]),
        number(&mobility["freedoms"]),
    ]
}

/// Freedoms that the drivers leave.
fn left(answer: &Value) -> i64 {
    answer["mobility"]["driven"]["freedoms"]
        .as_i64()
        .expect("a count")
}

fn entries(answer: &Value, list: &str) -> usize {
    answer["mobility"][list].as_array().expect("a list").len()
}

/// Shabana, Example 3.1: slider crank, one degree of freedom.
#[test]
fn slider_crank() {
    let found = answer("check", "slider-crank.toml", "");
    assert_eq!(count(&found), [9, 8, 8, 1]);
    assert_eq!(left(&found), 0);
}

/// Shabana, Example 3.7: two rods in a chain, two degrees of freedom.
#[test]
fn two_rods() {
    let found = answer("check", "two-link-driven.toml", "");
    assert_eq!(count(&found), [6, 4, 4, 2]);
    assert_eq!(left(&found), 0);
}

/// Shabana, Section 1.3: Peaucellier's linkage has one degree of freedom.
#[test]
fn peaucellier() {
    let found = answer("check", "peaucellier.toml", "");
    assert_eq!(count(&found), [21, 20, 20, 1]);
}

/// Shabana, Sections 3.1 and 6.5: the count gives none, the rank one degree of freedom.
#[test]
fn double_parallelogram() {
    let found = answer("check", "double-parallelogram.toml", "");
    assert_eq!(count(&found), [12, 12, 11, 1]);
    assert_eq!(entries(&found, "redundant"), 1);
    assert_eq!(entries(&found, "singular"), 0);
}

/// Shabana, Section 6.12: a floating ring of six links, six degrees of freedom.
#[test]
fn closed_ring() {
    let found = answer("check", "hexagon.toml", "");
    assert_eq!(count(&found), [18, 12, 12, 6]);
}

/// Three planets in a fixed ring: one degree of freedom, two meshes more than needed.
#[test]
fn planetary_gear() {
    let found = answer("check", "planetary-gear.toml", "");
    assert_eq!(count(&found), [15, 16, 14, 1]);
    assert_eq!(entries(&found, "redundant"), 2);
}

/// Shabana, Section 3.3 (Figures 3.10 and 3.11): rod as long as the crank, the crank upright: two
/// motions are possible, the crank does not choose. The driven rank is 8 of 9.
#[test]
fn bifurcation_of_the_equal_slider_crank() {
    let options = "crank_length=0.3; rod_length=0.3; start=90 deg";
    let found = answer("check", "slider-crank.toml", options);
    assert_eq!(count(&found), [9, 8, 7, 2]);
    assert_eq!(left(&found), 1);
    assert_eq!(entries(&found, "singular"), 1);
    assert_eq!(entries(&found, "redundant"), 0);
    let said = refused("kinematics", "slider-crank.toml", options);
    assert!(said.contains("singular pose"), "{said}");
}

/// Shabana, Sections 3.3 (Figure 3.12) and 3.9: at the dead centre the slider does not drive the
/// crank, the crank drives the slider.
#[test]
fn dead_centre() {
    let options = "slider_start=0.5; amplitude=0; speed=-1";
    let found = answer("check", "slider-driven.toml", options);
    assert_eq!(count(&found), [9, 8, 8, 1]);
    assert_eq!(left(&found), 1);
    assert_eq!(entries(&found, "dead_drivers"), 1);
    let said = refused("kinematics", "slider-driven.toml", options);
    assert!(said.contains("singular pose"), "{said}");
    let options = "crank_length=0.15; rod_length=0.35; start=0";
    assert_eq!(left(&answer("check", "slider-crank.toml", options)), 0);
}

/// Shabana, Section 3.3: Grashof's law. The cranks of Examples 3.4 and 3.13 turn fully, that of
/// problem 3.6 does not.
#[test]
fn grashof() {
    let turn = "speed=5; --end 1.26; --step 0.01";
    let bars = [
        "base=0.4; coupler_length=0.4; rocker_length=0.5; coupler_start=40 deg; rocker_start=280 deg",
        "base=0.35; coupler_length=0.35; rocker_length=0.25",
    ];
    for lengths in bars {
        published(
            "kinematics",
            "four-bar.toml",
            &format!("{lengths}; {turn}"),
            |run| {
                run.near(1.26, "violation.position", 0.0, 1e-12);
                let crank = run.at(1.26, "crank.angle") - run.at(0.0, "crank.angle");
                run.same("turn of the crank", crank, 6.3, 1e-12);
            },
        );
    }
    let lengths = "base=0.32; crank_length=0.3; coupler_length=0.35; rocker_length=0.4";
    let said = refused("kinematics", "four-bar.toml", &format!("{lengths}; {turn}"));
    assert!(said.contains("crank") || said.contains("motor"), "{said}");
}

/// Shabana, Section 6.12: undercarriage of an excavator, 53 moving bodies. Ten wheels turn on the
/// chassis, 42 links make the track; a driver turns the sprocket. (The geometry is ours, the
/// counts are the book's: 55 and 54 degrees of freedom.)
#[test]
fn tracked_vehicle() {
    let mut text = String::from("[model]\nname = \"Tracked vehicle\"\ngravity = [0, -9.81]\n");
    let mut body = |name: &str, x: f64, y: f64, angle: f64| {
        write!(
            text,
            "\n[[body]]\nname = \"{name}\"\nmass = 1\ninertia = 1\nposition = [{x}, {y}]\nangle = {angle}\n"
        )
    };
    body("chassis", 0.0, 1.0, 0.0).expect("text");
    for k in 0..10 {
        body(&format!("wheel {k}"), 0.4 * f64::from(k) - 2.0, 0.5, 0.0).expect("text");
    }
    // A regular polygon of 42 sides, each 0.2 m long.
    let turn = std::f64::consts::TAU / 42.0;
    let inner = 0.1 / (turn / 2.0).tan();
    for k in 0..42 {
        let angle = f64::from(k) * turn;
        body(
            &format!("link {k}"),
            inner * angle.sin(),
            -inner * angle.cos(),
            angle,
        )
        .expect("text");
    }
    let mut pin = |first: &str, second: &str, at: [f64; 4]| {
        let [a, b, c, d] = at;
        write!(
            text,
            "\n[[joint]]\nname = \"{first} to {second}\"\nkind = \"revolute\"\nbodies = [\"{first}\", \"{second}\"]\nat = [[{a}, {b}], [{c}, {d}]]\n"
        )
    };
    for k in 0..10 {
        let at = [0.4 * f64::from(k) - 2.0, -0.5, 0.0, 0.0];
        pin("chassis", &format!("wheel {k}"), at).expect("text");
    }
    for k in 0..42 {
        let next = format!("link {}", (k + 1) % 42);
        pin(&format!("link {k}"), &next, [0.1, 0.0, -0.1, 0.0]).expect("text");
    }
    text.push_str(
        "\n[[driver]]\nname = \"sprocket\"\nkind = \"angle\"\njoint = \"chassis to wheel 0\"\nrate = 3\n",
    );
    let file = scratch_file("tracked-vehicle").with_extension("toml");
    std::fs::write(&file, text).expect("the model is written");
    let found = answer_about("check", &file, "");
    let _ = std::fs::remove_file(&file);
    assert_eq!(count(&found), [159, 104, 104, 55]);
    assert_eq!(left(&found), 54);
}
