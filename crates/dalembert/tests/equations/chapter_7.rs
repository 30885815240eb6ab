//! Shabana, chapters 7 and 8: equations of spatial bodies in generalized coordinates of the orientation.

use super::*;
use dalembert::model::Model;
use dalembert::space::Spatial;
use dalembert::space::orientation::{EulerSequence, OrientationSet, Rotation};
use dalembert::system::compile::compile;
use dalembert::system::{State, System};
use nalgebra::Vector3;

pub const ZXZ: OrientationSet = OrientationSet::Euler(EulerSequence::ZXZ);

pub fn system(mut parts: Value) -> System<Spatial> {
    let gravity = parts
        .as_object_mut()
        .and_then(|map| map.remove("gravity"))
        .unwrap_or_else(|| json!([0, 0, 0]));
    parts["model"] = json!({"name": "test", "space": "spatial", "gravity": gravity});
    let model: Model = serde_json::from_value(parts).unwrap();
    let all = compile::<Spatial>(&model, &[]).unwrap_or_else(|e| panic!("{e:?}"));
    all.system.running()
}

/// A frame by its origin and its angles about z, x, z, with their rates.
pub struct Frame {
    pub at: [f64; 3],
    pub angles: [f64; 3],
    pub velocity: [f64; 3],
    pub rates: [f64; 3],
}

/// The state of bodies whose frames move so.
pub fn state(system: &System<Spatial>, frames: &[Frame]) -> State {
    let mut state = State::default();
    for (frame, body) in frames.iter().zip(&system.bodies) {
        let angles = Vector3::from(frame.angles);
        let turn = EulerSequence::ZXZ.rotation(&angles);
        let omegabar = EulerSequence::ZXZ.gbar(&angles) * Vector3::from(frame.rates);
        // From the user's frame to the engine's, at the centre of mass.
        let own: Rotation = Rotation::from_matrix(&body.frame.axes).inverse();
        let center = turn * own;
        let arm = center * body.frame.at;
        let omega = turn * omegabar;
        let r = Vector3::from(frame.at) - arm;
        let v = Vector3::from(frame.velocity) - omega.cross(&arm);
        let spin = center.inverse() * omega;
        state
            .q
            .extend([r.x, r.y, r.z, center.w, center.i, center.j, center.k]);
        state.v.extend([v.x, v.y, v.z, spin.x, spin.y, spin.z]);
    }
    state
}

fn in_set(set: OrientationSet) -> Equations {
    Equations {
        orientation: Some(set),
        basis: EquationBasis::Absolute,
        ..Equations::default()
    }
}

pub fn written(system: &System<Spatial>, state: &State, set: OrientationSet) -> EquationsReport {
    in_set(set).run(system, state).unwrap()
}

#[track_caller]
fn rows(found: &LabelledMatrix, expected: &[&[f64]], tolerance: f64) {
    let all: Vec<f64> = found.values.iter().flatten().copied().collect();
    near(&all, &expected.concat(), tolerance);
}

/// Example 7.8: a free body at theta = 90 degrees.
#[test]
fn example_7_8() {
    let system = system(json!({
        "body": [{"name": "b", "mass": 2, "inertia": [0.3, 0.3, 0.3]}],
        "force": [{"name": "F", "kind": "force", "body": "b", "at": [0.2, 0, -0.15], "value": [5, 0, -3]}]
    }));
    let quarter = std::f64::consts::FRAC_PI_4;
    let state = state(
        &system,
        &[Frame {
            at: [0.0; 3],
            angles: [quarter, 2.0 * quarter, 0.0],
            velocity: [0.0; 3],
            rates: [20.0, 0.0, -35.0],
        }],
    );
    let report = written(&system, &state, ZXZ);
    assert_eq!(
        report.velocities.rows,
        ["b.x", "b.y", "b.z", "b.phi", "b.theta", "b.psi"]
    );
    assert_eq!(report.positions.rows, report.velocities.rows);
    near(
        &report.positions.values[3..],
        &[quarter, 2.0 * quarter, 0.0],
        1e-15,
    );
    near(&report.velocities.values[3..], &[20.0, 0.0, -35.0], 1e-15);
    let m: Vec<f64> = (3..6)
        .flat_map(|i| report.mass.values[i][3..].to_vec())
        .collect();
    near(&m, &[0.3, 0.0, 0.0, 0.0, 0.3, 0.0, 0.0, 0.0, 0.3], 1e-15);
    let q_e = [5.0, 0.0, -3.0, -1.237_436_867_076_458_2, -0.45, -0.6];
    near(&report.applied.values, &q_e, 1e-15);
    near(
        &report.centrifugal.values,
        &[0.0, 0.0, 0.0, 0.0, 210.0, 0.0],
        1e-14,
    );
    let a = [2.5, 0.0, -1.5, -4.124_789_556_921_527, 698.5, -2.0];
    near(&report.accelerations.unwrap().values, &a, 1e-14);
}

