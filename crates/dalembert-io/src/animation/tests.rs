//! Tests of the animation data.

use super::*;
use dalembert::results::Channel;

fn sample() -> Animation {
    let end = |body: &str| JointEnd {
        body: body.to_owned(),
        at: [0.1, 0.0, 0.0],
        direction: None,
        reference: None,
        outline: Vec::new(),
    };
    let spring_end = |body: &str| SpringEnd {
        body: body.to_owned(),
        at: [0.25, 0.0, 0.0],
    };
    Animation {
        title: "</script><script>alert(1)</script> & <!-- \"x\"".to_owned(),
        analysis: "kinematics".to_owned(),
        time: vec![0.0, 1.0 / 3.0],
        bodies: vec![AnimatedBody {
            name: "crank".to_owned(),
            color: Some("#4477aa".to_owned()),
            position: vec![0.0, 1e-18, 0.0, 2.0, 0.123_456_789, 0.0],
            quaternion: vec![1.0, 0.0, 0.0, 0.0, 0.6, 0.0, 0.0, 0.8],
            shapes: vec![
                Shape::new(Form::Bar {
                    length: 0.15,
                    width: 0.02,
                })
                .planar([0.5, 0.25], std::f64::consts::PI),
                Shape {
                    cut: true,
                    ..Shape::new(Form::Circle { radius: 0.5 })
                },
            ],
        }],
        ground: Ground {
            shapes: vec![
                Shape::new(Form::Polygon {
                    points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.5]],
                }),
                Shape::new(Form::Lump),
            ],
        },
        joints: vec![Joint {
            name: "A".to_owned(),
            kind: "translational".to_owned(),
            first: JointEnd {
                direction: Some([1.0, 0.0, 0.0]),
                ..end("ground")
            },
            second: JointEnd {
                outline: vec![[0.0, 1.0 / 3.0], [1.0, 0.0], [0.0, -1.0]],
                ..end("crank")
            },
        }],
        springs: vec![Spring {
            name: "s".to_owned(),
            kind: "spring-damper".to_owned(),
            first: spring_end("ground"),
            second: spring_end("crank"),
        }],
        loads: vec![Load {
            name: "push".to_owned(),
            on: spring_end("crank"),
            along: None,
        }],
        traces: vec![AnimatedTrace {
            name: "tip".to_owned(),
            body: "crank".to_owned(),
            at: [0.0, 0.0, 0.0],
        }],
        channels: vec![AnimatedChannel::from(&Channel {
            name: "crank.angle".to_owned(),
            unit: "rad".to_owned(),
            meaning: "angle".to_owned(),
            values: vec![1.0, 2.5],
            gaps: false,
        })],
        notes: vec!["note".to_owned()],
        summary: vec![("Degrees of freedom".to_owned(), "1".to_owned())],
        ..Animation::default()
    }
}

#[test]
fn the_json_keeps_the_contract_with_the_viewer() {
    let json: serde_json::Value = serde_json::from_str(&sample().to_json().unwrap()).unwrap();
    let expected = serde_json::json!({
        "format": "dalembert-animation/1",
        "title": "</script><script>alert(1)</script> & <!-- \"x\"",
        "space": "planar",
        "analysis": "kinematics",
        "time": [0, 0.3333333],
        "bodies": [{
            "name": "crank",
            "color": "#4477aa",
            "position": [0, 0, 0, 2, 0.1234568, 0],
            "quaternion": [1, 0, 0, 0, 0.6, 0, 0, 0.8],
            "shapes": [
                {"kind": "bar", "length": 0.15, "width": 0.02, "position": [0.5, 0.25, 0],
                 "quaternion": [0, 0, 0, 1], "color": null, "cut": false},
                {"kind": "circle", "radius": 0.5, "position": [0, 0, 0],
                 "quaternion": [1, 0, 0, 0], "color": null, "cut": true}
            ]
        }],
        "ground": {"shapes": [
            {"kind": "polygon", "points": [[0, 0], [1, 0], [0, 0.5]], "position": [0, 0, 0],
             "quaternion": [1, 0, 0, 0], "color": null, "cut": false},
            {"kind": "lump", "position": [0, 0, 0], "quaternion": [1, 0, 0, 0],
             "color": null, "cut": false}
        ]},
        "joints": [{
            "name": "A", "kind": "translational",
            "first": {"body": "ground", "at": [0.1, 0, 0], "direction": [1, 0, 0]},
            "second": {"body": "crank", "at": [0.1, 0, 0], "direction": null,
                       "outline": [[0, 0.3333333], [1, 0], [0, -1]]}
        }],
        "springs": [{
            "name": "s", "kind": "spring-damper",
            "first": {"body": "ground", "at": [0.25, 0, 0]},
            "second": {"body": "crank", "at": [0.25, 0, 0]}
        }],
        "loads": [{"name": "push", "on": {"body": "crank", "at": [0.25, 0, 0]}}],
        "traces": [{"name": "tip", "body": "crank", "at": [0, 0, 0]}],
        "channels": [{"name": "crank.angle", "unit": "rad", "meaning": "angle", "values": [1, 2.5]}],
        "notes": ["note"],
        "summary": [["Degrees of freedom", "1"]]
    });
    assert_eq!(json, expected);
}

