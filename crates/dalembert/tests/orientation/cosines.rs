//! Direction cosines, axes, points.

use super::*;
use dalembert::space::orientation::{
    AxisAngle, OrientationError, from_axes, from_matrix, from_points, relative, triad,
};
use std::f64::consts::FRAC_PI_2;

fn axes(x: [f64; 3], y: [f64; 3], z: [f64; 3]) -> Rotation {
    from_axes([x, y, z].map(Vector3::from)).unwrap()
}

/// Shabana, Examples 7.1 and 7.2: axes of any length, then 90 degrees about body z and about body x.
#[test]
fn examples_7_1_and_7_2() {
    let start = axes([1.0, 0.0, 1.0], [1.0, 1.0, -1.0], [-1.0, 2.0, 1.0]);
    let (a, b, c) = (2.0_f64.sqrt(), 3.0_f64.sqrt(), 6.0_f64.sqrt());
    let expected = Matrix3::new(
        1.0 / a,
        1.0 / b,
        -1.0 / c, //
        0.0,
        1.0 / b,
        2.0 / c, //
        1.0 / a,
        -1.0 / b,
        1.0 / c,
    );
    near(matrix(&start).as_slice(), expected.as_slice(), EXACT);
    let turn = |axis| AxisAngle::new(axis, FRAC_PI_2).unwrap().rotation();
    let end = start * turn(Vector3::z()) * turn(Vector3::x());
    let expected = Matrix3::new(
        1.0 / b,
        -1.0 / c,
        1.0 / a, //
        1.0 / b,
        2.0 / c,
        0.0, //
        -1.0 / b,
        1.0 / c,
        1.0 / a,
    );
    near(matrix(&end).as_slice(), expected.as_slice(), EXACT);
    let u = end * Vector3::new(0.0, -1.0, 0.0);
    near(u.as_slice(), &[1.0 / c, -2.0 / c, -1.0 / c], EXACT);
}

/// Shabana, Problem 7.4: relative orientation of two bodies.
#[test]
fn problem_7_4() {
    let i = axes([0.0, 1.0, 1.0], [-1.0, 1.0, -1.0], [-2.0, -1.0, 1.0]);
    let j = axes([0.0, -1.0, 1.0], [-1.0, 1.0, 1.0], [-2.0, -1.0, -1.0]);
    let (a, b, c) = (2.0_f64.sqrt(), 3.0_f64.sqrt(), 6.0_f64.sqrt());
    let expected = Matrix3::new(
        0.0,
        -2.0 / c,
        1.0 / b, //
        2.0 / c,
        1.0 / 3.0,
        a / 3.0, //
        -1.0 / b,
        a / 3.0,
        2.0 / 3.0,
    );
    near(
        matrix(&relative(&j, &i)).as_slice(),
        expected.as_slice(),
        EXACT,
    );
    near(
        matrix(&relative(&i, &j)).as_slice(),
        expected.transpose().as_slice(),
        EXACT,
    );
}

#[test]
fn matrices_go_there_and_back_at_every_angle() {
    let mut random = Random::new(SEED);
    for _ in 0..500 {
        let r = rotation(&mut random);
        same(&from_matrix(&matrix(&r)).unwrap(), &r, EXACT);
        // Half turns, where the scalar part vanishes.
        let half = AxisAngle::new(vector(&mut random), std::f64::consts::PI)
            .unwrap()
            .rotation();
        same(&from_matrix(&matrix(&half)).unwrap(), &half, EXACT);
    }
}

/// Digits of four places become the nearest rotation.
#[test]
#[allow(clippy::approx_constant, reason = "the digits are the point")]
fn printed_digits_are_taken() {
    let printed = Matrix3::new(
        0.5773, -0.4082, 0.7071, //
        0.5773, 0.8165, 0.0, //
        -0.5773, 0.4082, 0.7071,
    );
    let a = matrix(&from_matrix(&printed).unwrap());
    assert!((a.transpose() * a - Matrix3::identity()).amax() < EXACT);
    assert!((a - printed).amax() < 1e-4);
}

#[test]
fn points_and_triads() {
    let mut random = Random::new(SEED);
    for _ in 0..200 {
        let [o, p, q] = [0; 3].map(|_| vector(&mut random));
        let a = matrix(&from_points(&o, &p, &q).unwrap());
        assert!(a.column(0).dot(&(p - o)) > 0.0);
        assert!(a.column(1).dot(&(q - o)) > 0.0);
        assert!(a.column(2).dot(&(q - o)).abs() < 1e-13);
        let axis = 1e-200 * vector(&mut random);
        let z = matrix(&triad(&axis).unwrap()).column(2).into_owned();
        assert!((z - (axis / 1e-200).normalize()).amax() < EXACT);
    }
}

#[test]
fn what_is_no_frame_is_refused() {
    let v = |x, y, z| Vector3::new(x, y, z);
    let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
    assert_eq!(from_axes([x, y, -z]), Err(OrientationError::LeftHanded));
    assert!(matches!(
        from_axes([x, v(0.1, 1.0, 0.0), z]),
        Err(OrientationError::NotOrthogonal {
            first: 'x',
            second: 'y',
            ..
        })
    ));
    assert!(matches!(
        from_axes([x, Vector3::zeros(), z]),
        Err(OrientationError::ZeroVector { .. })
    ));
    assert_eq!(
        from_axes([x, y, v(f64::NAN, 0.0, 1.0)]),
        Err(OrientationError::NotFinite)
    );
    assert!(matches!(
        from_matrix(&(2.0 * Matrix3::identity())),
        Err(OrientationError::NotNormal { letter: 'x', .. })
    ));
    assert_eq!(
        from_points(&x, &(2.0 * x), &(3.0 * x)),
        Err(OrientationError::Collinear)
    );
}
