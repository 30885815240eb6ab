//! Benchmarks of multibody dynamics in space and motions with closed forms.

use super::harness::{published, table};

const G: f64 = 9.81;

/// Two shafts at an angle b with a Hooke joint: the output turns with w cos b/(1 - (sin b)^2 (cos wt)^2).
#[test]
fn hooke_joint() {
    published("kinematics", "cardan.toml", "", |run| {
        run.near(0.05, "output bearing.angle_rate", 10.663452420377254, 1e-13);
        run.near(0.1, "output bearing.angle_rate", 9.407027657013565, 1e-13);
        run.near(0.2, "output bearing.angle_rate", 9.13962669756447, 1e-13);
        run.near(0.3, "output bearing.angle_rate", 11.327613404871585, 1e-13);
        let bend = 0.5_f64;
        for t in run.channel("time").to_vec() {
            let (sin, cos) = (10.0 * t).sin_cos();
            let angle = sin.atan2(bend.cos() * cos);
            run.near(t, "output bearing.angle", angle, 1e-13);
            let spread = 1.0 - (bend.sin() * cos).powi(2);
            let acceleration = -100.0 * bend.cos() * bend.sin().powi(2) * 2.0 * sin * cos;
            let acceleration = acceleration / (spread * spread);
            run.near(t, "output bearing.angle_acceleration", acceleration, 1e-11);
            // Only the driver does work: on the inertia of the output, 0.01 kg m^2.
            let rate = run.at(t, "output bearing.angle_rate");
            run.near(t, "drive.power", 0.01 * acceleration * rate, 1e-12);
        }
    });
    let least = "--end 0.15708; --step 0.15708";
    published("kinematics", "cardan.toml", least, |run| {
        run.near(
            0.15708,
            "output bearing.angle_rate",
            8.775825618930943,
            1e-13,
        );
    });
}

/// Free body with three moments of inertia: Jacobi's elliptic functions.
#[test]
fn free_asymmetric_top() {
    published("simulate", "free-top.toml", "--end 20", |run| {
        for [t, x, y, z] in table("free-top.csv") {
            run.near_in_body(t, "top", "top.omega_", [x, y, z], 1e-12);
        }
        // The angular momentum at the start, and for ever.
        for t in run.channel("time").to_vec() {
            run.near(t, "momentum.angular_x", 0.5, 1e-12);
            run.near(t, "momentum.angular_y", 1.4, 1e-12);
            run.near(t, "momentum.angular_z", 2.7, 1e-12);
        }
        run.near(20.0, "momentum.angular_x", 0.5, 1e-12);
        run.near(20.0, "momentum.angular_y", 1.4, 1e-12);
        run.near(20.0, "momentum.angular_z", 2.7, 1e-12);
    });
}

/// Spin about the middle axis with a disturbance of 1e-4: the body flips over, again and again (Dzhanibekov).
#[test]
fn flip_about_the_middle_axis() {
    let options = "omega_x=1e-4; omega_y=1; omega_z=1e-4";
    published("simulate", "free-top.toml", options, |run| {
        for [t, x, y, z] in table("free-top-flip.csv") {
            // The disturbance grows with exp(0.58 t), and so do errors.
            run.near_in_body(t, "top", "top.omega_", [x, y, z], 5e-10);
        }
    });
}

/// Free body with an axis of symmetry: the product of two steady turns.
#[test]
fn free_symmetric_top() {
    let options = "A=2; B=2; C=1; omega_x=0.6; omega_y=0.8; omega_z=3; --end 10";
    published("simulate", "free-top.toml", options, |run| {
        for [t, x, y, z, b0, b1, b2, b3] in table("free-top-symmetric.csv") {
            run.near_in_body(t, "top", "top.omega_", [x, y, z], 1e-12);
            run.near(t, "top.b0", b0, 1e-12);
            run.near(t, "top.b1", b1, 1e-12);
            run.near(t, "top.b2", b2, 1e-12);
            run.near(t, "top.b3", b3, 1e-12);
        }
    });
}

/// Heavy top with fast spin (Geradin and Cardona; Bruels, Cardona and Arnold), against Euler's equations
/// about the fixed point in extended precision.
#[test]
fn heavy_top() {
    published("simulate", "heavy-top.toml", "", |run| {
        for [t, x, y, z, b0, b1, b2, b3, p, q, r] in table("heavy-top.csv") {
            run.near(t, "top.x", x, 1e-11);
            run.near(t, "top.y", y, 1e-11);
            run.near(t, "top.z", z, 1e-11);
            run.near(t, "top.b0", b0, 1e-11);
            run.near(t, "top.b1", b1, 1e-11);
            run.near(t, "top.b2", b2, 1e-11);
            run.near(t, "top.b3", b3, 1e-11);
            run.near_in_body(t, "top", "top.omega_", [p, q, r], 5e-11);
        }
        for t in run.channel("time").to_vec() {
            // The joint carries the weight and what moves the centre of mass.
            let [x, y, z] = run.vector(t, "top.a");
            run.near_vector(
                t,
                "ball.force_",
                [15.0 * x, 15.0 * y, 15.0 * (z + G)],
                1e-10,
            );
        }
    });
}

