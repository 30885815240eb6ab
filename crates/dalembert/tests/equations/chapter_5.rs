//! Virtual work, Lagrange, Gibbs-Appel and Hamilton: chapter 5.

use super::chapter_4::{four_bar, moving_pin};
use super::*;

#[test]
fn example_5_1_end_of_two_arms() {
    // The frame of the second link sits at its end, so the rows of B at its origin are the wanted ones.
    let (t2, t3, l3) = (50_f64.to_radians(), 20_f64.to_radians(), 0.7);
    let end = [t2.cos() + l3 * t3.cos(), t2.sin() + l3 * t3.sin()];
    let model = json!({
        "body": [rod("2", 1.0, 1.0, [0.5 * t2.cos(), 0.5 * t2.sin()], t2),
                 {"name": "3", "mass": 1.0, "inertia": 0.05, "center": [-0.5 * l3, 0.0], "position": end, "angle": t3}],
        "joint": [pin("O", ["2", "ground"], [[-0.5, 0.0], [0.0, 0.0]]),
                  pin("A", ["2", "3"], [[0.5, 0.0], [-l3, 0.0]])]
    });
    let b = at_estimate(model, &independent(&["2.angle", "3.angle"]))
        .independent
        .unwrap()
        .motions;
    near(
        &b.values[3],
        &[-0.766_044_443_118_978, -0.239_414_100_327_968_1],
        EXACT,
    );
    near(
        &b.values[4],
        &[0.642_787_609_686_539_4, 0.657_784_834_550_135_8],
        EXACT,
    );
    let det = b.values[3][0] * b.values[4][1] - b.values[3][1] * b.values[4][0];
    near(&[det], &[-0.35], EXACT);
}

/// The slider-crank of chapter 5: forces and state of section 5.7.
fn slider_crank(m: [f64; 3], j4: f64, speed: f64, forces: Value) -> Value {
    let (l2, l3) = (0.2_f64, 0.4_f64);
    let t2 = std::f64::consts::FRAC_PI_4;
    let t3 = -0.361_367_123_906_707_8_f64;
    let a = [l2 * t2.cos(), l2 * t2.sin()];
    json!({
        "body": [rod("2", m[0], l2, [0.5 * a[0], 0.5 * a[1]], t2),
                 rod("3", m[1], l3, [a[0] + 0.5 * l3 * t3.cos(), 0.5 * a[1]], t3),
                 {"name": "4", "mass": m[2], "inertia": j4, "position": [0.515_587_094_914_703_7, 0.0], "angle": 0.0}],
        "joint": [pin("O", ["2", "ground"], [[-0.1, 0.0], [0.0, 0.0]]),
                  pin("A", ["2", "3"], [[0.1, 0.0], [-0.2, 0.0]]),
                  pin("B", ["3", "4"], [[0.2, 0.0], [0.0, 0.0]])],
        "constraint": [
            {"name": "y", "kind": "fixed", "value": 0.0, "quantity": {"kind": "coordinate", "body": "4", "coordinate": "y"}},
            {"name": "turn", "kind": "fixed", "value": 0.0, "quantity": {"kind": "coordinate", "body": "4", "coordinate": "angle"}}
        ],
        "force": forces,
        "initial": [{"kind": "coordinate", "body": "2", "coordinate": "angle", "value": t2, "rate": speed}]
    })
}

#[test]
fn section_5_2_slider_crank_by_crank_or_by_slider() {
    let model = slider_crank([0.5, 0.8, 1.0], 0.01, 0.0, json!([]));
    let by = |name: &str, of: &[&str]| -> Vec<f64> {
        let b = at_start(model.clone(), &independent(&[name]))
            .independent
            .unwrap()
            .motions;
        assert_eq!(b.columns, [name]);
        of.iter()
            .map(|of| b.values[b.rows.iter().position(|r| r == of).unwrap()][0])
            .collect()
    };
    near(
        &by("2.angle", &["3.angle", "4.x"]),
        &[-0.377_964_473_009_227_25, -0.194_873_604_619_794_4],
        SOLVED,
    );
    near(
        &by("4.x", &["2.angle", "3.angle"]),
        &[-5.131_531_291_531_436, 1.939_536_520_334_038_7],
        SOLVED,
    );
}

