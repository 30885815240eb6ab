//! Machines of our own.
//!
//! Combinations that the published cases do not have, against closed forms, and against minimal equations
//! that were integrated elsewhere by a method of order 8 with a tolerance of 1e-13.

use super::harness::{answer, published};
use std::f64::consts::{FRAC_PI_2, PI};

const INCH: f64 = 0.0254;
const POUND: f64 = 0.45359237;
const POUND_FORCE: f64 = 4.448_221_615_260_5;
const RPM: f64 = PI / 30.0;

/// The four-bar linkage of Shabana's Example 5.5 with masses, set free: equation of motion of the crank alone.
#[test]
fn four_bar_with_a_spring() {
    published("simulate", "four-bar-with-spring.toml", "", |run| {
        run.near(0.0, "crank.alpha", -29.62916376001166, 1e-10);
        let rows = [
            (0.1, 2.1979250829657357, 10.68304455181466),
            (0.3, 5.628613975903752, 9.767144467407332),
            (0.5, 7.542841760000117, 7.920405820613175),
        ];
        for (t, angle, rate) in rows {
            run.near(t, "crank.angle", angle, 1e-10);
            run.near(t, "crank.omega", rate, 1e-9);
        }
        run.near(0.3, "spring.length", 0.3079461521837713, 1e-11);
        run.near(0.3, "spring.force", -6.037172671835458, 1e-8);
        // The damper's work is in the balance.
        run.near(0.5, "energy.balance", 0.0, 1e-11);
    });
}

/// Differential of sun, carrier and ring: speeds by Willis, moments by virtual work, at both choices of motors.
#[test]
fn differential_train() {
    let (t, inertia) = (0.3, POUND * INCH * INCH);
    let (sun, carrier) = (900.0 * RPM + 10.0 * t, -120.0 * RPM + 40.0 * t);
    // Rates of ring and planet by those of sun and carrier; accelerations have the same ratios.
    let ring = |s: f64, c: f64| c - (s - c) * 32.0 / 64.0;
    let planet = |s: f64, c: f64| c - (s - c) * 32.0 / 16.0;
    let (ring_second, planet_second) = (ring(10.0, 40.0), planet(10.0, 40.0));
    let load = -200.0 * POUND_FORCE * INCH;
    let (arm, mass) = (3.0 * INCH, 1.5 * POUND);
    let outer = 150.0 * inertia * ring_second - load;
    let spin = 2.0 * inertia * planet_second;
    let at_sun = 3.0 * inertia * 10.0 + spin * planet(1.0, 0.0) + outer * ring(1.0, 0.0);
    let at_carrier = (20.0 * inertia + mass * arm * arm) * 40.0
        + spin * planet(0.0, 1.0)
        + outer * ring(0.0, 1.0);
    published("inverse", "differential-train.toml", "", |run| {
        run.near(t, "ring.omega", ring(sun, carrier), 1e-11);
        run.near(t, "planet.omega", planet(sun, carrier), 1e-11);
        run.near(t, "ring.alpha", ring_second, 1e-10);
        run.near(t, "sun motor.moment", at_sun, 1e-11);
        run.near(t, "carrier motor.moment", at_carrier, 1e-11);
        run.near(t, "outer mesh.moment", outer, 1e-11);
        let (sin, cos) = (35_f64.to_radians() - 120.0 * RPM * t + 20.0 * t * t).sin_cos();
        let pull = mass * arm * carrier * carrier;
        let push = mass * arm * 40.0;
        run.near(t, "planet axle.force_x", -pull * cos - push * sin, 1e-11);
        run.near(t, "planet axle.force_y", -pull * sin + push * cos, 1e-11);
    });
    let motors = "--actuator ring axle; --actuator carrier axle";
    published("inverse", "differential-train.toml", motors, |run| {
        let at_ring = at_sun / ring(1.0, 0.0);
        run.near(t, "actuator ring axle.moment", at_ring, 1e-11);
        let rest = at_carrier - at_ring * ring(0.0, 1.0);
        run.near(t, "actuator carrier axle.moment", rest, 1e-11);
    });
}

/// A disk rolls in a ring whose motion is given, with a spring: motion, contact force, moment of the motor.
#[test]
fn disk_in_a_driven_ring() {
    published("simulate", "disk-in-driven-ring.toml", "", |run| {
        let rows = [
            (
                0.0,
                -1.775,
                2.6102885682970025,
                -1.0471975511965976,
                0.0,
                [-8.54263519003443, 10.534560107391066, 18.72148457831769],
            ),
            (
                0.5,
                -1.5554893963280203,
                2.929926301487847,
                -0.1563556248666723,
                3.8832496072513836,
                [-8.3914088829005, 3.2860470894478784, -14.859318018575395],
            ),
            (
                1.0,
                -1.799333357458266,
                2.5972185473845304,
                -1.1085879187550884,
                -5.038214957465934,
                [-11.046448025523153, 8.589066950428428, 2.0388901699940427],
            ),
        ];
        for (t, x, y, psi, rate, [fx, fy, moment]) in rows {
            run.all(t, "disk", &[("x", x), ("y", y), ("omega", rate)], 1e-10);
            run.near(t, "contact.psi", psi, 1e-10);
            run.all(t, "contact", &[("force_x", fx), ("force_y", fy)], 1e-8);
            run.near(t, "motor.moment", moment, 1e-8);
        }
        run.near(1.0, "energy.balance", 0.0, 1e-10);
    });
}