/// Heavy top in slow steady precession: the tilt stays, the centre of mass goes round (Goldstein 5.7).
#[test]
fn top_in_steady_precession() {
    published("simulate", "steady-top.toml", "", |run| {
        run.near(0.5, "top.x", 0.34621424308347654, 1e-13);
        run.near(0.5, "top.y", 0.26006864072035946, 1e-13);
        run.near(2.0, "top.x", -0.365816468921834, 1e-13);
        run.near(2.0, "top.y", 0.23168580246869, 1e-13);
        run.near(5.0, "top.x", 0.4275258182180506, 1e-13);
        run.near(5.0, "top.y", 0.06871444358347348, 1e-13);
        let (radius, rate) = (0.5 * 60_f64.to_radians().sin(), 1.288_509_641_067_108_3);
        for t in run.channel("time").to_vec() {
            run.near(t, "top.z", 0.25, 1e-13);
            // The joint holds the weight and the centripetal force.
            let (sin, cos) = (rate * t).sin_cos();
            let pull = radius * rate * rate;
            run.near_vector(t, "ball.force_", [-pull * cos, -pull * sin, G], 1e-12);
        }
    });
}

/// A thin disc that leans 0.35 rad and rolls in a steady circle, its plane turning with 2 rad/s (Routh; Neimark and
/// Fufaev).
#[test]
fn disc_in_a_steady_circle() {
    published("simulate", "rolling-disc-steady.toml", "", |run| {
        run.near(0.5, "disc.x", -0.2664760417228536, 1e-12);
        run.near(0.5, "disc.y", 0.4877811225042186, 1e-12);
        run.near(1.0, "disc.x", -0.8209073230486521, 1e-12);
        run.near(1.0, "disc.y", 0.5270985304959577, 1e-12);
        run.near(2.0, "disc.x", -0.9585786749271449, 1e-12);
        run.near(2.0, "disc.y", -0.43870077202908053, 1e-12);
        run.near(3.0, "disc.x", -0.02308835674368627, 1e-12);
        run.near(3.0, "disc.y", -0.16197065355457582, 1e-12);
        let (radius, rate) = (0.579_676_698_674_971_6, 2.0_f64);
        for t in run.channel("time").to_vec() {
            run.near(t, "disc.z", 0.281_811_813_854_213_67, 1e-13);
            // The floor carries the weight and pulls the centre into its circle.
            let (sin, cos) = (rate * t).sin_cos();
            let pull = 2.0 * radius * rate * rate;
            run.near_vector(
                t,
                "floor.force_",
                [-pull * cos, -pull * sin, 2.0 * G],
                1e-11,
            );
            // It turns nothing about the vertical at the contact.
            run.near(t, "floor.moment_z", 0.0, 1e-12);
        }
    });
}

/// A04 of the IFToMM library: Bricard's six-bar, overconstrained, against a run of another method that is good to
/// about 1e-9. The mechanism starts and comes back to a pose at which its links stand along a cube's edges.
#[test]
fn iftomm_a04_bricard() {
    published("simulate", "bricard.toml", "", |run| {
        for [t, x, y, z, vx, vy, vz] in table("bricard.csv") {
            run.near(t, "P3.x", x, 2e-9);
            run.near(t, "P3.y", y, 2e-9);
            run.near(t, "P3.z", z, 2e-9);
            run.near(t, "P3.vx", vx, 2e-9);
            run.near(t, "P3.vy", vy, 2e-9);
            run.near(t, "P3.vz", vz, 2e-9);
            // Weights of 9.81 N at the heights 0, -0.5, -1, -1 and -0.5 m at the start.
            run.near(t, "energy.total", -29.43, 2e-9);
        }
        for t in run.channel("time").to_vec() {
            // The ground carries the weight and what moves the five rods, whatever set of reactions is chosen.
            for axis in ["x", "y", "z"] {
                let rods = (1..=5).map(|k| run.at(t, &format!("rod {k}.a{axis}")));
                let weight = if axis == "y" { 5.0 * G } else { 0.0 };
                let moved = rods.sum::<f64>() + weight;
                let last = run.at(t, &format!("pin 6.force_{axis}"));
                let carried = run.at(t, &format!("pin 1.force_{axis}")) - last;
                run.same(
                    &format!("force of the ground along {axis}"),
                    carried,
                    moved,
                    1e-9,
                );
            }
        }
    });
}

