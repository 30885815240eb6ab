//! All sequences of Euler angles.

use super::*;
use dalembert::space::orientation::{Axis, EulerSequence, OrientationSet};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

fn sequences() -> impl Iterator<Item = EulerSequence> {
    EulerSequence::all(false).chain(EulerSequence::all(true))
}

fn middle_of_singular_poses(sequence: EulerSequence) -> [f64; 2] {
    let [a, _, c] = sequence.axes();
    if a == c {
        [0.0, PI]
    } else {
        [-FRAC_PI_2, FRAC_PI_2]
    }
}

#[test]
fn there_are_twelve_and_they_go_there_and_back() {
    assert_eq!(EulerSequence::all(false).count(), 12);
    let mut random = Random::new(SEED);
    for sequence in sequences() {
        assert_eq!(sequence.to_string().parse(), Ok(sequence));
        for _ in 0..200 {
            let expected = rotation(&mut random);
            let found = sequence.angles(&expected);
            assert!(!found.singular);
            assert!(found.angles.iter().all(|x| *x > -PI && *x <= PI));
            same(&sequence.rotation(&found.angles), &expected, EXACT);
        }
    }
}

/// A product of elementary matrices, body axes from the left to the right, space axes the other way round.
#[test]
fn the_order_is_that_of_the_book() {
    let elementary = |axis: Axis, x: f64| {
        let (s, c) = x.sin_cos();
        match axis {
            Axis::X => Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c),
            Axis::Y => Matrix3::new(c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c),
            Axis::Z => Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0),
        }
    };
    let x = Vector3::new(0.4, 1.1, -0.6);
    for sequence in sequences() {
        let [a, b, c] = [0, 1, 2].map(|k| elementary(sequence.axes()[k], x[k]));
        let expected = if sequence.about_space_axes() {
            c * b * a
        } else {
            a * b * c
        };
        let d = (matrix(&sequence.rotation(&x)) - expected).amax();
        assert!(d < EXACT, "{sequence}: {d:e}");
    }
}

#[test]
fn singular_poses_are_told_and_keep_the_orientation() {
    let mut random = Random::new(SEED);
    for sequence in sequences() {
        for middle in middle_of_singular_poses(sequence) {
            let mut x = vector(&mut random);
            x[1] = middle;
            assert!(sequence.regularity(&x) < 1e-15);
            assert!(sequence.gbar(&x).determinant().abs() < 1e-15);
            let expected = sequence.rotation(&x);
            let found = sequence.angles(&expected);
            assert!(found.singular, "{sequence} at {middle}");
            same(&sequence.rotation(&found.angles), &expected, EXACT);
            // Nearly singular: the orientation is as good as anywhere.
            for off in [1e-13, 1e-9, 1e-5] {
                x[1] = middle + off;
                let expected = sequence.rotation(&x);
                let found = sequence.angles(&expected);
                same(&sequence.rotation(&found.angles), &expected, EXACT);
            }
        }
    }
}

#[test]
fn rates_are_those_of_the_matrix() {
    let mut random = Random::new(SEED);
    for sequence in sequences() {
        let (x, v) = (vector(&mut random), vector(&mut random));
        let at = |s: f64| matrix(&sequence.rotation(&(x + s * v)));
        let omegabar = body_omega(&at(0.0), &rate(at));
        near(
            (sequence.gbar(&x) * v).as_slice(),
            omegabar.as_slice(),
            1e-11,
        );
        let gbar_rate = rate(|s| sequence.gbar(&(x + s * v)));
        near(
            sequence.gbar_rate(&x, &v).as_slice(),
            gbar_rate.as_slice(),
            1e-11,
        );
        let determinant = sequence.gbar(&x).determinant().abs();
        assert!((determinant - sequence.regularity(&x)).abs() < EXACT);
    }
}

