//! Constrained dynamics: chapter 6.

use super::*;

/// Mass, place of the centre, inertia about it and about the end of the rod. (The book adds the masses to 36.227 kg.)
#[test]
fn example_6_1_body_of_parts() {
    let hammer = json!([{"name": "hammer", "shape": [
        {"kind": "lump", "mass": 0.62, "inertia": 0.05167, "at": [0.5, 0.0]},
        {"kind": "lump", "mass": 39.45, "inertia": 4.109, "at": [1.5, 0.0]},
        {"kind": "lump", "mass": 3.873, "inertia": 0.03026, "at": [1.5, 0.0], "cut": true}
    ]}]);
    let r = at_estimate(json!({"body": hammer}), &Equations::default());
    let m = &r.mass.values;
    near(
        &[m[0][0], m[1][2] / m[0][0], m[2][2], 150.0 * m[2][2]],
        &[
            36.197,
            1.482_871_508_688_565_3,
            84.333_660_000_000_01,
            12_650.049,
        ],
        EXACT,
    );
    let center = Equations {
        frame: ReferenceFrame::Center,
        ..Equations::default()
    };
    let r = at_estimate(json!({"body": hammer}), &center);
    near(&[r.mass.values[2][2]], &[4.739_790_335_386_911], SOLVED);
}

#[test]
fn example_6_2_rod_with_its_frame_at_one_end() {
    let body = json!([{"name": "rod", "mass": 2.0, "inertia": 0.375, "center": [0.75, 0.0],
                       "angle": 0.7, "angular_velocity": 3.0}]);
    let r = at_estimate(no_gravity(json!({"body": body})), &Equations::default());
    let (x, y) = (-0.966_326_530_856_536_5, 1.147_263_280_926_732_7);
    near_rows(
        &r.mass,
        &[&[2.0, 0.0, x], &[0.0, 2.0, y], &[x, y, 1.5]],
        EXACT,
    );
    near(
        &r.centrifugal.values,
        &[10.325_369_528_340_595, 8.696_938_777_708_828, 0.0],
        EXACT,
    );
    near(&r.velocities.values, &[0.0, 0.0, 3.0], EXACT);
    // Example 6.3: at the centre of mass M is diagonal and nothing is centrifugal.
    let center = Equations {
        frame: ReferenceFrame::Center,
        ..Equations::default()
    };
    let r = at_estimate(no_gravity(json!({"body": body})), &center);
    near_rows(
        &r.mass,
        &[&[2.0, 0.0, 0.0], &[0.0, 2.0, 0.0], &[0.0, 0.0, 0.375]],
        EXACT,
    );
    assert_eq!(r.centrifugal.values, [0.0; 3]);
}

fn manipulator() -> Value {
    let (ti, tj) = (0.4_f64, 1.1_f64);
    no_gravity(json!({
        "body": [{"name": "i", "mass": 2.0, "inertia": 0.18, "angle": ti, "position": [0.5 * ti.cos(), 0.5 * ti.sin()]},
                 {"name": "j", "mass": 1.5, "inertia": 0.1, "angle": tj,
                  "position": [ti.cos() + 0.4 * tj.cos(), ti.sin() + 0.4 * tj.sin()]}],
        "joint": [pin("O", ["i", "ground"], [[-0.5, 0.0], [0.0, 0.0]]),
                  pin("A", ["i", "j"], [[0.5, 0.0], [-0.4, 0.0]])],
        "force": [{"name": "M_i", "kind": "moment", "body": "i", "value": 3.0},
                  {"name": "M_j", "kind": "moment", "body": "j", "value": -1.0}],
        "initial": [{"kind": "coordinate", "body": "i", "coordinate": "angle", "value": ti, "rate": 2.0},
                    {"kind": "coordinate", "body": "j", "coordinate": "angle", "value": tj, "rate": -1.0}]
    }))
}

