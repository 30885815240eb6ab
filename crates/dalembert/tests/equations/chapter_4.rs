//! Forms of the equations of motion: chapter 4.

use super::*;

/// Example 4.1: a rod pinned to a block that follows z(t) = 0.1 sin 3t.
pub fn moving_pin(t: f64, theta: f64, rate: f64, moment: f64) -> Value {
    let (z, z_rate) = (0.1 * (3.0 * t).sin(), 0.3 * (3.0 * t).cos());
    let (s, c) = theta.sin_cos();
    json!({
        "analysis": {"start": t},
        "body": [{"name": "rod", "mass": 1.2, "inertia": 0.064,
                  "position": [z + 0.4 * c, 0.4 * s], "angle": theta,
                  "velocity": [z_rate - 0.4 * s * rate, 0.4 * c * rate], "angular_velocity": rate}],
        "driver": [{"name": "block", "kind": "path", "body": "rod", "at": [-0.4, 0.0],
                    "x": "0.1 m * sin(3 rad/s * t)", "y": 0.0}],
        "force": [{"name": "M", "kind": "moment", "body": "rod", "value": moment}]
    })
}

#[test]
fn example_4_1_rod_on_a_moving_block() {
    let r = at_estimate(
        moving_pin(0.25, 0.698_131_700_797_731_8, 2.0, 0.5),
        &independent(&["rod.angle"]),
    );
    near(&accelerations(&r)[2..], &[-12.876_681_327_437_048], SOLVED);
    // C = r - f: the force on the rod is -lambda.
    near(
        multipliers(&r),
        &[-1.765_970_989_742_467_8, -5.803_074_904_587_258],
        SOLVED,
    );
}

fn rod_and_disk() -> Value {
    let (t2, w2, w3) = (0.610_865_238_198_015_3_f64, 1.5, 0.7);
    let (s, c) = t2.sin_cos();
    json!({
        "body": [
            {"name": "rod", "mass": 2.0, "inertia": 1.0 / 6.0, "position": [0.5 * c, 0.5 * s], "angle": t2,
             "velocity": [-0.5 * s * w2, 0.5 * c * w2], "angular_velocity": w2},
            {"name": "disk", "mass": 3.0, "inertia": 0.03375, "position": [c, s], "angle": 0.3,
             "velocity": [-s * w2, c * w2], "angular_velocity": w3}
        ],
        "joint": [pin("O", ["rod", "ground"], [[-0.5, 0.0], [0.0, 0.0]]),
                  pin("A", ["rod", "disk"], [[0.5, 0.0], [0.0, 0.0]])],
        "force": [{"name": "M2", "kind": "moment", "body": "rod", "value": 4.0},
                  {"name": "M3", "kind": "moment", "body": "disk", "value": 0.6}]
    })
}

const ACCELERATIONS: [f64; 6] = [
    1.279_698_969_413_338_7,
    -3.788_977_177_471_334_6,
    -7.675_507_150_336_374,
    2.559_397_938_826_678_8,
    -7.577_954_354_942_668,
    17.777_777_777_777_775,
];
// F12 on the rod at O, F23 on the disk at A.
const REACTIONS: [f64; 4] = [
    10.237_591_755_306_713,
    18.738_182_580_229_328,
    7.678_193_816_480_036,
    6.696_136_935_171_995,
];

#[test]
fn section_4_3_augmented_form_of_rod_and_disk() {
    let r = at_estimate(rod_and_disk(), &independent(&["rod.angle", "disk.angle"]));
    near(accelerations(&r), &ACCELERATIONS, SOLVED);
    let l = multipliers(&r);
    near(&[-l[0], -l[1], l[2], l[3]], &REACTIONS, SOLVED);
    // The symmetric form of 4.5 has forces for unknowns: -lambda at O.
    let (x, y) = (0.286_788_218_175_523, 0.409_576_022_144_495_9);
    near_rows(
        &r.jacobian,
        &[
            &[1.0, 0.0, x, 0.0, 0.0, 0.0],
            &[0.0, 1.0, -y, 0.0, 0.0, 0.0],
            &[1.0, 0.0, -x, -1.0, 0.0, 0.0],
            &[0.0, 1.0, y, 0.0, -1.0, 0.0],
        ],
        EXACT,
    );
    near(
        &r.applied.values,
        &[0.0, -19.62, 4.0, 0.0, -29.43, 0.6],
        EXACT,
    );
    let (u, v) = (0.921_546_049_825_115_8, 0.645_273_490_894_926_8);
    near(&r.qd.values, &[-u, -v, u, v], EXACT);
}

