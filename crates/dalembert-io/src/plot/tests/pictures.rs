//! Whole pictures: well-formed, complete, of bounded size.

use crate::plot::{Plot, Series, XyCurve, XyPlot};
use dalembert::results::Channel;
use roxmltree::{Document, Node};

fn series(label: &str, unit: &str, values: impl IntoIterator<Item = f64>) -> Series {
    Series {
        label: label.to_owned(),
        unit: unit.to_owned(),
        values: values.into_iter().collect(),
    }
}

fn time(count: u32) -> Series {
    series("time", "s", (0..count).map(|k| 0.01 * f64::from(k)))
}

/// Texts of a class, in order.
fn texts(svg: &str, class: &str) -> Vec<String> {
    let document = Document::parse(svg).unwrap();
    let of_class = |n: &Node| n.has_tag_name("text") && n.attribute("class") == Some(class);
    document
        .descendants()
        .filter(of_class)
        .map(|n| n.text().unwrap().to_owned())
        .collect()
}

/// Points of every polyline.
fn polylines(svg: &str) -> Vec<Vec<(f64, f64)>> {
    let document = Document::parse(svg).unwrap();
    document
        .descendants()
        .filter(|n| n.has_tag_name("polyline"))
        .map(|n| {
            let points = n.attribute("points").unwrap().split(' ');
            points
                .map(|p| {
                    let (x, y) = p.split_once(',').unwrap();
                    (x.parse().unwrap(), y.parse().unwrap())
                })
                .collect()
        })
        .collect()
}

fn count(svg: &str, tag: &str, class: &str) -> usize {
    let document = Document::parse(svg).unwrap();
    document
        .descendants()
        .filter(|n| {
            n.has_tag_name(tag) && (class.is_empty() || n.attribute("class") == Some(class))
        })
        .count()
}

#[test]
fn one_channel_fills_one_panel() {
    let plot = Plot::new(
        "Crank",
        series("time", "s", [0.0, 1.0, 2.0]),
        vec![series("crank.angle", "rad", [0.0, 10.0, 5.0])],
    );
    let svg = plot.to_svg();
    assert_eq!(texts(&svg, "title"), ["Crank"]);
    assert_eq!(texts(&svg, "axis"), ["crank.angle [rad]", "time [s]"]);
    assert_eq!(
        texts(&svg, "tick"),
        [
            "0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "0.0", "0.2", "0.4", "0.6",
            "0.8", "1.0", "1.2", "1.4", "1.6", "1.8", "2.0"
        ]
    );
    // One curve needs no legend.
    assert_eq!(count(&svg, "g", "legend"), 0);
    let lines = polylines(&svg);
    assert_eq!(lines.len(), 1);
    let [(x0, y0), (x1, y1), (x2, y2)] = lines[0][..] else {
        panic!("{lines:?}");
    };
    // Linear scales: to the hundredth of a pixel that is written.
    assert!((x1 - x0 - (x2 - x1)).abs() < 0.02);
    assert!((0.5 * (y0 + y1) - y2).abs() < 0.02);
    assert!(y1 < y2 && y2 < y0);
}

#[test]
fn units_get_panels_and_several_curves_a_legend() {
    let channel = |name: &str, unit: &str, f: f64| Channel {
        name: name.to_owned(),
        unit: unit.to_owned(),
        meaning: String::new(),
        values: (0..200).map(|k| (f * f64::from(k)).sin()).collect(),
        gaps: false,
    };
    let channels = [
        channel("a.angle", "rad", 0.1),
        channel("a.x", "m", 0.2),
        channel("b.angle", "rad", 0.3),
        channel("ratio", "", 0.4),
    ];
    let t = Channel {
        name: "time".to_owned(),
        unit: "s".to_owned(),
        meaning: String::new(),
        values: time(200).values,
        gaps: false,
    };
    // A pattern like "*" catches the time too; it is not drawn over itself.
    let ys: Vec<&Channel> = std::iter::once(&t).chain(&channels).collect();
    let svg = Plot::of_channels("", &t, &ys).to_svg();
    assert_eq!(count(&svg, "g", "panel"), 3);
    assert_eq!(count(&svg, "g", "legend"), 2);
    assert_eq!(polylines(&svg).len(), 4);
    assert_eq!(
        texts(&svg, "axis"),
        ["angle [rad]", "a.x [m]", "ratio", "time [s]"]
    );
    assert!(texts(&svg, "title").is_empty());
    // Each panel has its zero line; the panels share one x axis.
    let starts: Vec<f64> = polylines(&svg).iter().map(|l| l[0].0).collect();
    assert!(starts.iter().all(|x| *x == starts[0]));
    assert_eq!(count(&svg, "path", "zero"), 3);
}

#[test]
fn the_legend_stands_right_of_every_curve() {
    let ys = (0..40)
        .map(|k| {
            let label = format!("a_body_with_quite_a_long_name_{k}.angular_velocity_in_the_plane");
            series(&label, "rad/s", (0..100).map(|i| f64::from(i * k)))
        })
        .collect();
    let mut plot = Plot::new("Crowd", time(100), ys);
    for (height, entries) in [(None, 40), (Some(300.0), 11)] {
        plot.height = height;
        let svg = plot.to_svg();
        let document = Document::parse(&svg).unwrap();
        let right = polylines(&svg)
            .iter()
            .flatten()
            .fold(0.0, |m: f64, p| m.max(p.0));
        let legends: Vec<Node> = document
            .descendants()
            .filter(|n| n.attribute("class") == Some("legend"))
            .collect();
        assert_eq!(legends.len(), entries);
        assert_eq!(svg.contains("and 29 more"), height.is_some());
        for legend in legends {
            let text = legend.children().find(|n| n.has_tag_name("text")).unwrap();
            assert!(text.attribute("x").unwrap().parse::<f64>().unwrap() > right);
            assert!(text.text().unwrap().contains('…'));
        }
        if let Some(height) = height {
            let stated = document.root_element().attribute("height").unwrap();
            assert_eq!(stated.parse::<f64>().unwrap(), height);
        }
    }
}