#[test]
fn examples_6_4_and_6_5_two_link_manipulator() {
    let r = at_start(manipulator(), &independent(&["i.angle", "j.angle"]));
    near(
        accelerations(&r),
        &[
            -2.693_405_334_622_462,
            1.234_637_772_606_423_7,
            4.372_076_269_288_671,
            -0.795_056_283_078_351_5,
            -0.316_610_311_848_395_33,
            -13.389_680_810_108_443,
        ],
        SOLVED,
    );
    let l = multipliers(&r);
    near(
        &[-l[0], -l[1], -l[2], -l[3]],
        &[
            -6.579_395_093_862_451,
            1.994_360_077_440_254_3,
            1.192_584_424_617_527_2,
            0.474_915_467_772_592_97,
        ],
        SOLVED,
    );
    let e = r.independent.unwrap();
    near_rows(
        &e.motions,
        &[
            &[-0.194_709_171_154_325_26, 0.0],
            &[0.460_530_497_001_442_55, 0.0],
            &[1.0, 0.0],
            &[-0.389_418_342_308_650_5, -0.356_482_944_024_574_2],
            &[0.921_060_994_002_885_1, 0.181_438_448_570_230_95],
            &[0.0, 1.0],
        ],
        SOLVED,
    );
    near_rows(
        &e.mass,
        &[
            &[2.18, 0.458_905_312_370_693_1],
            &[0.458_905_312_370_693_1, 0.34],
        ],
        SOLVED,
    );
    near(
        &e.force.values,
        &[3.386_530_612_342_615, -2.546_122_449_370_458_6],
        SOLVED,
    );
}

#[test]
fn example_6_6_generalized_reactions_of_a_pin() {
    let model = json!({
        "body": [{"name": "i", "mass": 1, "inertia": 1, "angle": 0.3}, {"name": "j", "mass": 1, "inertia": 1, "angle": -0.8}],
        "joint": [pin("P", ["i", "j"], [[0.4, 0.1], [-0.25, 0.2]])]
    });
    let c = dense(&at_estimate(model, &Equations::default()).jacobian);
    let q = -c.transpose() * DVector::from_column_slice(&[5.0, -3.0]);
    near(
        q.as_slice(),
        &[
            -5.0,
            3.0,
            2.126_456_382_837_807_4,
            5.0,
            -3.0,
            -1.501_285_445_500_908_8,
        ],
        EXACT,
    );
}

#[test]
fn example_6_7_ground_constraint() {
    let model = json!({
        "body": [{"name": "base", "mass": 1, "inertia": 1}],
        "joint": [{"name": "W", "kind": "weld", "bodies": ["base", "ground"], "at": [[0, 0], [0, 0]]}]
    });
    let r = at_estimate(model, &Equations::default());
    near_rows(
        &r.jacobian,
        &[&[1.0, 0.0, 0.0], &[0.0, 1.0, 0.0], &[0.0, 0.0, 1.0]],
        EXACT,
    );
}

/// The slider-crank of problem 6.5, whose coordinates are those of examples 6.8 and of problems 14 and 17.
fn slider_crank(theta2: f64, force: f64, gravity: f64) -> Value {
    let (l2, l3) = (0.2_f64, 0.4_f64);
    let theta3 = -(l2 * theta2.sin() / l3).asin();
    let a = [l2 * theta2.cos(), l2 * theta2.sin()];
    json!({
        "model": {"name": "slider-crank", "gravity": [0, -gravity]},
        "body": [rod("crank", 0.5, l2, [0.5 * a[0], 0.5 * a[1]], theta2),
                 rod("rod", 1.0, l3, [a[0] + 0.5 * l3 * theta3.cos(), 0.5 * a[1]], theta3),
                 {"name": "slider", "mass": 0.2, "inertia": 0.0001, "position": [a[0] + l3 * theta3.cos(), 0.0], "angle": 0.0}],
        "joint": [pin("O", ["crank", "ground"], [[-0.1, 0.0], [0.0, 0.0]]),
                  pin("A", ["crank", "rod"], [[0.1, 0.0], [-0.2, 0.0]]),
                  pin("B", ["rod", "slider"], [[0.2, 0.0], [0.0, 0.0]])],
        "constraint": [
            {"name": "y", "kind": "fixed", "value": 0.0, "quantity": {"kind": "coordinate", "body": "slider", "coordinate": "y"}},
            {"name": "turn", "kind": "fixed", "value": 0.0, "quantity": {"kind": "coordinate", "body": "slider", "coordinate": "angle"}}
        ],
        "force": [{"name": "M2", "kind": "moment", "body": "crank", "value": 10.0},
                  {"name": "F4", "kind": "force", "body": "slider", "value": [force, 0.0]}],
        "initial": [{"kind": "coordinate", "body": "crank", "coordinate": "angle", "value": theta2, "rate": 150.0}]
    })
}