/// Shabana 7.85 and 7.104, 7.105 for a frame that is neither central nor principal: point masses, against Lagrange's
/// equations.
#[test]
fn a_frame_that_is_not_central() {
    let mass = 3.8;
    let center = [
        0.113_572_944_717_562_35,
        -0.266_219_749_704_809_77,
        0.019_464_053_719_233_94,
    ];
    // About the origin of the frame.
    let inertia = [
        [
            0.821_146_274_193_654_2,
            0.117_734_340_029_528_78,
            -0.134_972_008_833_640_77,
        ],
        [
            0.117_734_340_029_528_8,
            0.520_247_317_989_226_2,
            -0.079_640_522_838_354_18,
        ],
        [
            -0.134_972_008_833_640_8,
            -0.079_640_522_838_354_18,
            0.953_672_082_400_290_1,
        ],
    ];
    let system = system(json!({
        "body": [{"name": "b", "mass": mass, "center": center, "inertia": inertia, "inertia_at": [0, 0, 0]}]
    }));
    let state = state(
        &system,
        &[Frame {
            at: [0.0; 3],
            angles: [0.4, 0.9, -0.6],
            velocity: [0.7, -1.1, 0.4],
            rates: [1.3, -0.7, 2.1],
        }],
    );
    let report = written(&system, &state, ZXZ);
    near(
        &report.velocities.values,
        &[0.7, -1.1, 0.4, 1.3, -0.7, 2.1],
        1e-15,
    );
    rows(
        &report.mass,
        &[
            &[
                mass,
                0.0,
                0.0,
                0.754_652_052_698_632_1,
                -0.311_121_809_471_054_4,
                1.045_527_796_820_182_4,
            ],
            &[
                0.0,
                mass,
                0.0,
                0.085_617_848_494_962_15,
                0.735_872_279_124_074_4,
                0.296_930_993_617_027_74,
            ],
            &[
                0.0,
                0.0,
                mass,
                0.0,
                -0.728_421_730_417_861_1,
                -0.168_427_889_881_554_8,
            ],
            &[
                0.754_652_052_698_632_1,
                0.085_617_848_494_962_15,
                0.0,
                0.689_461_131_603_595_9,
                -0.173_622_033_159_290_26,
                0.601_021_941_287_167_2,
            ],
            &[
                -0.311_121_809_471_054_4,
                0.735_872_279_124_074_4,
                -0.728_421_730_417_861_1,
                -0.173_622_033_159_290_34,
                0.834_946_337_806_822_7,
                -0.156_365_627_704_229_54,
            ],
            &[
                1.045_527_796_820_182_4,
                0.296_930_993_617_027_74,
                -0.168_427_889_881_554_8,
                0.601_021_941_287_167_2,
                -0.156_365_627_704_229_57,
                0.953_672_082_400_290_1,
            ],
        ],
        1e-15,
    );
    let q_v = [
        0.650_888_809_337_765_8,
        -10.515_527_846_722_76,
        -4.510_509_925_739_22,
        0.131_888_758_701_927_26,
        -2.745_320_159_800_193_5,
        -1.084_148_598_101_510_7,
    ];
    near(&report.centrifugal.values, &q_v, 1e-14);
    // Gbar of the first kind (7.81) in the velocities, and its rate in the accelerations: alphabar of 7.83.
    let kernel = ZXZ.rates(
        &EulerSequence::ZXZ.rotation(&Vector3::new(0.4, 0.9, -0.6)),
        &Vector3::new(
            -1.152_724_467_284_412,
            0.445_210_144_245_981_5,
            2.908_092_958_751_863_6,
        ),
    );
    let kernel = kernel.unwrap();
    near(kernel.rates.as_slice(), &[1.3, -0.7, 2.1], 1e-15);
    let accelerations = DVector::from_vec(vec![-0.5, 1.1, 0.3]);
    let alpha = &kernel.gbar * accelerations + kernel.gbar_rate_times;
    near(
        alpha.as_slice(),
        &[
            2.383_358_826_055_618_4,
            2.251_710_774_404_5,
            0.702_022_503_625_677_8,
        ],
        1e-14,
    );
}

