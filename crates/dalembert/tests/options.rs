//! Options of the analyses that no run could use.

use dalembert::model::Model;
use dalembert::system::compile::compile;
use serde_json::json;

#[test]
fn a_time_span_that_is_no_number_is_refused() {
    let model = json!({
        "model": { "name": "machine" },
        "body": [{ "name": "disc", "mass": 1, "inertia": 1 }],
        "analysis": { "start": -1e308, "end": 1e308 },
    });
    let model: Model = serde_json::from_value(model).unwrap();
    let mistakes = compile::<dalembert::space::Planar>(&model, &[])
        .map(|_| ())
        .unwrap_err()
        .0;
    let found: Vec<_> = mistakes
        .iter()
        .map(|d| (d.code.as_str(), d.path.as_str()))
        .collect();
    assert_eq!(found, [("bad-option", "analysis.end")]);
}