#[test]
fn example_5_2_four_bar_by_any_of_its_angles() {
    let angles = ["2.angle", "3.angle", "4.angle"];
    for (name, expected) in [
        (
            "2.angle",
            [1.0, 0.010_895_883_828_571_136, 0.674_753_819_791_889_5],
        ),
        (
            "3.angle",
            [91.777_777_345_404_94, 1.0, 61.927_405_835_821_524],
        ),
        (
            "4.angle",
            [1.482_021_991_825_736_2, 0.016_147_939_454_320_824, 1.0],
        ),
    ] {
        let b = at_start(four_bar(0.0), &independent(&[name]))
            .independent
            .unwrap()
            .motions;
        let found = angles.map(|a| b.values[b.rows.iter().position(|r| r == a).unwrap()][0]);
        near(&found, &expected, SOLVED);
    }
}

#[test]
fn example_5_3_pendulum() {
    let t = 0.610_865_238_198_015_3_f64;
    let model = json!({
        "body": [rod("rod", 1.0, 1.2, [0.6 * t.cos(), 0.6 * t.sin()], t)],
        "joint": [pin("O", ["rod", "ground"], [[-0.6, 0.0], [0.0, 0.0]])]
    });
    let r = at_estimate(model, &independent(&["rod.angle"]));
    let (x, y) = (0.344_145_861_810_627_6, 0.491_491_226_573_395_06);
    near_rows(&r.jacobian, &[&[1.0, 0.0, x], &[0.0, 1.0, -y]], EXACT);
    near_rows(
        &r.independent.unwrap().motions,
        &[&[-x], &[y], &[1.0]],
        EXACT,
    );
}

#[test]
fn example_5_4_generalized_force_of_the_crank() {
    let mut model = no_gravity(four_bar(0.0));
    model["force"] = json!([
        {"name": "M2", "kind": "moment", "body": "2", "value": 2.0},
        {"name": "F3", "kind": "force", "body": "3", "value": [3.0, -1.0]},
        {"name": "M4", "kind": "moment", "body": "4", "value": -0.5}
    ]);
    let e = at_start(model, &independent(&["2.angle"]))
        .independent
        .unwrap();
    near(&e.force.values, &[1.026_777_937_861_195_6], SOLVED);
    near(
        &e.motions.values.concat(),
        &[
            -0.093_969_262_078_590_84,
            0.034_202_014_332_566_89,
            1.0,
            -0.188_440_156_273_776_2,
            0.070_524_683_421_530_87,
            0.010_895_883_828_571_113,
            -0.094_470_894_195_185_35,
            0.036_322_669_088_963_98,
            0.674_753_819_791_889_8,
        ],
        SOLVED,
    );
}

#[test]
fn example_5_5_forces_of_a_spring_in_the_four_bar() {
    let mut model = no_gravity(four_bar(150.0));
    model["force"] = json!([{"name": "spring", "kind": "spring-damper", "bodies": ["2", "4"],
        "at": [[0.03, 0.0], [-0.05, 0.0]], "stiffness": 250.0, "damping": 10.0, "free_length": 0.35}]);
    let r = at_start(model, &independent(&["2.angle"]));
    near(
        &r.applied.values,
        &[
            3.528_773_002_850_566_6,
            0.603_390_792_719_865_5,
            -0.093_287_704_373_993_13,
            0.0,
            0.0,
            0.0,
            -3.528_773_002_850_566_6,
            -0.603_390_792_719_865_5,
            0.153_858_374_101_480_7,
        ],
        SOLVED,
    );
    let b = dense(&r.independent.unwrap().motions);
    near(
        (b.transpose() * vector(&r.applied)).as_slice(),
        &[0.011_019_383_573_804_584],
        1e-10,
    );
}

/// The same forces in the three link angles: where the last bar hangs on the other two, and where it turns about
/// its own pivot. The loop is open there, so that the three angles are independent.
#[test]
fn example_5_5_forces_of_the_spring_in_three_angles() {
    let angles = ["2.angle", "3.angle", "4.angle"];
    for (missing, expected) in [
        (
            "C",
            [
                0.217_671_310_205_984_04,
                0.090_045_437_996_977_3,
                -0.307_716_748_202_961_4,
            ],
        ),
        (
            "B",
            [-0.404_246_718_953_970_3, 0.0, 0.615_433_496_405_922_8],
        ),
    ] {
        let mut model = no_gravity(four_bar(150.0));
        model["force"] = json!([{"name": "spring", "kind": "spring-damper", "bodies": ["2", "4"],
            "at": [[0.03, 0.0], [-0.05, 0.0]], "stiffness": 250.0, "damping": 10.0, "free_length": 0.35}]);
        // Rates as in the closed loop.
        model["initial"] = json!([
            {"kind": "coordinate", "body": "2", "coordinate": "angle", "value": 1.221_730_476_396_030_6, "rate": 150.0},
            {"kind": "coordinate", "body": "3", "coordinate": "angle", "value": 0.232_276_418_925_485_5, "rate": 1.634_382_574_285_668},
            {"kind": "coordinate", "body": "4", "coordinate": "angle", "value": 4.345_328_481_925_324, "rate": 101.213_072_968_783_46}
        ]);
        let joints = model["joint"].as_array_mut().unwrap();
        joints.retain(|j| j["name"] != missing);
        let r = at_start(model, &independent(&angles));
        let b = dense(&r.independent.as_ref().unwrap().motions);
        near(
            (b.transpose() * vector(&r.applied)).as_slice(),
            &expected,
            SOLVED,
        );
    }
}

