//! Motion under forces in A. A. Shabana, Computational Dynamics (2nd ed., 2001), Chapters 1, 4, 5, 6.
//!
//! The book gives most of these as symbols; the numbers are closed forms at an instant and
//! integrations of the minimal equations to 13 digits.

use super::harness::published;

const G: f64 = 9.81;

/// Equations 1.4 to 1.6: a block under a constant force.
#[test]
fn section_1_6_block() {
    published("simulate", "block-on-floor.toml", "", |run| {
        run.near(0.0, "block.ax", 3.0, 1e-13);
        run.near(0.0, "floor.force_y", 19.62, 1e-13);
        run.near(1.5, "block.x", 3.775, 1e-12);
        run.near(1.5, "block.vx", 4.7, 1e-12);
    });
}

/// Example 4.1: rod on a moving base, at one instant with its pin force, and after 2 s; the same
/// system by Lagrange (5.160) and Hamilton (Example 5.10).
#[test]
fn example_4_1_moving_base() {
    let options = "--start 0.25; --end 0.3; --step 0.05";
    published("simulate", "rod-on-moving-base.toml", options, |run| {
        run.near(0.25, "rod.alpha", -12.876681327437048, 1e-11);
        run.near(0.25, "pin.force_x", 1.7659709897424678, 1e-11);
        run.near(0.25, "pin.force_y", 5.803074904587258, 1e-11);
    });
    published("simulate", "rod-on-moving-base.toml", "", |run| {
        run.near(2.0, "rod.angle", 0.2188695835763149, 1e-10);
        run.near(2.0, "rod.omega", 2.8905533974818627, 1e-10);
        // The model's base has 1 kg of its own.
        let base = run.at(2.0, "base.vx").powi(2) / 2.0;
        let energy = run.at(2.0, "energy.total") - base;
        run.same("T + V of the rod", energy, 2.0548897905572643, 1e-10);
        // The canonical momentum (J + m l^2/4) w - m (l/2) sin(angle) z'.
        let (angle, rate) = (run.at(2.0, "rod.angle"), run.at(2.0, "rod.omega"));
        let momentum =
            (0.064 + 1.2 * 0.16) * rate - 1.2 * 0.4 * angle.sin() * run.at(2.0, "base.vx");
        run.same("momentum", momentum, 0.7099608039791802, 1e-10);
    });
}

/// Sections 4.3 to 4.6: rod and disk, accelerations and pin forces at the start, state after 1 s.
#[test]
fn section_4_3_rod_and_disk() {
    published("simulate", "rod-and-disk.toml", "", |run| {
        run.near(0.0, "rod centre.ax", 1.2796989694133387, 1e-12);
        run.near(0.0, "rod centre.ay", -3.7889771774713346, 1e-12);
        run.near(0.0, "rod.alpha", -7.675507150336374, 1e-12);
        run.near(0.0, "disk.ax", 2.5593979388266788, 1e-12);
        run.near(0.0, "disk.ay", -7.577954354942668, 1e-12);
        run.near(0.0, "disk.alpha", 17.777777777777775, 1e-12);
        run.near(0.0, "O.force_x", 10.237591755306713, 1e-11);
        run.near(0.0, "O.force_y", 18.738182580229328, 1e-11);
        run.near(0.0, "A.force_x", 7.678193816480036, 1e-11);
        run.near(0.0, "A.force_y", 6.696136935171995, 1e-11);
        run.near(1.0, "rod.angle", -1.6102717853196857, 1e-10);
        run.near(1.0, "rod.omega", -5.573819703534966, 1e-10);
        run.near(1.0, "disk.angle", 9.888888888888891, 1e-10);
    });
}

