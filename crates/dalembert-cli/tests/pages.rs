//! The animated page of a run, from `view` and from `--html`.

mod common;

use common::{dalembert, folder, model};
use serde_json::Value;
use std::path::Path;

/// The data in a page.
fn data(page: &Path) -> Value {
    let text = std::fs::read_to_string(page).unwrap();
    let (_, rest) = text
        .split_once("<script id=\"dalembert-data\" type=\"application/json\">")
        .unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

fn facts(data: &Value) -> Vec<(String, String)> {
    serde_json::from_value(data["summary"].clone()).unwrap()
}

/// Was the program built with the page? Without it the tests look at what it then says.
fn has_page(run: &common::Run) -> bool {
    if run.err.contains("without the animated page") {
        assert_eq!(run.code, 2);
        eprintln!("skipped: {}", run.err);
        return false;
    }
    true
}

#[test]
fn an_analysis_and_view_write_the_same_page() {
    let folder = folder("same-page");
    let [one, other] = ["one.html", "other.html"].map(|name| folder.join(name));
    let model = model("pendulum.toml");
    let run = dalembert(&["simulate", &model, "--html", one.to_str().unwrap()]);
    if !has_page(&run) {
        return;
    }
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(run.out.contains("one.html"));
    let run = dalembert(&["view", &model, "--html", other.to_str().unwrap()]);
    assert_eq!(run.code, 0, "{}", run.err);
    let (one, other) = (data(&one), data(&other));
    assert_eq!(one, other);
    assert_eq!(one["analysis"], "simulate");
    assert_eq!(one["time"].as_array().unwrap().len(), 11);
    let facts = facts(&one);
    let fact = |name: &str| {
        let row = facts.iter().find(|(key, _)| key == name);
        row.unwrap_or_else(|| panic!("{name}: {facts:?}")).1.clone()
    };
    assert_eq!(fact("Mobility"), "1");
    assert_eq!(fact("Coordinates"), "3");
    assert_eq!(fact("Constraint equations"), "2");
    assert_eq!(fact("Driver equations"), "0");
    assert_eq!(fact("Instants"), "11");
    assert!(fact("Steps").parse::<f64>().unwrap() >= 1.0);
    assert!(fact("Largest |energy.balance|").ends_with(" J"));
    assert!(!fact("Largest |violation.position|").is_empty());
}

#[test]
fn view_puts_the_page_beside_the_model() {
    let folder = folder("beside");
    let own = folder.join("my pendulum.toml");
    std::fs::copy(model("pendulum.toml"), &own).unwrap();
    let run = dalembert(&["view", own.to_str().unwrap(), "--json"]);
    if !has_page(&run) && run.code == 2 {
        return;
    }
    assert_eq!(run.code, 0, "{}", run.out);
    assert_eq!(data(&folder.join("my pendulum.html"))["title"], "Pendulum");
    assert!(
        run.json()["files"][0]
            .as_str()
            .unwrap()
            .ends_with("my pendulum.html")
    );
}

#[test]
fn without_the_page_nothing_is_computed() {
    let folder = folder("early");
    let (page, results) = (folder.join("p.html"), folder.join("r.csv"));
    let run = dalembert(&[
        "simulate",
        &model("pendulum.toml"),
        "--html",
        page.to_str().unwrap(),
        "--out",
        results.to_str().unwrap(),
    ]);
    assert_eq!(run.code == 0, page.exists());
    assert_eq!(run.code == 0, results.exists());
}
