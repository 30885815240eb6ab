//! Bodies and machines in space of A. A. Shabana, Computational Dynamics (2nd ed., 2001), Chapters 7 and 8
//!
//! Where the book is symbolic the data are our own, and the numbers were found by its formulas and confirmed by Lagrange's
//! equations or by the Newton-Euler equations.

use super::harness::{Run, answer, published};
use std::f64::consts::TAU;

/// Generalized forces of the ZXZ Euler angles of a moment: its parts about z, the line of nodes and the body's z.
fn about_angles(moment: [f64; 3], [phi, theta]: [f64; 2]) -> [f64; 3] {
    let [x, y, z] = moment;
    let node = x * phi.cos() + y * phi.sin();
    let across = x * phi.sin() - y * phi.cos();
    [z, node, across * theta.sin() + z * theta.cos()]
}

/// Example 7.7, problems 7.21 to 7.23: generalized forces in Euler angles of forces and moments in ground and body axes.
/// Mass and moments of inertia of one make accelerations of them.
#[test]
fn generalized_forces() {
    let forces = |options: &str, angles: [f64; 2], force: [f64; 3], about: [f64; 3]| {
        published("simulate", "pushed-body.toml", options, |run| {
            run.near_vector(0.0, "body.a", force, 1e-13);
            let found = about_angles(run.vector(0.0, "body.alpha_"), angles);
            for (k, (found, value)) in found.into_iter().zip(about).enumerate() {
                run.same(&format!("{options}: angle {k}"), found, value, 1e-13);
            }
        });
    };
    let pose = "phi=45 deg; theta=90 deg; Fx=5; Fz=-3; u1=0.2; u3=-0.15";
    let angles = [45_f64.to_radians(), 90_f64.to_radians()];
    forces(
        pose,
        angles,
        [5.0, 0.0, -3.0],
        [-1.2374368670764582, -0.45, -0.6],
    );
    let pose = "phi=-2.677945044588987; theta=1.1502619915109316; psi=2.25551552979718";
    let angles = [-2.677945044588987, 1.1502619915109316];
    let turn = format!("{pose}; Mx=3; My=-11");
    forces(
        &turn,
        angles,
        [0.0; 3],
        [0.0, 2.2360679774997916, -10.206207261596576],
    );
    let two = format!(
        "{turn}; Fx=10; Fz=35; Px=5; Py=12; Pz=-25; u2=-0.25; u3=0.8; w1=0.15; w2=-0.3; w3=0.65"
    );
    forces(
        &two,
        angles,
        [15.0, 12.0, 10.0],
        [-10.866190887243416, -6.831587661967511, -2.856589964472557],
    );
    let own = format!(
        "{pose}; M1=3; M2=-11; F1=10; F3=35; P1=5; P2=12; P3=-25; \
         u2=-0.25; u3=0.8; w1=0.15; w2=-0.3; w3=0.65"
    );
    forces(
        &own,
        angles,
        [13.452322043435093, 15.093169039552771, 7.760881392161332],
        [-4.219557018246711, 0.727969291837808, 5.8],
    );
}

