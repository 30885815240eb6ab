//! Tests of the result files.

mod errors;
mod numpy;
mod round_trip;
mod selection;

use dalembert::results::{Channel, Results};

/// Names that hurt careless writers.
pub(super) const HOSTILE: [&str; 9] = [
    "a,b",
    "say \"x\"",
    "two\nlines",
    "x [1]",
    "x [",
    "<tag> & 'more'",
    "größe/µ",
    " padded ",
    "../../up",
];

/// A small generator (xorshift64*), so that a printed seed repeats a test.
pub(super) struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    /// A finite double with random bits: every magnitude, subnormal ones too.
    pub fn finite(&mut self) -> f64 {
        loop {
            let value = f64::from_bits(self.bits());
            if value.is_finite() {
                return value;
            }
        }
    }
}

pub(super) fn channel(name: &str, unit: &str, values: &[f64]) -> Channel {
    Channel {
        name: name.to_owned(),
        unit: unit.to_owned(),
        meaning: format!("meaning of {name}"),
        values: values.to_vec(),
        gaps: false,
    }
}

/// Results with awkward values and hostile names.
pub(super) fn sample(seed: u64) -> Results {
    println!("seed {seed}");
    let mut random = Random(seed);
    let instants = 257;
    let mut values = |special: &[f64]| -> Vec<f64> {
        let mut all = special.to_vec();
        all.resize_with(instants, || random.finite());
        all
    };
    let special = [
        0.0,
        -0.0,
        0.1,
        1.0 / 3.0,
        1e-5,
        9.999_999_999_999_999e-6,
        1e16,
        9_007_199_254_740_993.0,
        f64::MAX,
        f64::MIN_POSITIVE,
        5e-324,
        -2.225_073_858_507_201e-308,
    ];
    let mut channels = vec![
        channel("time", "s", &values(&[])),
        channel("crank.angle", "rad", &values(&special)),
        channel("plain", "", &values(&[])),
    ];
    for name in HOSTILE {
        channels.push(channel(name, "N m", &values(&[])));
        channels.push(channel(&format!("{name}2"), "", &values(&[])));
    }
    Results {
        model: "Slider \"crank\", new".to_owned(),
        analysis: "kinematics".to_owned(),
        channels,
        statistics: [("steps".to_owned(), 41.0), ("drift".to_owned(), 1.0 / 3.0)].into(),
        notes: vec!["line 1\nline 2".to_owned()],
    }
}
