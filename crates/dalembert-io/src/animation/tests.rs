//! Tests of the animation data.

use super::*;
use dalembert::results::Channel;

fn sample() -> Animation {
    let end = |body: &str| JointEnd {
        body: body.to_owned(),
        at: [0.1, 0.0, 0.0],
        direction: None,
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