#[test]
fn long_channels_stay_small_and_keep_their_spikes() {
    let n = 100_000;
    let mut values: Vec<f64> = (0..n).map(|k| (0.37 * f64::from(k)).sin()).collect();
    values[12_345] = 3.0;
    values[54_321] = -2.0;
    let svg = Plot::new("Long", time(n), vec![series("a", "m", values)]).to_svg();
    assert!(svg.len() < 200_000, "{} bytes", svg.len());
    let lines = polylines(&svg);
    let heights = lines[0].iter().map(|p| p.1);
    let (low, high) = heights.fold((f64::MAX, f64::MIN), |(l, h), y| (l.min(y), h.max(y)));
    // The panel is 360 px high and 5 of 5.5 units of its range are between the spikes.
    assert!(
        (high - low - 360.0 * 5.0 / 5.5).abs() < 0.02,
        "{}",
        high - low
    );
}

#[test]
fn hostile_names_are_escaped() {
    let name = "</text><script>alert(\"1\")</script> & 'x' \u{1} ]]>";
    let plot = Plot::new(
        name,
        series(name, name, [0.0, 1.0]),
        vec![
            series(name, name, [0.0, 1.0]),
            series("b", name, [1.0, 2.0]),
        ],
    );
    let mut plot_text = plot.to_svg();
    let xy = XyPlot {
        title: name.to_owned(),
        x_label: name.to_owned(),
        curves: vec![XyCurve {
            label: name.to_owned(),
            x: vec![0.0, 1.0],
            y: vec![1.0, 0.0],
        }],
        ..XyPlot::default()
    };
    for svg in [std::mem::take(&mut plot_text), xy.to_svg()] {
        let document = Document::parse(&svg).unwrap();
        assert!(document.descendants().all(|n| !n.has_tag_name("script")));
        let title = document
            .root_element()
            .children()
            .find(|n| n.has_tag_name("title"));
        assert_eq!(
            title.and_then(|t| t.text()),
            Some(name.replace('\u{1}', "\u{fffd}").as_str())
        );
    }
}

#[test]
fn gaps_and_lone_points_are_drawn_as_such() {
    let nan = f64::NAN;
    let values = [1.0, 2.0, nan, 3.0, nan, 4.0, 5.0, f64::INFINITY];
    let svg = Plot::new("", time(8), vec![series("a", "m", values)]).to_svg();
    assert_eq!(polylines(&svg).len(), 2);
    assert_eq!(count(&svg, "circle", ""), 1);
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
}

#[test]
fn poor_data_make_a_picture_too() {
    let cases = [
        Plot::new("", time(0), vec![]),
        Plot::new("", time(0), vec![series("a", "m", [])]),
        Plot::new("", time(3), vec![series("a", "m", [f64::NAN; 3])]),
    ];
    for plot in cases {
        let svg = plot.to_svg();
        assert!(svg.contains("no values") && !svg.contains("NaN"));
        assert!(polylines(&svg).is_empty());
    }
    let svg = Plot::new("", time(1), vec![series("a", "m", [0.25])]).to_svg();
    assert_eq!(count(&svg, "circle", ""), 1);
    let svg = Plot::new("", time(3), vec![series("a", "m", [7.0; 3])]).to_svg();
    assert_eq!(polylines(&svg).len(), 1);
    assert!(texts(&svg, "tick").contains(&"7.0".to_owned()));
    let extreme = [f64::MAX, -f64::MAX, 5e-324];
    let svg = Plot::new("", time(3), vec![series("a", "m", extreme)]).to_svg();
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    let mut tiny = Plot::new("Tiny", time(3), vec![series("a", "m", [1.0, 2.0, 3.0])]);
    tiny.width = 0.0;
    tiny.height = Some(0.0);
    assert_eq!(polylines(&tiny.to_svg()).len(), 1);
}

#[test]
fn equal_aspect_draws_a_circle_round() {
    let angle = |k: u32| f64::from(k) * std::f64::consts::TAU / 360.0;
    let channel = |values: Vec<f64>| Channel {
        values,
        ..Channel::default()
    };
    let circle = XyCurve::of_channels(
        "circle",
        &channel((0..=360).map(|k| 3.0 + 0.2 * angle(k).cos()).collect()),
        &channel((0..=360).map(|k| 0.2 * angle(k).sin()).collect()),
    );
    for height in [None, Some(300.0), Some(1500.0)] {
        let plot = XyPlot {
            curves: vec![circle.clone()],
            equal_aspect: true,
            height,
            ..XyPlot::default()
        };
        let lines = polylines(&plot.to_svg());
        let extent = |part: fn(&(f64, f64)) -> f64| {
            let values = lines[0].iter().map(part);
            let (low, high) = values.fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v), h.max(v)));
            high - low
        };
        let (across, upward) = (extent(|p| p.0), extent(|p| p.1));
        assert!(across > 100.0);
        // Straightening may cut a twentieth of a pixel off each side, writing a hundredth.
        assert!((across - upward).abs() < 0.12, "{across} {upward}");
    }
}
