//! Driven mechanisms with closed forms in textbooks.

use super::harness::published;
use std::f64::consts::PI;

/// Offset slider crank: x = r cos(w t) + sqrt(l^2 - (r sin(w t) - e)^2) (Norton, Design of Machinery).
#[test]
fn offset_slider_crank() {
    let options =
        "crank_length=0.1; rod_length=0.35; offset=0.02; speed=20; --end 0.3; --step 0.01";
    published("kinematics", "slider-crank.toml", options, |run| {
        // Time, slider x, velocity, acceleration.
        let rows = [
            [
                0.01,
                0.44800663248868705,
                -0.39659343615687837,
                -50.18317818155099,
            ],
            [
                0.05,
                0.3981016617700726,
                -1.8844049338888214,
                -18.848645036861168,
            ],
            [
                0.1,
                0.3011227838083349,
                -1.6463511345567428,
                22.065382034950037,
            ],
            [
                0.2,
                0.27130356013036144,
                1.1420769618291873,
                29.262789809893075,
            ],
            [
                0.3,
                0.4427180638536653,
                0.8243741991055364,
                -47.70126490519137,
            ],
        ];
        for [t, x, velocity, acceleration] in rows {
            run.near(t, "slider.x", x, 1e-12);
            run.near(t, "slider.y", 0.02, 1e-12);
            run.near(t, "slider.vx", velocity, 1e-11);
            run.near(t, "slider.ax", acceleration, 1e-9);
        }
    });
}

/// Four-bar linkage 0.4, 0.12, 0.35, 0.25 m by Freudenstein's equation.
#[test]
fn four_bar_linkage() {
    let options = "base=0.4; crank_length=0.12; coupler_length=0.35; rocker_length=0.25; start=0.5; speed=10; coupler_start=0.58; rocker_start=-1.56; --end 0.6; --step 0.01";
    published("kinematics", "four-bar.toml", options, |run| {
        // Time, coupler angle, angle of the rocker from C to B, angular velocities, acceleration of the rocker.
        let rows = [
            [
                0.05,
                0.43773979875990493,
                -4.639666890135901,
                -2.202282328592609,
                2.739354776999975,
                47.87608401226337,
            ],
            [
                0.1,
                0.35635598170366767,
                -4.455573131497325,
                -1.1087447441071274,
                4.39044892650212,
                19.788895477920512,
            ],
            [
                0.2,
                0.3359420287077838,
                -3.9878254495796464,
                0.7528768585279308,
                4.300459212742917,
                -20.56782165054576,
            ],
            [
                0.4,
                0.8705373927738179,
                -3.7867585975289106,
                3.1172024818828445,
                -2.253396910440146,
                -28.559989756301622,
            ],
            [
                0.6,
                0.6937878288756171,
                -4.657484611809949,
                -4.2151090690397,
                -2.7450759608334097,
                78.50803951498531,
            ],
        ];
        for [t, coupler, rocker, coupler_rate, rocker_rate, rocker_second] in rows {
            run.near(t, "coupler.angle", coupler, 1e-12);
            // The rocker of the model points from B to C.
            run.near(t, "rocker.angle", rocker + PI, 1e-12);
            run.near(t, "coupler.omega", coupler_rate, 1e-11);
            run.near(t, "rocker.omega", rocker_rate, 1e-11);
            run.near(t, "rocker.alpha", rocker_second, 1e-9);
        }
    });
}

/// Peaucellier (1864): P stays on x = 8/15 with y = x tan(crank angle / 2).
#[test]
fn peaucellier_straight_line() {
    published("kinematics", "peaucellier.toml", "", |run| {
        run.near(0.5, "P.y", -0.10811201893795866, 1e-12);
        run.near(1.0, "P.y", 0.0, 1e-12);
        run.near(1.5, "P.y", 0.10811201893795866, 1e-12);
        run.near(2.0, "P.y", 0.22548971666035295, 1e-12);
        for t in run.channel("time").to_vec() {
            run.near(t, "P.x", 8.0 / 15.0, 1e-12);
        }
    });
}

/// Eccentric disc under an offset roller: y = e sin(a) + sqrt((R + r)^2 - (x - e cos(a))^2).
#[test]
fn eccentric_cam_with_roller() {
    published("kinematics", "cam-eccentric-roller.toml", "", |run| {
        run.near(0.0, "follower.y", 0.049749371855331, 1e-12);
        run.near(0.1, "follower.y", 0.05709119028467203, 1e-12);
        run.near(0.3, "follower.y", 0.06415688908487108, 1e-12);
        run.near(0.6, "follower.y", 0.04550439159324987, 1e-12);
        run.near(1.0, "follower.y", 0.03528498127291533, 1e-12);
        run.near(0.1, "follower.vy", 0.06809842589971725, 1e-12);
        run.near(0.3, "follower.vy", -0.008288540911156545, 1e-12);
        run.near(0.6, "follower.vy", -0.08031133685403559, 1e-12);
    });
}