#[test]
fn example_6_8_generalized_reactions_of_the_slider_crank() {
    let c = dense(&at_start(slider_crank(0.8, 0.0, 0.0), &Equations::default()).jacobian);
    // Multipliers 4 to 11 of the book; the first three belong to the ground body.
    let l = DVector::from_fn(8, |k, _| (k + 4) as f64);
    near(
        (-c.transpose() * l).as_slice(),
        &[
            -10.0,
            -12.0,
            0.004_129_876_310_471_486,
            -2.0,
            -2.0,
            -3.991_374_792_012_937_4,
            8.0,
            -1.0,
            -11.0,
        ],
        SOLVED,
    );
}

fn two_free_bodies() -> Value {
    no_gravity(json!({
        "body": [
            {"name": "i", "mass": 2.0, "inertia": 0.3, "position": [0.2, -0.1], "angle": 0.5, "velocity": [1.0, 0.5], "angular_velocity": 3.0},
            {"name": "j", "mass": 1.0, "inertia": 0.05, "position": [1.045_965_568_590_978_8, 0.109_438_672_230_742_94], "angle": -0.3,
             "velocity": [-0.458_190_552_296_309_56, 1.201_103_779_187_059_1], "angular_velocity": -2.0}
        ],
        "joint": [pin("P", ["i", "j"], [[0.6, 0.1], [-0.4, 0.05]])],
        "force": [
            {"name": "F_i", "kind": "force", "body": "i", "value": [4.0, -2.0]},
            {"name": "M_i", "kind": "moment", "body": "i", "value": 1.5},
            {"name": "F_j", "kind": "force", "body": "j", "value": [-1.0, 3.0]},
            {"name": "M_j", "kind": "moment", "body": "j", "value": -0.7}
        ]
    }))
}

const TWO_FREE: [f64; 6] = [
    3.185_791_592_618_061_3,
    -0.194_657_799_715_730_83,
    4.601_867_565_542_728,
    -3.371_583_185_236_122,
    1.389_315_599_431_461_7,
    5.706_440_833_683_118,
];

#[test]
fn example_6_9_augmented_system_of_two_bodies() {
    let r = at_estimate(two_free_bodies(), &Equations::default());
    assert!(r.residual.values.iter().all(|c| c.abs() < 1e-15));
    near(accelerations(&r), &TWO_FREE, SOLVED);
    near(
        multipliers(&r),
        &[-2.371_583_185_236_122, -1.610_684_400_568_538_3],
        SOLVED,
    );
    near(
        &r.qd.values,
        &[5.776_897_190_732_932, 2.714_822_585_680_767],
        EXACT,
    );
    let k = kkt(&r);
    let mut eigenvalues: Vec<f64> = k.symmetric_eigenvalues().iter().copied().collect();
    eigenvalues.sort_by(f64::total_cmp);
    // Indefinite: as many negative ones as rows.
    near(
        &eigenvalues,
        &[
            -1.106_480_773_583_914_6,
            -0.956_456_147_799_097_2,
            0.129_209_586_954_465,
            0.434_969_912_603_472_2,
            1.355_026_644_720_009_4,
            1.381_509_571_997_565_9,
            2.541_460_305_666_081,
            2.570_760_899_441_417_3,
        ],
        SOLVED,
    );
}

