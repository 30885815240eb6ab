//! Channels by pattern.

use super::channel;
use crate::result_file::{UnknownChannel, select};
use dalembert::results::Results;

fn results() -> Results {
    let names = [
        "time",
        "crank.angle",
        "crank.angular_velocity",
        "rod.angle",
        "A.force_x",
        "A.force_y",
        "odd*name",
        "oddXname",
    ];
    Results {
        channels: names.iter().map(|n| channel(n, "", &[0.0])).collect(),
        ..Results::default()
    }
}

fn chosen(patterns: &[&str]) -> Result<Vec<String>, UnknownChannel> {
    let patterns: Vec<String> = patterns.iter().map(|p| (*p).to_owned()).collect();
    select(&results(), &patterns).map(|c| c.iter().map(|c| c.name.clone()).collect())
}

#[test]
fn patterns_choose_in_their_order_and_each_channel_once() {
    assert_eq!(
        chosen(&["*.angle", "crank.*"]).unwrap(),
        ["crank.angle", "rod.angle", "crank.angular_velocity"]
    );
    assert_eq!(chosen(&["A.force_?"]).unwrap(), ["A.force_x", "A.force_y"]);
    assert_eq!(chosen(&["*"]).unwrap().len(), 8);
    assert_eq!(chosen(&["c*k.*gl*e"]).unwrap(), ["crank.angle"]);
    assert!(chosen(&[]).unwrap().is_empty());
}

#[test]
fn a_name_with_a_star_is_taken_literally() {
    assert_eq!(chosen(&["odd*name"]).unwrap(), ["odd*name"]);
    assert_eq!(chosen(&["odd*nam?"]).unwrap(), ["odd*name", "oddXname"]);
}

#[test]
fn unknown_patterns_get_suggestions() {
    let error = chosen(&["crank.angel"]).unwrap_err();
    assert_eq!(error.pattern, "crank.angel");
    assert_eq!(error.suggestions[0], "crank.angle");
    assert_eq!(
        chosen(&["crnk.*"]).unwrap_err().suggestions,
        ["crank.angle", "crank.angular_velocity"]
    );
    assert_eq!(
        chosen(&["a.Force_X"]).unwrap_err().suggestions[0],
        "A.force_x"
    );
    let error = chosen(&["nothing_like_it_anywhere"]).unwrap_err();
    assert!(error.suggestions.is_empty());
    assert_eq!(
        error.to_string(),
        "no channel matches \"nothing_like_it_anywhere\"; the channels are: time, crank.angle, \
         crank.angular_velocity, rod.angle, A.force_x, A.force_y, odd*name, oddXname"
    );
}

#[test]
fn the_whole_name_must_match() {
    assert!(chosen(&["crank"]).is_err());
    assert!(chosen(&["angle*"]).is_err());
}
