//! Machines whose surfaces touch, against motions that are known.

use super::moving_machine::{G, compiled, mobility, motion, run, solved, spread, start};
use super::*;
use dalembert::formulation::{Basis, Formulation};
use dalembert::space::orientation::{EulerSequence, Rotation};
use dalembert::space::{Spatial, SpatialPose};
use dalembert::system::{State, System};
use nalgebra::{DMatrix, Matrix3, Vector3};
use serde_json::{Value, json};

/// Rank and singular values of C_s of the only element, over its first rows.
fn rank_of_auxiliaries(jacobian: &DMatrix<f64>, bodies: usize, rows: usize) -> usize {
    let count = jacobian.ncols() - 6 * bodies;
    let c_s = jacobian.view((0, 6 * bodies), (rows, count)).into_owned();
    let sizes = c_s.singular_values();
    sizes.iter().filter(|s| **s > 1e-9 * sizes.max()).count()
}

const HALF: [f64; 3] = [0.3, 0.2, 0.15];

/// An ellipsoid that slides and rocks on a plane without friction (own data on Shabana 8.6; the numbers come from a second
/// formulation with one constraint, by the support function of the ellipsoid).
fn ellipsoid() -> (System<Spatial>, State) {
    let m = 2.0;
    let [a, b, c] = HALF.map(|x| x * x);
    let inertia = [b + c, a + c, a + b].map(|x| 0.2 * m * x);
    let system = compiled(json!({
        "body": [{"name": "egg", "mass": m, "inertia": inertia, "position": [0.1, -0.2, 0.2],
                  "orientation": {"euler": "zxz", "angles": [0.4, 0.9, -0.5]},
                  "hold": ["x", "y", "orientation"]}],
        "joint": [{"name": "contact", "kind": "surface-contact", "bodies": ["egg", "ground"],
                   "at": [[0, 0, 0], [0, 0, 0]],
                   "surfaces": [{"kind": "ellipsoid", "semi_axes": HALF}, {"kind": "plane"}]}]
    }))
    .system;
    let mut state = start(&system);
    let (pose, ..) = motion(&state, 0);
    let own = pose.axes.transpose() * Vector3::new(1.5, -2.0, 3.0);
    let v_z = -0.156_794_114_976_203_08;
    state.v = vec![0.3, -0.4, v_z, own.x, own.y, own.z];
    let [w_rate, _] = over_parameters(SURFACE[0], SURFACE[1], SURFACE_RATES, [0.0; 4]);
    state.v.extend(w_rate);
    state.v.extend(&SURFACE_RATES[2..]);
    // Without what holds the start.
    let mut system = system.running();
    system.estimate = state.clone();
    (system, state)
}

/// The surface parameters: a and b of the ellipsoid, then of the plane.
const SURFACE: [f64; 4] = [
    -0.884_305_400_048_906,
    -0.483_101_315_692_813_8,
    0.203_004_167_385_930_22,
    -0.232_809_479_863_771_57,
];

/// First and second rates of the unit vector w = (cos b cos a, cos b sin a, sin b) from those of a and b.
fn over_parameters(a: f64, b: f64, rates: [f64; 4], second: [f64; 4]) -> [[f64; 3]; 2] {
    let ((sa, ca), (sb, cb)) = (a.sin_cos(), b.sin_cos());
    let by_a = Vector3::new(-cb * sa, cb * ca, 0.0);
    let by_b = Vector3::new(-sb * ca, -sb * sa, cb);
    let by_ab = Vector3::new(sb * sa, -sb * ca, 0.0);
    let w = Vector3::new(cb * ca, cb * sa, sb);
    let along = Vector3::new(w.x, w.y, 0.0);
    let [p, q] = [rates[0], rates[1]];
    let first = p * by_a + q * by_b;
    let bend = -p * p * along + 2.0 * p * q * by_ab - q * q * w;
    [
        first.into(),
        (second[0] * by_a + second[1] * by_b + bend).into(),
    ]
}

/// Rates of the surface parameters.
const SURFACE_RATES: [f64; 4] = [
    -3.609_110_441_169_342_7,
    -0.011_319_789_436_410_176,
    0.020_309_614_746_078_525,
    -0.117_413_519_733_256_69,
];