fn kkt(r: &EquationsReport) -> DMatrix<f64> {
    let (m, c) = (dense(&r.mass), dense(&r.jacobian));
    let (n, rows) = (m.nrows(), c.nrows());
    let mut k = DMatrix::zeros(n + rows, n + rows);
    k.view_mut((0, 0), (n, n)).copy_from(&m);
    k.view_mut((n, 0), (rows, n)).copy_from(&c);
    k.view_mut((0, n), (n, rows)).copy_from(&c.transpose());
    k
}

#[test]
fn equation_6_144_blocks_of_the_inverse() {
    let r = at_estimate(two_free_bodies(), &Equations::default());
    let h = kkt(&r).try_inverse().unwrap();
    near(
        h.view((6, 6), (2, 2)).into_owned().as_slice(),
        &[
            -0.409_308_232_742_102_93,
            0.051_180_286_987_917_48,
            0.051_180_286_987_917_48,
            -0.207_907_091_724_866_85,
        ],
        SOLVED,
    );
    // Columns of the upper right block, then of the symmetric upper left one.
    near(
        h.view((0, 6), (6, 2)).into_owned().as_slice(),
        &[
            0.204_654_116_371_051_46,
            -0.025_590_143_493_958_74,
            -0.593_850_371_567_161_8,
            -0.409_308_232_742_102_93,
            0.051_180_286_987_917_48,
            0.982_667_561_782_950_3,
            -0.025_590_143_493_958_734,
            0.103_953_545_862_433_42,
            0.395_731_869_006_808_6,
            0.051_180_286_987_917_47,
            -0.207_907_091_724_866_85,
            1.357_636_234_284_38,
        ],
        SOLVED,
    );
    near(
        h.view((0, 0), (6, 6)).into_owned().as_slice(),
        &[
            0.397_672_941_814_474_27,
            0.012_795_071_746_979_367,
            0.296_925_185_783_580_9,
            0.204_654_116_371_051_46,
            -0.025_590_143_493_958_734,
            -0.491_333_780_891_475_34,
            0.012_795_071_746_979_37,
            0.448_023_227_068_783_3,
            -0.197_865_934_503_404_3,
            -0.025_590_143_493_958_74,
            0.103_953_545_862_433_42,
            -0.678_818_117_142_189_9,
            0.296_925_185_783_580_9,
            -0.197_865_934_503_404_3,
            1.958_868_234_666_886_2,
            -0.593_850_371_567_161_8,
            0.395_731_869_006_808_6,
            -0.936_224_785_974_823_1,
            0.204_654_116_371_051_46,
            -0.025_590_143_493_958_734,
            -0.593_850_371_567_161_8,
            0.590_691_767_257_897_1,
            0.051_180_286_987_917_47,
            0.982_667_561_782_950_7,
            -0.025_590_143_493_958_74,
            0.103_953_545_862_433_42,
            0.395_731_869_006_808_6,
            0.051_180_286_987_917_48,
            0.792_092_908_275_133_1,
            1.357_636_234_284_379_7,
            -0.491_333_780_891_475_17,
            -0.678_818_117_142_19,
            -0.936_224_785_974_823_2,
            0.982_667_561_782_950_3,
            1.357_636_234_284_38,
            6.763_250_326_007_776_5,
        ],
        SOLVED,
    );
}

#[test]
fn section_6_9_bases_of_the_null_space() {
    for basis in [
        EquationBasis::Partition,
        EquationBasis::Qr,
        EquationBasis::Svd,
    ] {
        let r = at_estimate(
            two_free_bodies(),
            &Equations {
                basis,
                ..Equations::default()
            },
        );
        let e = r.independent.unwrap();
        let (c, b) = (dense(&r.jacobian), dense(&e.motions));
        assert!((&c * &b).amax() < 1e-15, "{basis:?}");
        let a = &b * vector(&e.accelerations.unwrap()) + vector(&e.acceleration_offset);
        near(a.as_slice(), &TWO_FREE, SOLVED);
        let mut values: Vec<f64> = c.singular_values().iter().copied().collect();
        values.sort_by(|x, y| y.total_cmp(x));
        near(
            &values,
            &[1.555_645_141_301_040_4, 1.453_433_243_856_238],
            EXACT,
        );
    }
}