/// Example 5.9: two-arm manipulator, loaded at one instant, and falling from the horizontal for 1 s.
#[test]
fn example_5_9_manipulator() {
    let options = "first_start=50 deg; second_start=20 deg; first_speed=2; second_speed=-3; \
                   first_moment=6; tip_force=4; --end 0.1";
    published("simulate", "two-link-arm.toml", options, |run| {
        run.near(0.0, "first.alpha", -5.8116756301055235, 1e-11);
        run.near(0.0, "second.alpha", 5.384440025537777, 1e-11);
        run.near(0.0, "O.force_x", -2.116198781302343, 1e-11);
        run.near(0.0, "O.force_y", 15.871946785380167, 1e-11);
        run.near(0.0, "A.force_x", -3.620879887627275, 1e-11);
        run.near(0.0, "A.force_y", 1.6918274726001312, 1e-11);
    });
    published("simulate", "two-link-arm.toml", "", |run| {
        run.near(1.0, "first.angle", -2.920414264218441, 1e-10);
        run.near(1.0, "second.angle", -2.444958846018796, 1e-10);
        run.near(1.0, "first.omega", -2.6361138762012235, 1e-10);
        run.near(1.0, "second.omega", -0.9586491974979039, 1e-10);
        run.near(1.0, "energy.total", 0.0, 1e-10);
    });
}

/// Examples 6.4 and 6.5: two links with constant moments, without gravity.
#[test]
fn examples_6_4_and_6_5_two_links() {
    let options = "g=0; first_center=0.5; second_inertia=0.1; second_center=0.4; \
                   first_start=0.4; second_start=1.1; first_speed=2; second_speed=-1; \
                   first_moment=3; second_moment=-1";
    published("simulate", "two-link-arm.toml", options, |run| {
        run.near(0.0, "first centre.ax", -2.693405334622462, 1e-11);
        run.near(0.0, "first centre.ay", 1.2346377726064237, 1e-11);
        run.near(0.0, "first.alpha", 4.372076269288671, 1e-11);
        run.near(0.0, "second centre.ax", -0.7950562830783515, 1e-11);
        run.near(0.0, "second centre.ay", -0.31661031184839533, 1e-11);
        run.near(0.0, "second.alpha", -13.389680810108443, 1e-11);
        run.near(0.0, "O.force_x", -6.579395093862451, 1e-11);
        run.near(0.0, "O.force_y", 1.9943600774402543, 1e-11);
        run.near(0.0, "A.force_x", -1.1925844246175272, 1e-11);
        run.near(0.0, "A.force_y", -0.47491546777259297, 1e-11);
        run.near(1.0, "first.angle", 3.443957997942473, 1e-10);
        run.near(1.0, "second.angle", 1.3193410044509635, 1e-10);
        run.near(1.0, "first.omega", 3.3927233482114962, 1e-10);
        run.near(1.0, "second.omega", 6.277351045967302, 1e-10);
    });
}

/// Section 5.7: slider crank with a moment and a load, at 10 rad/s and after 0.3 s.
#[test]
fn section_5_7_slider_crank() {
    published("simulate", "slider-crank-loaded.toml", "", |run| {
        run.near(0.0, "crank.alpha", 49.68851154358648, 1e-10);
        run.near(0.0, "rod.alpha", 13.616462749177762, 1e-10);
        run.near(0.0, "slider.ax", -24.58871852474313, 1e-10);
        run.near(0.0, "O.force_x", -18.184154939805186, 1e-10);
        run.near(0.0, "O.force_y", 6.652717944442449, 1e-10);
        run.near(0.0, "A.force_x", -12.891866860895645, 1e-10);
        run.near(0.0, "A.force_y", 3.526497677398382, 1e-10);
        run.near(0.0, "B.force_x", 5.411281475256872, 1e-10);
        run.near(0.0, "B.force_y", -1.4754547498721227, 1e-10);
        run.near(0.0, "guide.force_y", 11.285454749872123, 1e-10);
        run.near(0.3, "crank.angle", 8.77138967401749, 1e-9);
        run.near(0.3, "crank.omega", 53.002796290772565, 1e-9);
    });
}

/// Problems 6.14 and 6.17 at 150 rad/s: both directions of the load, without and with gravity.
/// (The figure with the direction is not in the text; all four are given.)
#[test]
fn problems_6_14_and_6_17_slider_crank() {
    // Load, gravity; then accelerations x, y, angle of crank, rod, slider x; forces on the crank in
    // O, on the rod in A, on the slider in B, of the guide on the slider.
    for [force, g, expected @ ..] in super::harness::table::<16>("problem-6-14.csv") {
        let options = format!(
            "crank_mass=0.5; rod_mass=1; slider_mass=0.2; moment=10; speed=150; \
             force={force}; g={g}; --end 1 ms; --step 1 ms"
        );
        published("simulate", "slider-crank-loaded.toml", &options, |run| {
            let accelerations = [
                "crank.ax",
                "crank.ay",
                "crank.alpha",
                "rod.ax",
                "rod.ay",
                "rod.alpha",
                "slider.ax",
            ];
            let forces = [
                "O.force_x",
                "O.force_y",
                "A.force_x",
                "A.force_y",
                "B.force_x",
                "B.force_y",
                "guide.force_y",
            ];
            for (channel, value) in accelerations.iter().chain(&forces).zip(expected) {
                run.near(0.0, channel, value, 1e-12 * 11_000.0);
            }
        });
    }
}

