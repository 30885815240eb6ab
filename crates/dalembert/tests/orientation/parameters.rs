//! Euler parameters, axis and angle, Rodriguez parameters.

use super::*;
use dalembert::space::orientation::{
    AxisAngle, EulerParameters, EulerSequence, OrientationError, OrientationSet,
    RodriguezParameters, relative,
};
use nalgebra::Vector4;
use std::f64::consts::PI;

/// Orientation along which a body turns with an angular velocity in its own axes, for a short time.
fn turned(start: &Rotation, omegabar: &Vector3<f64>, s: f64) -> Rotation {
    start * Rotation::from_scaled_axis(omegabar * s)
}

#[test]
fn every_set_goes_there_and_back() {
    let mut random = Random::new(SEED);
    let sets = [
        OrientationSet::EulerParameters,
        OrientationSet::AxisAngle,
        OrientationSet::Rodriguez,
        OrientationSet::DirectionCosines,
    ];
    let sets: Vec<_> = sets
        .into_iter()
        .chain(EulerSequence::all(false).map(OrientationSet::Euler))
        .collect();
    for set in sets {
        assert_eq!(set.to_string().parse(), Ok(set));
        for _ in 0..100 {
            let r = rotation(&mut random);
            let found = set.coordinates(&r);
            assert!(!found.singular);
            assert_eq!(found.values.len(), set.names().len());
            same(&set.rotation(&found.values).unwrap(), &r, EXACT);
        }
    }
}

#[test]
fn rates_are_those_of_the_coordinates() {
    let mut random = Random::new(SEED);
    for _ in 0..50 {
        let r = rotation(&mut random);
        let omegabar = vector(&mut random);
        let path = |s: f64| turned(&r, &omegabar, s);
        let rate = |f: &dyn Fn(&Rotation) -> Vec<f64>| -> Vec<f64> {
            let (h, mut sum) = (1e-3, vec![0.0; f(&r).len()]);
            for (k, w) in [0.8, -0.2, 4.0 / 105.0, -1.0 / 280.0]
                .into_iter()
                .enumerate()
            {
                let s = h * (k + 1) as f64;
                let (plus, minus) = (f(&path(s)), f(&path(-s)));
                for i in 0..sum.len() {
                    sum[i] += w * (plus[i] - minus[i]) / h;
                }
            }
            sum
        };
        let beta = |r: &Rotation| EulerParameters::of(r).0.as_slice().to_vec();
        let parameters = EulerParameters::of(&r);
        near(parameters.rates(&omegabar).as_slice(), &rate(&beta), 1e-11);
        near(
            (parameters.gbar() * parameters.rates(&omegabar)).as_slice(),
            omegabar.as_slice(),
            EXACT,
        );
        // omega = A omegabar, A = G Gbar^T / 4 (Shabana 8.25).
        let a = parameters.g() * parameters.gbar().transpose() / 4.0;
        near(a.as_slice(), matrix(&r).as_slice(), EXACT);

        let (turn, singular) = AxisAngle::of(&r);
        assert!(!singular && turn.angle > 0.0 && turn.angle <= PI);
        let found = turn.rates(&omegabar).unwrap();
        // Near zero angle the axis is quick: 1 / angle digits are lost in the differences.
        let axis = |r: &Rotation| {
            let (turn, _) = AxisAngle::of(r);
            vec![turn.axis.x, turn.axis.y, turn.axis.z, turn.angle]
        };
        if turn.angle > 0.5 && turn.angle < 3.0 {
            near(found.as_slice(), &rate(&axis), 1e-10);
        }
        let back = turn.gbar() * found;
        near(back.as_slice(), omegabar.as_slice(), 1e-13);

        let gamma = RodriguezParameters::of(&r).unwrap();
        let size = 1.0 + gamma.0.norm_squared();
        let scaled = 1e-14 * size;
        near(
            (gamma.gbar() * gamma.rates(&omegabar)).as_slice(),
            omegabar.as_slice(),
            scaled,
        );
        if size < 20.0 {
            let values = |r: &Rotation| RodriguezParameters::of(r).unwrap().0.as_slice().to_vec();
            near(gamma.rates(&omegabar).as_slice(), &rate(&values), 1e-8);
            // omegabar is constant on the path: Gbar gamma'' = -Gbar' gamma'.
            let g1 = gamma.rates(&omegabar);
            let rates = |r: &Rotation| {
                RodriguezParameters::of(r)
                    .unwrap()
                    .rates(&omegabar)
                    .as_slice()
                    .to_vec()
            };
            let g2 = Vector3::from_vec(rate(&rates));
            near(
                gamma.gbar_rate_times(&g1).as_slice(),
                (-(gamma.gbar() * g2)).as_slice(),
                1e-7,
            );
        }
    }
}