#[test]
fn examples_6_10_and_6_11_pendulum() {
    let t = 0.3_f64;
    let model = json!({
        "body": [{"name": "rod", "mass": 1.0, "inertia": 1.0 / 12.0, "position": [0.5 * t.cos(), 0.5 * t.sin()], "angle": t,
                  "velocity": [-t.sin(), t.cos()], "angular_velocity": 2.0}],
        "joint": [pin("O", ["rod", "ground"], [[-0.5, 0.0], [0.0, 0.0]])],
        "force": [{"name": "M", "kind": "moment", "body": "rod", "value": 1.0}]
    });
    let r = at_estimate(model, &Equations::default());
    near(
        accelerations(&r),
        &[
            -0.276_774_789_241_234_94,
            -5.872_989_072_983_25,
            -11.057_776_437_483_296,
        ],
        SOLVED,
    );
    // The book prints Q_d with the other sign, which spoils lambda.
    near(
        multipliers(&r),
        &[0.276_774_789_241_234_94, -3.937_010_927_016_751],
        SOLVED,
    );
    near(
        &r.qd.values,
        &[-1.910_672_978_251_212, -0.591_040_413_322_679_1],
        EXACT,
    );
}

/// F4, gravity, Qbar, accelerations of crank angle, rod angle and slider, multipliers.
type Case = (f64, f64, f64, [f64; 3], [f64; 8]);

#[test]
fn problems_6_14_and_6_17_slider_crank() {
    let angle = std::f64::consts::FRAC_PI_4;
    let cases: [Case; 4] = [
        (
            15.0,
            0.0,
            -523.888_273_536_292_3,
            [
                -10_596.413_919_752_08,
                11_294.382_839_573_256,
                -1_288.829_937_126_285_1,
            ],
            [
                2_179.746_921_655_564_6,
                2_358.796_114_834_116_5,
                -1_758.891_599_766_509_7,
                -1_188.661_179_053_439_6,
                -272.765_987_425_257,
                1_151.608_692_507_914_4,
                1_151.608_692_507_914_4,
                0.0,
            ],
        ),
        (
            -15.0,
            0.0,
            -518.042_065_397_698_6,
            [
                -10_478.165_727_481_231,
                11_249.689_223_897_314,
                -1_311.873_388_593_880_5,
            ],
            [
                2_178.419_452_475_547,
                2_354.681_509_033_506_2,
                -1_753.383_425_655_603_3,
                -1_188.727_278_183_717_8,
                -247.374_677_718_776_04,
                1_143.181_183_515_859_4,
                1_143.181_183_515_859_4,
                0.0,
            ],
        ),
        (
            15.0,
            9.81,
            -524.928_781_164_808_4,
            [
                -10_617.459_722_980_304,
                11_302.337_405_499_473,
                -1_284.728_665_589_082_5,
            ],
            [
                2_174.643_787_052_794_3,
                2_351.736_534_570_62,
                -1_754.532_546_672_649,
                -1_185.762_517_281_033_3,
                -271.945_733_117_816_87,
                1_146.185_517_298_139_3,
                1_144.223_517_298_139_3,
                0.0,
            ],
        ),
        (
            -15.0,
            9.81,
            -519.082_573_026_214_5,
            [
                -10_499.211_530_709_452,
                11_257.643_789_823_525,
                -1_307.772_117_056_678_3,
            ],
            [
                2_173.316_317_872_777_3,
                2_347.621_928_770_009,
                -1_749.024_372_561_743_1,
                -1_185.828_616_411_311_3,
                -246.554_423_411_335_85,
                1_137.758_008_306_084_3,
                1_135.796_008_306_084_3,
                0.0,
            ],
        ),
    ];
    for (force, gravity, qbar, a, l) in cases {
        let r = at_start(
            slider_crank(angle, force, gravity),
            &independent(&["crank.angle"]),
        );
        let e = r.independent.as_ref().unwrap();
        near(&e.mass.values[0], &[0.049_440_148_101_401_22], SOLVED);
        near(&e.force.values, &[qbar], SOLVED);
        let found = r.accelerations.as_ref().unwrap();
        near(
            &["crank.angle", "rod.angle", "slider.x"].map(|n| found.get(n).unwrap()),
            &a,
            SOLVED,
        );
        near(multipliers(&r), &l, SOLVED);
        near(
            &[
                r.velocities.get("rod.angle").unwrap(),
                r.velocities.get("slider.x").unwrap(),
            ],
            &[-56.694_670_951_384_09, -29.231_040_692_969_16],
            SOLVED,
        );
    }
}