/// Two bodies at a pose at which no joint holds, all velocities different from zero.
fn unassembled(system: &System<Spatial>) -> State {
    state(
        system,
        &[
            Frame {
                at: [0.3, -0.2, 0.5],
                angles: [0.4, 0.9, -0.6],
                velocity: [0.2, 0.1, -0.4],
                rates: [1.3, -0.7, 2.1],
            },
            Frame {
                at: [-0.4, 0.6, 1.1],
                angles: [-1.1, 1.4, 0.7],
                velocity: [-0.3, 0.5, 0.2],
                rates: [-0.6, 0.8, 0.4],
            },
        ],
    )
}

fn pair(joint: Value) -> System<Spatial> {
    let mut joint = joint;
    joint["name"] = json!("J");
    joint["bodies"] = json!(["i", "j"]);
    joint["at"] = json!([[0.1, 0.2, -0.15], [-0.2, 0.05, 0.3]]);
    let body = |name: &str| json!({"name": name, "mass": 1, "inertia": [1, 1, 1], "center": [0.03, -0.02, 0.05]});
    system(json!({"body": [body("i"), body("j")], "joint": [joint]}))
}

const V_I: [f64; 3] = [
    0.408_248_290_463_863_1,
    0.816_496_580_927_726_1,
    -0.408_248_290_463_863_1,
];
const V1_I: [f64; 3] = [0.894_427_190_999_915_9, -0.447_213_595_499_957_9, 0.0];
const V_J: [f64; 3] = [
    0.431_934_212_790_68,
    -0.863_868_425_581_36,
    0.259_160_527_674_408,
];

/// Rows 7.165: the points of a spherical joint. The engine's rows are r_j - r_i with a minus, in ground axes: r_i - r_j.
const SPHERICAL: [[f64; 12]; 3] = [
    [
        1.0,
        0.0,
        0.0,
        -0.246_519_855_126_836_38,
        -0.003_181_524_603_306_832_7,
        -0.147_344_653_893_329_87,
        -1.0,
        0.0,
        0.0,
        0.023_949_274_648_040_742,
        -0.034_127_012_325_237_73,
        -0.013_046_239_214_554_518,
    ],
    [
        0.0,
        1.0,
        0.0,
        0.107_987_096_932_694_62,
        0.007_525_013_321_647_358,
        0.069_618_029_733_385_61,
        0.0,
        -1.0,
        0.0,
        0.361_192_576_932_553_3,
        -0.017_369_560_800_646_44,
        0.095_021_325_419_219_95,
    ],
    [
        0.0,
        0.0,
        1.0,
        0.0,
        0.185_007_666_526_317_64,
        0.153_110_688_409_060_03,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.311_034_184_870_540_6,
        0.182_484_912_685_765_17,
    ],
];

/// The first two rows of 7.169: v1_i.v_j = v2_i.v_j = 0.
const PARALLEL: [[f64; 12]; 2] = [
    [
        0.0,
        0.0,
        0.0,
        -0.580_243_625_978_464,
        -0.440_412_570_408_343_75,
        -0.625_088_916_382_094,
        0.0,
        0.0,
        0.0,
        0.580_243_625_978_464,
        0.367_847_411_287_596_2,
        -0.310_765_728_658_147_44,
    ],
    [
        0.0,
        0.0,
        0.0,
        0.475_804_641_625_019_1,
        -0.852_772_508_104_868_7,
        0.243_386_269_240_635_5,
        0.0,
        0.0,
        0.0,
        -0.475_804_641_625_019_1,
        0.127_022_134_339_505_52,
        -0.914_469_314_536_800_9,
    ],
];

