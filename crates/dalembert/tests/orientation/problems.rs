//! Problems of A. A. Shabana, Computational Dynamics (2nd ed.), Chapters 7 and 8, and its formulas with data of our own.

use super::*;
use dalembert::space::orientation::{
    AxisAngle, EulerParameters, EulerSequence, RodriguezParameters, from_axes, relative, skew,
};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, FRAC_PI_6};

fn axes(x: [f64; 3], y: [f64; 3], z: [f64; 3]) -> Rotation {
    from_axes([x, y, z].map(Vector3::from)).unwrap()
}

fn turn(axis: Vector3<f64>, angle: f64) -> Rotation {
    AxisAngle::new(axis, angle).unwrap().rotation()
}

#[track_caller]
fn equal(found: &Matrix3<f64>, expected: &Matrix3<f64>, tolerance: f64) {
    near(found.as_slice(), expected.as_slice(), tolerance);
}

/// Equations 7.32 and 7.67 to 7.84: matrices, velocities and accelerations of ZXZ Euler angles in general motion.
#[test]
fn zxz_kinematics() {
    let zxz = EulerSequence::ZXZ;
    let angles = Vector3::new(0.4, 0.9, -0.6);
    let rates = Vector3::new(1.3, -0.7, 2.1);
    let accelerations = Vector3::new(-0.5, 1.1, 0.3);
    let a = matrix(&zxz.rotation(&angles));
    let gbar = zxz.gbar(&angles);
    let change = zxz.gbar_rate(&angles, &rates);
    equal(
        &a,
        &Matrix3::from_row_slice(&[
            0.8968653694285765,
            0.3202841999238543,
            0.3050418666328927,
            -0.0018799672830789886,
            0.6924203627676979,
            -0.721491862010698,
            -0.4422996437289516,
            0.6465075966326971,
            0.6216099682706644,
        ]),
        EXACT,
    );
    equal(
        &gbar,
        &Matrix3::from_row_slice(&[
            -0.4422996437289516,
            0.8253356149096783,
            0.0,
            0.6465075966326971,
            0.5646424733950354,
            0.0,
            0.6216099682706644,
            0.0,
            1.0,
        ]),
        EXACT,
    );
    equal(
        &(a * gbar),
        &Matrix3::from_row_slice(&[
            0.0,
            0.9210609940028851,
            0.3050418666328927,
            0.0,
            0.3894183423086505,
            -0.721491862010698,
            1.0,
            0.0,
            0.6216099682706644,
        ]),
        EXACT,
    );
    equal(
        &change,
        &Matrix3::from_row_slice(&[
            1.6033571259086141,
            1.1857491941295744,
            0.0,
            0.5697034600531403,
            -1.7332047913103246,
            0.0,
            0.5483288367392384,
            0.0,
            0.0,
        ]),
        EXACT,
    );
    // G' = A' Gbar + A Gbar', with A' = A omegabar~.
    let own = gbar * rates;
    let moving = a * skew(&own) * gbar + a * change;
    equal(
        &moving,
        &Matrix3::from_row_slice(&[
            0.0,
            -0.5062438450012458,
            0.768492994229361,
            0.0,
            1.1973792922037507,
            0.7973329133029965,
            0.0,
            0.0,
            0.5483288367392384,
        ]),
        EXACT,
    );
    near(
        own.as_slice(),
        &[-1.152724467284412, 0.4452101442459815, 2.9080929587518636],
        EXACT,
    );
    near(
        (a * own).as_slice(),
        &[
            -0.004154775872944833,
            -1.7877257498385213,
            2.6053809333683953,
        ],
        EXACT,
    );
    let alpha = gbar * accelerations + change * rates;
    near(
        alpha.as_slice(),
        &[2.3833588260556184, 2.2517107744045, 0.7020225036256778],
        EXACT,
    );
    near(
        (a * alpha).as_slice(),
        &[3.072885632775572, 1.0481462313299734, 0.8379735476335999],
        EXACT,
    );
    // A point of the body.
    let u = Vector3::new(0.2, -0.35, 0.15);
    let normal = a * (own.cross(&own.cross(&u)) + (change * rates).cross(&u));
    near(
        normal.as_slice(),
        &[-0.9098068122896941, 3.980843180865471, 1.5560262055988479],
        2e-14,
    );
    let whole = a * (own.cross(&own.cross(&u)) + alpha.cross(&u));
    near(
        whole.as_slice(),
        &[-1.0667724515795698, 4.190088616175897, 1.1443898474453245],
        2e-14,
    );
    assert!(((a * gbar).determinant() - -0.7833269096274835).abs() < EXACT);
}

