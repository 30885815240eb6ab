//! The models to start from.

use dalembert::analysis::{Assembly, Dynamics, Kinematics};
use dalembert::model::{Model, SpaceKind};
use dalembert::space::{Planar, Spatial};
use dalembert::system::compile::{ModelSpace, compile};
use dalembert_io::model_file::{parse_model, render, templates, write_model};

#[test]
fn templates_have_no_mistakes_and_survive_writing() {
    assert_eq!(templates().len(), 8);
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
        match model.info.space {
            SpaceKind::Planar => assembles_near::<Planar>(&model, template.name),
            SpaceKind::Spatial => assembles_near::<Spatial>(&model, template.name),
        }
    }
}

fn assembles_near<S: ModelSpace>(model: &Model, name: &str) {
    let compiled = compile::<S>(model, &[]).unwrap_or_else(|e| panic!("{name}: {e}"));
    assert_eq!(compiled.warnings, [], "{name}");
    let (_, report) = Assembly::default()
        .run(&compiled.system)
        .unwrap_or_else(|e| panic!("{name}: {e}"));
    for moved in report.moved {
        let (distance, turn) = (moved.distance.abs(), moved.turn.abs());
        assert!(distance < 0.01 && turn < 0.01, "{name}: {moved:?}");
    }
}

#[test]
fn driven_templates_move_as_their_comments_say() {
    for template in templates() {
        let model = parse_model(template.text, None).model.unwrap();
        if model.drivers.is_empty() {
            continue;
        }
        let compiled = compile::<Planar>(&model, &[]).unwrap();
        let run = Kinematics {
            instants: compiled.options.instants(),
            ..Kinematics::default()
        }
        .run(&compiled.system)
        .unwrap();
        assert!(run.stopped.is_none(), "{}", template.name);
        let range = |name: &str| {
            let values = &run.results.channel(name).unwrap().values;
            values.iter().copied().fold(f64::MIN, f64::max)
                - values.iter().copied().fold(f64::MAX, f64::min)
        };
        let turn = std::f64::consts::TAU;
        let (measured, expected) = match template.name {
            // The stroke of a centred slider crank is twice its crank; 84 ms are two turns.
            "slider-crank" => (range("slider.x"), 0.3),
            "four-bar" => (range("crank.angle"), 2.0 * turn),
            "cam-follower" => (range("follower.y"), 0.012),
            "planetary-gear" => (range("carrier.angle"), turn),
            name => panic!("what does {name} do?"),
        };
        // The stroke is found between the instants: half a step from the dead centre of the crank
        // costs r (1 + r/l) phi^2 / 2 with phi = 150/s * 0.1 ms.
        let tolerance = if template.name == "slider-crank" {
            3e-5
        } else {
            1e-9
        };
        assert!(
            (measured - expected).abs() < tolerance,
            "{}: {measured}",
            template.name
        );
    }
}

#[test]
fn free_templates_run_to_their_end() {
    for template in templates() {
        let model = parse_model(template.text, None).model.unwrap();
        if !model.drivers.is_empty() {
            continue;
        }
        match model.info.space {
            SpaceKind::Planar => runs_to_its_end::<Planar>(&model, template.name),
            SpaceKind::Spatial => runs_to_its_end::<Spatial>(&model, template.name),
        }
    }
}

fn runs_to_its_end<S: ModelSpace>(model: &Model, name: &str) {
    let compiled = compile::<S>(model, &[]).unwrap();
    let run = Dynamics::new(&compiled.options)
        .run(&compiled.system, &mut |_| true)
        .unwrap();
    assert!(run.stopped.is_none(), "{name}");
    assert_eq!(run.results.len(), compiled.options.instants().len());
}
