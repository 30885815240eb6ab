//! Gears and racks between axes in any directions, wires, and bushings with six rows.

use super::power::G;
use super::run::{Run, close, said};
use super::space::{dot, minus, vector};
use std::f64::consts::TAU;

/// The wheel turns a twentieth of the worm, which sees its inertia with the square of that.
#[test]
fn worm_gear() {
    let run = Run::new("simulate", "worm-gear", &[]);
    let ratio = -2.0 / 40.0;
    let inertia = 0.05 + ratio * ratio * 0.4;
    let acceleration = (1.5 + ratio * 20.0) / inertia;
    run.follows("worm bearing.angle_acceleration", 1e-12, |_| acceleration);
    // To the tolerance of the run.
    run.follows("worm bearing.angle", 1e-10, |t| 0.5 * acceleration * t * t);
    run.always("ratio of the angles", 1e-13, |i| {
        let worm = i.get("worm bearing.angle");
        (i.get("wheel bearing.angle"), ratio * worm)
    });
    run.always("ratio of the rates", 1e-13, |i| {
        // About x and about y: the axes cross.
        (i.get("wheel.omega_y"), ratio * i.get("worm.omega_x"))
    });
    // The motor gives what the wheels gain and the load takes.
    run.always("energy", 1e-10, |i| {
        let (worm, wheel) = (i.get("worm.omega_x"), i.get("wheel.omega_y"));
        let kinetic = 0.5 * (0.05 * worm * worm + 0.4 * wheel * wheel);
        let work = 1.5 * i.get("worm bearing.angle") + 20.0 * i.get("wheel bearing.angle");
        (kinetic, work)
    });
    assert!(run.largest("energy.balance") < 1e-11);
    let held = Run::new("simulate", "worm-gear", &["--set", "load=30 N*m"]);
    held.follows("worm bearing.angle", 1e-13, |_| 0.0);
}

/// The rack moves with the pinion's angle; the tie rods keep their lengths; what the hands do goes into the tyres.
#[test]
fn steering_rack() {
    let run = Run::new("inverse", "steering-rack", &[]);
    let swing = 300.0 / 360.0 * TAU;
    run.follows("guide.displacement", 1e-15, |t| {
        -0.008 * swing * (0.25 * TAU * t).sin()
    });
    for (side, sign) in [("left", 1.0), ("right", -1.0)] {
        let length = ((0.15_f64 - 0.13).powi(2) + (0.625_f64 - 0.35).powi(2)).sqrt();
        run.always(side, 1e-13, |i| {
            let end = [-0.15, i.get("rack.y") + sign * 0.35, 0.2];
            let rod = minus(vector(i, &format!("{side} ball.")), end);
            (dot(rod, rod).sqrt(), length)
        });
    }
    // Half a period later everything is seen in a mirror.
    for i in run.instants().filter(|i| i.time() <= 2.0) {
        let later = run.at(i.time() + 2.0);
        let (left, right) = (
            i.get("left kingpin.angle"),
            later.get("right kingpin.angle"),
        );
        close("mirror", left, -right, 1e-12);
    }
    // To the left: both wheels, the inner one further.
    let turned = run.at(1.0);
    let [left, right] = ["left", "right"].map(|s| turned.get(&format!("{s} kingpin.angle")));
    assert!(left > right && right > 0.2, "{left} {right}");
    // What the hands do is in the tyres and the wheels: their power, summed by trapezia, which err by h^2/12 times the
    // change of its slope.
    let fine = Run::new("inverse", "steering-rack", &["--step", "1 ms"]);
    let first = fine.instant(0);
    let (mut work, mut last) = (0.0, first);
    for i in fine.instants().skip(1) {
        let h = i.time() - last.time();
        work += 0.5 * h * (i.get("hands.power") + last.get("hands.power"));
        last = i;
        let stored = i.get("energy.total") - first.get("energy.total");
        close("work", stored, work, 5e-6);
    }
    assert!(fine.largest("hands.power") > 5.0);
}

