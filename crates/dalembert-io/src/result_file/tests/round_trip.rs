//! What is written reads back bit for bit.

use super::sample;
use crate::result_file::{Meta, read, read_with_meta, sidecar_path, write};
use dalembert::results::Results;
use std::fs;

fn bits(results: &Results) -> Vec<Vec<u64>> {
    let of = |values: &[f64]| values.iter().map(|v| v.to_bits()).collect();
    results.channels.iter().map(|c| of(&c.values)).collect()
}

#[test]
fn every_format_reads_back_bit_for_bit() {
    let meta = Meta::of_model_text("[model]\nname = \"x\"\n");
    for extension in ["csv", "npz", "json", "CSV"] {
        for seed in [1, 2, 3] {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join("run").with_extension(extension);
            let results = sample(seed);
            write(&path, &results, &meta).unwrap();
            let (back, back_meta) = read_with_meta(&path).unwrap();
            assert_eq!(bits(&back), bits(&results), "{extension}");
            assert_eq!(back, results, "{extension}");
            assert_eq!(back_meta, meta, "{extension}");
        }
    }
}

#[test]
fn the_hash_is_sha_256() {
    // FIPS 180-2, example B.1.
    assert_eq!(
        Meta::of_model_text("abc").model_sha256.unwrap(),
        "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
    );
}

#[test]
fn a_csv_file_looks_as_documented() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("run.csv");
    let results = Results {
        channels: vec![
            super::channel("time", "s", &[0.0, 0.1]),
            super::channel("crank.angle", "rad", &[0.5235987755982988, 1e-17]),
            super::channel("a,\"b\"", "", &[1.0, -2.0]),
            super::channel("x [1]", "", &[3e20, 4.0]),
        ],
        ..Results::default()
    };
    write(&path, &results, &Meta::default()).unwrap();
    assert_eq!(
        fs::read_to_string(&path).unwrap(),
        "time [s],crank.angle [rad],\"a,\"\"b\"\"\",x [1] []\n\
         0,0.5235987755982988,1,3e20\n\
         0.1,1e-17,-2,4\n"
    );
}

#[test]
fn a_csv_file_without_its_sidecar_keeps_names_units_and_values() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("run.csv");
    fs::write(
        &path,
        "\u{feff}time [s], a.b [m/s^2] ,plain\r\n0, 1.5 ,-0\r\n1e-3,2,7\r\n",
    )
    .unwrap();
    let results = read(&path).unwrap();
    let names: Vec<(&str, &str)> = results
        .channels
        .iter()
        .map(|c| (c.name.as_str(), c.unit.as_str()))
        .collect();
    assert_eq!(names, [("time", "s"), ("a.b", "m/s^2"), ("plain", "")]);
    assert_eq!(results.channels[0].values, [0.0, 1e-3]);
    assert_eq!(results.channels[1].values, [1.5, 2.0]);
    assert!(results.channels[2].values[0].is_sign_negative());
}

#[test]
fn the_sidecar_describes_by_name_after_columns_were_removed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("run.csv");
    write(&path, &sample(5), &Meta::default()).unwrap();
    fs::write(&path, "crank.angle [rad],time [ms]\n1,2\n").unwrap();
    let results = read(&path).unwrap();
    assert_eq!(results.model, "Slider \"crank\", new");
    assert_eq!(results.channels[0].meaning, "meaning of crank.angle");
    // The unit is another one than the sidecar's: this is not the same channel.
    assert_eq!(results.channels[1].meaning, "");
    assert_eq!(results.channels[1].unit, "ms");
}

#[test]
fn writing_again_replaces_both_files_and_leaves_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("run.npz");
    write(&path, &sample(6), &Meta::default()).unwrap();
    let second = sample(7);
    write(&path, &second, &Meta::default()).unwrap();
    assert_eq!(read(&path).unwrap(), second);
    let mut names: Vec<String> = fs::read_dir(folder.path())
        .unwrap()
        .map(|e| e.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(names, ["run.json", "run.npz"]);
    assert_eq!(sidecar_path(&path), folder.path().join("run.json"));
}

#[test]
fn no_instants_are_no_obstacle() {
    for extension in ["csv", "npz", "json"] {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("run").with_extension(extension);
        let results = Results {
            channels: vec![
                super::channel("time", "s", &[]),
                super::channel("a", "", &[]),
            ],
            ..Results::default()
        };
        write(&path, &results, &Meta::default()).unwrap();
        assert_eq!(read(&path).unwrap(), results, "{extension}");
    }
}
