//! Where machines come to rest.

use super::power::G;
use super::run::{Run, answer, close};

/// Ten links: every link carries the same horizontal pull, and the weight below it.
#[test]
fn catenary() {
    let (links, link, mass, span) = (10, 0.15, 0.2, 1.0);
    let slope = |number: i32, pull: f64| -(5.0 - f64::from(number) + 0.5) * mass * G / pull;
    let reach = |pull: f64| -> f64 {
        (1..=links)
            .map(|n| link * slope(n, pull).atan().cos())
            .sum()
    };
    // The more pull, the straighter the chain.
    let (mut low, mut high) = (1.0, 10.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if reach(middle) < span {
            low = middle;
        } else {
            high = middle;
        }
    }
    let pull = 0.5 * (low + high);
    close("pull", pull, 4.024162090074492, 1e-14);

    let run = Run::new("statics", "catenary", &[]);
    let rest = run.instant(0);
    let mut pin = [0.0, 0.0];
    for number in 1..=links {
        let angle = slope(number, pull).atan();
        let half = [0.5 * link * angle.cos(), 0.5 * link * angle.sin()];
        for (suffix, expected) in [
            ("x", pin[0] + half[0]),
            ("y", pin[1] + half[1]),
            ("angle", angle),
        ] {
            let channel = format!("link {number}.{suffix}");
            close(&channel, rest.get(&channel), expected, 1e-13);
        }
        pin = [pin[0] + 2.0 * half[0], pin[1] + 2.0 * half[1]];
    }
    close("sag", rest.get("lowest pin.y"), -0.5059459315710845, 1e-13);
    // The pin holds half the weight and the pull.
    close("left pin, x", rest.get("left pin.force_x"), -pull, 1e-12);
    close(
        "left pin, y",
        rest.get("left pin.force_y"),
        5.0 * mass * G,
        1e-12,
    );
}

/// A pendulum rests hanging and, not for long, standing.
#[test]
fn pendulum() {
    let run = Run::new("statics", "pendulum", &[]);
    assert_eq!(run.channel("bar.angle").len(), 2);
    let equilibria = answer("statics", "pendulum", &[]);
    for (index, y, expected) in [(0, -1.0, "stable"), (1, 1.0, "unstable")] {
        let rest = run.instant(index);
        close("tip", rest.get("tip.y"), y, 1e-14);
        close("pin", rest.get("pin.force_y"), 2.0 * G, 1e-13);
        assert_eq!(equilibria["equilibria"][index]["stability"], expected);
    }
}