#[test]
fn section_4_4_elimination_of_dependent_accelerations() {
    let r = at_estimate(rod_and_disk(), &independent(&["rod.angle", "disk.angle"]));
    let e = r.independent.as_ref().unwrap();
    let left = dense(&r.mass) * dense(&e.motions);
    near(
        left.transpose().as_slice(),
        &[
            -0.573_576_436_351_046,
            0.0,
            0.819_152_044_288_991_8,
            0.0,
            1.0 / 6.0,
            0.0,
            -1.720_729_309_053_138_1,
            0.0,
            2.457_456_132_866_975_3,
            0.0,
            0.0,
            0.03375,
        ],
        EXACT,
    );
    let right = vector(&r.applied) - dense(&r.mass) * vector(&e.acceleration_offset);
    near(
        right.as_slice(),
        &[
            1.843_092_099_650_231_6,
            -18.329_453_018_210_15,
            4.0,
            5.529_276_298_950_695,
            -25.558_359_054_630_44,
            0.6,
        ],
        EXACT,
    );
}

#[test]
fn section_4_5_embedding() {
    let r = at_estimate(rod_and_disk(), &independent(&["rod.angle", "disk.angle"]));
    let e = r.independent.unwrap();
    let (x, y) = (0.286_788_218_175_523, 0.409_576_022_144_495_9);
    near_rows(
        &e.motions,
        &[
            &[-x, 0.0],
            &[y, 0.0],
            &[1.0, 0.0],
            &[-2.0 * x, 0.0],
            &[2.0 * y, 0.0],
            &[0.0, 1.0],
        ],
        EXACT,
    );
    near(
        &e.acceleration_offset.values,
        &[
            -0.921_546_049_825_115_8,
            -0.645_273_490_894_926_8,
            0.0,
            -1.843_092_099_650_231_6,
            -1.290_546_981_789_853_6,
            0.0,
        ],
        EXACT,
    );
    near_rows(&e.mass, &[&[11.0 / 3.0, 0.0], &[0.0, 0.03375]], EXACT);
    near(&e.force.values, &[-28.143_526_217_900_04, 0.6], EXACT);
    near(
        &e.accelerations.unwrap().values,
        &[-7.675_507_150_336_375, 17.777_777_777_777_775],
        EXACT,
    );
}

#[test]
fn section_4_6_amalgamated_form() {
    let r = at_estimate(rod_and_disk(), &independent(&["rod.angle", "disk.angle"]));
    let q_c = -dense(&r.jacobian).transpose() * vector(r.multipliers.as_ref().unwrap());
    near(
        q_c.as_slice(),
        &[
            2.559_397_938_826_678_3,
            12.042_045_645_057_334,
            -5.279_251_191_722_729,
            7.678_193_816_480_034,
            6.696_136_935_171_992,
            0.0,
        ],
        SOLVED,
    );
    let b = dense(&r.independent.unwrap().motions);
    let mut k = DMatrix::zeros(14, 14);
    k.view_mut((0, 0), (6, 6)).copy_from(&dense(&r.mass));
    k.view_mut((0, 6), (6, 6)).fill_with_identity();
    k.view_mut((6, 0), (6, 6)).fill_with_identity();
    k.view_mut((6, 12), (6, 2)).copy_from(&-&b);
    k.view_mut((12, 6), (2, 6)).copy_from(&-b.transpose());
    near(&[k.determinant().abs()], &[0.12375], SOLVED);
}

