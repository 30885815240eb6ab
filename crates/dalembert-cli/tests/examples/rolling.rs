//! Machines that roll and touch.

use super::power::G;
use super::run::{Run, close};
use super::space::axes;

/// The lean stays, and the centre goes round once.
#[test]
fn rolling_disc() {
    let run = Run::new("simulate", "rolling-disc", &[]);
    let (r, lean, w) = (0.3, 20.0_f64.to_radians(), 2.0);
    let (s, c) = lean.sin_cos();
    let spin = (4.0 * G * s + 5.0 * r * w * w * s * c) / (6.0 * r * w * c);
    // The centre moves with r (w sin(lean) - spin), and turns with w.
    let radius = r * (spin - w * s) / w;
    run.follows("disc.z", 1e-10, |_| r * c);
    run.follows("disc.x", 1e-9, |t| radius * (1.0 - (w * t).cos()));
    run.follows("disc.y", 1e-9, |t| -radius * (w * t).sin());
    assert!(run.largest("energy.balance") < 1e-9);
}

/// No slip: the material point at the contact stands still; the energy stays.
#[test]
fn rolling_coin() {
    let run = Run::new("simulate", "rolling-coin", &[]);
    let r = 0.012;
    for i in run.instants() {
        let [_, _, axle] = axes(i, "coin");
        let tilt = axle[2];
        // From the centre down in the plane of the coin.
        let long = (1.0 - tilt * tilt).sqrt();
        let down = [0, 1, 2].map(|k| {
            let vertical = if k == 2 { 1.0 } else { 0.0 };
            -r * (vertical - tilt * axle[k]) / long
        });
        let [wx, wy, wz] = ["x", "y", "z"].map(|c| i.get(&format!("coin.omega_{c}")));
        let turn = [
            wy * down[2] - wz * down[1],
            wz * down[0] - wx * down[2],
            wx * down[1] - wy * down[0],
        ];
        for (c, turn) in ["x", "y", "z"].iter().zip(turn) {
            close("slip", i.get(&format!("coin.v{c}")) + turn, 0.0, 1e-12);
        }
        close("height", i.get("coin.z"), r * long, 1e-12);
    }
    assert!(run.largest("energy.balance") < 1e-12);
    assert!(run.range("coin.z").0 < 0.0115, "it leans over");
}

/// The centre is a spherical pendulum; the bowl pushes with N = m (g cos + v^2 / l).
#[test]
fn ball_in_bowl() {
    let run = Run::new("simulate", "ball-in-bowl", &[]);
    let (l, m) = (0.5 - 0.06, 1.0);
    for i in run.instants() {
        let [x, y, z] = ["x", "y", "z"].map(|c| i.get(&format!("ball.{c}")));
        close("length", (x * x + y * y + z * z).sqrt(), l, 1e-12);
        let speed2: f64 = ["x", "y", "z"]
            .map(|c| i.get(&format!("ball.v{c}")).powi(2))
            .iter()
            .sum();
        let force = m * (-G * z / l + speed2 / l);
        close("normal force", i.get("bowl.normal_force"), force, 1e-9);
        // On the line through both centres, on the bowl.
        close("contact", i.get("bowl.point_z"), z * 0.5 / l, 1e-12);
    }
    let first = run.instant(0).get("momentum.angular_z");
    run.follows("momentum.angular_z", 1e-9, |_| first);
    assert!(run.largest("energy.balance") < 1e-8);
}

/// The centre stands at the height of the support function; nothing moves it sideways.
#[test]
fn ellipsoid_on_plane() {
    let run = Run::new("simulate", "ellipsoid-on-plane", &[]);
    let half = [0.3, 0.2, 0.15];
    for i in run.instants() {
        let up = axes(i, "pebble").map(|axis| axis[2]);
        let height: f64 = (0..3).map(|k| (half[k] * up[k]).powi(2)).sum();
        close("height", i.get("pebble.z"), height.sqrt(), 1e-12);
        assert!(i.get("floor.normal_force") > 0.0, "it only pushes");
    }
    for c in ["x", "y"] {
        run.follows(&format!("pebble.{c}"), 1e-12, |_| 0.0);
    }
    assert!(run.largest("energy.balance") < 1e-9);
}
