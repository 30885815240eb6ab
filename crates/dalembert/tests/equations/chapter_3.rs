//! Constraints: chapter 3.

use super::*;

fn two_rods(rest: Value) -> Value {
    let mut model = json!({
        "body": [rod("rod 2", 1.0, 1.0, [0.204_243_720_442_078_7, 0.456_381_970_130_260_5], 1.15),
                 rod("rod 3", 1.0, 0.6, [0.617_499_453_688_307, 0.697_557_112_990_664_1], -0.8)],
        "joint": [pin("O", ["rod 2", "ground"], [[-0.5, 0.0], [0.0, 0.0]]),
                  pin("A", ["rod 2", "rod 3"], [[0.5, 0.0], [-0.3, 0.0]])]
    });
    for (key, value) in rest.as_object().unwrap() {
        model[key] = value.clone();
    }
    model
}

#[test]
fn example_3_7_two_rods_have_two_freedoms() {
    // The book counts the ground's three coordinates and rows too: 9 coordinates, 7 constraints.
    let report = at_estimate(two_rods(json!({})), &Equations::default());
    assert_eq!(report.positions.rows.len() + 3, 9);
    assert_eq!(report.residual.rows.len() + 3, 7);
    assert_eq!(report.independent.unwrap().mass.rows.len(), 2);
}

#[test]
fn examples_3_10_to_3_12_driven_rods() {
    let mut model = two_rods(json!({
        "analysis": {"start": 0.25},
        "driver": [
            {"name": "turn 2", "kind": "coordinate", "body": "rod 2", "coordinate": "angle", "value": "0.4 + 3 rad/s * t"},
            {"name": "turn 3", "kind": "coordinate", "body": "rod 3", "coordinate": "angle", "value": "-0.3 - 2 rad/s * t"}
        ]
    }));
    model["body"][0]["velocity"] = json!([-1.369_145_910_390_781_5, 0.612_731_161_326_236_1]);
    model["body"][0]["angular_velocity"] = json!(3.0);
    model["body"][1]["velocity"] = json!([-3.168_705_475_321_276_7, 0.807_438_297_044_172_9]);
    model["body"][1]["angular_velocity"] = json!(-2.0);
    let r = at_estimate(model, &Equations::default());
    near(
        &r.residual
            .values
            .iter()
            .map(|x| x + 1.0)
            .collect::<Vec<_>>(),
        &[1.0; 6],
        1e-15,
    );
    near_rows(
        &r.jacobian,
        &[
            &[1.0, 0.0, 0.456_381_970_130_260_5, 0.0, 0.0, 0.0],
            &[0.0, 1.0, -0.204_243_720_442_078_7, 0.0, 0.0, 0.0],
            &[
                1.0,
                0.0,
                -0.456_381_970_130_260_5,
                -1.0,
                0.0,
                0.215_206_827_269_856_82,
            ],
            &[
                0.0,
                1.0,
                0.204_243_720_442_078_7,
                0.0,
                -1.0,
                0.209_012_012_804_149_6,
            ],
            &[0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
            &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
        ],
        EXACT,
    );
    near(
        &r.time_derivative.values,
        &[0.0, 0.0, 0.0, 0.0, -3.0, 2.0],
        EXACT,
    );
    near(
        &r.qd.values,
        &[
            -1.838_193_483_978_708_2,
            -4.107_437_731_172_345,
            2.674_241_535_195_306_6,
            3.246_610_422_092_917_5,
            0.0,
            0.0,
        ],
        EXACT,
    );
    near(
        accelerations(&r),
        &[
            -1.838_193_483_978_708_2,
            -4.107_437_731_172_345,
            0.0,
            -4.512_435_019_174_015,
            -7.354_048_153_265_262,
            0.0,
        ],
        EXACT,
    );
    // Every freedom is driven.
    assert!(r.independent.unwrap().mass.rows.is_empty());
}

#[test]
fn example_3_14_prismatic_joint_off_the_constraints() {
    // The book's normal h = A (u_P - u_Q) of the slide is not a unit vector; ours is.
    let (h, c) = ([0.1_f64 - 0.3, 0.2_f64 + 0.1], 0.2);
    let length = h[0].hypot(h[1]);
    let axis = h[1].atan2(h[0]) - std::f64::consts::FRAC_PI_2;
    let model = json!({
        "body": [
            {"name": "i", "mass": 1, "inertia": 1, "position": [-1.980_796_468_223_927, -0.347_912_149_326_152_6],
             "angle": 0.156_348_969_103_980_05, "velocity": [-1.706_270_190_625_012_6, 1.950_775_395_231_789_7],
             "angular_velocity": -0.509_652_181_751_653_5},
            {"name": "j", "mass": 1, "inertia": 1, "position": [1.230_290_680_727_720_7, 1.202_379_848_784_411_3],
             "angle": -0.387_326_817_407_952_3, "velocity": [-0.438_074_301_611_186_4, -1.252_795_360_049_926_2],
             "angular_velocity": 0.777_490_355_831_910_1}
        ],
        "joint": [{"name": "slide", "kind": "prismatic", "bodies": ["i", "j"],
                   "at": [[0.1, 0.2], [0.5, 0.6]], "angles": [axis, axis + c]}]
    });
    let r = at_estimate(model, &Equations::default());
    near(
        &[r.residual.values[0], length * r.residual.values[1]],
        &[0.343_675_786_511_932_37, 0.484_453_462_410_585_7],
        EXACT,
    );
    near(
        &r.jacobian.values[0],
        &[0.0, 0.0, 1.0, 0.0, 0.0, -1.0],
        EXACT,
    );
    let second: Vec<f64> = r.jacobian.values[1].iter().map(|x| length * x).collect();
    near(
        &second,
        &[
            -0.244_274_302_216_135_55,
            0.265_198_162_280_246_8,
            1.502_723_248_115_644,
            0.244_274_302_216_135_55,
            -0.265_198_162_280_246_8,
            -0.272_452_341_222_233_4,
        ],
        EXACT,
    );
    // The printed Q_d has a term too many; this is its value without.
    near(
        &[r.qd.values[0], length * r.qd.values[1]],
        &[0.0, -0.239_927_704_901_881_98],
        1e-13,
    );
}
