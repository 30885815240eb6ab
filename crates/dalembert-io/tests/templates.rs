//! The models to start from.

use dalembert::analysis::Assembly;
use dalembert::system::compile::compile;
use dalembert_io::model_file::{parse_model, render, templates, write_model};

#[test]
fn templates_have_no_mistakes_and_survive_writing() {
    assert_eq!(templates().len(), 7);
    for template in templates() {
        let parsed = parse_model(template.text, None);
        let report = render(
            &parsed.diagnostics,
            &parsed.source,
            template.name,
            template.text,
            false,
        );
        assert_eq!(report, "");
        let model = parsed.model.unwrap();
        assert!(!model.bodies.is_empty() && !model.joints.is_empty());
        assert!(model.bodies.iter().all(|b| !b.shape.is_empty()));
        assert_eq!(parse_model(&write_model(&model), None).model, Some(model));
    }
}

#[test]
fn the_slider_crank_is_what_the_design_says() {
    let template = templates().iter().find(|t| t.name == "slider-crank");
    let model = parse_model(template.unwrap().text, None).model.unwrap();
    let names: Vec<&str> = model.bodies.iter().map(|b| b.name.as_str()).collect();
    assert_eq!(names, ["crank", "rod", "slider"]);
    assert_eq!(model.parameters["crank_length"], "150 mm".into());
    assert_eq!(model.parameters["rod_length"], "350 mm".into());
}

#[test]
fn the_engine_accepts_templates_and_assembles_them_near_their_estimates() {
    for template in templates() {
        let model = parse_model(template.text, None).model.unwrap();
        let compiled = compile(&model, &[]).unwrap_or_else(|e| panic!("{}: {e}", template.name));
        assert_eq!(compiled.warnings, [], "{}", template.name);
        let assembly = Assembly::default();
        let (_, report) = assembly
            .run(&compiled.system)
            .unwrap_or_else(|e| panic!("{}: {e}", template.name));
        for moved in report.moved {
            let (distance, turn) = (moved.distance.abs(), moved.turn.abs());
            assert!(
                distance < 0.01 && turn < 0.01,
                "{}: {moved:?}",
                template.name
            );
        }
    }
}
