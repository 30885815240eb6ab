//! What gears, racks, rolling and cams mean: no slip and no parting at the contact.

use super::*;
use dalembert::solve::null_basis_svd;
use nalgebra::{DVector, Vector2};

/// Velocity of the material point of a marker's body that is at a place.
fn material(m: &PlanarMarker, at: Vector2<f64>) -> Vector2<f64> {
    let d = at - m.point;
    m.velocity + m.omega * Vector2::new(-d.y, d.x)
}

/// Where two bodies touch, and the directions in which they must not move on each other.
type Contact = (Vector2<f64>, Vec<Vector2<f64>>);

/// At an assembled pose, for random velocities that the constraints allow: the two bodies of joint J have the same
/// velocity at the contact, in the directions that the joint holds.
fn check_contact(name: &str, model: Value, contact: impl Fn(&[PlanarMarker], &[f64]) -> Contact) {
    let (system, mut state) = assembled(model);
    let ws = evaluated(&system, &state);
    let scale = vec![1.0; system.nv()];
    let b = null_basis_svd(&system.dense_jacobian(&ws), &scale, 1e-9).unwrap();
    assert!(b.ncols() > 0, "{name} cannot move");
    let mut random = Random::new(SEED);
    let u = DVector::from_fn(b.ncols(), |_, _| random.uniform(0.5, 1.5));
    state.v = (b * u).as_slice().to_vec();
    let ws = evaluated(&system, &state);
    let e = system.element("J").unwrap();
    let markers: Vec<_> = e.markers.iter().map(|&m| ws.markers[m]).collect();
    let (at, directions) = contact(&markers, &ws.s[e.aux.clone()]);
    let slip = material(&markers[0], at) - material(&markers[1], at);
    assert!(markers[0].omega != markers[1].omega, "{name} does not turn");
    for d in directions {
        assert!(
            slip.dot(&d).abs() < 1e-12,
            "{name}: slip {slip:?} along {d:?}"
        );
    }
}

fn both() -> Vec<Vector2<f64>> {
    vec![Vector2::x(), Vector2::y()]
}

#[test]
fn gears_do_not_slip_at_the_pitch_point() {
    for (radii, internal) in [([0.3, 0.2], false), ([0.5, 0.2], true), ([0.2, 0.5], true)] {
        let [a, b]: [f64; 2] = radii;
        let distance = if internal { (a - b).abs() } else { a + b };
        let carrier = json!({"name": "c", "mass": 1.0, "inertia": 0.1, "position": [0.4, -0.2], "angle": 0.8});
        let (s, c) = 0.8_f64.sin_cos();
        let far = [0.4 + distance * c, -0.2 + distance * s];
        let model = json!({
            "body": [carrier, {"name": "a", "mass": 1.0, "inertia": 0.1, "position": [0.4, -0.2], "angle": 0.1},
                     {"name": "b", "mass": 1.0, "inertia": 0.1, "position": far, "angle": -0.5}],
            "joint": [support::pin("A", ["c", "a"], [[0.0, 0.0], [0.0, 0.0]]),
                      support::pin("B", ["c", "b"], [[distance, 0.0], [0.0, 0.0]]),
                      {"name": "J", "kind": "gear", "bodies": ["a", "b"], "carrier": "c", "radii": radii, "internal": internal}]
        });
        check_contact(&format!("gear {radii:?}"), model, |m, _| {
            let e = m[2].ex;
            let side = if internal && b > a { -1.0 } else { 1.0 };
            (m[0].point + side * a * e, both())
        });
    }
}