#[test]
fn section_6_5_double_parallelogram_has_one_redundant_row() {
    let r = at_start(
        support::machines::double_parallelogram(),
        &Equations::default(),
    );
    assert_eq!((r.positions.rows.len(), r.residual.rows.len()), (12, 12));
    assert_eq!(r.independent.as_ref().unwrap().mass.rows.len(), 1);
    // What is open is how the three rockers share a pull along them.
    assert!(!r.not_unique.is_empty());
    assert!(
        r.notes.iter().any(|n| n.contains("redundant")),
        "{:?}",
        r.notes
    );
}

#[test]
fn section_6_12_near_the_dead_centre() {
    for (theta, by_crank, by_slider) in [
        (
            std::f64::consts::FRAC_PI_2,
            0.346_410_161_513_775_46,
            0.069_282_032_302_755_12,
        ),
        (
            std::f64::consts::FRAC_PI_4,
            0.374_165_738_677_394_17,
            0.072_915_026_221_291_83,
        ),
        (0.1, 0.399_501_353_635_785_4, 0.011_950_103_633_599_864),
        (
            0.001,
            0.399_999_950_000_013_54,
            0.000_119_999_950_000_010_48,
        ),
        (1e-8, 0.4, 1.2e-9),
    ] {
        let mut model = slider_crank(theta, 0.0, 0.0);
        // Near the dead centre the slider's velocity does not determine the crank's.
        model["initial"][0]["rate"] = json!(0.0);
        let r = at_start(model, &independent(&["crank.angle"]));
        let c = dense(&r.jacobian);
        let det = |name: &str| {
            let at = r.positions.rows.iter().position(|n| n == name).unwrap();
            c.clone().remove_column(at).determinant().abs()
        };
        let tolerance = 1e-12;
        assert!(
            (det("crank.angle") - by_crank).abs() < tolerance,
            "{theta}: {}",
            det("crank.angle")
        );
        assert!(
            (det("slider.x") - by_slider).abs() < tolerance,
            "{theta}: {}",
            det("slider.x")
        );
    }
    // At the dead centre the slider is refused, and the report says so.
    let mut model = slider_crank(1e-8, 0.0, 0.0);
    model["initial"][0]["rate"] = json!(0.0);
    let r = at_start(model, &independent(&["slider.x"]));
    assert!(
        r.notes
            .iter()
            .any(|n| n == "not independent at this pose, made dependent: slider.x"),
        "{:?}",
        r.notes
    );
    assert_ne!(r.independent.unwrap().force.rows, ["slider.x"]);
}

#[test]
fn problems_6_1_and_6_2_generalized_inertia_forces() {
    let body = json!([{"name": "rod", "mass": 1.0, "inertia": 1.0 / 12.0, "velocity": [5.0, -15.0], "angular_velocity": 150.0}]);
    let r = at_estimate(no_gravity(json!({"body": body})), &Equations::default());
    let m = dense(&r.mass);
    for (alpha, expected) in [(0.0, [100.0, 250.0, 0.0]), (450.0, [100.0, 250.0, 37.5])] {
        let force =
            &m * DVector::from_column_slice(&[100.0, 250.0, alpha]) - vector(&r.centrifugal);
        near(force.as_slice(), &expected, EXACT);
    }
    near(&[r.scalars.kinetic], &[1_062.5], EXACT);
}