/// Shabana, Examples 7.7 and 7.8: Gbar, omegabar and Gbar' theta' at z, x, z angles (pi/4, pi/2, 0).
#[test]
fn examples_7_7_and_7_8() {
    let zxz = EulerSequence::ZXZ;
    let x = Vector3::new(FRAC_PI_4, FRAC_PI_2, 0.0);
    let gbar = zxz.gbar(&x);
    let expected = Matrix3::new(0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    near(gbar.as_slice(), expected.as_slice(), EXACT);
    let h = FRAC_PI_4.sin();
    let g = matrix(&zxz.rotation(&x)) * gbar;
    let expected = Matrix3::new(0.0, h, h, 0.0, h, -h, 1.0, 0.0, 0.0);
    near(g.as_slice(), expected.as_slice(), EXACT);
    let rates = Vector3::new(20.0, 0.0, -35.0);
    near((gbar * rates).as_slice(), &[0.0, 20.0, -35.0], 1e-13);
    let change = zxz.gbar_rate(&x, &rates);
    let expected = Matrix3::new(-35.0, 0.0, 0.0, 0.0, 35.0, 0.0, 0.0, 0.0, 0.0);
    near(change.as_slice(), expected.as_slice(), 1e-13);
    near((change * rates).as_slice(), &[-700.0, 0.0, 0.0], 1e-12);
    // Generalized forces of the force (5, 0, -3) N at (0.2, 0, -0.15) m: printed to four digits, here to all.
    let a = matrix(&zxz.rotation(&x));
    let u = a * Vector3::new(0.2, 0.0, -0.15);
    let moment = u.cross(&Vector3::new(5.0, 0.0, -3.0));
    near(
        (g.transpose() * moment).as_slice(),
        &[-1.237_436_867_076_458_2, -0.45, -0.6],
        EXACT,
    );
}

/// Shabana, Problems 7.11 and 7.12: z, x, z angles of given axes.
#[test]
fn problems_7_11_and_7_12() {
    use dalembert::space::orientation::from_axes;
    let cases = [
        (
            [[0.5, 0.0, 0.5], [0.25, 0.25, -0.25], [-2.0, 4.0, 2.0]],
            [
                -2.677_945_044_588_987,
                1.150_261_991_510_931_6,
                2.255_515_529_797_18,
            ],
            ([-1.5, 0.4, 3.2], [0.3, 0.1, -0.5]),
            [
                -1.026_008_793_493_141_7,
                0.049_486_736_455_099_545,
                3.150_272_862_205_07,
            ],
        ),
        (
            [[0.0, 1.0, 1.0], [-1.0, 1.0, -1.0], [-2.0, -1.0, 1.0]],
            [
                -1.107_148_717_794_090_4,
                1.150_261_991_510_931_6,
                2.255_515_529_797_18,
            ],
            ([2.1, 3.4, -11.0], [0.1, -0.2, 0.35]),
            [
                1.929_696_250_513_221_1,
                3.212_353_722_618_377_4,
                -10.670_932_366_381_068,
            ],
        ),
    ];
    for (axes, angles, (origin, at), point) in cases {
        let rotation = from_axes(axes.map(Vector3::from)).unwrap();
        let found = EulerSequence::ZXZ.angles(&rotation);
        near(found.angles.as_slice(), &angles, EXACT);
        let r = Vector3::from(origin) + rotation * Vector3::from(at);
        near(r.as_slice(), &point, EXACT);
    }
}

#[test]
fn names_are_read_and_wrong_ones_refused() {
    assert_eq!(
        "euler-zxz".parse(),
        Ok(OrientationSet::Euler(EulerSequence::ZXZ))
    );
    assert_eq!("rodriguez".parse(), Ok(OrientationSet::Rodriguez));
    for wrong in ["zzx", "zx", "zxzz", "abc", "zxz-body-x", "euler-", ""] {
        assert!(wrong.parse::<EulerSequence>().is_err(), "{wrong}");
        assert!(wrong.parse::<OrientationSet>().is_err(), "{wrong}");
    }
}