#[test]
fn the_data_reads_back_from_the_page_to_seven_digits() {
    let page = format!("<html><head>{MARKER}</head><body></body></html>");
    let text = html(&page, &sample()).unwrap();
    // Nothing of the data can end the element: its only closing tag is the page's own.
    let (_, rest) = text.split_once("type=\"application/json\">").unwrap();
    let (data, rest) = rest.split_once("</script>").unwrap();
    assert_eq!(rest, "</head><body></body></html>");
    assert!(!data.contains('<'));
    let back: Animation = serde_json::from_str(data).unwrap();
    assert_eq!(back.title, sample().title);
    assert_eq!(back.joints[0].first, sample().joints[0].first);
    assert_eq!(back.loads, sample().loads);
    for (found, exact) in back.bodies[0]
        .position
        .iter()
        .zip(&sample().bodies[0].position)
    {
        assert!((found - exact).abs() <= 0.5e-6 * exact.abs().max(1e-6));
    }
}

#[test]
fn a_page_without_its_one_marker_is_refused() {
    for (page, count) in [("<html></html>".to_owned(), 0), (MARKER.repeat(2), 2)] {
        let error = html(&page, &sample()).unwrap_err();
        assert!(matches!(error, AnimationError::Marker { found } if found == count));
    }
}

#[test]
fn data_that_do_not_hang_together_are_refused() {
    let mut wrong = sample();
    wrong.bodies[0].quaternion.pop();
    assert_eq!(
        wrong.to_json().unwrap_err().to_string(),
        "\"crank\": quaternion has 7 numbers instead of 8"
    );
    let mut wrong = sample();
    wrong.springs[0].second.body = "crnk".to_owned();
    assert_eq!(
        wrong.to_json().unwrap_err().to_string(),
        "\"s\" sits on the body \"crnk\", which is not there"
    );
    let mut wrong = sample();
    wrong.joints[0].second.outline = vec![[0.0, f64::NAN]];
    assert_eq!(
        wrong.to_json().unwrap_err().to_string(),
        "\"A\": number 1 of outline is not finite"
    );
    let mut wrong = sample();
    wrong.bodies[0].shapes[1].form = Form::Circle { radius: f64::NAN };
    assert!(matches!(
        wrong.to_json(),
        Err(AnimationError::NotFinite {
            field: "circle",
            index: 0,
            ..
        })
    ));
    let mut wrong = sample();
    wrong.channels[0].values[1] = f64::INFINITY;
    assert!(matches!(
        wrong.to_json(),
        Err(AnimationError::NotFinite {
            field: "values",
            index: 1,
            ..
        })
    ));
}

fn spatial(form: Solid) -> Animation {
    let mut animation = sample();
    animation.space = "spatial".to_owned();
    animation.bodies[0].shapes =
        vec![Shape::new(form).spatial([0.0, 0.0, 0.5], [0.0, 1.0, 0.0, 0.0])];
    animation
}

/// One of each form, with what JSON says of it.
fn solids() -> Vec<(Solid, serde_json::Value)> {
    use serde_json::json;
    vec![
        (
            Solid::Box {
                size: [1.0, 2.0, 0.5],
            },
            json!({"kind": "box", "size": [1, 2, 0.5]}),
        ),
        (
            Solid::Cylinder {
                radius: 0.5,
                length: 2.0,
            },
            json!({"kind": "cylinder", "radius": 0.5, "length": 2}),
        ),
        (
            Solid::Tube {
                outer: 0.5,
                inner: 0.25,
                length: 2.0,
            },
            json!({"kind": "tube", "outer": 0.5, "inner": 0.25, "length": 2}),
        ),
        (
            Solid::Sphere { radius: 0.5 },
            json!({"kind": "sphere", "radius": 0.5}),
        ),
        (
            Solid::Hemisphere { radius: 0.5 },
            json!({"kind": "hemisphere", "radius": 0.5}),
        ),
        (
            Solid::Cone {
                radius: 0.5,
                height: 1.0,
            },
            json!({"kind": "cone", "radius": 0.5, "height": 1}),
        ),
        (
            Solid::Rod {
                length: 2.0,
                radius: 0.125,
            },
            json!({"kind": "rod", "length": 2, "radius": 0.125}),
        ),
        (
            Solid::Disk {
                radius: 0.5,
                thickness: 0.125,
            },
            json!({"kind": "disk", "radius": 0.5, "thickness": 0.125}),
        ),
        (
            Solid::Plate {
                width: 2.0,
                height: 1.0,
                thickness: 0.125,
            },
            json!({"kind": "plate", "width": 2, "height": 1, "thickness": 0.125}),
        ),
        (
            Solid::Ellipsoid {
                semi_axes: [1.0, 2.0, 3.0],
            },
            json!({"kind": "ellipsoid", "semi_axes": [1, 2, 3]}),
        ),
        (
            Solid::Torus {
                radius: 1.0,
                tube: 0.25,
            },
            json!({"kind": "torus", "radius": 1, "tube": 0.25}),
        ),
        (
            Solid::Mesh {
                vertices: vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0],
                triangles: vec![0, 1, 2],
            },
            json!({"kind": "mesh", "vertices": [0, 0, 0, 1, 0, 0, 0, 1, 0], "triangles": [0, 1, 2]}),
        ),
        (
            Solid::Revolved {
                profile: vec![[0.0, 0.0], [0.5, 1.0]],
            },
            json!({"kind": "revolved", "profile": [[0, 0], [0.5, 1]]}),
        ),
        (
            Solid::Surface {
                nu: 2,
                nv: 2,
                points: vec![0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.5],
            },
            json!({"kind": "surface", "nu": 2, "nv": 2,
                   "points": [0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0.5]}),
        ),
        (
            Solid::Curve {
                points: vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
            },
            json!({"kind": "curve", "points": [0, 0, 0, 1, 1, 1]}),
        ),
    ]
}