#[test]
fn section_4_7_moments_that_give_a_motion_of_two_arms() {
    let (t2, t3, w2, w3) = (50_f64.to_radians(), 20_f64.to_radians(), 2.0, -3.0);
    let model = json!({
        "body": [
            {"name": "2", "mass": 2.0, "inertia": 0.18, "angle": t2, "position": [0.4 * t2.cos(), 0.4 * t2.sin()]},
            {"name": "3", "mass": 1.5, "inertia": 0.09, "angle": t3,
             "position": [t2.cos() + 0.35 * t3.cos(), t2.sin() + 0.35 * t3.sin()]}
        ],
        "joint": [pin("O", ["2", "ground"], [[-0.4, 0.0], [0.0, 0.0]]),
                  pin("A", ["2", "3"], [[0.6, 0.0], [-0.35, 0.0]])],
        "force": [{"name": "M2", "kind": "moment", "body": "2", "value": 25.047_063_489_410_068},
                  {"name": "M3", "kind": "moment", "body": "3", "value": 4.967_968_605_136_775}],
        "initial": [{"kind": "coordinate", "body": "2", "coordinate": "angle", "value": t2, "rate": w2},
                    {"kind": "coordinate", "body": "3", "coordinate": "angle", "value": t3, "rate": w3}]
    });
    let r = at_start(model, &Equations::default());
    near(
        accelerations(&r),
        &[
            -2.560_549_061_736_419,
            0.059_904_110_382_713_864,
            5.0,
            -8.882_576_209_160_723,
            -2.243_172_844_619_343_3,
            -4.0,
        ],
        SOLVED,
    );
    let l = multipliers(&r);
    near(
        &[-l[0], -l[1], l[2], l[3]],
        &[
            -18.444_962_437_213_92,
            31.090_048_953_836_416,
            -13.323_864_313_741_083,
            11.350_240_733_070_985,
        ],
        SOLVED,
    );
}

#[test]
fn section_4_7_moment_that_gives_a_motion_of_the_four_bar() {
    let mut model = four_bar(10.0);
    model["force"] = json!([
        {"name": "M2", "kind": "moment", "body": "2", "value": 2.0},
        {"name": "F3", "kind": "force", "body": "3", "value": [3.0, -1.0]},
        {"name": "M4", "kind": "moment", "body": "4", "value": 2.235_826_121_049_856}
    ]);
    let r = at_start(model, &independent(&["2.angle"]));
    near(
        &[
            r.velocities.get("3.angle").unwrap(),
            r.velocities.get("4.angle").unwrap(),
        ],
        &[0.108_958_838_285_711_11, 6.747_538_197_918_897],
        SOLVED,
    );
    near(
        accelerations(&r),
        &[
            -5.299_586_674_828_506,
            -8.712_885_921_207_747,
            20.0,
            -11.495_348_865_318_944,
            -13.647_495_776_253_66,
            19.415_518_889_023_35,
            -6.195_762_190_490_44,
            -4.934_609_855_045_916,
            26.747_598_348_527_17,
        ],
        SOLVED,
    );
    let l = multipliers(&r);
    near(
        &[-l[0], -l[1], l[2], l[3], l[4], l[5], l[6], l[7]],
        &[
            -12.688_189_357_193_629,
            -2.195_368_284_302_055,
            -10.038_396_019_779_377,
            -2.743_925_323_698_182,
            4.456_952_845_539_567,
            0.093_570_452_555_477_25,
            9.103_774_488_407_396,
            -3.562_972_156_160_086,
        ],
        SOLVED,
    );
}

/// The four-bar of example 5.5 with masses; links are numbered as in the book.
pub fn four_bar(speed: f64) -> Value {
    let (l1, l2, l3, l4) = (0.35_f64, 0.2_f64, 0.4_f64, 0.3_f64);
    let t2 = 1.221_730_476_396_030_6_f64;
    let (t3, t4) = (0.232_276_418_925_485_5_f64, 4.345_328_481_925_324_f64);
    let a = [l2 * t2.cos(), l2 * t2.sin()];
    let b = [a[0] + l3 * t3.cos(), a[1] + l3 * t3.sin()];
    let middle = |p: [f64; 2], l: f64, t: f64| [p[0] + 0.5 * l * t.cos(), p[1] + 0.5 * l * t.sin()];
    json!({
        "body": [rod("2", 0.5, l2, middle([0.0, 0.0], l2, t2), t2),
                 rod("3", 1.0, l3, middle(a, l3, t3), t3),
                 rod("4", 0.75, l4, middle(b, l4, t4), t4)],
        "joint": [pin("O", ["2", "ground"], [[-0.1, 0.0], [0.0, 0.0]]),
                  pin("A", ["2", "3"], [[0.1, 0.0], [-0.2, 0.0]]),
                  pin("B", ["3", "4"], [[0.2, 0.0], [-0.15, 0.0]]),
                  pin("C", ["4", "ground"], [[0.15, 0.0], [l1, 0.0]])],
        "initial": [{"kind": "coordinate", "body": "2", "coordinate": "angle", "value": t2, "rate": speed}]
    })
}
