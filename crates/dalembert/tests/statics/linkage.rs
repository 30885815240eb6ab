//! Linkages: the virtual work of one freedom, solved by itself, is the referee.

use crate::common::{G, close, pin, rod, run_both, slide, system, value};
use dalembert::analysis::Stability;
use serde_json::json;

const CRANK: f64 = 0.2;
const ROD: f64 = 0.4;

/// Rod angle and slider position of the slider crank.
fn slider_crank(angle: f64) -> (f64, f64) {
    let rod = (-CRANK * angle.sin() / ROD).asin();
    (rod, CRANK * angle.cos() + ROD * rod.cos())
}

/// Potential energy of the spring-held slider crank (Shabana 6.14, our own data).
fn energy(angle: f64, spring: f64) -> f64 {
    let (rod, x) = slider_crank(angle);
    let y_crank = 0.5 * CRANK * angle.sin();
    let y_rod = CRANK * angle.sin() + 0.5 * ROD * rod.sin();
    0.5 * G * y_crank + 0.8 * G * y_rod + 0.5 * spring * (x - 0.45).powi(2)
}

/// Zero of dV/dangle between two angles, by bisection on a fourth-order difference.
fn referee(mut low: f64, mut high: f64, spring: f64) -> f64 {
    let slope = |a: f64| {
        let h = 1e-3;
        let d = |h: f64| (energy(a + h, spring) - energy(a - h, spring)) / (2.0 * h);
        (4.0 * d(h / 2.0) - d(h)) / 3.0
    };
    assert!(slope(low) * slope(high) < 0.0);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if slope(low) * slope(middle) <= 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    0.5 * (low + high)
}

#[test]
fn a_slider_crank_rests_against_its_spring() {
    let spring = 300.0;
    let start: f64 = 0.9;
    let (phi, x) = slider_crank(start);
    let s = system(json!({
        "model": {"name": "slider crank", "gravity": [0.0, -G]},
        "body": [rod("crank", 0.5, CRANK, [0.0, 0.0], start),
                 rod("rod", 0.8, ROD, [CRANK * start.cos(), CRANK * start.sin()], phi),
                 {"name": "slider", "mass": 1.0, "inertia": 0.1, "position": [x, 0.0]}],
        "joint": [pin("O", ["ground", "crank"], [[0.0, 0.0], [-CRANK / 2.0, 0.0]]),
                  pin("A", ["crank", "rod"], [[CRANK / 2.0, 0.0], [-ROD / 2.0, 0.0]]),
                  pin("B", ["rod", "slider"], [[ROD / 2.0, 0.0], [0.0, 0.0]]),
                  slide("guide", "slider", [0.0, 0.0], 0.0)],
        "force": [{"name": "spring", "kind": "joint-spring", "joint": "guide", "stiffness": spring, "free": 0.45}]
    }));
    let report = run_both(&s);
    assert_eq!(report.freedoms, 1);
    let found = value(&report, "crank.angle");
    let expected = referee(found - 0.2, found + 0.2, spring);
    // The referee's difference is good to some 1e-11.
    close(found, expected, 1e-9);
    let h = 1e-3;
    let curvature = (energy(found + h, spring) - 2.0 * energy(found, spring)
        + energy(found - h, spring))
        / (h * h);
    assert!(curvature > 0.0);
    assert_eq!(report.equilibria[0].stability, Stability::Stable);
    // Every other one is a zero of the slope as well, with the stability of its curvature.
    assert!(report.equilibria.len() >= 2);
    for e in &report.equilibria {
        let a = e.q[2];
        // Poses of the other assembly branch (slider on the left) have another energy.
        if e.q[6] < 0.0 {
            continue;
        }
        let slope = (energy(a + 1e-5, spring) - energy(a - 1e-5, spring)) / 2e-5;
        close(slope, 0.0, 1e-7);
        let curvature = energy(a + h, spring) - 2.0 * energy(a, spring) + energy(a - h, spring);
        assert_eq!(e.stability == Stability::Stable, curvature > 0.0, "{a}");
    }
}

/// A two-link arm with a moment on each link: m g l cos(angle) balances each moment by itself, up to
/// a limit beyond which there is none (Shabana, problem 5.19).
#[test]
fn a_two_link_arm_balances_moments_up_to_a_limit() {
    let (m2, m3) = (2.0, 1.5);
    let arm = |moments: [f64; 2]| {
        system(json!({
            "model": {"name": "arm", "gravity": [0.0, -G]},
            "body": [rod("two", m2, 1.0, [0.0, 0.0], 0.2), rod("three", m3, 0.8, [0.98, 0.199], 0.5)],
            "joint": [pin("O", ["ground", "two"], [[0.0, 0.0], [-0.5, 0.0]]),
                      pin("A", ["two", "three"], [[0.5, 0.0], [-0.4, 0.0]])],
            "force": [{"name": "M2", "kind": "moment", "body": "two", "value": moments[0]},
                      {"name": "M3", "kind": "moment", "body": "three", "value": moments[1]}]
        }))
    };
    let most = [(0.5 * m2 + m3) * G, 0.4 * m3 * G];
    let report = run_both(&arm([10.0, -3.0]));
    assert_eq!(report.equilibria.len(), 4);
    let e = &report.equilibria[0];
    assert_eq!(e.stability, Stability::Stable);
    close(most[0] * e.q[2].cos(), 10.0, 1e-10);
    close(most[1] * e.q[5].cos(), -3.0, 1e-10);
    for k in 0..2 {
        let mut moments = [10.0, -3.0];
        moments[k] = 1.02 * most[k];
        let error = dalembert::analysis::Statics {
            starts: Some(2),
            ..Default::default()
        }
        .run(&arm(moments))
        .expect_err("too strong");
        assert!(error.to_string().contains("round and round"), "{error}");
    }
}

/// An eccentric disc under a flat follower: M = W e cos(angle); the surface parameter of the cam is
/// an unknown of its own.
#[test]
fn a_cam_balances_the_weight_of_its_follower() {
    let (eccentricity, weight, moment) = (0.02_f64, 3.0 * G, 0.25);
    let start = -0.3_f64;
    let s = system(json!({
        "model": {"name": "cam", "gravity": [0.0, -G]},
        "body": [{"name": "disc", "mass": 1.0, "inertia": 0.01, "angle": start},
                 {"name": "follower", "mass": 3.0, "inertia": 0.01, "position": [0.0, 0.05]}],
        "joint": [pin("O", ["ground", "disc"], [[0.0, 0.0], [0.0, 0.0]]),
                  slide("guide", "follower", [0.0, 0.0], std::f64::consts::FRAC_PI_2),
                  {"name": "contact", "kind": "cam", "bodies": ["disc", "follower"],
                   "at": [[0.0, 0.0], [0.0, 0.0]], "angles": [0.0, 0.0],
                   "profile": {"radius": "0.02 m * cos(phi) + sqrt(0.0025 m^2 - 0.0004 m^2 * sin(phi)^2)"},
                   "follower": {"kind": "flat"}}],
        "force": [{"name": "M", "kind": "moment", "body": "disc", "value": moment}]
    }));
    let report = run_both(&s);
    assert_eq!(report.freedoms, 1);
    assert_eq!(report.equilibria[0].stability, Stability::Stable);
    let angle = -(moment / (weight * eccentricity)).acos();
    close(value(&report, "disc.angle"), angle, 1e-10);
    close(
        value(&report, "follower.y"),
        0.05 + eccentricity * angle.sin(),
        1e-12,
    );
}
