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

/// Three bars that turn about one point, their angles tied by the loop equations of a four-bar linkage: the
/// book's three coordinates. Lengths: ground, crank, coupler, rocker; angles and rates of the three bars.
pub fn loop_equations(lengths: [f64; 4], angles: [f64; 3], rates: [f64; 3]) -> Value {
    let [ground, crank, coupler, rocker] = lengths;
    let names = ["crank", "coupler", "rocker"];
    let bars: Vec<Value> = (0..3)
        .map(|k| {
            json!({"name": names[k], "mass": 1.0, "inertia": 1.0, "angle": angles[k], "angular_velocity": rates[k]})
        })
        .collect();
    let pins: Vec<Value> = names
        .iter()
        .map(|n| {
            pin(
                &format!("pin of {n}"),
                ["ground", n],
                [[0.0, 0.0], [0.0, 0.0]],
            )
        })
        .collect();
    let side = |function: &str| {
        format!(
            "{crank}*{function}(crank.angle) + {coupler}*{function}(coupler.angle) + {rocker}*{function}(rocker.angle)"
        )
    };
    json!({
        "body": bars,
        "joint": pins,
        "constraint": [
            {"name": "along", "kind": "expression", "expression": format!("{} - {ground}", side("cos"))},
            {"name": "across", "kind": "expression", "expression": side("sin")}
        ]
    })
}

/// Residuals and gradients by the three angles of the rows behind those of the pins.
fn of_angles(r: &EquationsReport) -> (DVector<f64>, DMatrix<f64>) {
    let (c, all) = (vector(&r.residual), dense(&r.jacobian));
    let rows = c.len() - 6;
    (
        c.rows(6, rows).into_owned(),
        DMatrix::from_fn(rows, 3, |i, j| all[(6 + i, 3 * j + 2)]),
    )
}

#[test]
fn example_3_13_newton_steps_of_a_four_bar() {
    let degree = std::f64::consts::PI / 180.0;
    let at = |angles: [f64; 3], rates: [f64; 3]| {
        let mut model = loop_equations([0.35, 0.2, 0.35, 0.25], angles, rates);
        model["driver"] = json!([{"name": "motor", "kind": "angle", "joint": "pin of crank",
            "value": format!("{} + 5*(t - 0.02 s)", 63.0 * degree)}]);
        model["analysis"] = json!({"start": 0.02});
        at_estimate(model, &Equations::default())
    };
    let (c, c_q) = of_angles(&at([63.0, 10.0, 245.0].map(|a| a * degree), [0.0; 3]));
    near(
        c.as_slice(),
        &[-0.020_173_751_932_992_645, 0.012_401_220_261_936_685, 0.0],
        EXACT,
    );
    near(
        c_q.transpose().as_slice(),
        &[
            -0.178_201_304_837_673_57,
            -0.060_776_862_183_425_61,
            0.226_576_946_759_162_5,
            0.090_798_099_947_909_37,
            0.344_682_713_554_272_77,
            -0.105_654_565_435_174_79,
            1.0,
            0.0,
            0.0,
        ],
        EXACT,
    );
    let step = |c: DVector<f64>, c_q: DMatrix<f64>| -c_q.lu().solve(&c).unwrap();
    near(
        step(c, c_q).as_slice(),
        &[0.0, -0.009_464_583_481_204_884, 0.086_498_315_594_145_45],
        SOLVED,
    );
    // The book stops here and takes rates and accelerations at this pose.
    let r = at(
        [
            1.099_557_428_756_427_6,
            0.165_068_341_718_228_07,
            4.362_554_982_980_253,
        ],
        [5.0, -0.397_568_018_194_187_7, 3.696_462_652_469_820_8],
    );
    let (c, c_q) = of_angles(&r);
    near(
        c.as_slice(),
        &[
            0.000_355_128_556_838_835_15,
            0.000_855_809_826_403_458_6,
            0.0,
        ],
        SOLVED,
    );
    let rates = c_q.clone()
        * DVector::from_column_slice(&[5.0, -0.397_568_018_194_187_7, 3.696_462_652_469_820_8]);
    near(rates.as_slice(), &[0.0, 0.0, 5.0], SOLVED);
    near(
        step(c, c_q).as_slice(),
        &[0.0, -0.003_038_844_108_889_185, -0.002_256_255_390_615_012],
        SOLVED,
    );
    near(
        &r.qd.values[6..],
        &[1.153_729_472_485_241, 1.255_069_867_737_167_2, 0.0],
        SOLVED,
    );
    let angular = [2, 5, 8].map(|k| accelerations(&r)[k]);
    near(
        &angular,
        &[0.0, 5.168_685_207_061_56, 6.178_176_201_904_22],
        SOLVED,
    );
    // The converged answer.
    let r = at(
        [
            1.099_557_428_756_427_6,
            0.162_030_026_665_343_97,
            4.360_304_717_755_604,
        ],
        [5.0, -0.390_060_448_996_733_5, 3.703_093_258_639_361],
    );
    assert!(r.residual.values.iter().all(|c| c.abs() < 1e-15));
    let angular = [2, 5, 8].map(|k| accelerations(&r)[k]);
    near(
        &angular,
        &[0.0, 5.127_100_640_852_201, 6.092_779_717_079_026_5],
        SOLVED,
    );
}