/// On the wire the speed follows from the height; the wire pushes across itself and runs through its points.
#[test]
fn bead_on_wire() {
    let run = Run::new("simulate", "bead-on-wire", &[]);
    // The given speed is that along y.
    let start = |run: &Run| {
        let v = vector(run.instant(0), "bead.v");
        close("along y", v[1], 0.6, 1e-14);
        dot(v, v)
    };
    let first = start(&run);
    assert!(first > 0.36 && first < 0.37, "{first}");
    run.always("speed", 2e-9, |i| {
        let v = vector(i, "bead.v");
        (dot(v, v), first + 2.0 * G * (1.2 - i.get("bead.z")))
    });
    run.always("power of the wire", 1e-13, |i| {
        (dot(vector(i, "wire.force_"), vector(i, "bead.v")), 0.0)
    });
    run.always("force", 1e-13, |i| {
        let force = vector(i, "wire.force_");
        let [x, y, z] = vector(i, "bead.a").map(|a| 0.05 * a);
        let rest = minus(force, [x, y, z + 0.05 * G]);
        (dot(rest, rest).sqrt(), 0.0)
    });
    assert!(run.largest("energy.balance") < 1e-10);
    // The points of the tables, where u is a whole number: by a cubic through four instants.
    let points = [
        [0.7, 0.8, 0.7],
        [0.0, 1.0, 0.3],
        [-0.7, 0.7, 0.6],
        [-1.0, 0.0, 0.9],
        [-0.6, -0.7, 0.4],
        [0.1, -0.9, 0.1],
        [0.7, -0.7, 0.6],
        [1.0, 0.0, 1.2],
    ];
    let all: Vec<_> = run.instants().collect();
    for (k, point) in points.iter().enumerate() {
        let u = (k + 1) as f64;
        let next = all.iter().position(|i| i.get("wire.u") > u);
        let next = next.expect("it comes round");
        let four = &all[next - 2..next + 2];
        let at = four.iter().map(|i| i.get("wire.u")).collect::<Vec<f64>>();
        for (axis, expected) in ["x", "y", "z"].iter().zip(point) {
            let found: f64 = (0..4)
                .map(|m| {
                    let others = (0..4).filter(|n| *n != m);
                    let weight: f64 = others.map(|n| (u - at[n]) / (at[m] - at[n])).product();
                    weight * four[m].get(&format!("bead.{axis}"))
                })
                .sum();
            close(&format!("point {u}, {axis}"), found, *expected, 2e-5);
        }
    }
    // Half a metre lower the second hill, of 0.9 m, is too high.
    let low = Run::new("simulate", "bead-on-wire", &["--set", "top=0.8 m"]);
    let (_, furthest) = low.range("wire.u");
    assert!(furthest > 3.0 && furthest < 4.0, "{furthest}");
    let highest = 0.8 + start(&low) / (2.0 * G);
    assert!(low.range("bead.z").1 <= highest + 1e-9);
}

/// A cantilever: sag F L^3/(3 E I), slope F L^2/(2 E I), twist F offset L/(G J).
#[test]
fn springy_beam() {
    let (length, offset) = (0.5_f64, 0.04);
    let (ei, gj) = (
        210e9 * 0.02 * 0.004_f64.powi(3) / 12.0,
        81e9 * 0.02 * 0.004_f64.powi(3) / 3.0,
    );
    let small = Run::new("statics", "springy-beam", &["--set", "load=1 g"]);
    let i = small.instant(0);
    let force = 0.001 * G;
    let sag = force * length.powi(3) / (3.0 * ei);
    let slope = force * length.powi(2) / (2.0 * ei);
    let twist = force * offset * length / gj;
    // Turns of this size add up.
    close("sag", i.get("weight.z"), -sag, 1e-7 * sag);
    close("slope", 2.0 * i.get("weight.b2"), slope, 1e-7 * slope);
    close("twist", 2.0 * i.get("weight.b1"), -twist, 1e-4 * twist);
    close(
        "below",
        i.get("centre.z"),
        -sag - offset * twist,
        1e-6 * sag,
    );
    close("carried", i.get("beam.force_z"), force, 1e-12 * force);
    // The whole weight, to the square of the slope.
    let whole = Run::new("statics", "springy-beam", &[]);
    let sag = 1.2 * G * length.powi(3) / (3.0 * ei);
    close("sag", whole.instant(0).get("weight.z"), -sag, 5e-3 * sag);
    // Let go, it swings about that place, twice as far, and keeps its energy.
    let swing = Run::new("simulate", "springy-beam", &[]);
    let (low, high) = swing.range("weight.z");
    close("lowest", low, -2.0 * sag, 0.02 * sag);
    assert!(high < 1e-3 * sag, "{high}");
    assert!(swing.largest("energy.balance") < 1e-10);
    swing.follows("energy.total", 1e-10, |_| 0.0);
}

/// The poses that `statics` prints in space are positions and Euler parameters, under names of their own.
#[test]
fn printed_poses_in_space() {
    let text = said("statics", "springy-beam", &[]);
    let line = text.lines().find(|l| l.contains("centre of mass:"));
    let line = line.unwrap_or_else(|| panic!("{text}"));
    let values: Vec<(&str, f64)> = line
        .split_once(": ")
        .unwrap()
        .1
        .split(", ")
        .map(|part| {
            let (name, value) = part.rsplit_once(' ').unwrap();
            (name, value.parse().unwrap())
        })
        .collect();
    let names: Vec<&str> = values.iter().map(|v| v.0).collect();
    let expected = ["x", "y", "z", "b0", "b1", "b2", "b3"].map(|n| format!("weight.{n}"));
    assert_eq!(names, expected);
    let norm: f64 = values[3..].iter().map(|v| v.1 * v.1).sum();
    close("norm", norm, 1.0, 1e-5);
}