/// Example 7.8, problems 7.24 and 7.25, the data of problem 8.6: accelerations of a free body with a full tensor of inertia.
#[test]
fn free_bodies() {
    let model = "pushed-body.toml";
    let example = "mass=2; Ixx=0.3; Iyy=0.3; Izz=0.3; phi=45 deg; theta=90 deg; omega_2=20; omega_3=-35; Fx=5; Fz=-3; u1=0.2; u3=-0.15";
    published("simulate", model, example, |run| {
        run.all(
            0.0,
            "body",
            &[("ax", 2.5), ("ay", 0.0), ("az", -1.5)],
            1e-13,
        );
        run.near(0.0, "body.alpha_x", -2.474873734152917, 1e-12);
        run.near(0.0, "body.alpha_y", 0.3535533905932741, 1e-12);
        run.near(0.0, "body.alpha_z", -4.124789556921527, 1e-12);
        run.near_in_body(
            0.0,
            "body",
            "body.alpha_",
            [-1.5000000000000002, -4.124789556921527, -2.000000000000001],
            1e-12,
        );
    });
    let problem = "mass=5; Ixx=4.5; Iyy=7.5; Izz=9; Ixy=-1.5; phi=45 deg; theta=90 deg; psi=180 deg; omega_1=-80; omega_2=-15; omega_3=-35; Fx=3; Fz=-8; u1=0.1; u3=-0.15";
    published("simulate", model, problem, |run| {
        run.all(
            0.0,
            "body",
            &[("ax", 0.6), ("ay", 0.0), ("az", -1.6)],
            1e-13,
        );
        run.near_in_body(
            0.0,
            "body",
            "body.alpha_",
            [-549.7092349515632, 1675.0722951453113, 629.2555555555551],
            1e-11,
        );
    });
    let problem = "mass=3; Ixx=15; Iyy=25; Izz=30; Ixz=-10; theta=90 deg; psi=45 deg; Fx=9; Fy=7; Fz=-12; u1=0.2; u3=-0.15";
    published("simulate", model, problem, |run| {
        run.near_vector(0.0, "body.a", [3.0, 7.0 / 3.0, -4.0], 1e-13);
        run.near_in_body(
            0.0,
            "body",
            "body.alpha_",
            [
                -0.2757716446627535,
                0.06872792206135786,
                -0.19091883092036782,
            ],
            1e-13,
        );
    });
    let spun = "Ixx=2; Iyy=1.5; Izz=1; Ixy=0.3; Ixz=-0.1; Iyz=0.2; omega_1=1; omega_2=-2; omega_3=0.5; \
        phi=0.3; theta=0.8; psi=-1.1; M1=0.7; M2=0.1; M3=-0.4";
    published("simulate", model, spun, |run| {
        run.near_in_body(
            0.0,
            "body",
            "body.alpha_",
            [
                -0.2843382090617196,
                -0.2630217623974313,
                -0.4758294684266854,
            ],
            1e-14,
        );
    });
}

/// Equations 7.85 to 7.105: mass, centre, tensor and accelerations of six point masses about a frame that is not central.
/// The accelerations are the mass matrix and the quadratic velocity vector in Euler angles, solved.
#[test]
fn frame_away_from_the_centre() {
    published("simulate", "lumps.toml", "", |run| {
        run.near(0.0, "body.ax", 0.3534710411550529, 1e-12);
        run.near(0.0, "body.ay", -1.9306091782303545, 1e-12);
        run.near(0.0, "body.az", -1.9577103041135966, 1e-12);
        run.near_in_body(
            0.0,
            "body",
            "body.alpha_",
            [-2.2789168864199914, 1.1920156832020958, -1.119827581294309],
            1e-12,
        );
    });
}

/// Example 7.10 and problem 7.32: the moment that keeps a body turning about an axis that is no principal one.
#[test]
fn unbalanced_rotors() {
    let other = "Ixx=2; Iyy=1.8; Izz=3; Ixy=1.5; Ixz=-1; Iyz=0.5; x=0; y=1; rate=20";
    for (options, moment) in [("", [0.0, 225.0, 0.0]), (other, [200.0, 0.0, -600.0])] {
        published("inverse", "unbalanced-rotor.toml", options, |run| {
            for t in run.channel("time").to_vec() {
                // The bearing's moment turns with the rotor.
                run.near_in_body(t, "rotor", "bearing.moment_", moment, 1e-10);
                run.near(t, "drive.moment", 0.0, 1e-10);
            }
        });
    }
}