/// Forces of the slider crank in crank angle, rod angle and slider position, before the last pin ties them.
#[test]
fn section_5_3_forces_in_three_coordinates() {
    let forces = json!([
        {"name": "M2", "kind": "moment", "body": "2", "value": 2.0},
        {"name": "F3", "kind": "force", "body": "3", "value": [3.0, -1.0]},
        {"name": "F4", "kind": "force", "body": "4", "value": [-30.0, 0.0]}
    ]);
    let mut model = no_gravity(slider_crank([0.5, 0.8, 1.0], 0.01, 0.0, forces));
    model["joint"]
        .as_array_mut()
        .unwrap()
        .retain(|j| j["name"] != "B");
    let r = at_start(model, &independent(&["2.angle", "3.angle", "4.x"]));
    let b = dense(&r.independent.unwrap().motions);
    near(
        (b.transpose() * vector(&r.applied)).as_slice(),
        &[1.434_314_575_050_762, 0.025_049_165_017_267_2, -30.0],
        SOLVED,
    );
}

#[test]
fn section_5_4_gravity_away_from_the_centre_of_mass() {
    let body = json!([{"name": "plate", "mass": 3.0, "inertia": 1.0, "center": [0.2, -0.1], "angle": 0.436_332_312_998_582_4}]);
    let r = at_estimate(json!({"body": body}), &Equations::default());
    near(
        &r.applied.values,
        &[0.0, -29.43, -6.578_293_178_800_600_5],
        EXACT,
    );
}

#[test]
fn problems_5_20_to_5_34_mass_matrix_of_three_links() {
    let angles = [45.0_f64, 30.0, 45.0].map(f64::to_radians);
    let (mut bodies, mut at) = (Vec::new(), [0.0_f64, 0.0]);
    for (k, a) in angles.iter().enumerate() {
        bodies.push(rod(
            &(k + 2).to_string(),
            1.0,
            1.0,
            [at[0] + 0.5 * a.cos(), at[1] + 0.5 * a.sin()],
            *a,
        ));
        at = [at[0] + a.cos(), at[1] + a.sin()];
    }
    let model = json!({
        "body": bodies,
        "joint": [pin("O", ["2", "ground"], [[-0.5, 0.0], [0.0, 0.0]]),
                  pin("A", ["2", "3"], [[0.5, 0.0], [-0.5, 0.0]]),
                  pin("B", ["3", "4"], [[0.5, 0.0], [-0.5, 0.0]])]
    });
    let e = at_estimate(model, &independent(&["2.angle", "3.angle", "4.angle"]))
        .independent
        .unwrap();
    near(
        dense(&e.mass).as_slice(),
        &[
            2.333_333_333_333_333_5,
            1.448_888_739_433_602_5,
            0.5,
            1.448_888_739_433_602_5,
            1.333_333_333_333_333_3,
            0.482_962_913_144_534_16,
            0.5,
            0.482_962_913_144_534_16,
            0.333_333_333_333_333_3,
        ],
        SOLVED,
    );
}