#[test]
fn example_5_2_gradients_of_the_loop_equations() {
    let angles = [
        1.221_730_476_396_030_6,
        0.232_276_418_925_485_5,
        4.345_328_481_925_324,
    ];
    let r = at_estimate(
        loop_equations([0.35, 0.2, 0.4, 0.3], angles, [0.0; 3]),
        &independent(&["crank.angle"]),
    );
    near(
        of_angles(&r).1.transpose().as_slice(),
        &[
            -0.187_938_524_157_181_68,
            -0.092_077_361_412_232_22,
            0.280_015_885_569_413_87,
            0.068_404_028_665_133_77,
            0.389_257_960_118_173_04,
            -0.107_661_988_783_306_95,
        ],
        EXACT,
    );
    let b = r.independent.unwrap().motions;
    near(
        &[b.values[5][0], b.values[8][0]],
        &[0.010_895_883_828_571_136, 0.674_753_819_791_889_5],
        SOLVED,
    );
}

/// A squared distance, which the book takes for its row, and the joint, whose row is the distance itself.
#[test]
fn problem_3_22_massless_rod() {
    let bodies = json!([
        {"name": "i", "mass": 1, "inertia": 1, "position": [0.2, 0.1], "angle": 0.3, "velocity": [1.0, -2.0], "angular_velocity": 0.5},
        {"name": "j", "mass": 1, "inertia": 1, "position": [0.9, -0.4], "angle": 1.1, "velocity": [0.3, 0.7], "angular_velocity": -1.5}
    ]);
    let gradient = [
        -0.876_741_639_971_781_3,
        1.885_243_828_734_256_3,
        0.262_104_835_977_437_3,
        0.876_741_639_971_781_3,
        -1.885_243_828_734_256_3,
        0.619_195_024_150_651_5,
    ];
    let squared = json!({
        "body": bodies,
        "trace": [{"name": "P", "body": "i", "at": [0.1, 0.2]}, {"name": "Q", "body": "j", "at": [-0.3, 0.1]}],
        "constraint": [{"name": "rod", "kind": "expression", "expression": "(P.x - Q.x)^2 + (P.y - Q.y)^2 - 1 m^2"}]
    });
    let r = at_estimate(squared, &Equations::default());
    near(&r.jacobian.values[0], &gradient, EXACT);
    near(&r.qd.values, &[-19.345_069_447_109_754], EXACT);
    let joint = json!({
        "body": bodies,
        "joint": [{"name": "rod", "kind": "distance", "bodies": ["i", "j"], "at": [[0.1, 0.2], [-0.3, 0.1]], "length": 1.0}]
    });
    let r = at_estimate(joint, &Equations::default());
    // C = 1 - l, so the square's gradient is -2 l times this one, and (l^2)'' = 2 l l'' + 2 l'^2.
    let length = 1.0 - r.residual.values[0];
    let scaled: Vec<f64> = r.jacobian.values[0]
        .iter()
        .map(|x| -2.0 * length * x)
        .collect();
    near(&scaled, &gradient, EXACT);
    let rate: f64 = -(dense(&r.jacobian) * vector(&r.velocities))[0];
    near(
        &[-2.0 * length * r.qd.values[0] - 2.0 * rate * rate],
        &[-19.345_069_447_109_754],
        EXACT,
    );
}
