//! Constraint equations of joints in ZXZ Euler angles, off the constraints and in motion: residual, Jacobian and right side
//! of the accelerations (A. A. Shabana, Computational Dynamics, 2nd ed., sections 7.9 and 7.10, data of our own).

use super::near;
use dalembert::joint::SpatialMeasure::{self, Along, Distance, Dot, Ground};
use dalembert::space::orientation::{Axis, EulerSequence};
use dalembert::space::{Space, Spatial, SpatialFrame, SpatialMarker};
use nalgebra::{Matrix3, Vector3, Vector6};

/// A few roundings.
const EXACT: f64 = 1e-14;

/// A body by position and ZXZ Euler angles, with their rates, and a frame of a joint on it.
struct Moving {
    position: [f64; 3],
    angles: [f64; 3],
    velocity: [f64; 3],
    rates: [f64; 3],
    frame: SpatialFrame,
}

impl Moving {
    fn marker(&self) -> SpatialMarker {
        let turn = EulerSequence::ZXZ.rotation(&Vector3::from(self.angles));
        let [x, y, z] = self.position;
        let pose = Spatial::pose(&[x, y, z, turn.w, turn.i, turn.j, turn.k]);
        let omega = self.gbar() * Vector3::from(self.rates);
        let mut v = [0.0; 6];
        v[..3].copy_from_slice(&self.velocity);
        v[3..].copy_from_slice(omega.as_slice());
        Spatial::marker(&self.frame, &pose, &v)
    }

    fn gbar(&self) -> Matrix3<f64> {
        EulerSequence::ZXZ.gbar(&Vector3::from(self.angles))
    }

    /// Velocities of the body for a unit rate of each of the six coordinates.
    fn directions(&self) -> [Vector6<f64>; 6] {
        let gbar = self.gbar();
        std::array::from_fn(|k| {
            let mut v = Vector6::zeros();
            if k < 3 {
                v[k] = 1.0;
            } else {
                v.fixed_rows_mut::<3>(3).copy_from(&gbar.column(k - 3));
            }
            v
        })
    }

    /// Acceleration of the frame where those of the coordinates vanish.
    fn bias(&self) -> Vector6<f64> {
        let rates = Vector3::from(self.rates);
        let change = EulerSequence::ZXZ.gbar_rate(&Vector3::from(self.angles), &rates) * rates;
        let mut v = Vector6::zeros();
        v.fixed_rows_mut::<3>(3).copy_from(&change);
        let marker = self.marker();
        Spatial::push(&marker, &v) + Spatial::bias(&marker)
    }
}

/// A row C = sign * measure(i, j), and what its value must be zero at.
#[derive(Clone, Copy)]
struct Row(f64, SpatialMeasure);

/// Residual, row of the Jacobian and Q_d = -(C_q q')_q q' of a measure between two bodies.
fn equations(two: &[Moving; 2], measure: SpatialMeasure) -> (f64, [f64; 12], f64) {
    let markers = [two[0].marker(), two[1].marker()];
    let found = measure.evaluate(&markers[0], &markers[1]);
    let gradients = [found.first, found.second];
    let mut row = [0.0; 12];
    let mut bias = found.bias;
    for k in 0..2 {
        for (c, direction) in two[k].directions().iter().enumerate() {
            row[6 * k + c] = gradients[k].dot(&Spatial::push(&markers[k], direction));
        }
        bias += gradients[k].dot(&two[k].bias());
    }
    (found.value, row, -bias)
}

#[track_caller]
fn compare(
    what: &str,
    two: &[Moving; 2],
    rows: &[Row],
    residual: &[f64],
    jacobian: &[[f64; 12]],
    right: &[f64],
) {
    assert_eq!(rows.len(), jacobian.len());
    for (k, Row(sign, measure)) in rows.iter().enumerate() {
        let (value, row, q_d) = equations(two, *measure);
        near(
            &format!("{what} {k}: C"),
            &[sign * value],
            &[residual[k]],
            EXACT,
        );
        near(
            &format!("{what} {k}: C_q"),
            &row.map(|x| sign * x),
            &jacobian[k],
            EXACT,
        );
        near(
            &format!("{what} {k}: Q_d"),
            &[sign * q_d],
            &[right[k]],
            EXACT,
        );
    }
}