#[test]
fn an_ellipsoid_on_a_plane() {
    let (system, state) = ellipsoid();
    let report = mobility(&system);
    assert_eq!((report.freedoms(), report.position_freedoms), (5, None));
    // Where it touches.
    near("R_z", &state.q[2..3], &[0.200_723_175_027_491_6], 1e-15);
    let contact = &system.elements[0].element;
    let found = contact.parameters(&state.q[7..], &SURFACE);
    let found: Vec<f64> = found.iter().map(|(_, x)| *x).collect();
    near("surface parameters", &found, &SURFACE, 1e-14);
    // v_z and the rates of the parameters fulfil C_q v = 0.
    let ws = solved(&system, &state);
    let mut rate = vec![0.0; system.rows];
    system.jac_mul(&ws, &state.v, &mut rate);
    near("rates", &rate, &[0.0; 6], 1e-15);
    // Four parameters, and the length of w.
    assert_eq!(rank_of_auxiliaries(&system.dense_jacobian(&ws), 1, 6), 5);
    // Accelerations and multipliers by (8.74).
    near(
        "acceleration",
        &ws.a[..3],
        &[0.0, 0.0, -3.378_287_572_067_939],
        1e-13,
    );
    let (pose, ..) = motion(&state, 0);
    let alpha = pose.axes * Vector3::new(ws.a[3], ws.a[4], ws.a[5]);
    let expected = [
        -18.960_616_461_234_13,
        -28.073_627_811_112_228,
        2.232_144_868_161_153,
    ];
    near("alpha", alpha.as_slice(), &expected, 1e-13);
    let second = [
        -35.851_620_347_016_99,
        -29.150_059_448_013_18,
        -6.893_115_508_469_907,
        -5.107_703_027_907_739,
    ];
    let [_, w] = over_parameters(SURFACE[0], SURFACE[1], SURFACE_RATES, second);
    let expected = [&w[..], &second[2..]].concat();
    near("s_ddot", &ws.a[6..], &expected, 1e-13);
    const NORMAL: f64 = 12.863_424_855_864_121;
    near(
        "lambda",
        &ws.lambda[..5],
        &[0.0, 0.0, -NORMAL, 0.0, 0.0],
        1e-13,
    );
}

#[test]
fn an_ellipsoid_rocks_on() {
    let (system, _) = ellipsoid();
    let instants: Vec<f64> = (0..=50).map(|k| 0.01 * f64::from(k)).collect();
    let report = run(&system, &instants, 1e-12);
    let normal = &report
        .results
        .channel("contact.normal_force")
        .unwrap()
        .values;
    near(
        "N",
        &[normal[0], normal[50]],
        &[12.863_424_855_864_121, 9.997_287_225_315_402],
        1e-10,
    );
    let least = normal.iter().copied().fold(f64::INFINITY, f64::min);
    assert!((least - 9.997_287_225_315_402).abs() < 1e-9, "{least}");
    let energy = &report.results.channel("energy.total").unwrap().values;
    // The other formulation leaves out the energy of the horizontal motion, 2 kg (0.5 m/s)^2 / 2.
    near(
        "energy",
        &energy[..1],
        &[4.355_364_078_913_404_5 + 0.25],
        1e-14,
    );
    assert!(spread(&report, "energy.total") < 1e-11);
    let at = |k: usize, of: &str| {
        let channel = report.results.channel(&format!("contact.point_{of}"));
        channel.unwrap().values[k]
    };
    let first = ["x", "y", "z"].map(|of| at(0, of));
    near(
        "point",
        &first,
        &[0.203_004_167_385_930_22, -0.232_809_479_863_771_57, 0.0],
        1e-14,
    );
    let last = ["x", "y", "z"].map(|of| at(50, of));
    near(
        "point",
        &last,
        &[0.191_557_054_146_271_44, -0.284_585_921_004_226_4, 0.0],
        1e-10,
    );
    let (pose, _, omega) = motion(&report.state, 0);
    near("z", &[pose.point.z], &[0.203_399_863_104_757_5], 1e-10);
    let expected = [
        -0.203_196_643_055_697_6,
        2.506_563_414_291_756_3,
        2.875_565_769_336_143_6,
    ];
    near("omega", omega.as_slice(), &expected, 1e-9);
    let expected = Matrix3::new(
        -0.166_029_144_231_687_24,
        -0.756_440_335_826_557_1,
        -0.632_639_187_531_328_3,
        0.871_557_228_805_905_8,
        -0.412_689_272_392_440_46,
        0.264_717_890_155_479_2,
        -0.461_326_695_717_756_9,
        -0.507_430_372_353_492_2,
        0.727_799_489_578_917_3,
    );
    assert!((pose.axes - expected).amax() < 1e-9);
}