/// The last two rows of 7.169: v1_i.r_ij = v2_i.r_ij = 0.
const ON_AXIS: [[f64; 12]; 2] = [
    [
        0.658_945_324_453_329_3,
        -0.311_341_293_886_903_5,
        -0.684_731_814_728_894_7,
        -0.212_544_452_150_680_05,
        -0.497_397_520_259_727_83,
        0.006_337_427_705_467_358,
        -0.658_945_324_453_329_3,
        0.311_341_293_886_903_5,
        0.684_731_814_728_894_7,
        -0.096_672_901_691_150_99,
        -0.230_054_975_524_483_8,
        -0.163_134_046_158_966_7,
    ],
    [
        -0.559_159_570_931_467_7,
        0.406_136_011_986_359,
        -0.722_768_368_153_693_5,
        0.029_730_601_736_577_85,
        -1.179_627_973_956_631,
        0.547_222_526_960_121_6,
        0.559_159_570_931_467_7,
        -0.406_136_011_986_359,
        0.722_768_368_153_693_5,
        0.133_301_846_618_145_04,
        -0.212_777_628_823_471_12,
        -0.086_007_810_873_660_1,
    ],
];

#[test]
fn a_spherical_joint_in_euler_angles() {
    let system = pair(json!({"kind": "spherical"}));
    let report = written(&system, &unassembled(&system), ZXZ);
    let c = [
        1.169_179_673_865_248,
        -0.577_429_419_521_204_4,
        -0.569_876_930_315_757_3,
    ];
    near(&report.residual.values, &c, 1e-15);
    let expected: Vec<&[f64]> = SPHERICAL.iter().map(|r| &r[..]).collect();
    rows(&report.jacobian, &expected, 1e-15);
    let q_d = [
        1.765_137_038_316_294_8,
        1.564_437_709_741_379_5,
        0.747_024_919_128_512_3,
    ];
    near(&report.qd.values, &q_d, 1e-14);
}

/// Rows of a revolute (7.175) and of a cylindrical joint (7.169). Row of the engine, row of the book, sign.
#[track_caller]
fn axes(kind: &str, book: &[[f64; 12]], c: &[f64], q_d: &[f64], map: &[(usize, usize, f64)]) {
    let system = pair(json!({"kind": kind, "axes": [V_I, V_J], "x_axes": [V1_I, V1_I]}));
    let report = written(&system, &unassembled(&system), ZXZ);
    assert_eq!(report.qd.values.len(), map.len());
    for &(own, of, sign) in map {
        let expected = book[of].map(|x| sign * x);
        near(&report.jacobian.values[own], &expected, 2e-15);
        near(&[report.residual.values[own]], &[sign * c[of]], 2e-15);
        near(&[report.qd.values[own]], &[sign * q_d[of]], 4e-15);
    }
}

#[test]
fn joints_with_axes_in_euler_angles() {
    let (c_s, qd_s) = (
        [
            1.169_179_673_865_248,
            -0.577_429_419_521_204_4,
            -0.569_876_930_315_757_3,
        ],
        [
            1.765_137_038_316_294_8,
            1.564_437_709_741_379_5,
            0.747_024_919_128_512_3,
        ],
    );
    let c_p = [0.596_172_170_039_201_6, -0.204_738_395_660_654_1];
    let qd_p = [9.826_119_166_741_414, 1.536_176_350_818_776_7];
    let c_a = [1.340_415_966_808_709_2, -0.476_383_867_455_469_7];
    let qd_a = [15.768_926_926_794_457, -5.414_526_566_309_878_5];
    let joined = |a: &[f64], b: &[f64]| [a, b].concat();
    // The engine writes e.f = 0 with a minus; its x axis is v1, its y axis v x v1, which is -v2 or v2.
    let side = Vector3::from(V_I).cross(&Vector3::from(V1_I));
    let v2 = Vector3::new(
        -0.182_574_185_835_055_39,
        -0.365_148_371_670_110_77,
        -0.912_870_929_175_276_9,
    );
    let y = side.dot(&v2).signum();
    axes(
        "revolute",
        &[&SPHERICAL[..], &PARALLEL].concat(),
        &joined(&c_s, &c_p),
        &joined(&qd_s, &qd_p),
        &[
            (0, 0, 1.0),
            (1, 1, 1.0),
            (2, 2, 1.0),
            (3, 3, -1.0),
            (4, 4, -y),
        ],
    );
    // On the axis e.(r_j - r_i) with a minus: e.r_ij.
    axes(
        "cylindrical",
        &[&ON_AXIS[..], &PARALLEL].concat(),
        &joined(&c_a, &c_p),
        &joined(&qd_a, &qd_p),
        &[(0, 0, 1.0), (1, 1, y), (2, 2, -1.0), (3, 3, -y)],
    );
}