#[test]
fn racks_and_rolling_circles_do_not_slip() {
    for (side, sign) in [("left", 1.0), ("right", -1.0)] {
        // The rack and the pinion's axis are both held by the moving base.
        let model = json!({
            "body": [{"name": "base", "mass": 1.0, "inertia": 0.1, "position": [0.1, 0.2], "angle": 0.4},
                     {"name": "bar", "mass": 1.0, "inertia": 0.1, "position": [0.1, 0.2], "angle": 0.4},
                     {"name": "wheel", "mass": 1.0, "inertia": 0.1,
                      "position": [0.1 - sign * 0.3 * 0.4_f64.sin(), 0.2 + sign * 0.3 * 0.4_f64.cos()], "angle": 0.0}],
            "joint": [{"name": "guide", "kind": "prismatic", "bodies": ["base", "bar"], "at": [[0, 0], [0, 0]], "angles": [0, 0]},
                      support::pin("axis", ["base", "wheel"], [[0.0, sign * 0.3], [0.0, 0.0]]),
                      {"name": "J", "kind": "rack", "bodies": ["wheel", "bar"], "at": [[0, 0], [0, 0]], "angles": [0, 0],
                       "radius": 0.3, "side": side}]
        });
        // The markers are the rack's and the pinion's; across the rack it is the guide that holds.
        check_contact(&format!("rack {side}"), model, |m, _| {
            (m[1].point - sign * 0.3 * m[0].ey(), vec![m[0].ex])
        });
        let model = json!({
            "body": [{"name": "bar", "mass": 1.0, "inertia": 0.1, "position": [0.1, 0.2], "angle": 0.4},
                     {"name": "wheel", "mass": 1.0, "inertia": 0.1, "position": [0.3, 0.2 + 0.5 * sign], "angle": 0.0}],
            "joint": [{"name": "J", "kind": "rolling-on-line", "bodies": ["bar", "wheel"], "at": [[0, 0], [0, 0]],
                       "angles": [0.2, 0], "radius": 0.3, "side": side}]
        });
        check_contact(&format!("rolling on line {side}"), model, |m, _| {
            let eta = m[0].ey().dot(&(m[1].point - m[0].point));
            assert!((eta - sign * 0.3).abs() < 1e-12);
            (m[1].point - sign * 0.3 * m[0].ey(), both())
        });
    }
    for (radii, internal) in [([0.5, 0.2], false), ([0.5, 0.2], true), ([0.2, 0.5], true)] {
        let model = json!({
            "body": [{"name": "a", "mass": 1.0, "inertia": 0.1, "position": [0.1, 0.2], "angle": 0.4},
                     {"name": "b", "mass": 1.0, "inertia": 0.1, "position": [0.5, 0.1], "angle": 0.0}],
            "joint": [{"name": "J", "kind": "rolling-on-circle", "bodies": ["a", "b"], "at": [[0, 0], [0, 0]],
                       "radii": radii, "internal": internal}]
        });
        check_contact(
            &format!("rolling on circle {radii:?} {internal}"),
            model,
            |m, psi| {
                let e = Vector2::new(psi[0].cos(), psi[0].sin());
                let at = m[0].point + radii[0] * e;
                // The contact lies on both circles.
                assert!(((at - m[1].point).norm() - radii[1]).abs() < 1e-12);
                (at, both())
            },
        );
    }
}

#[test]
fn cams_and_followers_do_not_part() {
    let radius = |phi: f64| (0.3 + 0.05 * (2.0 * phi).cos(), -0.1 * (2.0 * phi).sin());
    for follower in ["knife-edge", "roller", "flat"] {
        let mut spec = json!({"kind": follower});
        if follower == "roller" {
            spec["radius"] = json!(0.1);
        }
        let model = json!({
            "body": [{"name": "cam", "mass": 1.0, "inertia": 0.1, "position": [0.1, 0.2], "angle": 0.4},
                     {"name": "follower", "mass": 1.0, "inertia": 0.1, "position": [0.15, 0.65], "angle": 0.1}],
            "joint": [{"name": "J", "kind": "cam", "bodies": ["cam", "follower"], "at": [[0, 0], [0, 0]], "angles": [0.3, 0.0],
                       "profile": {"radius": "0.3 m + 0.05 m * cos(2*phi)"}, "follower": spec}]
        });
        check_contact(follower, model, |m, phi| {
            let (r, slope) = radius(phi[0]);
            let (s, c) = phi[0].sin_cos();
            let turn = |x: f64, y: f64| x * m[0].ex + y * m[0].ey();
            let at = m[0].point + turn(r * c, r * s);
            let tangent = turn(slope * c - r * s, slope * s + r * c).normalize();
            let normal = Vector2::new(tangent.y, -tangent.x);
            let gap = m[1].point - at;
            match follower {
                "knife-edge" => assert!(gap.norm() < 1e-12),
                "roller" => {
                    assert!((gap.norm() - 0.1).abs() < 1e-12 && gap.dot(&tangent).abs() < 1e-12);
                    assert!(gap.dot(&normal) > 0.0, "the roller is inside the cam");
                }
                _ => assert!(
                    m[1].ey().dot(&gap).abs() < 1e-12 && m[1].ey().dot(&tangent).abs() < 1e-12
                ),
            }
            (at, vec![normal])
        });
    }
}