/// Every formulation gives what (8.74) gives.
#[test]
fn formulations_agree_on_contacts() {
    let (system, state) = ellipsoid();
    let mut ws = solved(&system, &state);
    let (a, lambda) = (ws.a.clone(), ws.lambda.clone());
    for formulation in [
        Formulation::AugmentedDense,
        Formulation::Embedding(Basis::default()),
        Formulation::Embedding(Basis::Qr),
        Formulation::Embedding(Basis::Svd),
        Formulation::Elimination(Basis::default()),
        Formulation::Amalgamated(Basis::default()),
    ] {
        let found = formulation.solve(&system, &mut ws).unwrap();
        near(&format!("{formulation:?}: a"), &found.a, &a, 1e-12);
        near(
            &format!("{formulation:?}: lambda"),
            &found.lambda,
            &lambda,
            1e-12,
        );
    }
}

fn lying_cylinder() -> Value {
    json!({
        "gravity": [0.0, 3.0, -9.0],
        "body": [{"name": "log", "mass": 2, "inertia": [0.3, 0.3, 0.01], "position": [0, 0, 0.1],
                  "orientation": {"axis": [0, 1, 0], "angle": "90 deg"}}],
        "joint": [{"name": "contact", "kind": "surface-contact", "bodies": ["log", "ground"],
                   "at": [[0, 0, 0], [0, 0, 0]],
                   "surfaces": [{"kind": "cylinder", "radius": 0.1}, {"kind": "plane"}]}]
    })
}

/// A cylinder that lies on a plane touches it along a line (Shabana 8.6): C_s has rank 3 of 4. It slides and turns about
/// the normal and about its axis, but does not tilt.
#[test]
fn a_cylinder_on_a_plane() {
    let all = compiled(lying_cylinder());
    assert_eq!(all.warnings.len(), 1, "{:?}", all.warnings);
    assert_eq!(all.warnings[0].code, "line-contact");
    let system = all.system.running();
    let state = start(&system);
    let ws = solved(&system, &state);
    let jacobian = system.dense_jacobian(&ws);
    assert_eq!(rank_of_auxiliaries(&jacobian, 1, 5), 3);
    assert_eq!(rank_of_auxiliaries(&jacobian, 1, 6), 4);
    assert_eq!(mobility(&system).freedoms(), 4);
    near(
        "it slides",
        &ws.a[..6],
        &[0.0, 1.5 * 2.0, 0.0, 0.0, 0.0, 0.0],
        1e-14,
    );
    let report = run(&system, &[0.0, 1.0], 1e-11);
    let (pose, _, omega) = motion(&report.state, 0);
    near("place", pose.point.as_slice(), &[0.0, 1.5, 0.1], 1e-11);
    assert!(omega.amax() < 1e-12);
    let normal = &report
        .results
        .channel("contact.normal_force")
        .unwrap()
        .values;
    near("N", normal, &[18.0, 18.0], 1e-11);
}

/// z = x^2 + 2 y^2 and Lagrange's equations in x and y: with l = z'' + g,
/// x'' = -2 x l, y'' = -4 y l, l = (g + 2 x'^2 + 4 y'^2) / (1 + 4 x^2 + 16 y^2).
fn on_paraboloid([x, y, vx, vy]: [f64; 4]) -> ([f64; 4], f64) {
    let steep = 1.0 + 4.0 * x * x + 16.0 * y * y;
    let l = (G + 2.0 * vx * vx + 4.0 * vy * vy) / steep;
    ([vx, vy, -2.0 * x * l, -4.0 * y * l], l * steep.sqrt())
}