fn frame(at: [f64; 3], x: [f64; 3], z: [f64; 3]) -> SpatialFrame {
    let (x, z) = (Vector3::from(x), Vector3::from(z));
    SpatialFrame {
        at: Vector3::from(at),
        axes: Matrix3::from_columns(&[x, z.cross(&x), z]),
    }
}

/// Equations 7.165 to 7.182 of two bodies in general motion that no joint holds together.
#[test]
fn joints_off_their_constraints() {
    let two = [
        Moving {
            position: [0.3, -0.2, 0.5],
            angles: [0.4, 0.9, -0.6],
            velocity: [0.2, 0.1, -0.4],
            rates: [1.3, -0.7, 2.1],
            frame: frame(
                [0.1, 0.2, -0.15],
                [0.8944271909999159, -0.4472135954999579, 0.0],
                [0.4082482904638631, 0.8164965809277261, -0.4082482904638631],
            ),
        },
        Moving {
            position: [-0.4, 0.6, 1.1],
            angles: [-1.1, 1.4, 0.7],
            velocity: [-0.3, 0.5, 0.2],
            rates: [-0.6, 0.8, 0.4],
            frame: frame(
                [-0.2, 0.05, 0.3],
                [0.0, 0.28734788556634544, 0.9578262852211514],
                [0.43193421279068, -0.86386842558136, 0.259160527674408],
            ),
        },
    ];
    // The book's r_ij is r_i - r_j, the measures run from the first frame to the second.
    let ball = Axis::ALL.map(|axis| Row(-1.0, Ground(axis)));
    let sleeve = [
        Row(1.0, Dot(Axis::X, Axis::Z)),
        Row(1.0, Dot(Axis::Y, Axis::Z)),
        Row(-1.0, Along(Axis::X)),
        Row(-1.0, Along(Axis::Y)),
    ];
    let key = Row(1.0, Dot(Axis::X, Axis::X));
    compare(
        "spherical",
        &two,
        &ball,
        &[1.169179673865248, -0.5774294195212044, -0.5698769303157573],
        &[
            [
                1.0,
                0.0,
                0.0,
                -0.24651985512683638,
                -0.0031815246033068327,
                -0.14734465389332987,
                -1.0,
                0.0,
                0.0,
                0.023949274648040742,
                -0.03412701232523773,
                -0.013046239214554518,
            ],
            [
                0.0,
                1.0,
                0.0,
                0.10798709693269462,
                0.007525013321647358,
                0.06961802973338561,
                0.0,
                -1.0,
                0.0,
                0.3611925769325533,
                -0.01736956080064644,
                0.09502132541921995,
            ],
            [
                0.0,
                0.0,
                1.0,
                0.0,
                0.18500766652631764,
                0.15311068840906003,
                0.0,
                0.0,
                -1.0,
                0.0,
                0.3110341848705406,
                0.18248491268576517,
            ],
        ],
        &[1.7651370383162948, 1.5644377097413795, 0.7470249191285123],
    );
    compare(
        "cylindrical",
        &two,
        &sleeve,
        &[
            0.5961721700392016,
            -0.2047383956606541,
            1.3404159668087092,
            -0.4763838674554697,
        ],
        &[
            [
                0.0,
                0.0,
                0.0,
                -0.580243625978464,
                -0.44041257040834375,
                -0.625088916382094,
                0.0,
                0.0,
                0.0,
                0.580243625978464,
                0.3678474112875962,
                -0.31076572865814744,
            ],
            [
                0.0,
                0.0,
                0.0,
                0.4758046416250191,
                -0.8527725081048687,
                0.2433862692406355,
                0.0,
                0.0,
                0.0,
                -0.4758046416250191,
                0.12702213433950552,
                -0.9144693145368009,
            ],
            [
                0.6589453244533293,
                -0.3113412938869035,
                -0.6847318147288947,
                -0.21254445215068005,
                -0.49739752025972783,
                0.006337427705467358,
                -0.6589453244533293,
                0.3113412938869035,
                0.6847318147288947,
                -0.09667290169115099,
                -0.2300549755244838,
                -0.1631340461589667,
            ],
            [
                -0.5591595709314677,
                0.406136011986359,
                -0.7227683681536935,
                0.02973060173657785,
                -1.179627973956631,
                0.5472225269601216,
                0.5591595709314677,
                -0.406136011986359,
                0.7227683681536935,
                0.13330184661814504,
                -0.21277762882347112,
                -0.0860078108736601,
            ],
        ],
        &[
            9.826119166741414,
            1.5361763508187767,
            15.768926926794457,
            -5.4145265663098785,
        ],
    );
    compare(
        "revolute",
        &two,
        &[&ball[..], &sleeve[..2]].concat(),
        &[
            1.169179673865248,
            -0.5774294195212044,
            -0.5698769303157573,
            0.5961721700392016,
            -0.2047383956606541,
        ],
        &[
            [
                1.0,
                0.0,
                0.0,
                -0.24651985512683638,
                -0.0031815246033068327,
                -0.14734465389332987,
                -1.0,
                0.0,
                0.0,
                0.023949274648040742,
                -0.03412701232523773,
                -0.013046239214554518,
            ],
            [
                0.0,
                1.0,
                0.0,
                0.10798709693269462,
                0.007525013321647358,
                0.06961802973338561,
                0.0,
                -1.0,
                0.0,
                0.3611925769325533,
                -0.01736956080064644,
                0.09502132541921995,
            ],
            [
                0.0,
                0.0,
                1.0,
                0.0,
                0.18500766652631764,
                0.15311068840906003,
                0.0,
                0.0,
                -1.0,
                0.0,
                0.3110341848705406,
                0.18248491268576517,
            ],
            [
                0.0,
                0.0,
                0.0,
                -0.580243625978464,
                -0.44041257040834375,
                -0.625088916382094,
                0.0,
                0.0,
                0.0,
                0.580243625978464,
                0.3678474112875962,
                -0.31076572865814744,
            ],
            [
                0.0,
                0.0,
                0.0,
                0.4758046416250191,
                -0.8527725081048687,
                0.2433862692406355,
                0.0,
                0.0,
                0.0,
                -0.4758046416250191,
                0.12702213433950552,
                -0.9144693145368009,
            ],
        ],
        &[
            1.7651370383162948,
            1.5644377097413795,
            0.7470249191285123,
            9.826119166741414,
            1.5361763508187767,
        ],
    );
    compare(
        "prismatic",
        &two,
        &[&sleeve[..], &[key]].concat(),
        &[
            0.5961721700392016,
            -0.2047383956606541,
            1.3404159668087092,
            -0.4763838674554697,
            -0.7708101806508176,
        ],
        &[
            [
                0.0,
                0.0,
                0.0,
                -0.580243625978464,
                -0.44041257040834375,
                -0.625088916382094,
                0.0,
                0.0,
                0.0,
                0.580243625978464,
                0.3678474112875962,
                -0.31076572865814744,
            ],
            [
                0.0,
                0.0,
                0.0,
                0.4758046416250191,
                -0.8527725081048687,
                0.2433862692406355,
                0.0,
                0.0,
                0.0,
                -0.4758046416250191,
                0.12702213433950552,
                -0.9144693145368009,
            ],
            [
                0.6589453244533293,
                -0.3113412938869035,
                -0.6847318147288947,
                -0.21254445215068005,
                -0.49739752025972783,
                0.006337427705467358,
                -0.6589453244533293,
                0.3113412938869035,
                0.6847318147288947,
                -0.09667290169115099,
                -0.2300549755244838,
                -0.1631340461589667,
            ],
            [
                -0.5591595709314677,
                0.406136011986359,
                -0.7227683681536935,
                0.02973060173657785,
                -1.179627973956631,
                0.5472225269601216,
                0.5591595709314677,
                -0.406136011986359,
                0.7227683681536935,
                0.13330184661814504,
                -0.21277762882347112,
                -0.0860078108736601,
            ],
            [
                0.0,
                0.0,
                0.0,
                -0.4399274157240419,
                -0.12361457631696444,
                -0.6211712830291962,
                0.0,
                0.0,
                0.0,
                0.4399274157240419,
                0.4515184221242889,
                -0.015795193543359325,
            ],
        ],
        &[
            9.826119166741414,
            1.5361763508187767,
            15.768926926794457,
            -5.4145265663098785,
            -3.5244889589644464,
        ],
    );
    // Equation 7.173 has the square of the distance less that of the joint.
    let (length, row, q_d) = equations(&two, Distance);
    let markers = [two[0].marker(), two[1].marker()];
    let rate = Distance.evaluate(&markers[0], &markers[1]).rate;
    near(
        "square",
        &[length * length - 0.09],
        &[1.9351655600143534],
        EXACT,
    );
    near(
        "its row",
        &row.map(|x| 2.0 * length * x),
        &[
            2.338359347730496,
            -1.1548588390424088,
            -1.1397538606315145,
            -0.7011618610322573,
            -0.22699307811439176,
            -0.5994522439820752,
            -2.338359347730496,
            1.1548588390424088,
            1.1397538606315145,
            -0.3611244298224534,
            -0.41424424045449726,
            -0.3482308967185987,
        ],
        EXACT,
    );
    let right = 2.0 * length * q_d - 2.0 * rate * rate;
    near("its right side", &[right], &[1.1998055372455243], EXACT);
}