/// Examples 7.11 and 7.12: accelerations and reactions of the manipulator with two pins.
#[test]
fn manipulator() {
    published("simulate", "manipulator.toml", "", |run| {
        run.near(0.0, "Q.angle_acceleration", 6.408224601354748, 1e-12);
        run.near(0.0, "P.angle_acceleration", -6.872554286124972, 1e-12);
        run.near_vector(
            0.0,
            "third.omega_",
            [-0.27259283961605535, 1.2, -0.6447426958020195],
            1e-14,
        );
        run.near_vector(
            0.0,
            "second.a",
            [-0.08381193859048802, 0.0, 0.2214863071468188],
            1e-12,
        );
        run.near_vector(0.0, "second.alpha_", [0.0, 6.408224601354748, 0.0], 1e-12);
        run.near_vector(
            0.0,
            "third.a",
            [
                -0.38226688537352804,
                -2.0443793109538544,
                -2.3810652372076073,
            ],
            1e-12,
        );
        run.near_vector(
            0.0,
            "third.alpha_",
            [-3.4499899324914214, 6.408224601354748, -6.002930274577788],
            1e-12,
        );
        run.near_vector(
            0.0,
            "P.force_",
            [-0.9556672134338202, 19.414051722615362, -5.952663093019017],
            1e-12,
        );
        run.near_vector(
            0.0,
            "P.moment_",
            [-1.2131718740072517, 2.369969010148501, 0.5129208414941333],
            1e-12,
        );
        run.near_vector(
            0.0,
            "Q.force_",
            [-1.2909149677957723, 58.654051722615364, -5.066717864431741],
            1e-12,
        );
        run.near_vector(
            0.0,
            "Q.moment_",
            [-2.26716908395875, 0.0, 5.564258338226486],
            1e-12,
        );
    });
}

/// Equations 7.116 to 7.124: a spring with damper and actuator between two moving bodies.
#[test]
fn spring_between_bodies() {
    published("simulate", "sprung-bodies.toml", "", |run| {
        run.near(0.0, "spring.length", 1.4230831177462382, 1e-14);
        run.near(0.0, "spring.rate", 0.01739092223851507, 1e-14);
        run.near(0.0, "spring.force", 1397.320313508898, 1e-11);
        run.near_vector(
            0.0,
            "i.a",
            [-1148.0134140168623, 566.9759183092966, 559.5601556930966],
            1e-11,
        );
        run.near_vector(
            0.0,
            "j.a",
            [1148.0134140168623, -566.9759183092966, -559.5601556930966],
            1e-11,
        );
        run.near_vector(
            0.0,
            "i.alpha_",
            [142.57484791294084, -51.046075731362535, 344.2341839560713],
            1e-11,
        );
        run.near_vector(
            0.0,
            "j.alpha_",
            [-35.11227434404153, -246.06986369358725, 177.29340444091093],
            1e-11,
        );
    });
}

/// Equations 7.125 to 7.132: a torsion spring with damper and motor between two bodies without a joint.
#[test]
fn torsion_spring_between_bodies() {
    published("simulate", "coiled-bodies.toml", "", |run| {
        run.near(0.0, "spring.angle", 0.85, 1e-14);
        run.near(0.0, "spring.rate", -1.7, 1e-14);
        run.near(0.0, "spring.moment", 49.9, 1e-12);
        run.near_vector(
            0.0,
            "i.alpha_",
            [11.49520977134478, 46.424010897367616, -14.236620544001035],
            1e-12,
        );
        run.near_vector(
            0.0,
            "j.alpha_",
            [-11.49520977134478, -46.424010897367616, 14.236620544001035],
            1e-12,
        );
    });
}

/// Section 7.12: a free body spun about its middle axis keeps energy and angular momentum while it tumbles.
#[test]
fn tumbling_body() {
    let options = "A=0.5; B=1.1; C=1.4; omega_x=0.1; omega_y=6; omega_z=0.1; --end 10";
    published("simulate", "free-top.toml", options, |run| {
        for t in run.channel("time").to_vec() {
            run.near_vector(t, "momentum.angular_", [0.05, 6.6, 0.14], 1e-10);
            run.near(t, "energy.kinetic", 19.8095, 1e-10);
        }
        run.near(10.0, "momentum.angular_x", 0.05, 1e-10);
        run.near(10.0, "momentum.angular_y", 6.6, 1e-10);
        run.near(10.0, "energy.kinetic", 19.8095, 1e-10);
        let end = [-4.952340367987038, -1.602976583339617, 4.185832834044753];
        run.near_in_body(10.0, "top", "top.omega_", end, 1e-7);
    });
}

