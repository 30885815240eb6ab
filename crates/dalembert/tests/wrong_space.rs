//! Keys and kinds in the wrong space, in models that are built without a file.

use dalembert::diagnostic::Diagnostic;
use dalembert::model::*;
use dalembert::system::compile::compile;

/// Path, message and help of what belongs to the other space.
fn found(model: &Model) -> Vec<[String; 3]> {
    let errors = compile(model, &[]).map(|_| ()).unwrap_err().0;
    let wrong = errors.into_iter().filter(|d| d.code == "wrong-space");
    let parts = |d: Diagnostic| [d.path, d.message, d.help.unwrap_or_default()];
    wrong.map(parts).collect()
}

fn paths(model: &Model) -> Vec<String> {
    found(model).into_iter().map(|[path, ..]| path).collect()
}

fn turn() -> Option<Orientation> {
    Some(Orientation::Rodriguez {
        rodriguez: Default::default(),
    })
}

fn three() -> Point {
    vec![0.0.into(), 0.0.into(), 1.0.into()]
}

fn placement() -> Placement {
    Placement {
        bodies: ["ground".to_owned(), "a".to_owned()],
        ..Placement::default()
    }
}

fn joint(kind: JointKind) -> Joint {
    let name = "j".to_owned();
    Joint { name, kind }
}

fn shape(kind: ShapeKind) -> Shape {
    Shape {
        kind,
        at: None,
        angle: None,
        orientation: None,
        mass: None,
        density: None,
        thickness: None,
        cut: false,
        color: None,
    }
}

/// A model that has everything that only spatial models have.
fn all_spatial() -> Model {
    let numbers = || [1.0.into(), 1.0.into(), 1.0.into()];
    let angle = Quantity::RelativeAngle {
        bodies: placement().bodies,
        axis: Some(three()),
    };
    let height = Quantity::Coordinate {
        body: "a".to_owned(),
        at: None,
        coordinate: CoordinateName::Z,
    };
    let named = |name: &str| name.to_owned();
    Model {
        bodies: vec![Body {
            name: named("a"),
            inertia: Some(Inertia::Moments(numbers())),
            inertia_at: Some(three()),
            inertia_orientation: turn(),
            orientation: turn(),
            angular_velocity: Some(AxialVector::Spatial(numbers())),
            angular_velocity_axes: Some(Axes::Body),
            hold: vec![
                HeldCoordinate::X,
                HeldCoordinate::Z,
                HeldCoordinate::Orientation,
            ],
            shape: vec![
                Shape {
                    orientation: turn(),
                    ..shape(ShapeKind::Lump {
                        inertia: Some(Inertia::Tensor([numbers(), numbers(), numbers()])),
                    })
                },
                shape(ShapeKind::Sphere { radius: 1.0.into() }),
            ],
            ..Body::default()
        }],
        joints: vec![
            joint(JointKind::Revolute {
                placement: Placement {
                    axis: Some(three()),
                    axes: Some([three(), three()]),
                    x_axis: Some(three()),
                    x_axes: Some([three(), three()]),
                    ..placement()
                },
            }),
            // Of a kind that is wrong, nothing else is said.
            joint(JointKind::Spherical {
                placement: Placement {
                    axis: Some(three()),
                    ..placement()
                },
            }),
        ],
        constraints: vec![Constraint {
            name: named("c"),
            kind: ConstraintKind::Coupler {
                terms: vec![Term {
                    factor: 1.0.into(),
                    quantity: angle.clone(),
                }],
                value: None,
            },
        }],
        drivers: vec![Driver {
            name: named("d"),
            kind: DriverKind::Path {
                kind: PathTag::Path,
                body: named("a"),
                at: None,
                from: None,
                from_at: None,
                x: None,
                y: None,
                z: Some(1.0.into()),
            },
        }],
        forces: vec![
            Force {
                name: named("f"),
                kind: ForceKind::Moment {
                    body: named("a"),
                    value: AxialVector::Spatial(numbers()),
                    axes: Some(Axes::Body),
                },
            },
            Force {
                name: named("g"),
                kind: ForceKind::TorsionSpring {
                    bodies: placement().bodies,
                    axis: Some(three()),
                    stiffness: None,
                    damping: None,
                    free_angle: None,
                    moment: None,
                },
            },
        ],
        initial: vec![Initial {
            quantity: height,
            value: Some(1.0.into()),
            rate: None,
        }],
        traces: vec![Trace {
            name: named("t"),
            body: named("a"),
            orientation: turn(),
            ..Trace::default()
        }],
        output: OutputOptions {
            orientation: Some(named("euler-zxz")),
            ..OutputOptions::default()
        },
        ..Model::default()
    }
}