#[test]
fn a_point_on_a_surface() {
    let system = compiled(json!({
        "body": [{"name": "bead", "mass": 0.7, "inertia": [0.1, 0.2, 0.3], "position": [0.5, -0.3, 0.4],
                  "hold": ["x", "y"]}],
        "joint": [{"name": "bowl", "kind": "point-on-surface", "bodies": ["ground", "bead"],
                   "at": [[0, 0, 0], [0, 0, 0]],
                   "surface": {"kind": "expression", "x": "1 m * a", "y": "1 m * b", "z": "1 m * (a^2 + 2*b^2)"}}],
        "initial": [{"kind": "coordinate", "body": "bead", "coordinate": "x", "rate": 0.4},
                    {"kind": "coordinate", "body": "bead", "coordinate": "y", "rate": 1.1}]
    }))
    .system;
    assert_eq!(mobility(&system).freedoms(), 5);
    let mut y = [0.5, -0.3, 0.4, 1.1];
    let report = run(&system, &[0.0, 2.0], 1e-12);
    let normal = &report.results.channel("bowl.normal_force").unwrap().values;
    near(
        "N at the start",
        &normal[..1],
        &[0.7 * on_paraboloid(y).1],
        1e-12,
    );
    // Runge and Kutta's step of fourth order.
    let steps = 8000;
    let h = 2.0 / f64::from(steps);
    for _ in 0..steps {
        let moved = |k: &[f64; 4], h: f64| [0, 1, 2, 3].map(|i| y[i] + h * k[i]);
        let k1 = on_paraboloid(y).0;
        let k2 = on_paraboloid(moved(&k1, 0.5 * h)).0;
        let k3 = on_paraboloid(moved(&k2, 0.5 * h)).0;
        let k4 = on_paraboloid(moved(&k3, h)).0;
        y = [0, 1, 2, 3].map(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
    }
    let (pose, v, _) = motion(&report.state, 0);
    let found = [pose.point.x, pose.point.y, v.x, v.y];
    near("at the end", &found, &y, 1e-9);
    near(
        "N at the end",
        &normal[1..],
        &[0.7 * on_paraboloid(y).1],
        1e-9,
    );
    assert!(spread(&report, "energy.total") < 1e-10);
}

/// A ball in a bowl, by spheres, or by a bowl that is a surface of revolution or an ellipsoid, and either body first.
fn bowl(surface: Value, swapped: bool) -> System<Spatial> {
    let (bowl, ball) = (surface, json!({"kind": "sphere", "radius": 0.2}));
    let (bodies, surfaces) = if swapped {
        (["ball", "ground"], [ball, bowl])
    } else {
        (["ground", "ball"], [bowl, ball])
    };
    // 0.8 m from the centre of the bowl, 0.7 rad from the vertical.
    let (s, c) = 0.7_f64.sin_cos();
    compiled(json!({
        "body": [{"name": "ball", "mass": 1.5, "inertia": [0.024, 0.024, 0.024],
                  "position": [0.8 * s, 0, -0.8 * c], "velocity": [0, 2, 0], "angular_velocity": [1, 2, 3]}],
        "joint": [{"name": "contact", "kind": "surface-contact", "bodies": bodies, "at": [[0, 0, 0], [0, 0, 0]],
                   "surfaces": surfaces}]
    }))
    .system
}

/// Without friction a ball in a bowl is a spherical pendulum of the length R - r (Shabana 8.6, own data), with the force
/// N = m (g cos b + v^2/(R - r)); it keeps its spin.
#[test]
fn a_ball_in_a_bowl_is_a_spherical_pendulum() {
    let bowls = [
        json!({"kind": "sphere", "radius": 1.0, "inside": true}),
        json!({"kind": "revolved", "r": "1 m * cos(b)", "z": "1 m * sin(b)", "inside": true}),
        json!({"kind": "ellipsoid", "semi_axes": [1.0, 1.0, 1.0], "inside": true}),
    ];
    let pendulum = compiled(json!({
        "body": [{"name": "ball", "mass": 1.5, "inertia": [0.024, 0.024, 0.024],
                  "position": [0.8 * 0.7_f64.sin(), 0, -0.8 * 0.7_f64.cos()], "velocity": [0, 2, 0],
                  "angular_velocity": [1, 2, 3]}],
        "joint": [{"name": "rod", "kind": "distance", "bodies": ["ground", "ball"], "at": [[0, 0, 0], [0, 0, 0]]}]
    }))
    .system;
    let expected = run(&pendulum, &[0.0, 1.5], 1e-11).state;
    let normal = 1.5 * (G * 0.7_f64.cos() + 4.0 / 0.8);
    for surface in bowls {
        for swapped in [false, true] {
            let name = format!("{surface}, swapped {swapped}");
            let system = bowl(surface.clone(), swapped);
            let report = run(&system, &[0.0, 1.5], 1e-11);
            let force = &report
                .results
                .channel("contact.normal_force")
                .unwrap()
                .values;
            near(&format!("{name}: N"), &force[..1], &[normal], 1e-13);
            let (found, wanted) = (motion(&report.state, 0), motion(&expected, 0));
            assert!((found.0.point - wanted.0.point).amax() < 1e-9, "{name}");
            assert!((found.1 - wanted.1).amax() < 1e-9, "{name}");
            assert!(
                (found.2 - Vector3::new(1.0, 2.0, 3.0)).amax() < 1e-11,
                "{name}"
            );
            let point = ["x", "y", "z"].map(|of| {
                let channel = report.results.channel(&format!("contact.point_{of}"));
                channel.unwrap().values[0]
            });
            let (s, c) = 0.7_f64.sin_cos();
            near(&format!("{name}: point"), &point, &[s, 0.0, -c], 1e-14);
        }
    }
}

/// A ball on a cone, as a point at a distance and as two surfaces: the same motion.
#[test]
fn surfaces_and_balls_agree() {
    let start_at = |kind: Value, inertia: f64| {
        compiled(json!({
            "body": [{"name": "ball", "mass": 1.2, "inertia": [inertia, inertia, inertia],
                      "position": [0.75, 0.1, 0.45], "hold": ["x", "y"],
                      "orientation": {"axis": [1, 2, 3], "angle": 0.4}}],
            "initial": [{"kind": "coordinate", "body": "ball", "coordinate": "x", "rate": -0.3},
                        {"kind": "coordinate", "body": "ball", "coordinate": "y", "rate": 0.8}],
            "joint": [{"name": "contact", "kind": "surface-contact", "bodies": ["ground", "ball"],
                       "at": [[0, 0, 0], [0, 0, 0]],
                       "surfaces": [{"kind": "cone", "radius": 1.0, "height": 2.0}, kind]}]
        }))
        .system
    };
    // An ellipsoid with equal axes has coordinates of its own, w.
    let a = start_at(json!({"kind": "sphere", "radius": 0.15}), 0.01);
    let b = start_at(
        json!({"kind": "ellipsoid", "semi_axes": [0.15, 0.15, 0.15]}),
        0.01,
    );
    assert_eq!((a.aux, b.aux), (2, 5));
    let [a, b] = [a, b].map(|system| run(&system, &[0.0, 0.4], 1e-11));
    for channel in [
        "ball.x",
        "ball.y",
        "ball.z",
        "contact.normal_force",
        "contact.point_x",
    ] {
        let [a, b] = [&a, &b].map(|r| r.results.channel(channel).unwrap().values.clone());
        near(channel, &a, &b, 1e-9);
    }
}

/// The pose of the estimate is Shabana's z, x, z.
#[test]
fn the_ellipsoid_stands_as_the_book_says() {
    let (_, state) = ellipsoid();
    let expected: Rotation = EulerSequence::ZXZ.rotation(&Vector3::new(0.4, 0.9, -0.5));
    let SpatialPose { axes, .. } = motion(&state, 0).0;
    assert!((axes - expected.to_rotation_matrix().matrix()).amax() < 1e-15);
}

/// Euler angles about axes that stay are those of the reversed sequence.
#[test]
fn bodies_stand_by_angles_about_space_axes() {
    let body = |euler: &str, angles: [f64; 3], axes: &str| {
        let orientation = json!({"euler": euler, "angles": angles, "axes": axes});
        let body =
            json!({"name": "b", "mass": 1, "inertia": [1, 1, 1], "orientation": orientation});
        motion(&start(&compiled(json!({"body": [body]})).system), 0)
            .0
            .axes
    };
    let space = body("xyz", [0.3, 0.4, 0.5], "space");
    let turned = body("zyx", [0.5, 0.4, 0.3], "body");
    assert!((space - turned).amax() < 1e-15);
}
