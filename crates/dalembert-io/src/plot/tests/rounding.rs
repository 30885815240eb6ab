//! Channels of rounding beside channels with values.

use crate::plot::rounding_as_zero;
use dalembert::results::{Channel, Results};

fn channel(name: &str, unit: &str, values: &[f64]) -> Channel {
    Channel {
        name: name.to_owned(),
        unit: unit.to_owned(),
        values: values.to_vec(),
        ..Channel::default()
    }
}

#[test]
fn rounding_is_drawn_as_zero_and_small_values_stay() {
    let run = Results {
        channels: vec![
            channel("a.force_x", "N", &[4000.0, -3000.0]),
            channel("a.force_y", "N", &[3e-9, -2e-9]),
            channel("b.force_y", "N", &[5e-9, f64::NAN]),
            channel("tiny.x", "m", &[2e-14, -3e-14]),
            channel("small.y", "m", &[2e-12, -3e-12]),
            channel("violation.position", "", &[2e-15, 1e-15]),
            channel("energy.total", "J", &[1e6, 1e6]),
            channel("energy.balance", "J", &[1e-8, 2e-8]),
        ],
        ..Results::default()
    };
    let drawn = |k: usize| rounding_as_zero(&run.channels[k], &run).values;
    assert_eq!(drawn(1), [0.0, 0.0]);
    assert_eq!(drawn(3), [0.0, 0.0]);
    for kept in [0, 4, 5, 6, 7] {
        assert_eq!(drawn(kept), run.channels[kept].values, "{kept}");
    }
    // 5e-9 N is more than 1e-12 of 4000 N; a gap stays a gap.
    let gap = drawn(2);
    assert!(gap[0] == 5e-9 && gap[1].is_nan(), "{gap:?}");
}