#[test]
fn problem_6_8_pinned_rod_with_a_force_at_its_end() {
    let (t, phi) = (45_f64.to_radians(), 80_f64.to_radians());
    for (gravity, a, reaction) in [
        (
            0.0,
            [
                -7_976.944_887_740_448,
                -7_932.957_688_956_871,
                62.207_293_090_534_31,
            ],
            [-7_978.681_369_517_118, -7_942.805_766_486_993],
        ),
        (
            9.81,
            [
                -7_973.266_137_740_448,
                -7_936.636_438_956_872,
                51.802_216_805_371_586,
            ],
            [-7_975.002_619_517_118, -7_936.674_516_486_993_5],
        ),
    ] {
        let model = json!({
            "model": {"name": "rod", "gravity": [0, -gravity]},
            "body": [{"name": "rod", "mass": 1.0, "inertia": 1.0 / 12.0, "position": [0.5 * t.cos(), 0.5 * t.sin()], "angle": t,
                      "velocity": [-75.0 * t.sin(), 75.0 * t.cos()], "angular_velocity": 150.0}],
            "joint": [pin("O", ["rod", "ground"], [[-0.5, 0.0], [0.0, 0.0]])],
            "force": [{"name": "F", "kind": "force", "body": "rod", "at": [0.5, 0.0], "value": [10.0 * phi.cos(), 10.0 * phi.sin()]},
                      {"name": "M", "kind": "moment", "body": "rod", "value": 15.0}]
        });
        let r = at_estimate(model, &Equations::default());
        near(accelerations(&r), &a, SOLVED);
        let l = multipliers(&r);
        near(&[-l[0], -l[1]], &reaction, SOLVED);
    }
}

/// The angles of two links of a closed ring are determined by the other four unless the two links are parallel.
#[test]
fn section_6_12_dependent_angles_of_a_ring() {
    let step = std::f64::consts::FRAC_PI_3;
    let (mut bodies, mut joints, mut at) = (Vec::new(), Vec::new(), [0.0_f64, 0.0]);
    for k in 0..6_u8 {
        let (sin, cos) = (f64::from(k) * step).sin_cos();
        bodies.push(rod(
            &format!("link {}", k + 1),
            1.0,
            0.5,
            [at[0] + 0.25 * cos, at[1] + 0.25 * sin],
            f64::from(k) * step,
        ));
        at = [at[0] + 0.5 * cos, at[1] + 0.5 * sin];
        let pair = [
            format!("link {}", k + 1),
            format!("link {}", (k + 1) % 6 + 1),
        ];
        joints.push(pin(
            &format!("pin {}", k + 1),
            [&pair[0], &pair[1]],
            [[0.25, 0.0], [-0.25, 0.0]],
        ));
    }
    let ring = json!({"body": bodies, "joint": joints});
    for (dependent, expected) in [
        ([1, 2], 0.216_506_350_946_109_65),
        ([1, 3], 0.216_506_350_946_109_68),
        ([1, 4], 0.0),
    ] {
        let mut names = vec!["link 1.x".to_owned(), "link 1.y".to_owned()];
        names.extend(
            (1..=6)
                .filter(|k| !dependent.contains(k))
                .map(|k| format!("link {k}.angle")),
        );
        let wanted: Vec<&str> = names.iter().map(String::as_str).collect();
        let r = at_estimate(ring.clone(), &independent(&wanted));
        // The five other places follow with determinant 1: |det C_qd| is that of the two loop equations.
        let mut c = dense(&r.jacobian);
        for (k, name) in r.positions.rows.iter().enumerate().rev() {
            if names.contains(name) {
                c = c.remove_column(k);
            }
        }
        assert!(
            (c.determinant().abs() - expected).abs() < 1e-14,
            "{dependent:?}: {}",
            c.determinant()
        );
        let refused = r
            .notes
            .iter()
            .any(|n| n.contains("not independent at this pose"));
        assert_eq!(refused, expected == 0.0, "{:?}", r.notes);
    }
}
