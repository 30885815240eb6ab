//! Shabana, chapter 7: the equations of motion in Euler angles as the program writes them.

use super::harness::{answer, refused, told};

const BODY: &str = "mass=5; Ixx=4.5; Iyy=7.5; Izz=9; Ixy=-1.5; phi=45 deg; theta=90 deg; psi=180 deg; omega_1=-80; \
    omega_2=-15; omega_3=-35; Fx=3; Fz=-8; u1=0.1; u3=-0.15; --orientation euler-zxz";

fn angles(vector: &serde_json::Value) -> Vec<f64> {
    let values = vector["values"].as_array().expect("values");
    values[3..].iter().map(|x| x.as_f64().unwrap()).collect()
}

#[track_caller]
fn near(found: &[f64], expected: [f64; 3], tolerance: f64) {
    for (x, y) in found.iter().zip(expected) {
        assert!((x - y).abs() <= tolerance, "{found:?} for {expected:?}");
    }
}

/// Problem 7.24 for programs: all numbers, with names of their rows.
#[test]
fn free_body_as_json() {
    let report = &answer("equations", "pushed-body.toml", BODY);
    let report = report.get("equations").unwrap_or(report);
    assert_eq!(report["orientation"], "euler-zxz");
    let names = ["x", "y", "z", "phi", "theta", "psi"].map(|n| format!("body.{n}"));
    assert_eq!(
        report["velocities"]["rows"],
        serde_json::json!(names),
        "{report:#}"
    );
    near(&angles(&report["velocities"]), [15.0, 80.0, -35.0], 1e-13);
    near(
        &angles(&report["applied"]),
        [-0.106_066_017_177_982_14, -1.2, 0.8],
        1e-10,
    );
    near(
        &angles(&report["centrifugal"]),
        [-35_175.0, 11_550.0, 16_462.5],
        1e-9,
    );
    near(
        &angles(&report["accelerations"]),
        [
            -4_475.072_295_145_311,
            1_074.709_234_951_563_3,
            1_829.255_555_555_555_5,
        ],
        1e-9,
    );
    let mass = report["mass"]["values"].as_array().expect("rows");
    for (row, expected) in
        mass[3..]
            .iter()
            .zip([[7.5, -1.5, 0.0], [-1.5, 4.5, 0.0], [0.0, 0.0, 9.0]])
    {
        let row: Vec<f64> = row.as_array().unwrap()[3..]
            .iter()
            .map(|x| x.as_f64().unwrap())
            .collect();
        near(&row, expected, 1e-14);
    }
}

/// The same for people: the set is named, and the columns hold q, v, a, Q_e, Q_v and M v.
#[test]
fn free_body_as_text() {
    let text = told("equations", "pushed-body.toml", BODY);
    assert!(text.contains("euler-zxz of the body frames"), "{text}");
    let line = |name: &str| -> Vec<String> {
        let line = text.lines().find(|l| l.trim_start().starts_with(name));
        let line = line.unwrap_or_else(|| panic!("no {name}\n{text}"));
        line.split_whitespace().skip(1).map(str::to_owned).collect()
    };
    assert_eq!(
        line("body.phi"),
        ["0.785398", "15", "-4475.07", "-0.106066", "-35175", "-7.5"]
    );
    assert_eq!(
        line("body.theta"),
        ["1.5708", "80", "1074.71", "-1.2", "11550", "337.5"]
    );
    assert_eq!(
        line("body.psi"),
        ["3.14159", "-35", "1829.26", "0.8", "16462.5", "-315"]
    );
    // Without the choice the turns are about the axes of the frame.
    let plain = told("equations", "pushed-body.toml", "");
    assert!(!plain.contains("body.phi"), "{plain}");
}

/// At theta = 0 the rates of these angles are not determined: the program names other sets.
#[test]
fn singular_angles_are_refused() {
    let text = refused("equations", "pushed-body.toml", "--orientation euler-zxz");
    assert!(
        text.contains("body 'body' stands at a singular pose of euler-zxz"),
        "{text}"
    );
    assert!(text.contains("euler-parameters"), "{text}");
}