/// Problem 7.30: a ball joint puts the second body in its place.
#[test]
fn problem_7_30_assembly() {
    published("simulate", "ball-to-assemble.toml", "", |run| {
        run.near(0.0, "i.x", 0.95, 1e-15);
        run.near(0.0, "j.x", 0.6491025403784438, 1e-14);
        run.near(0.0, "j.y", 2.728349364905389, 1e-14);
        run.near(0.0, "j.z", -1.2566987298107781, 1e-14);
        run.near(0.0, "j.theta", 30_f64.to_radians(), 1e-14);
    });
}

/// Equation 7.183 is no weld: when a welded pair turns, the difference of the positions turns with it and the difference
/// of the Euler angles changes.
#[test]
fn welded_pair_turns_as_one() {
    let differences = |run: &mut Run, t: f64, position: [f64; 3], angles: [f64; 3]| {
        for (channel, value) in ["x", "y", "z"].into_iter().zip(position) {
            let found = run.at(t, &format!("i.{channel}")) - run.at(t, &format!("j.{channel}"));
            run.same(&format!("{channel} at {t} s"), found, value, 1e-13);
        }
        for (channel, value) in ["phi", "theta", "psi"].into_iter().zip(angles) {
            let found = run.at(t, &format!("i.{channel}")) - run.at(t, &format!("j.{channel}"));
            run.same(&format!("{channel} at {t} s"), found, value, 1e-13);
        }
    };
    published("kinematics", "welded-pair.toml", "", |run| {
        differences(run, 0.0, [1.0, 0.5, 0.0], [0.3, 0.2, 0.1]);
        let turned = [1.0, 0.25, 0.4330127018922193];
        let angles = [0.33186921186285506, 0.1054540807569262, 0.39868749485198685];
        differences(run, 1.0, turned, angles);
    });
}

/// The pins of Example 7.12 remove five degrees of freedom each: points that coincide do not cost the form of the
/// program a rank, as they do that of equation 7.173.
#[test]
fn pins_have_full_rank() {
    let found = &answer("check", "manipulator.toml", "")["mobility"]["mobility"];
    let counts = ["rows", "rank", "freedoms"].map(|count| found[count].as_i64());
    assert_eq!(counts, [Some(10), Some(10), Some(2)], "{found:#}");
}

/// Section 8.1: steady precession of a gyroscope, at 60 and at 90 degrees. The moment is
/// phi'^2 (izz - ixx) sin cos + izz phi' psi' sin: 69.80164754502574 N m, and 80 N m at 90 degrees.
#[test]
fn gyroscope() {
    for (tilt, moment) in [(60.0_f64, 69.80164754502574), (90.0, 80.0)] {
        let options = format!("tilt={tilt} deg");
        published("simulate", "gyroscope.toml", &options, |run| {
            for t in run.channel("time").to_vec() {
                run.near(t, "rotor.theta", tilt.to_radians(), 1e-11);
                run.near(t, "rotor.phi", 0.3 + 2.0 * t, 1e-11);
                // Four turns between two rows: the angle is written up to whole turns.
                let spin = run.at(t, "rotor.psi") - (0.7 + 50.0 * t);
                let spin = spin - (spin / TAU).round() * TAU;
                run.same("spin angle", spin, 0.0, 5e-10);
            }
            // The formula, as the model has it.
            let [x, y, _] = run.vector(0.0, "moment.moment_");
            run.same("moment", x.hypot(y), moment, 1e-13);
        });
    }
}