/// Problem 6.22: the same slider crank over more than one turn, without gravity.
#[test]
fn problem_6_22_one_turn() {
    let cases = [
        (
            "15",
            "0.035209376826536604",
            [7.770490580141888, 147.74859626119442],
            [7.76993754006807, 147.6794942610047],
        ),
        (
            "-15",
            "0.03508511353439628",
            [7.79026481641953, 149.03126294979475],
            [7.789689027454742, 148.95639963863172],
        ),
    ];
    for (force, turn, [angle, rate], [fixed_angle, fixed_rate]) in cases {
        let loads =
            format!("rod_mass=1; slider_mass=0.2; moment=10; speed=150; g=0; force={force}");
        let model = "slider-crank-loaded.toml";
        published(
            "simulate",
            model,
            &format!("{loads}; --end 0.04; --step 0.01"),
            |run| {
                run.near(0.04, "crank.angle", angle, 1e-9);
                run.near(0.04, "crank.omega", rate, 1e-7);
                // The answers asked for are those of 40 steps of a fixed-step method of order 4,
                // with its errors.
                run.near(0.04, "crank.angle", fixed_angle, 6e-4);
                run.near(0.04, "crank.omega", fixed_rate, 8e-2);
            },
        );
        published(
            "simulate",
            model,
            &format!("{loads}; --end {turn}; --step {turn}"),
            |run| {
                let end: f64 = turn.parse().expect("a number");
                let start = std::f64::consts::FRAC_PI_4;
                run.near(end, "crank.angle", start + std::f64::consts::TAU, 1e-9);
                run.near(end, "crank.omega", 158.24580252, 1e-7);
                // The load does no work over a turn: the moment alone raises the energy.
                run.near(0.0, "energy.kinetic", 556.2016661407638, 1e-9);
                let gain = run.at(end, "energy.kinetic") - run.at(0.0, "energy.kinetic");
                run.same("gain of energy", gain, 10.0 * std::f64::consts::TAU, 1e-8);
            },
        );
    }
}

/// The same slider crank at 0.4 s (Section 6.12 speaks of its drift).
#[test]
fn section_6_12_slider_crank_at_0_4_s() {
    let options = "rod_mass=1; slider_mass=0.2; moment=10; speed=150; g=0; force=15; \
                   --end 0.4; --step 0.1";
    published("simulate", "slider-crank-loaded.toml", options, |run| {
        run.near(0.4, "crank.angle", 92.1641103590, 1e-8);
    });
}

/// Example 5.11: cylinder in a circular track; contact force and period (elliptic integral).
#[test]
fn example_5_11_rolling_in_a_track() {
    published("simulate", "cylinder-in-track.toml", "", |run| {
        let angle = run.at(1.0, "cylinder.x").atan2(-run.at(1.0, "cylinder.y"));
        run.same("angle at 1 s", angle, -0.5088609336050092, 1e-11);
        let (sin, cos) = angle.sin_cos();
        let along = run.at(1.0, "cylinder.vx") * cos + run.at(1.0, "cylinder.vy") * sin;
        run.same("rate at 1 s", along / 0.75, -0.35618687688540823, 1e-11);
        // The cylinder turns against its line of centres.
        run.near(1.0, "cylinder.omega", 1.0685606306562248, 1e-11);
        let (fx, fy) = (
            run.at(1.0, "contact.force_x"),
            run.at(1.0, "contact.force_y"),
        );
        run.same(
            "normal force",
            -fx * sin + fy * cos,
            25.98667468023347,
            1e-9,
        );
        run.same("friction", fx * cos + fy * sin, -4.779263429468924, 1e-9);
        let energy = run.at(1.0, "energy.total") + 3.0 * G * 0.75;
        run.same(
            "energy over the lowest point",
            energy,
            2.9571542749679764,
            1e-10,
        );
    });
    let period = "2.164796686818239";
    let options = format!("--end {period}; --step {period}");
    published("simulate", "cylinder-in-track.toml", &options, |run| {
        let end: f64 = period.parse().expect("a number");
        run.near(end, "cylinder.x", 0.75 * 0.5, 1e-10);
        run.near(end, "cylinder.omega", 0.0, 1e-10);
        run.near(end, "cylinder.angle", 0.0, 1e-10);
    });
}