/// Examples 7.3 and 7.4: angular velocity of a turn about the ground's z; in body axes it is the same only where the body
/// stood along that axis.
#[test]
fn turn_about_a_fixed_axis() {
    let start = axes([1.0, 0.0, 1.0], [1.0, 1.0, -1.0], [-1.0, 2.0, 1.0]);
    let skewed = [1.7677669529663687, -1.4433756729740645, 1.0206207261596576];
    for (start, own) in [(Rotation::identity(), [0.0, 0.0, 2.5]), (start, skewed)] {
        let path = |s: f64| matrix(&(turn(Vector3::z(), 0.7 + 2.5 * s) * start));
        let (a, change) = (path(0.0), rate(path));
        let found = body_omega(&a, &change);
        near(found.as_slice(), &own, 1e-11);
        near((a * found).as_slice(), &[0.0, 0.0, 2.5], 1e-11);
    }
}

/// Problems 7.1 to 7.3 and 7.5 to 7.8: frames of axes, relative orientation, turns about body axes.
#[test]
fn problems_7_1_to_7_8() {
    let first = axes([0.5, 0.0, 0.5], [0.25, 0.25, -0.25], [-2.0, 4.0, 2.0]);
    let second = axes([0.0, 1.0, 1.0], [-1.0, 1.0, -1.0], [-2.0, -1.0, 1.0]);
    let third = axes([0.0, -1.0, 1.0], [-1.0, 1.0, 1.0], [-2.0, -1.0, -1.0]);
    equal(
        &matrix(&first),
        &Matrix3::from_row_slice(&[
            0.7071067811865475,
            0.5773502691896258,
            -0.4082482904638631,
            0.0,
            0.5773502691896258,
            0.8164965809277261,
            0.7071067811865475,
            -0.5773502691896258,
            0.4082482904638631,
        ]),
        EXACT,
    );
    equal(
        &matrix(&second),
        &Matrix3::from_row_slice(&[
            0.0,
            -0.5773502691896258,
            -0.8164965809277261,
            0.7071067811865475,
            0.5773502691896258,
            -0.4082482904638631,
            0.7071067811865475,
            -0.5773502691896258,
            0.4082482904638631,
        ]),
        EXACT,
    );
    equal(
        &matrix(&third),
        &Matrix3::from_row_slice(&[
            0.0,
            -0.5773502691896258,
            -0.8164965809277261,
            -0.7071067811865475,
            0.5773502691896258,
            -0.4082482904638631,
            0.7071067811865475,
            0.5773502691896258,
            -0.4082482904638631,
        ]),
        EXACT,
    );
    let seen = relative(&third, &first);
    equal(
        &matrix(&seen),
        &Matrix3::from_row_slice(&[
            0.4999999999999999,
            -0.816496580927726,
            -0.2886751345948129,
            0.0,
            -0.3333333333333334,
            0.9428090415820636,
            -0.8660254037844387,
            -0.4714045207910318,
            -0.1666666666666667,
        ]),
        EXACT,
    );
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let sixth = first * turn(z, FRAC_PI_4) * turn(x, FRAC_PI_3);
    equal(
        &matrix(&sixth),
        &Matrix3::from_row_slice(&[
            0.908248290463863,
            -0.39942924536134217,
            -0.12466483393298619,
            0.408248290463863,
            0.9112309264184791,
            0.05469489987058938,
            0.09175170953613697,
            -0.10057075463865783,
            0.9906902377174246,
        ]),
        EXACT,
    );
    let seventh = second * turn(y, FRAC_PI_2) * turn(x, FRAC_PI_6);
    equal(
        &matrix(&seventh),
        &Matrix3::from_row_slice(&[
            0.8164965809277261,
            -0.5000000000000001,
            0.2886751345948128,
            0.40824829046386313,
            0.8535533905932738,
            0.32369730110098166,
            -0.408248290463863,
            -0.1464466094067264,
            0.9010475702906073,
        ]),
        EXACT,
    );
    let eighth = third * turn(x, FRAC_PI_3) * turn(z, FRAC_PI_4);
    equal(
        &matrix(&eighth),
        &Matrix3::from_row_slice(&[
            -0.7041241452319316,
            -0.7041241452319317,
            0.09175170953613683,
            -0.5458758547680684,
            0.45412414523193145,
            -0.7041241452319316,
            0.45412414523193156,
            -0.5458758547680683,
            -0.7041241452319316,
        ]),
        EXACT,
    );
}