#[test]
fn a_planar_model_has_nothing_spatial() {
    assert_eq!(
        paths(&all_spatial()),
        [
            "body[0].orientation",
            "body[0].inertia",
            "body[0].inertia_at",
            "body[0].inertia_orientation",
            "body[0].angular_velocity",
            "body[0].angular_velocity_axes",
            "body[0].hold[1]",
            "body[0].hold[2]",
            "body[0].shape[0].orientation",
            "body[0].shape[0].inertia",
            "body[0].shape[1].kind",
            "joint[0].axis",
            "joint[0].axes",
            "joint[0].x_axis",
            "joint[0].x_axes",
            "joint[1].kind",
            "constraint[0].terms[0].axis",
            "driver[0].z",
            "force[0].value",
            "force[0].axes",
            "force[1].axis",
            "initial[0].coordinate",
            "trace[0].orientation",
            "output.orientation",
        ]
    );
}

#[test]
fn a_spatial_model_may_have_all_of_that() {
    let mut model = all_spatial();
    model.info.space = SpaceKind::Spatial;
    let errors = compile(&model, &[]).map(|_| ()).err();
    let errors = errors.map(|e| e.0).unwrap_or_default();
    assert!(errors.iter().all(|d| d.code != "wrong-space"), "{errors:?}");
}

#[test]
fn a_spatial_model_has_nothing_planar() {
    let placement = Placement {
        angles: Some([0.0.into(), 0.0.into()]),
        direction: Some(three()),
        ..placement()
    };
    let thick = |kind| Shape {
        angle: Some(1.0.into()),
        thickness: Some(0.01.into()),
        ..shape(kind)
    };
    let radius = || 1.0.into();
    let model = Model {
        info: Info {
            space: SpaceKind::Spatial,
            ..Info::default()
        },
        bodies: vec![Body {
            name: "a".to_owned(),
            inertia: Some(1.0.into()),
            angle: Some(1.0.into()),
            angular_velocity: Some(1.0.into()),
            hold: vec![HeldCoordinate::Angle],
            shape: vec![
                thick(ShapeKind::Sphere { radius: radius() }),
                thick(ShapeKind::Disk { radius: radius() }),
                thick(ShapeKind::Circle { radius: radius() }),
            ],
            ..Body::default()
        }],
        joints: vec![
            joint(JointKind::Revolute {
                placement: placement.clone(),
            }),
            joint(JointKind::PinSlot { placement }),
        ],
        drivers: vec![Driver {
            name: "d".to_owned(),
            kind: DriverKind::Scalar {
                quantity: Quantity::Coordinate {
                    body: "a".to_owned(),
                    at: None,
                    coordinate: CoordinateName::Angle,
                },
                motion: Motion::Value { value: 1.0.into() },
            },
        }],
        forces: vec![Force {
            name: "f".to_owned(),
            kind: ForceKind::Moment {
                body: "a".to_owned(),
                value: 1.0.into(),
                axes: None,
            },
        }],
        traces: vec![Trace {
            name: "t".to_owned(),
            body: "a".to_owned(),
            angle: Some(1.0.into()),
            ..Trace::default()
        }],
        ..Model::default()
    };
    assert_eq!(
        paths(&model),
        [
            "body[0].angle",
            "body[0].inertia",
            "body[0].angular_velocity",
            "body[0].hold[0]",
            "body[0].shape[0].angle",
            "body[0].shape[0].thickness",
            "body[0].shape[1].angle",
            "body[0].shape[2].kind",
            "joint[0].angles",
            "joint[0].direction",
            "joint[1].kind",
            "driver[0].coordinate",
            "force[0].value",
            "trace[0].angle",
        ]
    );
    let [_, message, help] = &found(&model)[0];
    assert_eq!(message, "body 'a': `angle` belongs to planar models");
    assert_eq!(
        help,
        "a spatial body has `orientation`: write orientation = { axis = [0, 0, 1], angle = ... }"
    );
}

#[test]
fn an_actuator_may_name_one_of_several_coordinates() {
    let slot = |coordinate: Option<&str>| Model {
        bodies: vec![Body {
            name: "a".to_owned(),
            mass: Some(1.0.into()),
            inertia: Some(1.0.into()),
            ..Body::default()
        }],
        joints: vec![joint(JointKind::PinSlot {
            placement: Placement {
                point: Some(vec![0.0.into(), 0.0.into()]),
                angles: Some([0.0.into(), 0.0.into()]),
                ..placement()
            },
        })],
        forces: vec![Force {
            name: "f".to_owned(),
            kind: ForceKind::Actuator {
                joint: "j".to_owned(),
                value: "2 N*m".into(),
                coordinate: coordinate.map(str::to_owned),
            },
        }],
        ..Model::default()
    };
    assert!(compile(&slot(Some("angle")), &[]).is_ok());
    for wrong in [Some("displacement"), Some("angle_1"), None] {
        assert!(compile(&slot(wrong), &[]).is_err(), "{wrong:?}");
    }
}