/// Example 5.11, small swings: after one period 2 pi/omega the cylinder is back. (From 1e-4 rad the period is longer by
/// 6e-10 of itself, which the angle does not feel where it turns back.)
#[test]
fn example_5_11_small_swings() {
    let period = (std::f64::consts::TAU / 2.95296461204668).to_string();
    let options = format!("start=1e-4; --end {period}; --step {period}");
    published("simulate", "cylinder-in-track.toml", &options, |run| {
        let end: f64 = period.parse().expect("a number");
        run.near(end, "cylinder.x", 0.75 * 1e-4_f64.sin(), 1e-12);
        run.near(end, "cylinder.omega", 0.0, 1e-11);
        run.near(
            end,
            "contact.psi",
            1e-4 - std::f64::consts::FRAC_PI_2,
            1e-12,
        );
    });
}

/// Problems 5.44 to 5.46: slider on a spring with a pinned rod.
#[test]
fn problems_5_44_to_5_46_sprung_slider() {
    published("simulate", "sprung-slider-with-rod.toml", "", |run| {
        run.near(0.0, "block.ax", -1.577933118488404, 1e-12);
        run.near(0.0, "rod.alpha", -4.66288182195917, 1e-12);
        run.near(1.5, "block.x", 0.04621899155266636, 1e-11);
        run.near(1.5, "rod.angle", -1.2620869872727274, 1e-11);
        run.near(1.5, "block.vx", -0.11203321615764375, 1e-10);
        run.near(1.5, "rod.omega", 1.8838371622609136, 1e-10);
    });
}

/// Examples 6.10 and 6.11: pendulum at one instant. (The book's Q_d has the wrong sign, which shows
/// in the reaction only.)
#[test]
fn examples_6_10_and_6_11_pendulum() {
    let options = "amplitude=0; constant=1; start=0.3; speed=2; --end 0.01";
    published("simulate", "driven-pendulum.toml", options, |run| {
        run.near(0.0, "rod.ax", -0.27677478924123494, 1e-12);
        run.near(0.0, "rod.ay", -5.87298907298325, 1e-12);
        run.near(0.0, "rod.alpha", -11.057776437483296, 1e-12);
        run.near(0.0, "pin.force_x", -0.27677478924123494, 1e-12);
        run.near(0.0, "pin.force_y", 3.937010927016751, 1e-12);
        run.near(0.0, "pin.moment", 0.0, 1e-12);
    });
}

/// Example 6.12: pendulum under 10 sin(5 t), to 5 s.
#[test]
fn example_6_12_driven_pendulum() {
    published("simulate", "driven-pendulum.toml", "", |run| {
        for [t, angle, rate] in super::harness::table("example-6-12.csv") {
            run.near(t, "rod.angle", angle, 1e-9);
            run.near(t, "rod.omega", rate, 1e-9);
        }
    });
}

/// Problem 6.8 (force at the free end, angle from x): without and with gravity.
#[test]
fn problem_6_8_pinned_rod() {
    let cases = [
        (
            "g=0",
            [-7976.944887740448, -7932.957688956871, 62.20729309053431],
            [-7978.681369517118, -7942.805766486993],
        ),
        (
            "g=9.81",
            [-7973.266137740448, -7936.636438956872, 51.802216805371586],
            [-7975.002619517118, -7936.6745164869935],
        ),
    ];
    for (g, [ax, ay, alpha], [fx, fy]) in cases {
        published("simulate", "pinned-rod.toml", g, |run| {
            run.near(0.0, "rod.ax", ax, 1e-8);
            run.near(0.0, "rod.ay", ay, 1e-8);
            run.near(0.0, "rod.alpha", alpha, 1e-8);
            run.near(0.0, "pin.force_x", fx, 1e-8);
            run.near(0.0, "pin.force_y", fy, 1e-8);
        });
    }
}