#[test]
fn section_5_7_slider_crank_in_one_coordinate() {
    let model = slider_crank(
        [0.5, 0.8, 1.0],
        0.01,
        10.0,
        json!([
            {"name": "M2", "kind": "moment", "body": "2", "value": 3.0},
            {"name": "F4", "kind": "force", "body": "4", "value": [-30.0, 0.0]}
        ]),
    );
    let r = at_start(model, &independent(&["2.angle"]));
    let e = r.independent.as_ref().unwrap();
    near(
        &e.accelerations.as_ref().unwrap().values,
        &[49.688_511_543_586_48],
        SOLVED,
    );
    near(&e.mass.values[0], &[0.072_785_058_107_564_33], SOLVED);
    let b = dense(&e.motions);
    near(
        (b.transpose() * vector(&r.applied)).as_slice(),
        &[7.944_434_860_546_627],
        SOLVED,
    );
    let a = r.accelerations.as_ref().unwrap();
    near(
        &[a.get("3.angle").unwrap(), a.get("4.x").unwrap()],
        &[13.616_462_749_177_762, -24.588_718_524_743_13],
        SOLVED,
    );
    let l = multipliers(&r);
    near(
        &[-l[0], -l[1], l[2], l[3], l[4], l[5], -l[6]],
        &[
            -18.184_154_939_805_186,
            6.652_717_944_442_449,
            -12.891_866_860_895_645,
            3.526_497_677_398_382,
            5.411_281_475_256_872,
            -1.475_454_749_872_122_7,
            11.285_454_749_872_123,
        ],
        SOLVED,
    );
}

#[test]
fn example_5_9_two_arms() {
    let (t2, t3) = (50_f64.to_radians(), 20_f64.to_radians());
    let phi = 75_f64.to_radians();
    let model = json!({
        "body": [
            {"name": "2", "mass": 2.0, "inertia": 0.18, "angle": t2, "position": [0.4 * t2.cos(), 0.4 * t2.sin()]},
            {"name": "3", "mass": 1.5, "inertia": 0.09, "angle": t3,
             "position": [t2.cos() + 0.35 * t3.cos(), t2.sin() + 0.35 * t3.sin()]}
        ],
        "joint": [pin("O", ["2", "ground"], [[-0.4, 0.0], [0.0, 0.0]]),
                  pin("A", ["2", "3"], [[0.6, 0.0], [-0.35, 0.0]])],
        "force": [{"name": "M2", "kind": "moment", "body": "2", "value": 6.0},
                  {"name": "F3", "kind": "force", "body": "3", "at": [0.45, 0.0],
                   "value": [4.0 * phi.cos(), 4.0 * phi.sin()]}],
        "initial": [{"kind": "coordinate", "body": "2", "coordinate": "angle", "value": t2, "rate": 2.0},
                    {"kind": "coordinate", "body": "3", "coordinate": "angle", "value": t3, "rate": -3.0}]
    });
    let r = at_start(model, &independent(&["2.angle", "3.angle"]));
    let e = r.independent.as_ref().unwrap();
    near(
        &e.accelerations.as_ref().unwrap().values,
        &[-5.811_675_630_105_523_5, 5.384_440_025_537_777],
        SOLVED,
    );
    near_rows(
        &e.mass,
        &[
            &[2.0, 0.454_663_336_986_830_2],
            &[0.454_663_336_986_830_2, 0.27375],
        ],
        SOLVED,
    );
    let q = dense(&e.motions).transpose() * vector(&r.applied);
    near(
        q.as_slice(),
        &[-6.812_743_790_394_589, -2.218_365_378_477_850_3],
        SOLVED,
    );
    let l = multipliers(&r);
    near(
        &[-l[0], -l[1], l[2], l[3]],
        &[
            -2.116_198_781_302_343,
            15.871_946_785_380_167,
            -3.620_879_887_627_275,
            1.691_827_472_600_131_2,
        ],
        SOLVED,
    );
}

#[test]
fn section_5_8_lagrangian_of_a_pendulum_on_a_moving_base() {
    // Between a state and its neighbours along the motion: d/dt(dT/dtheta') - dT/dtheta = Q. Here T and L are read
    // from the report, their slopes by differences; 5.160 has the angle's equation in closed form.
    let (theta, rate, t) = (0.7, 2.0, 0.3);
    let of = |theta: f64, rate: f64| {
        at_estimate(
            moving_pin(t, theta, rate, 0.5),
            &independent(&["rod.angle"]),
        )
        .scalars
        .lagrangian
    };
    let h = 1e-3;
    let momentum = (of(theta, rate + h) - of(theta, rate - h)) / (2.0 * h);
    let r = at_estimate(
        moving_pin(t, theta, rate, 0.5),
        &independent(&["rod.angle"]),
    );
    let p = &r.independent.as_ref().unwrap().momenta.values;
    // T is of second degree in the rate: the central difference is exact up to rounding.
    near(p, &[momentum], 1e-12);
    let z_rate = 0.3 * (3.0_f64 * t).cos();
    near(
        p,
        &[(0.064 + 1.2 * 0.16) * rate - 1.2 * 0.4 * theta.sin() * z_rate],
        SOLVED,
    );
}

