//! Mass properties of spatial bodies: solids, meshes, composites, principal axes.

#[path = "support/mod.rs"]
mod support;

use dalembert::mass::{InertiaWarning, MassProperties, MeshError, Solid, mesh_properties};
use dalembert::space::orientation::{EulerSequence, Rotation};
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::PI;
use support::Random;

/// A few roundings.
const EXACT: f64 = 4e-15;

#[track_caller]
fn near(found: &Matrix3<f64>, expected: &Matrix3<f64>, tolerance: f64) {
    let d = (found - expected).amax();
    assert!(
        d <= tolerance * expected.amax().max(1.0),
        "{found} for {expected}, off by {d:e}"
    );
}

fn rotation(random: &mut Random) -> Rotation {
    let angles = Vector3::from_fn(|_, _| random.uniform(-3.0, 3.0));
    EulerSequence::ZXZ.rotation(&angles)
}

/// Eight corners and twelve triangles of a box with one corner at the origin.
fn box_mesh([a, b, c]: [f64; 3]) -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    let corner = |k: usize| {
        let pick = |bit: usize, x: f64| if k >> bit & 1 == 1 { x } else { 0.0 };
        [pick(0, a), pick(1, b), pick(2, c)]
    };
    let quads = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let triangles = quads
        .iter()
        .flat_map(|[i, j, k, l]| [[*i, *j, *k], [*i, *k, *l]])
        .collect();
    ((0..8).map(corner).collect(), triangles)
}

/// Shabana, Examples 7.5 and 7.6: a prism of 3 kg about a corner and about its centre.
#[test]
fn examples_7_5_and_7_6() {
    let edges = [0.4, 0.6, 0.9];
    let prism = Solid::Box(edges).properties(3.0);
    let central = Matrix3::from_diagonal(&Vector3::new(0.2925, 0.2425, 0.13));
    near(&prism.inertia, &central, EXACT);
    let corner = Vector3::from(edges) / 2.0;
    let about = prism.placed(&corner, &Rotation::identity());
    let expected = Matrix3::new(
        1.17, -0.18, -0.27, //
        -0.18, 0.97, -0.405, //
        -0.27, -0.405, 0.52,
    );
    near(&about.inertia_about(&Vector3::zeros()), &expected, EXACT);
    let back = MassProperties::about_origin(3.0, corner, expected);
    near(&back.inertia, &central, EXACT);
    // The same from triangles, of unit density.
    let (vertices, triangles) = box_mesh(edges);
    let mesh = mesh_properties(&vertices, &triangles).unwrap();
    let volume = 0.4 * 0.6 * 0.9;
    assert!((mesh.mass - volume).abs() < EXACT);
    near(&(mesh.inertia * 3.0 / volume), &central, EXACT);
    assert!((mesh.center - corner).amax() < EXACT);
    // Cube of unit mass and edge about a corner: moments 1/6, 11/12, 11/12.
    let cube = Solid::Box([1.0; 3])
        .properties(1.0)
        .inertia_about(&Vector3::repeat(0.5));
    let moments = MassProperties::about_origin(1.0, Vector3::zeros(), cube)
        .principal()
        .moments;
    let expected = Vector3::new(1.0 / 6.0, 11.0 / 12.0, 11.0 / 12.0);
    assert!((moments - expected).amax() < EXACT);
}