/// Section 8.2 and problem 8.12: turns about body axes are the turns about where these axes stand, in reverse order.
#[test]
fn successive_turns() {
    let (phi, theta, psi) = (0.4, 1.1, -0.6);
    let expected = &Matrix3::from_row_slice(&[
        0.8599221259089616,
        0.3742839892483949,
        0.34705249280839284,
        0.08549902055847894,
        0.564698850379906,
        -0.8208563369208728,
        -0.5032135280929487,
        0.7355451745283359,
        0.4535961214255773,
    ]);
    equal(
        &matrix(&EulerSequence::ZXZ.rotation(&Vector3::new(phi, theta, psi))),
        expected,
        EXACT,
    );
    let first = turn(Vector3::z(), phi);
    let node = first * Vector3::x();
    near(
        node.as_slice(),
        &[0.9210609940028851, 0.3894183423086505, 0.0],
        EXACT,
    );
    let second = turn(node, theta);
    let last = second * first * Vector3::z();
    near(
        last.as_slice(),
        &[0.34705249280839284, -0.8208563369208728, 0.4535961214255773],
        EXACT,
    );
    equal(
        &matrix(&(turn(last, psi) * second * first)),
        expected,
        EXACT,
    );
}

/// Problems 8.10 and 8.11: rates of Euler parameters, Rodriguez parameters and Euler angles. The book's parameters have
/// the square of the norm 1.12495; these are the numbers of the same direction, and of the 60 degrees that are meant.
#[test]
fn problems_8_10_and_8_11() {
    let omega = Vector3::new(60.36, 37.935, -23.295);
    let cases = [
        (
            Quaternion::new(0.866, 0.35355, 0.35355, 0.35355),
            [
                -12.500164534182002,
                34.84683895932797,
                1.5441134513441392,
                -5.7725321402673115,
            ],
            [48.92901499321294, 8.141404283051275, -0.8196788578263257],
            [1.173001759097768, 0.981779428160225, -0.39779456769712873],
            [-50.65600865292234, 58.35556627829259, 49.2508528235308],
        ),
        (
            *turn(Vector3::repeat(1.0), FRAC_PI_3).quaternion(),
            [
                -10.825317547305483,
                34.974435931834556,
                4.351777654016805,
                -6.850260943934911,
            ],
            [44.55166666666666, 9.191666666666668, -3.743333333333336],
            [1.1071487177940904, 0.8410686705679301, -0.4636476090008062],
            [-56.409, 60.923908114959275, 49.67099999999999],
        ),
    ];
    for (parameters, beta, gamma, angles, angle_rates) in cases {
        let rotation = Rotation::from_quaternion(parameters);
        let own = rotation.inverse() * omega;
        let found = EulerParameters::of(&rotation).rates(&own);
        near(found.as_slice(), &beta, 2e-14);
        let rodriguez = RodriguezParameters::of(&rotation).unwrap();
        near(rodriguez.rates(&own).as_slice(), &gamma, 2e-14);
        let euler = EulerSequence::ZXZ.angles(&rotation).angles;
        near(euler.as_slice(), &angles, EXACT);
        let found = EulerSequence::ZXZ.gbar(&euler).lu().solve(&own).unwrap();
        near(found.as_slice(), &angle_rates, 5e-14);
    }
}

/// Problem 8.6: second derivatives of the Euler parameters, 1/2 Gbar^T alphabar - 1/4 |omegabar|^2 beta.
#[test]
fn problem_8_6() {
    let [w, x, y, z] = [
        0.8319126178569929,
        -0.4834829448522443,
        -0.17420660811923577,
        0.2093267684146428,
    ];
    let rotation = Rotation::from_quaternion(Quaternion::new(w, x, y, z));
    let beta = EulerParameters::of(&rotation);
    let tensor = Matrix3::new(2.0, 0.3, -0.1, 0.3, 1.5, 0.2, -0.1, 0.2, 1.0);
    let omega = Vector3::new(1.0, -2.0, 0.5);
    let moment = Vector3::new(0.7, 0.1, -0.4) - omega.cross(&(tensor * omega));
    let alpha = tensor.lu().solve(&moment).unwrap();
    near(
        alpha.as_slice(),
        &[
            -0.2843382090617196,
            -0.2630217623974313,
            -0.4758294684266854,
        ],
        EXACT,
    );
    let rates = beta.rates(&alpha);
    let own = [w, x, y, z];
    let found: Vec<f64> = (0..4)
        .map(|k| rates[k] - own[k] * omega.norm_squared() / 4.0)
        .collect();
    near(
        &found,
        &[
            -1.1337297903361823,
            0.5852741598315038,
            -0.025546903839260938,
            -0.4338491822679928,
        ],
        EXACT,
    );
}