/// The manipulator of Example 7.12 and its state.
pub fn manipulator() -> (System<Spatial>, State) {
    let half = std::f64::consts::FRAC_PI_2;
    let system = system(json!({
        "gravity": [0, -9.81, 0],
        "body": [
            {"name": "2", "mass": 4, "inertia": [0.12, 0.05, 0.1]},
            {"name": "3", "mass": 2.5, "inertia": [[0.02, 0.004, 0], [0.004, 0.09, -0.003], [0, -0.003, 0.085]]}
        ],
        "joint": [
            {"name": "Q", "kind": "revolute", "bodies": ["ground", "2"], "at": [[0.1, 0.2, -0.1], [0.02, -0.25, 0.03]],
             "axes": [[0, 1, 0], [0, 1, 0]]},
            {"name": "P", "kind": "revolute", "bodies": ["2", "3"], "at": [[0.05, 0.25, 0.1], [-0.3, 0.02, -0.04]],
             "axes": [[0, 0, 1], [0, 0, 1]]}
        ],
        "force": [
            {"name": "T2", "kind": "actuator", "joint": "Q", "value": 3},
            {"name": "T3", "kind": "actuator", "joint": "P", "value": 5}
        ]
    }));
    let state = state(
        &system,
        &[
            Frame {
                at: [0.069_896_229_850_682_79, 0.45, -0.119_843_462_973_913_54],
                angles: [half, 0.4, -half],
                velocity: [-0.023_812_155_568_696_25, 0.0, 0.036_124_524_179_180_66],
                rates: [0.0, 1.2, 0.0],
            },
            Frame {
                at: [
                    0.439_888_643_064_323_9,
                    0.769_549_332_215_889_7,
                    -0.124_275_126_291_555_4,
                ],
                angles: [half, 0.4, 0.3 - half],
                velocity: [
                    0.015_711_272_394_236_517,
                    -0.204_757_945_609_636,
                    -0.426_825_021_639_318_4,
                ],
                rates: [0.0, 1.2, -0.7],
            },
        ],
    );
    (system, state)
}

/// Example 7.12, the manipulator with two revolute joints, in Euler angles and multipliers.
#[test]
fn example_7_12() {
    let (system, state) = manipulator();
    let report = written(&system, &state, ZXZ);
    let a = &report.accelerations.unwrap().values;
    let first = [
        -0.083_811_938_590_487_69,
        0.0,
        0.221_486_307_146_819_38,
        0.0,
        6.408_224_601_354_751,
        0.0,
    ];
    near(&a[..6], &first, 1e-13);
    let second = [
        -0.382_266_885_373_529,
        -2.044_379_310_953_856,
        -2.381_065_237_207_606_4,
        0.0,
        6.408_224_601_354_751,
        -6.872_554_286_124_95,
    ];
    near(&a[6..], &second, 1e-13);
    let lambda = &report.multipliers.unwrap().values;
    near(
        &lambda[..3],
        &[
            -1.290_914_967_795_773_2,
            58.654_051_722_615_336,
            -5.066_717_864_431_738,
        ],
        1e-14,
    );
    near(
        &lambda[5..8],
        &[
            -0.955_667_213_433_822_4,
            19.414_051_722_615_362,
            -5.952_663_093_019_016,
        ],
        1e-14,
    );
}