#[test]
fn forms_of_space_keep_the_contract_and_read_back() {
    for (form, mut expected) in solids() {
        let animation = spatial(form.clone());
        let text = animation.to_json().unwrap();
        let json: serde_json::Value = serde_json::from_str(&text).unwrap();
        for (key, value) in [
            ("position", serde_json::json!([0, 0, 0.5])),
            ("quaternion", serde_json::json!([0, 1, 0, 0])),
            ("color", serde_json::Value::Null),
            ("cut", serde_json::json!(false)),
        ] {
            expected[key] = value;
        }
        assert_eq!(json["bodies"][0]["shapes"][0], expected);
        let back: Animation = serde_json::from_str(&text).unwrap();
        assert_eq!(back.bodies[0].shapes[0].form, Form::Solid(form));
    }
}

#[test]
fn axes_lines_and_the_upward_direction_are_written_where_they_are_given() {
    let mut animation = sample();
    animation.up = Some([0.0, 1.0, 0.0]);
    animation.joints[0].first.reference = Some([0.0, 0.0, 1.0]);
    animation.loads[0].along = Some(Line {
        body: "ground".to_owned(),
        direction: [0.0, 0.0, -2.0],
    });
    let text = animation.to_json().unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["up"], serde_json::json!([0, 1, 0]));
    assert_eq!(
        json["joints"][0]["first"]["reference"],
        serde_json::json!([0, 0, 1])
    );
    assert_eq!(
        json["loads"][0]["along"],
        serde_json::json!({"body": "ground", "direction": [0, 0, -2]})
    );
    let back: Animation = serde_json::from_str(&text).unwrap();
    assert_eq!(back.loads, animation.loads);
    animation.loads[0].along = Some(Line {
        body: "crank".to_owned(),
        direction: [0.0; 3],
    });
    assert_eq!(
        animation.to_json().unwrap_err().to_string(),
        "\"push\": its direction has no length"
    );
}

#[test]
fn forms_without_sense_are_refused_by_name() {
    let corners = vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    for (form, text) in [
        (
            Solid::Cylinder {
                radius: -1.0,
                length: 1.0,
            },
            "\"crank\": the radius of its cylinder is -1, it must be positive",
        ),
        (
            Solid::Box {
                size: [1.0, f64::NAN, 1.0],
            },
            "\"crank\": number 1 of box is not finite",
        ),
        (
            Solid::Tube {
                outer: 0.5,
                inner: 0.5,
                length: 1.0,
            },
            "\"crank\": the inner size of its tube must be smaller than the outer",
        ),
        (
            Solid::Mesh {
                vertices: corners.clone(),
                triangles: vec![0, 1, 3],
            },
            "\"crank\": a triangle of its mesh names corner 3 of 3, counted from 0",
        ),
        (
            Solid::Mesh {
                vertices: corners[..8].to_vec(),
                triangles: vec![0, 1, 2],
            },
            "\"crank\": the vertices of its mesh have 8 numbers, not a multiple of 3",
        ),
        (
            Solid::Mesh {
                vertices: corners.clone(),
                triangles: vec![],
            },
            "\"crank\": its mesh has 0 in triangles, it needs at least 1",
        ),
        (
            Solid::Revolved {
                profile: vec![[-0.5, 0.0], [1.0, 0.0]],
            },
            "\"crank\": the radius -0.5 in the profile of its revolved form is negative",
        ),
        (
            Solid::Surface {
                nu: 2,
                nv: 2,
                points: corners.clone(),
            },
            "\"crank\": points of its surface has 9 numbers instead of 12",
        ),
        (
            Solid::Curve {
                points: corners[..3].to_vec(),
            },
            "\"crank\": its curve has 1 in points, it needs at least 2",
        ),
    ] {
        assert_eq!(spatial(form).to_json().unwrap_err().to_string(), text);
    }
}