/// Example 7.9 and problem 7.30: Jacobians of ball joints. The poses of the example are singular in the Euler angles,
/// which the Jacobian survives.
#[test]
fn ball_joints() {
    let moving = |position, angles, at| Moving {
        position,
        angles,
        velocity: [0.0; 3],
        rates: [0.0; 3],
        frame: SpatialFrame {
            at: Vector3::from(at),
            axes: Matrix3::identity(),
        },
    };
    let ball = Axis::ALL.map(|axis| Row(-1.0, Ground(axis)));
    let quarter = std::f64::consts::FRAC_PI_2;
    let example = [
        moving([0.0; 3], [0.0; 3], [0.0, 0.0, 0.15]),
        moving([-0.0, -0.12, 0.15], [quarter, 0.0, 0.0], [0.12, 0.0, 0.0]),
    ];
    compare(
        "Example 7.9",
        &example,
        &ball,
        &[0.0; 3],
        &[
            [
                1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.12, 0.0, 0.12,
            ],
            [
                0.0, 1.0, 0.0, 0.0, -0.15, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0,
            ],
            [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0],
        ],
        &[0.0; 3],
    );
    let problem = [
        moving(
            [0.95, 3.0, -1.5],
            [30.0_f64, 60.0, 150.0].map(f64::to_radians),
            [0.1, 0.1, 0.25],
        ),
        moving(
            [0.6491025403784438, 2.728349364905389, -1.2566987298107781],
            [60.0_f64, 30.0, 90.0].map(f64::to_radians),
            [-0.3, -0.15, 0.0],
        ),
    ];
    compare(
        "Problem 7.30",
        &problem,
        &ball,
        &[0.0; 3],
        &[
            [
                1.0,
                0.0,
                0.0,
                0.27165063509461096,
                0.04665063509461096,
                0.06584936490538906,
                -1.0,
                0.0,
                0.0,
                0.0,
                0.12990381056766578,
                -0.037500000000000054,
            ],
            [
                0.0,
                1.0,
                0.0,
                -0.0008974596215561709,
                -0.08080127018922194,
                -0.04084936490538905,
                0.0,
                -1.0,
                0.0,
                -0.3,
                -0.07500000000000001,
                -0.3247595264191645,
            ],
            [
                0.0,
                0.0,
                1.0,
                0.0,
                -0.23480762113533157,
                -0.11830127018922193,
                0.0,
                0.0,
                -1.0,
                0.0,
                0.2598076211353316,
                -0.07499999999999997,
            ],
        ],
        &[0.0; 3],
    );
}