/// Example 6.9: two free bodies with a pin.
#[test]
fn example_6_9_two_bodies() {
    published("simulate", "pinned-bodies.toml", "", |run| {
        run.near(0.0, "j.x", 1.0459655685909788, 1e-13);
        run.near(0.0, "j.y", 0.10943867223074294, 1e-13);
        run.near(0.0, "j.vx", -0.45819055229630956, 1e-12);
        run.near(0.0, "j.vy", 1.2011037791870591, 1e-12);
        run.near(0.0, "i.ax", 3.1857915926180613, 1e-11);
        run.near(0.0, "i.ay", -0.19465779971573083, 1e-11);
        run.near(0.0, "i.alpha", 4.601867565542728, 1e-11);
        run.near(0.0, "j.ax", -3.371583185236122, 1e-11);
        run.near(0.0, "j.ay", 1.3893155994314617, 1e-11);
        run.near(0.0, "j.alpha", 5.706440833683118, 1e-11);
        run.near(0.0, "pin.force_x", -2.371583185236122, 1e-11);
        run.near(0.0, "pin.force_y", -1.6106844005685383, 1e-11);
    });
}

/// Section 5.4: generalized forces of force elements, as accelerations of unit bodies.
#[test]
fn section_5_4_force_elements() {
    published("simulate", "free-bodies-with-springs.toml", "", |run| {
        run.near(0.0, "spring.length", 1.002128304429116, 1e-13);
        run.near(0.0, "spring.rate", -0.06665571050348298, 1e-13);
        run.near(0.0, "spring.force", 127.8514861140942, 1e-11);
        let i = [117.09085488543364, -51.339402059049576, -34.76366887609959];
        let j = [-117.09085488543364, 51.339402059049576, 36.835754053861876];
        for (k, suffix) in ["ax", "ay", "alpha"].into_iter().enumerate() {
            run.near(0.0, &format!("i.{suffix}"), i[k], 1e-11);
            run.near(0.0, &format!("j.{suffix}"), j[k], 1e-11);
        }
        run.near(0.0, "wheel i.alpha", -17.3, 1e-12);
        run.near(0.0, "wheel j.alpha", 17.3, 1e-12);
        run.near(0.0, "plate.ax", 12.0, 1e-12);
        run.near(0.0, "plate.ay", -7.0, 1e-12);
        run.near(0.0, "plate.alpha", -4.253834301896212, 1e-12);
    });
}

/// Section 5.4: wheel on flat ground. A wheel that turns counter-clockwise rolls towards -x.
#[test]
fn section_5_4_rolling() {
    published("simulate", "rolling-wheel.toml", "", |run| {
        run.near(0.0, "wheel.vx", -3.6, 1e-13);
        run.near(0.0, "wheel.vy", 0.0, 1e-13);
        run.near(0.0, "wheel.alpha", 3.703703703703704, 1e-12);
        run.near(0.0, "wheel.ax", -0.3 * 3.703703703703704, 1e-12);
        run.near(0.0, "touching point.vx", 0.0, 1e-13);
        run.near(0.0, "touching point.ax", 0.0, 1e-12);
        run.near(0.0, "touching point.ay", 43.2, 1e-12);
        run.near(0.0, "contact.force_x", -11.11111111111111, 1e-11);
        run.near(0.0, "contact.force_y", 98.1, 1e-11);
    });
}

/// Section 6.12: rates of a floating hexagon of links from four given ones.
#[test]
fn section_6_12_closed_ring() {
    published("simulate", "hexagon.toml", "", |run| {
        let rates = [
            [0.0, 0.0, -0.05],
            [-0.1623797632095822, 0.08125, 0.75],
            [-0.3897114317029973, 0.1375, 0.3],
            [-0.4546633369868302, 0.15, -0.2],
            [-0.25980762113533157, 0.0875, 0.9],
            [-0.03247595264191646, -0.00625, 0.15],
        ];
        for (k, [vx, vy, omega]) in rates.into_iter().enumerate() {
            let link = format!("link {}", k + 1);
            run.all(
                0.0,
                &link,
                &[("vx", vx), ("vy", vy), ("omega", omega)],
                1e-12,
            );
        }
    });
}