#[test]
fn singular_poses_of_the_sets() {
    let none = Rotation::identity();
    assert!(OrientationSet::AxisAngle.coordinates(&none).singular);
    assert_eq!(
        AxisAngle {
            axis: Vector3::x(),
            angle: 0.0
        }
        .rates(&Vector3::y()),
        None
    );
    assert!(!OrientationSet::Rodriguez.coordinates(&none).singular);
    let half = Rotation::from_quaternion(Quaternion::new(0.0, 0.6, 0.0, -0.8));
    let found = OrientationSet::Rodriguez.coordinates(&half);
    assert!(found.singular);
    assert_eq!(
        found.values.as_slice(),
        [f64::INFINITY, 0.0, f64::NEG_INFINITY]
    );
    let (turn, singular) = AxisAngle::of(&half);
    assert!(!singular);
    assert_eq!(turn.angle, PI);
    assert!(!OrientationSet::EulerParameters.coordinates(&half).singular);
    // A quaternion and its negative are one orientation: the angle is the shorter one.
    let r = Rotation::from_scaled_axis(Vector3::new(0.0, 0.0, 5.0));
    let (turn, _) = AxisAngle::of(&r);
    near(&[turn.angle, turn.axis.z], &[2.0 * PI - 5.0, -1.0], EXACT);
}

#[test]
fn a_quaternion_without_unit_norm_is_refused() {
    // Shabana, Problem 8.10 prints (0.8660, 0.35355, 0.35355, 0.35355), whose norm is not one.
    let given = Vector4::new(0.866, 0.35355, 0.35355, 0.35355);
    assert!(matches!(
        EulerParameters(given).rotation(),
        Err(OrientationError::NotUnit { norm }) if (norm * norm - 1.124_948_807_5).abs() < 1e-12
    ));
    let nan = Vector4::new(f64::NAN, 0.0, 0.0, 1.0);
    assert_eq!(
        EulerParameters(nan).rotation(),
        Err(OrientationError::NotFinite)
    );
}

/// Shabana, Examples 8.1 and 8.2: rates at 45 degrees about (1, 1, 1), 150 rad/s about body x. The book prints
/// (-16.5675, 69.2923, 16.5688, -16.5686) and (79.2886, 22.2194, -13.6530) from data of four digits.
#[test]
fn examples_8_1_and_8_2() {
    let turn = AxisAngle::new(Vector3::repeat(1.0), PI / 4.0).unwrap();
    let r = turn.rotation();
    let omegabar = Vector3::new(150.0, 0.0, 0.0);
    let omega = r * omegabar;
    near(
        omega.as_slice(),
        &[
            120.710_678_118_654_76,
            75.881_904_510_252_07,
            -46.592_582_628_906_83,
        ],
        1e-12,
    );
    let rates = EulerParameters::of(&r).rates(&omegabar);
    near(
        rates.as_slice(),
        &[-16.5675, 69.2923, 16.5688, -16.5686],
        4e-3,
    );
    let expected = [-16.570_679, 69.290_965, 16.570_679, -16.570_679];
    near(rates.as_slice(), &expected, 5e-7);
    let gamma = RodriguezParameters::of(&r).unwrap();
    near(&[gamma.0.x], &[0.239_146_311_738_100_33], EXACT);
    let found = gamma.rates(&omegabar);
    near(found.as_slice(), &[79.289_32, 22.225_30, -13.646_65], 5e-6);
    near(found.as_slice(), &[79.2886, 22.2194, -13.6530], 1e-2);
}

/// Shabana, Example 8.3: 1.2 rad about the ground's axes after an orientation (the printed third parameter for Y has a
/// wrong sign).
#[test]
fn example_8_3() {
    let start = EulerParameters(Vector4::new(0.5, 0.1, -0.7, 0.5))
        .rotation()
        .unwrap();
    let expected = [
        [
            0.356_203_560_115_335_55,
            0.364_854_798_188_485_54,
            -0.860_056_167_134_292_4,
            0.017_418_076_078_314_304,
        ],
        [
            0.807_917_538_831_364,
            0.364_854_798_188_485_54,
            -0.295_413_693_739_256_97,
            0.356_203_560_115_335_55,
        ],
        [
            0.130_346_570_757_321_37,
            0.477_783_292_867_492_66,
            -0.521_270_683_097_271_2,
            0.694_989_044_152_356_8,
        ],
    ];
    for (axis, expected) in [Vector3::x(), Vector3::y(), Vector3::z()]
        .into_iter()
        .zip(expected)
    {
        let turned = AxisAngle::new(axis, 1.2).unwrap().rotation() * start;
        near(EulerParameters::of(&turned).0.as_slice(), &expected, EXACT);
    }
}

/// Products and relative parameters (Shabana 8.46, 8.48).
#[test]
fn quaternion_algebra() {
    let second = EulerParameters(Vector4::new(
        0.769_985_174_110_759_7,
        0.424_447_560_293_068_35,
        -0.029_327_995_751_706_727,
        0.475_507_065_011_733_6,
    ));
    let third = EulerParameters(Vector4::new(
        0.859_502_246_553_124_9,
        -0.373_147_128_029_256_26,
        0.348_458_815_842_903_95,
        -0.024_363_141_731_112_432,
    ));
    let (second, third) = (second.rotation().unwrap(), third.rotation().unwrap());
    near(
        EulerParameters::of(&(second * third)).0.as_slice(),
        &[
            0.841_989_819_772_891_7,
            -0.087_484_231_410_386_78,
            0.076_007_424_153_830_74,
            0.526_898_969_563_280_8,
        ],
        EXACT,
    );
    near(
        EulerParameters::of(&relative(&second, &third)).0.as_slice(),
        &[
            0.481_618_154_148_702_4,
            -0.4871512812786869,
            0.460_608_819_820_624_3,
            -0.564_417_485_418_712_2,
        ],
        EXACT,
    );
}
