//! Every refusal says what, where and which file.

use super::{channel, sample};
use crate::result_file::{Defect, Meta, NpyError, ReadError, WriteError, read, write};
use dalembert::results::{Channel, Results};
use std::fs;
use std::path::Path;

fn with(channels: Vec<Channel>) -> Results {
    Results {
        channels,
        ..Results::default()
    }
}

/// Writes text to a file of this name and reads it as results.
fn read_text(name: &str, text: &[u8]) -> ReadError {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    fs::write(&path, text).unwrap();
    let error = read(&path).unwrap_err();
    assert!(error.to_string().contains(name), "{error}");
    error
}

#[test]
fn unknown_formats_are_refused() {
    let results = with(vec![channel("time", "s", &[0.0])]);
    let error = write(Path::new("run.xlsx"), &results, &Meta::default()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "run.xlsx: unknown result format \"xlsx\"; use .csv, .npz or .json"
    );
    let error = read(Path::new("run")).unwrap_err();
    assert_eq!(
        error.to_string(),
        "run: the name has no extension that tells the format; use .csv, .npz or .json"
    );
}

#[test]
fn defective_results_are_refused_and_leave_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let time = channel("time", "s", &[0.0, 1.0]);
    let cases = [
        (with(vec![]), Defect::NoChannels),
        (
            with(vec![time.clone(), channel("a", "", &[1.0])]),
            Defect::UnequalLengths {
                name: "a".to_owned(),
                found: 1,
                expected: 2,
            },
        ),
        (
            with(vec![time.clone(), time.clone()]),
            Defect::DuplicateChannel {
                name: "time".to_owned(),
            },
        ),
        (
            with(vec![time.clone(), channel("a", "", &[1.0, f64::NAN])]),
            Defect::ChannelNotFinite {
                name: "a".to_owned(),
                index: 1,
            },
        ),
        (
            Results {
                statistics: [("s".to_owned(), f64::INFINITY)].into(),
                ..with(vec![time.clone()])
            },
            Defect::StatisticNotFinite {
                name: "s".to_owned(),
            },
        ),
    ];
    for (results, expected) in cases {
        for name in ["x.csv", "x.npz", "x.json"] {
            let error = write(&folder.path().join(name), &results, &Meta::default()).unwrap_err();
            let WriteError::Defective { defect, .. } = error else {
                panic!("{error}");
            };
            assert_eq!(defect, expected);
        }
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn a_sidecar_never_overwrites_another_file() {
    let folder = tempfile::tempdir().unwrap();
    let json = folder.path().join("package.json");
    for foreign in ["{\"name\": \"mine\"}", "not even JSON"] {
        fs::write(&json, foreign).unwrap();
        let error = write(
            &folder.path().join("package.csv"),
            &sample(1),
            &Meta::default(),
        )
        .unwrap_err();
        assert!(matches!(error, WriteError::SidecarInTheWay { path } if path == json));
        assert_eq!(fs::read_to_string(&json).unwrap(), foreign);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}

#[test]
fn a_full_result_file_is_not_overwritten_by_a_sidecar() {
    let folder = tempfile::tempdir().unwrap();
    let json = folder.path().join("run.json");
    write(&json, &sample(1), &Meta::default()).unwrap();
    let error = write(&folder.path().join("run.csv"), &sample(2), &Meta::default());
    assert!(matches!(error, Err(WriteError::SidecarInTheWay { .. })));
    assert_eq!(read(&json).unwrap(), sample(1));
}

#[test]
fn a_full_result_file_does_not_replace_the_sidecar_of_another() {
    let folder = tempfile::tempdir().unwrap();
    let (csv, json) = (
        folder.path().join("run.csv"),
        folder.path().join("run.json"),
    );
    write(&csv, &sample(1), &Meta::default()).unwrap();
    let error = write(&json, &sample(2), &Meta::default()).unwrap_err();
    assert!(matches!(error, WriteError::SidecarOfAnother { data, .. } if data == "run.csv"));
    assert_eq!(read(&csv).unwrap(), sample(1));
    // Without its data file the sidecar describes nothing.
    fs::remove_file(&csv).unwrap();
    write(&json, &sample(2), &Meta::default()).unwrap();
    assert_eq!(read(&json).unwrap(), sample(2));
}

#[test]
fn a_missing_folder_is_reported_with_the_path() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("none").join("x.json");
    let error = write(&path, &sample(1), &Meta::default()).unwrap_err();
    assert!(matches!(error, WriteError::Io { path: p, .. } if p == path));
    assert!(matches!(read(&path), Err(ReadError::Io { path: p, .. }) if p == path));
    let csv = path.with_extension("csv");
    assert!(matches!(read(&csv), Err(ReadError::Io { path: p, .. }) if p == csv));
}

#[test]
fn csv_errors_name_line_and_column() {
    let error = read_text("x.csv", b"time [s],a\n0,1\n1,abc\n");
    assert!(
        error
            .to_string()
            .ends_with("x.csv:3: \"abc\" in column \"a\" is not a number")
    );
    let error = read_text("x.csv", b"time [s],a\n0,1\n1\n");
    assert!(
        error
            .to_string()
            .ends_with("x.csv:3: 1 fields, but the header has 2"),
        "{error}"
    );
    let error = read_text("x.csv", b"time,a\n0,1e999\n");
    assert!(matches!(error, ReadError::Defective { .. }));
    let error = read_text("x.csv", b"");
    assert!(matches!(
        error,
        ReadError::Defective {
            defect: Defect::NoChannels,
            ..
        }
    ));
    let error = read_text("x.csv", b"time,\xff\n0,1\n");
    assert!(matches!(error, ReadError::Csv { .. }));
}

#[test]
fn json_errors_tell_the_kind_of_file() {
    assert!(matches!(read_text("x.json", b"{"), ReadError::Json { .. }));
    assert!(matches!(
        read_text("x.json", b"{\"a\": 1}"),
        ReadError::OtherFormat { .. }
    ));
    let folder = tempfile::tempdir().unwrap();
    write(&folder.path().join("x.csv"), &sample(1), &Meta::default()).unwrap();
    let error = read(&folder.path().join("x.json")).unwrap_err();
    assert!(
        error
            .to_string()
            .ends_with("this sidecar holds no values; read \"x.csv\" instead")
    );
}

#[test]
fn npz_errors_name_the_array() {
    assert!(matches!(
        read_text("x.npz", b"hello"),
        ReadError::Zip { .. }
    ));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.npz");
    let entries: [(&[u8], NpyError); 4] = [
        (b"no array", NpyError::NotAnArray),
        (b"\x93NUMPY\x09\x00\x00\x00", NpyError::UnknownVersion { major: 9 }),
        (
            b"\x93NUMPY\x01\x00\x3b\x00{'descr': '<c16', 'fortran_order': False, 'shape': (1,), }\n",
            NpyError::UnknownType {
                descr: "<c16".to_owned(),
            },
        ),
        (
            b"\x93NUMPY\x01\x00\x3c\x00{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2), }\n",
            NpyError::NotOneDimensional {
                shape: "(1, 2)".to_owned(),
            },
        ),
    ];
    for (bytes, expected) in entries {
        let mut archive = zip::ZipWriter::new(fs::File::create(&path).unwrap());
        archive
            .start_file("a.npy", zip::write::SimpleFileOptions::default())
            .unwrap();
        std::io::Write::write_all(&mut archive, bytes).unwrap();
        archive.finish().unwrap();
        match read(&path).unwrap_err() {
            ReadError::Npy { array, source, .. } => {
                assert_eq!((array.as_str(), source), ("a", expected));
            }
            other => panic!("{other}"),
        }
    }
}