/// A cam given by nine points (periodic quintic spline) under a roller; the forces follow from the lift by virtual work
/// and from the direction of the normal.
#[test]
fn cam_by_points() {
    published("kinematics", "cam-by-points.toml", "", |run| {
        // Time, height, surface parameter, slope of the normal against the guide.
        let rows = [
            [
                0.0,
                0.05571882912814788,
                1.4542711191334325,
                0.2438134353365609,
            ],
            [
                0.04,
                0.06181552224583814,
                2.7101773338489785,
                0.17860651693406554,
            ],
            [
                0.1,
                0.05626802551860337,
                4.544905997609435,
                0.04286328430991304,
            ],
            [
                0.16,
                0.051408232586522155,
                6.44564093866996,
                0.16476984973053949,
            ],
        ];
        for [t, y, phi, slope] in rows {
            run.near(t, "follower.y", y, 1e-13);
            run.near(t, "contact.phi", phi, 1e-10);
            let push = 0.4 * run.at(t, "follower.ay") + 3000.0 * (y - 0.03);
            run.near(t, "contact.force_y", push, 1e-9);
            run.near(t, "contact.force_x", push * slope, 1e-9);
            run.near(t, "guide.force_x", -push * slope, 1e-9);
            let work = push * run.at(t, "follower.vy");
            run.near(t, "motor.moment", work / (-300.0 * RPM), 1e-10);
        }
    });
}

/// Equilibrium of a bracket in a bushing with coupled stiffness between leaning frames, under a following load.
#[test]
fn coupled_bushing() {
    published("statics", "coupled-bushing.toml", "", |run| {
        run.first("bracket.x", 0.9781411619777126, 1e-12);
        run.first("bracket.y", 1.9940498736389993, 1e-12);
        run.first("bracket.angle", 0.08860057679741631, 1e-12);
        run.first("rubber.force_x", 39.84780782953156, 1e-9);
        run.first("rubber.force_y", 74.1745354684067, 1e-9);
        run.first("rubber.moment", 15.054458464832502, 1e-9);
    });
    published(
        "simulate",
        "coupled-bushing.toml",
        "--end 30; --step 30",
        |run| {
            run.near(30.0, "bracket.angle", 0.08860057679741631, 1e-8);
        },
    );
}

/// A bead on a parabola that turns and changes its width: a user's constraint that depends on time, with its force.
#[test]
fn bead_on_a_moving_wire() {
    published("simulate", "bead-on-moving-wire.toml", "", |run| {
        let rows = [
            [
                0.0,
                0.4,
                0.16,
                0.3,
                0.6,
                -2.7325853658536583,
                3.4157317073170734,
                1.8035063414634147,
            ],
            [
                0.5,
                -0.08694570399658659,
                -0.01274508787967859,
                -2.2810807091375094,
                -0.14233465976342374,
                -0.41848936818957205,
                9.651954142959488,
                -0.8445296316766705,
            ],
            [
                1.0,
                -0.8204284113011971,
                0.0891798906038393,
                -0.5529790555649146,
                -0.342143426704995,
                1.7701182509064342,
                3.6825144868201436,
                -3.179098461987189,
            ],
        ];
        for [t, x, y, vx, vy, fx, fy, moment] in rows {
            run.all(t, "hole", &[("x", x), ("y", y)], 1e-11);
            run.all(t, "hole", &[("vx", vx), ("vy", vy)], 1e-10);
            // The wire pushes at the centre of mass of the bead; the frame's motor takes the moment.
            run.all(t, "wire", &[("force_x", fx), ("force_y", fy)], 1e-9);
            run.near(t, "motor.moment", moment, 1e-9);
        }
    });
}

/// A sleeve is driven along an arm that swings freely: both bodies of the slide move, both frames lie off the centres.
#[test]
fn sleeve_on_a_free_arm() {
    published("simulate", "sleeve-on-free-arm.toml", "", |run| {
        let rows = [
            [
                0.0,
                -0.8726646259971648,
                FRAC_PI_2,
                -4.3732849283871875,
                6.8228243808122,
                -1.1527990886897392,
                -6.249695003644259,
                21.13583633780339,
            ],
            [
                0.5,
                -1.6118231046290252,
                -3.19279238824325,
                -24.829946659190604,
                -1.716488756299964,
                -0.6900549630434402,
                -10.775236942003225,
                49.006025806075314,
            ],
            [
                1.0,
                -2.6534474461188,
                -0.2822613565850461,
                -13.633928352841423,
                -0.3563638313743427,
                -0.2525792947938286,
                13.287686481256394,
                25.842812339113912,
            ],
        ];
        for [t, angle, rate, feed, across, moment, fx, fy] in rows {
            run.all(t, "arm", &[("angle", angle), ("omega", rate)], 1e-10);
            run.near(t, "sleeve.angle", angle + 65_f64.to_radians(), 1e-10);
            run.near(t, "feed.force", feed, 1e-9);
            run.all(t, "rail", &[("force_2", across), ("moment", moment)], 1e-9);
            run.all(t, "pin", &[("force_x", fx), ("force_y", fy)], 1e-9);
        }
    });
}