#[test]
fn section_5_9_gibbs_appel() {
    let states = [0.5 - 3.0, 0.5, 0.5 + 3.0].map(|moment| {
        at_estimate(
            moving_pin(0.25, 0.7, 2.0, moment),
            &independent(&["rod.angle"]),
        )
    });
    let s = states.each_ref().map(|r| r.scalars.gibbs_appel.unwrap());
    let u = states.each_ref().map(|r| {
        r.independent
            .as_ref()
            .unwrap()
            .accelerations
            .as_ref()
            .unwrap()
            .values[0]
    });
    // S is of second degree in the acceleration: its slope at the middle is exact (5.163).
    let slope = (s[2] - s[0]) / (u[2] - u[0]);
    let e = states[1].independent.as_ref().unwrap();
    let b = dense(&e.motions);
    near(
        &[slope],
        (b.transpose() * vector(&states[1].applied)).as_slice(),
        SOLVED,
    );
    let z_second = -0.9 * (0.75_f64).sin();
    near(
        &[slope],
        &[(0.064 + 1.2 * 0.16) * u[1] - 1.2 * 0.4 * 0.7_f64.sin() * z_second],
        SOLVED,
    );
    // The value itself.
    let a = accelerations(&states[1]);
    let expected = 0.6 * (a[0] * a[0] + a[1] * a[1]) + 0.032 * (a[2] * a[2] + 16.0);
    near(&[s[1]], &[expected], EXACT);
}

#[test]
fn example_5_10_hamiltonian_of_a_pendulum_on_a_moving_base() {
    let start = at_estimate(
        moving_pin(0.0, 0.698_131_700_797_731_8, 2.0, 0.5),
        &independent(&["rod.angle"]),
    );
    near(
        &start.independent.unwrap().momenta.values,
        &[0.419_438_584_205_138_46],
        EXACT,
    );
    let end = at_estimate(
        moving_pin(2.0, 0.218_869_583_576_368_93, 2.890_553_397_482_170_4, 0.5),
        &independent(&["rod.angle"]),
    );
    near(
        &end.independent.as_ref().unwrap().momenta.values,
        &[0.709_960_803_979_180_2],
        SOLVED,
    );
    let s = &end.scalars;
    near(
        &[s.hamiltonian, s.energy],
        &[2.042_098_592_350_622, 2.054_889_790_557_264_3],
        SOLVED,
    );
    let [t2, t1, t0] = [s.kinetic_2, s.kinetic_1, s.kinetic_0].map(Option::unwrap);
    near(&[t2 + t1 + t0], &[s.kinetic], EXACT);
    near(&[t2 - t0 + s.potential], &[s.hamiltonian], EXACT);
    assert!(
        end.notes
            .iter()
            .any(|n| n.contains("H = T2 - T0 + V is not T + V")),
        "{:?}",
        end.notes
    );
}

#[test]
fn problems_5_44_to_5_46_rod_on_a_sprung_slider() {
    let theta = -1.047_197_551_196_597_6_f64;
    let (s, c) = theta.sin_cos();
    let model = json!({
        "body": [{"name": "block", "mass": 2.0, "inertia": 0.01, "position": [0.05, 0.0], "angle": 0.0},
                 {"name": "rod", "mass": 1.2, "inertia": 0.081, "position": [0.05 + 0.45 * c, 0.45 * s], "angle": theta,
                  "velocity": [-0.45 * s, 0.45 * c], "angular_velocity": 1.0}],
        "joint": [{"name": "guide", "kind": "prismatic", "bodies": ["ground", "block"], "at": [[0, 0], [0, 0]], "angles": [0, 0]},
                  pin("A", ["block", "rod"], [[0.0, 0.0], [-0.45, 0.0]])],
        "force": [{"name": "k", "kind": "joint-spring", "joint": "guide", "stiffness": 150.0},
                  {"name": "F", "kind": "force", "body": "block", "value": ["5 N * sin(2 rad/s * t)", 0.0]},
                  {"name": "M", "kind": "moment", "body": "rod", "value": 0.4}]
    });
    let r = at_estimate(model, &independent(&["block.x", "rod.angle"]));
    let e = r.independent.unwrap();
    near(
        &e.accelerations.unwrap().values,
        &[-1.577_933_118_488_404, -4.662_881_821_959_17],
        SOLVED,
    );
    // Scleronomic: the Hamiltonian is the energy.
    near(&[r.scalars.hamiltonian], &[r.scalars.energy], EXACT);
}