/// Problem 8.6: a body that turns, in Euler parameters with the norm as a further row (8.16).
#[test]
fn problem_8_6() {
    let system = system(json!({
        "body": [{"name": "b", "mass": 1, "inertia": [[2, 0.3, -0.1], [0.3, 1.5, 0.2], [-0.1, 0.2, 1]]}],
        "force": [{"name": "M", "kind": "moment", "body": "b", "value": [0.7, 0.1, -0.4], "axes": "body"}]
    }));
    let beta = [
        0.831_912_617_856_992_9,
        -0.483_482_944_852_244_3,
        -0.174_206_608_119_235_77,
        0.209_326_768_414_642_8,
    ];
    let state = State {
        t: 0.0,
        q: [&[0.0; 3][..], &beta].concat(),
        v: vec![0.0, 0.0, 0.0, 1.0, -2.0, 0.5],
    };
    let report = written(&system, &state, OrientationSet::EulerParameters);
    assert_eq!(report.qd.rows, ["b (euler-parameters): norm"]);
    near(&report.positions.values[3..], &beta, 1e-15);
    let gradient: Vec<f64> = [0.0; 3].into_iter().chain(beta.map(|b| 2.0 * b)).collect();
    near(&report.jacobian.values[0], &gradient, 1e-15);
    let second = [
        -1.133_729_790_336_182_3,
        0.585_274_159_831_503_8,
        -0.025_546_903_839_260_938,
        -0.433_849_182_267_992_8,
    ];
    near(&report.accelerations.unwrap().values[3..], &second, 1e-14);
    // M of the parameters has rank 3, its null vector are they themselves.
    let m = dense(&report.mass).view((3, 3), (4, 4)).into_owned();
    let left = &m * DVector::from_column_slice(&beta);
    assert!(left.amax() < 1e-15);
}

fn sets() -> Vec<OrientationSet> {
    let mut sets = vec![
        OrientationSet::EulerParameters,
        OrientationSet::Rodriguez,
        OrientationSet::AxisAngle,
        OrientationSet::DirectionCosines,
    ];
    for space in [false, true] {
        sets.extend(EulerSequence::all(space).map(OrientationSet::Euler));
    }
    sets
}

/// A pair of bodies with frames of their own, a joint, a contact, gravity and a force: every set gives the accelerations of
/// the plain form, the same energies and multipliers.
#[test]
fn every_set_gives_the_same_motion() {
    let system = system(json!({
        "gravity": [0.5, -1, -9.81],
        "body": [
            {"name": "i", "mass": 2, "inertia": [[1.1, 0.2, -0.1], [0.2, 0.9, 0.3], [-0.1, 0.3, 1.4]],
             "center": [0.3, -0.1, 0.2]},
            {"name": "j", "mass": 3, "inertia": [0.4, 0.5, 0.6], "center": [-0.1, 0.2, 0.1]}
        ],
        "joint": [
            {"name": "J", "kind": "universal", "bodies": ["i", "j"], "at": [[0.1, 0.2, -0.15], [-0.2, 0.05, 0.3]],
             "axes": [[1, 0, 0], [0, 1, 0]]},
            {"name": "bowl", "kind": "point-on-surface", "bodies": ["ground", "i"], "at": [[0, 0, 0], [0.4, 0, 0]],
             "surface": {"kind": "ellipsoid", "semi_axes": [1, 2, 3]}, "parameters": [0.3, 0.4]}
        ],
        "force": [{"name": "F", "kind": "force", "body": "j", "at": [0.2, 0, -0.15], "value": [5, 0, -3]}]
    }));
    let mut state = unassembled(&system);
    // The unit vector of a = 0.3 and b = 0.4, and its rate with a' = -0.6, b' = 0.2.
    let ((sa, ca), (sb, cb)) = (0.3_f64.sin_cos(), 0.4_f64.sin_cos());
    state.q.extend([cb * ca, cb * sa, sb]);
    let around = [-cb * sa, cb * ca, 0.0];
    let up = [-sb * ca, -sb * sa, cb];
    state
        .v
        .extend([0, 1, 2].map(|k| -0.6 * around[k] + 0.2 * up[k]));
    for frame in [ReferenceFrame::User, ReferenceFrame::Center] {
        let plain = Equations {
            frame,
            ..Equations::default()
        };
        let plain = plain.run(&system, &state).unwrap();
        let expected = plain.accelerations.unwrap().values;
        for set in sets() {
            let equations = Equations {
                frame,
                orientation: Some(set),
                ..Equations::default()
            };
            let report = equations.run(&system, &state).unwrap();
            assert_eq!(report.orientation, Some(set.to_string()));
            let a = report.accelerations.unwrap().values;
            let n = 3 + set.names().len();
            for b in 0..2 {
                near(&a[n * b..n * b + 3], &expected[6 * b..6 * b + 3], 1e-11);
                // Back to the angular acceleration in body axes.
                let x = &report.positions.values[n * b + 3..n * (b + 1)];
                let rotation = set.rotation(x).unwrap();
                let omegabar =
                    Vector3::from_column_slice(&plain.velocities.values[6 * b + 3..6 * b + 6]);
                let rates = set.rates(&rotation, &omegabar).unwrap();
                let second = DVector::from_column_slice(&a[n * b + 3..n * (b + 1)]);
                let alpha = rates.gbar * second + rates.gbar_rate_times;
                near(alpha.as_slice(), &expected[6 * b + 3..6 * b + 6], 1e-11);
            }
            near(&a[2 * n..], &expected[12..], 1e-11);
            let lambda = &report.multipliers.unwrap().values;
            let own = &plain.multipliers.as_ref().unwrap().values;
            near(&lambda[..own.len()], own, 1e-11);
            let energies = |s: &dalembert::analysis::equations::Scalars| {
                [s.kinetic, s.potential, s.gibbs_appel.unwrap()]
            };
            near(&energies(&report.scalars), &energies(&plain.scalars), 1e-12);
            let count = |r: &Option<dalembert::analysis::equations::IndependentEquations>| {
                r.as_ref().unwrap().force.rows.len()
            };
            assert_eq!(
                count(&report.independent),
                count(&plain.independent),
                "{set}"
            );
        }
    }
}