/// Stacks of thin ellipses along z with half axes a(z), b(z), by Gauss-Legendre with five points, which is exact here.
fn stacked(from: f64, to: f64, half_axes: impl Fn(f64) -> [f64; 2]) -> MassProperties {
    let nodes = [
        (0.0, 128.0 / 225.0),
        (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
        (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
        (0.906_179_845_938_664, 0.236_926_885_056_189_08),
        (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
    ];
    let mut sum = MassProperties::default();
    for (x, w) in nodes {
        let z = 0.5 * (from + to) + 0.5 * (to - from) * x;
        let [a, b] = half_axes(z);
        let mass = 0.5 * (to - from) * w * PI * a * b;
        let (xx, yy) = (b * b / 4.0, a * a / 4.0);
        sum = sum.plus(&MassProperties {
            mass,
            center: Vector3::new(0.0, 0.0, z),
            inertia: Matrix3::from_diagonal(&Vector3::new(xx, yy, xx + yy)) * mass,
        });
    }
    sum
}

#[test]
fn solids_are_stacks_of_ellipses() {
    let (r, h) = (0.7, 1.3);
    let round = |x: f64| [x, x];
    let ball = |z: f64| round((r * r - z * z).sqrt());
    let cases = [
        (
            Solid::Cylinder {
                radius: r,
                length: h,
            },
            stacked(-h / 2.0, h / 2.0, |_| round(r)),
        ),
        (
            Solid::Tube {
                inner: 0.4,
                outer: r,
                length: h,
            },
            stacked(-h / 2.0, h / 2.0, |_| round(r))
                .minus(&stacked(-h / 2.0, h / 2.0, |_| round(0.4))),
        ),
        (Solid::Sphere { radius: r }, stacked(-r, r, ball)),
        (Solid::Hemisphere { radius: r }, stacked(0.0, r, ball)),
        (
            Solid::Cone {
                radius: r,
                height: h,
            },
            stacked(0.0, h, |z| round(r * (1.0 - z / h))),
        ),
        (
            Solid::Ellipsoid([0.3, 0.5, 0.9]),
            stacked(-0.9, 0.9, |z| {
                let s = (1.0 - z * z / 0.81).sqrt();
                [0.3 * s, 0.5 * s]
            }),
        ),
    ];
    for (solid, expected) in cases {
        let found = solid.properties(solid.extent());
        assert!((found.mass - expected.mass).abs() < EXACT, "{solid:?}");
        assert!((found.center - expected.center).amax() < EXACT, "{solid:?}");
        near(&found.inertia, &expected.inertia, EXACT);
    }
}

/// Thin bodies are limits of thick ones; a shell is the derivative of a ball by its radius.
#[test]
fn thin_solids_are_limits() {
    let thin = 1e-9;
    let pairs = [
        (Solid::Rod { length: 0.8 }, Solid::Box([0.8, thin, thin])),
        (Solid::Plate([0.8, 0.5]), Solid::Box([0.8, 0.5, thin])),
        (
            Solid::Disk { radius: 0.6 },
            Solid::Cylinder {
                radius: 0.6,
                length: thin,
            },
        ),
    ];
    for (thin, thick) in pairs {
        near(
            &thin.properties(2.0).inertia,
            &thick.properties(2.0).inertia,
            1e-15,
        );
    }
    let ball = |r: f64| {
        let solid = Solid::Sphere { radius: r };
        solid.properties(solid.extent()).inertia
    };
    let h = 1e-4;
    // Per unit thickness and density; the fifth power of r leaves h^2 in the difference.
    let layer = (ball(0.6 + h) - ball(0.6 - h)) / (2.0 * h);
    let shell = Solid::Shell { radius: 0.6 };
    near(&shell.properties(shell.extent()).inertia, &layer, 1e-7);
}

#[test]
fn a_composite_is_its_parts_wherever_it_stands() {
    let mut random = Random::new(7_020);
    for _ in 0..50 {
        let part = |random: &mut Random| {
            let at = Vector3::from_fn(|_, _| random.uniform(-1.0, 1.0));
            let solid = Solid::Cone {
                radius: random.uniform(0.1, 1.0),
                height: random.uniform(0.1, 1.0),
            };
            solid
                .properties(random.uniform(0.5, 2.0))
                .placed(&at, &rotation(random))
        };
        let (a, b) = (part(&mut random), part(&mut random));
        let (at, turn) = (Vector3::new(0.3, -0.7, 0.2), rotation(&mut random));
        let once = a.plus(&b).placed(&at, &turn);
        let apart = a.placed(&at, &turn).plus(&b.placed(&at, &turn));
        assert!((once.center - apart.center).amax() < EXACT);
        near(&once.inertia, &apart.inertia, EXACT);
        let rest = once.minus(&b.placed(&at, &turn));
        near(&rest.inertia, &a.placed(&at, &turn).inertia, 2e-14);
    }
}

#[test]
fn principal_axes_of_simple_and_repeated_moments() {
    let mut random = Random::new(7_101);
    for moments in [
        [1.0, 2.0, 2.5],
        [1.0, 2.0, 2.0],
        [2.0, 2.0, 3.0],
        [2.0, 2.0, 2.0],
    ] {
        for _ in 0..50 {
            let c = *rotation(&mut random).to_rotation_matrix().matrix();
            let d = Matrix3::from_diagonal(&Vector3::from(moments));
            let inertia = c * d * c.transpose();
            let body = MassProperties {
                mass: 1.0,
                center: Vector3::zeros(),
                inertia,
            };
            let found = body.principal();
            assert!((found.moments - Vector3::from(moments)).amax() < EXACT);
            assert!((found.axes.determinant() - 1.0).abs() < EXACT);
            near(&(found.axes * d * found.axes.transpose()), &inertia, EXACT);
        }
        // A tensor that is diagonal already keeps the axes of the frame, whichever the order.
        let d = Matrix3::from_diagonal(&Vector3::new(moments[2], moments[0], moments[1]));
        let body = MassProperties {
            mass: 1.0,
            center: Vector3::zeros(),
            inertia: d,
        };
        let axes = body.principal().axes;
        assert!(
            axes.iter()
                .all(|x| x.abs() < 1e-15 || (x.abs() - 1.0).abs() < 1e-15),
            "{axes}"
        );
    }
}

/// Problem 7.24's tensor: 6 -+ 1.5 sqrt(2) and 9; those of Example 7.10 and problem 7.32 cannot be, and are told.
#[test]
fn tensors_of_the_book() {
    let tensor = |m: [[f64; 3]; 3]| MassProperties {
        mass: 1.0,
        center: Vector3::zeros(),
        inertia: Matrix3::from_fn(|i, j| m[i][j]),
    };
    let p24 = tensor([[4.5, -1.5, 0.0], [-1.5, 7.5, 0.0], [0.0, 0.0, 9.0]]);
    let root = 1.5 * 2.0_f64.sqrt();
    let expected = Vector3::new(6.0 - root, 6.0 + root, 9.0);
    assert!((p24.principal().moments - expected).amax() < EXACT);
    assert_eq!(p24.warning(), None);
    let flat = tensor([[15.0, 0.0, -10.0], [0.0, 25.0, 0.0], [-10.0, 0.0, 30.0]]);
    assert_eq!(flat.warning(), None, "10, 25, 35 is the limit");
    let wrong = tensor([[1.5, 0.0, -1.0], [0.0, 2.0, 0.0], [-1.0, 0.0, 2.5]]);
    assert!(
        matches!(wrong.warning(), Some(InertiaWarning::Triangle { moments })
        if (moments[0] - 0.881_966_011_250_105_2).abs() < EXACT)
    );
    let spun = tensor([[2.0, 1.5, -1.0], [1.5, 1.8, 0.5], [-1.0, 0.5, 3.0]]);
    assert!(matches!(
        spun.warning(),
        Some(InertiaWarning::Triangle { .. })
    ));
    for (tensor, digits) in [
        (p24, [3.878_679_656_440_358_5, 8.121_320_343_559_642, 9.0]),
        (flat, [10.0, 25.0, 35.0]),
        (wrong, [0.881_966_011_250_105_2, 2.0, 3.118_033_988_749_895]),
        (
            spun,
            [
                0.022_025_044_627_078_178,
                3.022_215_989_169_5,
                3.755_758_966_203_421_4,
            ],
        ),
    ] {
        let found = tensor.principal();
        let expected = Vector3::from(digits);
        assert!(
            (found.moments - expected).amax() < EXACT * expected.amax(),
            "{} for {expected}",
            found.moments
        );
        assert!((found.axes.determinant() - 1.0).abs() < EXACT);
    }
    let negative = tensor([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -0.1]]);
    assert!(matches!(
        negative.warning(),
        Some(InertiaWarning::Negative { .. })
    ));
}

#[test]
fn meshes_far_away_turned_inside_out_and_wrong() {
    let (vertices, triangles) = box_mesh([0.4, 0.6, 0.9]);
    let here = mesh_properties(&vertices, &triangles).unwrap();
    let far: Vec<[f64; 3]> = vertices
        .iter()
        .map(|v| [v[0] + 1e4, v[1] - 1e4, v[2]])
        .collect();
    let there = mesh_properties(&far, &triangles).unwrap();
    // The vertices themselves are rounded to 2e-12 there.
    near(&there.inertia, &here.inertia, 1e-11);
    let inside_out: Vec<[usize; 3]> = triangles.iter().map(|[a, b, c]| [*a, *c, *b]).collect();
    let turned = mesh_properties(&vertices, &inside_out).unwrap();
    near(&turned.inertia, &here.inertia, EXACT);
    assert_eq!(mesh_properties(&vertices, &[]), Err(MeshError::Empty));
    assert_eq!(
        mesh_properties(&vertices, &triangles[1..]),
        Err(MeshError::NotClosed { edges: 3 })
    );
    assert_eq!(
        mesh_properties(&vertices[..7], &triangles),
        Err(MeshError::NoSuchVertex {
            triangle: 3,
            vertex: 8,
            vertices: 7
        })
    );
    let flat: Vec<[f64; 3]> = vertices.iter().map(|v| [v[0], v[1], 0.0]).collect();
    assert_eq!(mesh_properties(&flat, &triangles), Err(MeshError::NoVolume));
    let mut bad = vertices;
    bad[2][1] = f64::NAN;
    assert_eq!(
        mesh_properties(&bad, &triangles),
        Err(MeshError::NotFinite { vertex: 3 })
    );
}