/// A preloaded toggle in inches and pounds: three equilibria, roots of one equation; the middle one is unstable.
#[test]
fn preloaded_toggle() {
    let inches = |y: f64| y * INCH;
    published("statics", "preloaded-toggle.toml", "", |run| {
        let [upper, middle, lower] = [25.88699752800349, 21.329939975843338, 13.84574161209154];
        let mut found = run.channel("node.y").to_vec();
        found.sort_by(|a, b| b.total_cmp(a));
        assert_eq!(found.len(), 3, "{found:?}");
        for (found, expected) in found.into_iter().zip([upper, middle, lower]) {
            run.same("node.y", found, inches(expected), 1e-12);
        }
        // The nearest to the estimate comes first.
        run.first("node.y", inches(upper), 1e-12);
        run.first(
            "left.length",
            inches((20.0_f64.powi(2) + (upper - 20.0).powi(2)).sqrt()),
            1e-12,
        );
    });
    let report = answer("statics", "preloaded-toggle.toml", "");
    let equilibria = report["equilibria"].as_array().expect("a list");
    let stability: Vec<_> = equilibria.iter().map(|e| e["stability"].as_str()).collect();
    // Stable ones first.
    assert_eq!(
        stability,
        [Some("stable"), Some("stable"), Some("unstable")]
    );
    // A load that the springs cannot carry from below leaves the lower pose alone.
    let report = answer("statics", "preloaded-toggle.toml", "load=-400 lbf");
    assert_eq!(report["equilibria"].as_array().map(Vec::len), Some(1));
}

/// Scotch yoke, every number in inches and pounds: slot force, motor, and the moment in the guide.
#[test]
fn scotch_yoke() {
    published("inverse", "scotch-yoke.toml", "", |run| {
        let (r, w, g) = (4.0 * INCH, 240.0 * RPM, 386.0885826771654 * INCH);
        for t in [0.0, 0.05, 0.1, 0.225] {
            let (sin, cos) = (15_f64.to_radians() + w * t).sin_cos();
            let (x, rate, second) = (r * cos, -r * w * sin, -r * w * w * cos);
            run.near(t, "guide.displacement", x, 1e-13);
            run.near(t, "yoke.vx", rate, 1e-12);
            let spring = 15.0 * POUND_FORCE / INCH * (x + INCH) + 0.4 * POUND_FORCE / INCH * rate;
            let rubbing = 3.0 * POUND_FORCE * rate / rate.hypot(0.1 * INCH);
            let push = 8.0 * POUND * second + spring + rubbing;
            // The slot is the yoke's, the reaction that on the crank's pin.
            run.near(t, "slot.force_x", -push, 1e-10);
            let (arm_x, arm_y) = (1.5 * cos - 0.2 * sin, 1.5 * sin + 0.2 * cos);
            let moment = push * rate / w + 5.0 * POUND * g * arm_x * INCH;
            run.near(t, "motor.moment", moment, 1e-10);
            let centripetal = w * w * arm_y * INCH;
            run.near(t, "axle.force_y", 5.0 * POUND * (g - centripetal), 1e-10);
            run.near(t, "guide.force_y", 8.0 * POUND * g, 1e-10);
            let tilt = 8.0 * POUND * g * 3.0 * INCH + r * sin * push;
            run.near(t, "guide.moment", tilt, 1e-10);
        }
    });
}

/// Two free bodies, a pin in a slot, a spring: momentum is kept. The angle of the second body is not given, and no turn
/// alone brings its pin into the slot: the assembly must move it too.
#[test]
fn floating_slot() {
    published("simulate", "floating-slot.toml", "", |run| {
        let begin = ["momentum.x", "momentum.y", "momentum.angular"].map(|m| run.at(0.0, m));
        for t in run.channel("time").to_vec() {
            // The pin lies on the slot's line, which stands 30 degrees off the plate through (0.1, 0.05) m.
            let (sin, cos) = run.at(t, "plate.angle").sin_cos();
            let x = run.at(t, "bob.x") - run.at(t, "plate.x") - (0.1 * cos - 0.05 * sin);
            let y = run.at(t, "bob.y") - run.at(t, "plate.y") - (0.1 * sin + 0.05 * cos);
            let (sin, cos) = (run.at(t, "plate.angle") + PI / 6.0).sin_cos();
            run.same("across the slot", y * cos - x * sin, 0.0, 1e-13);
            run.near(t, "slot.force_1", 0.0, 1e-11);
            run.near(t, "energy.balance", 0.0, 1e-11);
            for (name, value) in ["momentum.x", "momentum.y", "momentum.angular"]
                .into_iter()
                .zip(begin)
            {
                run.near(t, name, value, 1e-11);
            }
        }
    });
}