/// Slider crank in space of the IFToMM library (Haug 1989) with a ball and a cross, against a run of another method
/// that is good to 3e-8.
#[test]
fn iftomm_slider_crank_in_space() {
    published("simulate", "slider-crank-space.toml", "", |run| {
        for [t, x, omega, angle, energy] in table("slider-crank-space.csv") {
            run.near(t, "slider.x", x, 1e-9);
            run.near(t, "crank.omega_x", omega, 2e-8);
            run.near(t, "energy.total", energy, 1e-9);
            // The reference knows the angle up to whole turns.
            let found = run.at(t, "pin.angle");
            run.same("sine of the crank angle", found.sin(), angle.sin(), 2e-8);
            run.same("its cosine", found.cos(), angle.cos(), 2e-8);
        }
    });
}

/// Kepler's ellipse of eccentricity 0.6, in the plane of x and y and in a tilted one.
#[test]
fn kepler_ellipse_in_space() {
    published("simulate", "orbit.toml", "", |run| {
        for [t, x, y] in table("kepler.csv") {
            run.near(t, "satellite.x", x, 5e-11);
            run.near(t, "satellite.y", y, 5e-11);
        }
        run.near(20.0, "momentum.angular_z", 0.8, 1e-12);
    });
    published("simulate", "orbit.toml", "tilt=50 deg", |run| {
        let (sin, cos) = 50_f64.to_radians().sin_cos();
        for [t, x, y] in table("kepler.csv") {
            run.near_vector(t, "satellite.", [x, y * cos, y * sin], 5e-11);
        }
        run.near_vector(
            20.0,
            "momentum.angular_",
            [0.0, -0.8 * sin, 0.8 * cos],
            1e-12,
        );
    });
}

/// A chain and a tree of unit bodies at rest (tests of the Rigid Body Dynamics Library, numbers of spatial_v2).
#[test]
fn rbdl_chain_and_tree() {
    published("simulate", "unit-chain-space.toml", "", |run| {
        run.near(0.0, "first pin.angle_acceleration", -5.886, 1e-13);
        run.near(0.0, "second pin.angle_acceleration", 3.924, 1e-13);
    });
    published("simulate", "unit-tree.toml", "", |run| {
        run.near(0.0, "pin a.angle_acceleration", -1.6031906614786, 1e-13);
        run.near(0.0, "pin b1.angle_acceleration", -0.534396887159533, 1e-13);
        run.near(0.0, "pin c1.angle_acceleration", 4.1034046692607, 1e-13);
        run.near(0.0, "pin b2.angle_acceleration", 0.267198443579767, 1e-13);
        run.near(0.0, "pin c2.angle_acceleration", 5.30579766536965, 1e-13);
    });
}

/// A nut slides down a screw without friction: z'' = -g/(1 + I (2 pi/pitch)^2/m).
#[test]
fn nut_on_a_screw() {
    published("simulate", "screw-nut.toml", "", |run| {
        run.near(1.0, "nut.z", -0.09742190069491435, 1e-13);
        run.near(2.0, "nut.z", -0.3896876027796574, 2e-12);
        run.near(1.0, "nut.omega_z", -61.21198550437946, 1e-12);
        run.near(2.0, "nut.omega_z", -122.42397100875893, 1e-11);
        for t in run.channel("time").to_vec() {
            run.near(t, "nut.az", -0.194_843_801_389_828_7, 1e-13);
            // The screw carries the weight but for what the nut falls; its thread turns the nut.
            run.near(
                t,
                "thread.force_z",
                2.0 * (G - 0.194_843_801_389_828_7),
                1e-11,
            );
            run.near(
                t,
                "thread.moment_z",
                0.001 * run.at(t, "nut.alpha_z"),
                1e-13,
            );
        }
    });
}

/// Spherical pendulum: elliptic functions (Whittaker).
#[test]
fn spherical_pendulum() {
    published("simulate", "spherical-pendulum.toml", "", |run| {
        run.near(0.5, "bob.x", -0.10534971923969533, 1e-11);
        run.near(0.5, "bob.y", 0.5519506033843092, 1e-11);
        run.near(0.5, "bob.z", -0.8271952418140559, 1e-11);
        run.near(2.0, "bob.x", 0.2713081496100909, 1e-11);
        run.near(2.0, "bob.y", 0.7601507400475074, 1e-11);
        run.near(2.0, "bob.z", -0.5903920226090248, 1e-11);
        run.near(10.0, "bob.x", 0.22525578704970714, 1e-11);
        run.near(10.0, "bob.y", -0.6575467968542998, 1e-11);
        run.near(10.0, "bob.z", -0.7189520431484058, 1e-11);
        for t in run.channel("time").to_vec() {
            // Along the rod: the weight's part and v^2/r.
            let [x, y, z] = run.vector(t, "bob.");
            let speed: f64 = run.vector(t, "bob.v").iter().map(|v| v * v).sum();
            let pull = speed - G * z;
            run.near_vector(t, "rod.force_", [-pull * x, -pull * y, -pull * z], 1e-10);
        }
    });
}
