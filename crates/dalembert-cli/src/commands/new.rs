//! `dalembert new`: templates.

use crate::arguments::NewArgs;
use crate::failure::Failure;
use dalembert_io::model_file::templates;

/// Prints a template, or the list of templates.
pub fn run(args: &NewArgs) -> Result<(), Failure> {
    let Some(name) = &args.template else {
        say!("Templates (dalembert new NAME > my.toml):");
        for t in templates() {
            say!("  {:16} {}", t.name, t.description);
        }
        return Ok(());
    };
    if let Some(t) = templates().iter().find(|t| t.name == name) {
        say_on!("{}", t.text);
        return Ok(());
    }
    let names: Vec<&str> = templates().iter().map(|t| t.name).collect();
    let hint = dalembert_expr::nearest(name, names.iter().copied())
        .first()
        .map_or_else(
            || format!("the templates are: {}", names.join(", ")),
            |n| format!("did you mean '{n}'?"),
        );
    Err(Failure::Usage(format!(
        "there is no template '{name}'; {hint}"
    )))
}
