//! Shabana, chapter 7: problems 7.24 and 7.25 in Euler angles, Example 7.12 in independent coordinates.

use super::chapter_7::{Frame, ZXZ, manipulator, state, system, written};
use super::*;

/// A free body, pushed at a point in ground axes.
struct Pushed {
    mass: f64,
    inertia: [[f64; 3]; 3],
    angles: [f64; 3],
    rates: [f64; 3],
    force: [f64; 3],
    at: [f64; 3],
}

impl Pushed {
    fn equations(&self) -> EquationsReport {
        let system = system(json!({
            "body": [{"name": "b", "mass": self.mass, "inertia": self.inertia}],
            "force": [{"name": "F", "kind": "force", "body": "b", "at": self.at, "value": self.force, "axes": "ground"}]
        }));
        let frame = Frame {
            at: [0.0; 3],
            angles: self.angles,
            velocity: [0.0; 3],
            rates: self.rates,
        };
        let state = state(&system, &[frame]);
        written(&system, &state, ZXZ)
    }
}

/// The block of the angles of a matrix of one body, row by row.
fn of_angles(m: &LabelledMatrix) -> Vec<f64> {
    m.values[3..]
        .iter()
        .flat_map(|row| row[3..].to_vec())
        .collect()
}

/// The generalized forces, and the accelerations they give.
#[track_caller]
fn pushes(
    report: &EquationsReport,
    forces: [[f64; 3]; 3],
    accelerations: [[f64; 3]; 2],
    rounding: f64,
) {
    let [force, q_theta, q_v] = forces;
    near(&report.applied.values[..3], &force, 1e-15);
    near(&report.applied.values[3..], &q_theta, rounding);
    assert_eq!(report.centrifugal.values[..3], [0.0; 3]);
    // At rest every entry is zero.
    near(&report.centrifugal.values[3..], &q_v, 2e-15);
    let a = &report.accelerations.as_ref().unwrap().values;
    near(&a[..3], &accelerations[0], 1e-15);
    near(&a[3..], &accelerations[1], 1e-14);
}

/// Problem 7.24: M, Q_e and Q_v of a body with a full tensor of inertia that turns fast.
#[test]
fn problem_7_24() {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
    let report = Pushed {
        mass: 5.0,
        inertia: [[4.5, -1.5, 0.0], [-1.5, 7.5, 0.0], [0.0, 0.0, 9.0]],
        angles: [FRAC_PI_4, FRAC_PI_2, PI],
        rates: [15.0, 80.0, -35.0],
        force: [3.0, 0.0, -8.0],
        at: [0.1, 0.0, -0.15],
    }
    .equations();
    let m = [7.5, -1.5, 0.0, -1.5, 4.5, 0.0, 0.0, 0.0, 9.0];
    near(&of_angles(&report.mass), &m, 1e-15);
    pushes(
        &report,
        [
            [3.0, 0.0, -8.0],
            [-0.106_066_017_177_982_14, -1.2, 0.8],
            [-35_175.0, 11_550.0, 16_462.5],
        ],
        [
            [0.6, 0.0, -1.6],
            [
                -4_475.072_295_145_311,
                1_074.709_234_951_563_3,
                1_829.255_555_555_555_5,
            ],
        ],
        // Q_e stands beside gyroscopic forces of 35 kN m: a rounding of these is left in it.
        1e-12,
    );
}

/// Problem 7.25: a flat body at rest, whose moments of inertia are on the limit of what can be.
#[test]
fn problem_7_25() {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, SQRT_2};
    let report = Pushed {
        mass: 3.0,
        inertia: [[15.0, 0.0, -10.0], [0.0, 25.0, 0.0], [-10.0, 0.0, 30.0]],
        angles: [0.0, FRAC_PI_2, FRAC_PI_4],
        rates: [0.0; 3],
        force: [9.0, 7.0, -12.0],
        at: [0.2, 0.0, -0.15],
    }
    .equations();
    let skew = -5.0 * SQRT_2;
    let m = [20.0, -5.0, skew, -5.0, 20.0, skew, skew, skew, 30.0];
    near(&of_angles(&report.mass), &m, 1e-15);
    pushes(
        &report,
        [
            [9.0, 7.0, -12.0],
            [
                -0.360_050_506_338_833_2,
                -2.789_949_493_661_166,
                -2.969_848_480_983_5,
            ],
            [0.0; 3],
        ],
        [
            [3.0, 7.0 / 3.0, -4.0],
            [
                -0.146_402_020_253_553_3,
                -0.243_597_979_746_446_67,
                -0.190_918_830_920_367_82,
            ],
        ],
        1e-15,
    );
}

/// Example 7.12 in the angles of its two pins (7.211 to 7.219): M_r, Q_r and the accelerations. The angles are theta of
/// the second body and psi of the third, so the embedding in these coordinates gives the equations of the book.
#[test]
fn example_7_12_in_joint_coordinates() {
    let (system, state) = manipulator();
    let report = Equations {
        orientation: Some(ZXZ),
        independent: vec!["2.theta".to_owned(), "3.psi".to_owned()],
        ..Equations::default()
    }
    .run(&system, &state)
    .unwrap();
    let own = report.independent.unwrap();
    assert_eq!(own.mass.rows, ["2.theta", "3.psi"]);
    near_rows(
        &own.mass,
        &[
            &[0.431_629_245_016_864_6, -0.021_992_075_826_746_5],
            &[-0.021_992_075_826_746_5, 0.311],
        ],
        1e-14,
    );
    near(&own.velocities.values, &[1.2, -0.7], 1e-15);
    near(
        &own.force.values,
        &[2.917_118_881_565_14, -2.278_294_544_332_682_3],
        1e-14,
    );
    near(
        &own.accelerations.unwrap().values,
        &[6.408_224_601_354_748, -6.872_554_286_124_972],
        1e-13,
    );
    // H_t and gamma_t of Example 7.11 are the rows of B and gamma that belong to the positions.
    let b = |row: usize| own.motions.values[row].clone();
    near(&b(0), &[-0.019_843_462_973_913_543, 0.0], 1e-13);
    near(&b(2), &[0.030_103_770_149_317_217, 0.0], 1e-13);
    near(
        &b(6),
        &[-0.024_275_126_291_555_4, -0.064_059_177_063_004_29],
        1e-13,
    );
    near(&b(7), &[0.0, 0.292_511_350_870_908_6], 1e-13);
    near(
        &b(8),
        &[-0.339_888_643_064_323_87, 0.027_083_785_660_185_405],
        1e-13,
    );
    let gamma = &own.acceleration_offset.values;
    near(
        &gamma[..3],
        &[0.043_349_429_015_016_79, 0.0, 0.028_574_586_682_435_5],
        1e-13,
    );
    near(
        &gamma[6..9],
        &[
            -0.666_956_595_760_977_9,
            -0.034_079_172_785_785_98,
            -0.016_847_685_778_326_918,
        ],
        1e-13,
    );
}
