//! `dalembert plot`: SVG of channels of a result file.

use crate::arguments::PlotArgs;
use crate::failure::Failure;
use crate::load::beside;
use crate::output::write_text;
use dalembert::results::Channel;
use dalembert_io::plot::{Plot, XyCurve, XyPlot, rounding_as_zero};
use dalembert_io::result_file::{read, select};

/// Draws the chosen channels.
pub fn run(args: &PlotArgs) -> Result<(), Failure> {
    let results = read(&args.results).map_err(|e| Failure::File {
        path: args.results.clone(),
        cause: e.to_string(),
    })?;
    if results.is_empty() {
        return Err(Failure::File {
            path: args.results.clone(),
            cause: "the file has no rows: there is nothing to draw".to_owned(),
        });
    }
    let usage = |e: dalembert_io::result_file::UnknownChannel| Failure::Usage(e.to_string());
    let ys = select(&results, &args.channels).map_err(usage)?;
    let drawn: Vec<Channel> = ys.iter().map(|y| rounding_as_zero(y, &results)).collect();
    let ys: Vec<&Channel> = drawn.iter().collect();
    let x = match &args.against {
        Some(name) => {
            let found = select(&results, std::slice::from_ref(name)).map_err(usage)?;
            if found.len() > 1 {
                let names: Vec<&str> = found.iter().map(|c| c.name.as_str()).collect();
                return Err(Failure::Usage(format!(
                    "--against {name}: {} channels match, the horizontal axis takes one: {}",
                    names.len(),
                    dalembert_io::result_file::some_of(&names)
                )));
            }
            found.first().copied()
        }
        None => results.channels.first(),
    };
    let Some(x) = x else {
        return Err(Failure::Usage("the result file has no channels".to_owned()));
    };
    let x = &rounding_as_zero(x, &results);
    let title = args.title.as_ref().unwrap_or(&results.model);
    let svg = if args.equal {
        let plot = XyPlot {
            title: title.clone(),
            x_label: x.name.clone(),
            x_unit: x.unit.clone(),
            y_label: ys
                .iter()
                .map(|c| c.name.as_str())
                .collect::<Vec<_>>()
                .join(", "),
            y_unit: ys.first().map(|c| c.unit.clone()).unwrap_or_default(),
            curves: ys
                .iter()
                .map(|y| XyCurve::of_channels(&y.name, x, y))
                .collect(),
            equal_aspect: true,
            ..XyPlot::default()
        };
        plot.to_svg()
    } else {
        Plot::of_channels(title, x, &ys).to_svg()
    };
    let path = args
        .out
        .clone()
        .unwrap_or_else(|| beside(&args.results, ".svg"));
    write_text(&path, &svg)?;
    say!("written: {}", path.display());
    Ok(())
}