/// Singular poses name another set; planar machines have no such sets.
#[test]
fn singular_poses_and_planar_machines_are_refused() {
    let system = system(json!({"body": [{"name": "b", "mass": 1, "inertia": [1, 1, 1]}]}));
    let at = |angles: [f64; 3]| {
        state(
            &system,
            &[Frame {
                at: [0.0; 3],
                angles,
                velocity: [0.0; 3],
                rates: [0.1, 0.2, 0.3],
            }],
        )
    };
    let upright = at([0.4, 0.0, 0.3]);
    for set in [ZXZ, OrientationSet::AxisAngle] {
        let pose = if set == ZXZ { &upright } else { &at([0.0; 3]) };
        let error = in_set(set).run(&system, pose).unwrap_err();
        let AnalysisError::SingularOrientation { body, better, .. } = &error else {
            panic!("{error}");
        };
        assert_eq!(body, "b");
        written(&system, pose, better.parse().unwrap());
        let text = error.to_string();
        assert!(
            text.contains(&format!("singular pose of {set}")) && text.contains("euler-parameters"),
            "{text}"
        );
    }
    // Half turns have no Rodriguez parameters.
    let half = at([std::f64::consts::PI, 0.0, 0.0]);
    let error = in_set(OrientationSet::Rodriguez).run(&system, &half);
    assert!(matches!(
        error,
        Err(AnalysisError::SingularOrientation { .. })
    ));
    let planar = compiled(json!({"body": [rod("a", 1.0, 1.0, [0.0, 0.0], 0.0)]})).system;
    let error = in_set(ZXZ).run(&planar, &planar.estimate);
    assert_eq!(error, Err(AnalysisError::PlanarOrientation));
}

/// The text says which coordinates these are.
#[test]
fn the_text_names_the_set() {
    let system = system(json!({"body": [{"name": "b", "mass": 1, "inertia": [1, 1, 1]}]}));
    let state = state(
        &system,
        &[Frame {
            at: [0.0; 3],
            angles: [0.4, 0.9, 0.3],
            velocity: [0.0; 3],
            rates: [0.1, 0.2, 0.3],
        }],
    );
    let text = written(&system, &state, ZXZ).to_text();
    assert!(
        text.contains(
            "coordinates: origins of the body frames, ground axes; euler-zxz of the body frames"
        ),
        "{text}"
    );
    assert!(
        text.contains("b.theta") && !text.contains("Euler parameters"),
        "{text}"
    );
}
