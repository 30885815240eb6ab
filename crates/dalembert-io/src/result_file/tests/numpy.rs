//! NumPy itself reads our archives, and we read NumPy's.

use super::sample;
use crate::result_file::{Meta, read, write};
use std::process::Command;

/// Runs a Python program with NumPy; `None` where this machine has none.
fn python(program: &str, arguments: &[&str]) -> Option<String> {
    let numpy = Command::new("python3")
        .args(["-c", "import numpy"])
        .output();
    if !numpy.is_ok_and(|o| o.status.success()) {
        println!("no NumPy here: only our own reader was tried");
        return None;
    }
    let output = Command::new("python3")
        .args(["-c", program])
        .args(arguments)
        .output()
        .unwrap();
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    Some(String::from_utf8(output.stdout).unwrap())
}

#[test]
fn numpy_reads_every_channel_bit_for_bit() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("run.npz");
    let results = sample(11);
    write(&path, &results, &Meta::default()).unwrap();
    assert_eq!(read(&path).unwrap(), results);
    let program = "
import numpy, sys
a = numpy.load(sys.argv[1], allow_pickle=False)
for name in a.files:
    print(name.encode().hex(), a[name].dtype, a[name].tobytes().hex())
";
    let Some(text) = python(program, &[path.to_str().unwrap()]) else {
        return;
    };
    let hex = |bytes: &[u8]| -> String { bytes.iter().map(|b| format!("{b:02x}")).collect() };
    let expected: Vec<String> = results
        .channels
        .iter()
        .map(|c| {
            let bytes: Vec<u8> = c.values.iter().flat_map(|v| v.to_le_bytes()).collect();
            format!("{} float64 {}", hex(c.name.as_bytes()), hex(&bytes))
        })
        .collect();
    assert_eq!(text.lines().collect::<Vec<_>>(), expected);
}

#[test]
fn arrays_of_numpy_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("other.npz");
    let program = "
import numpy, sys
numpy.savez(sys.argv[1], time=numpy.array([0.0, 0.1]), f=numpy.array([1.5, 2.5], dtype='f4'),
            i=numpy.array([-1, 2]), j=numpy.array([-3, 4], dtype='i4'))
";
    if python(program, &[path.to_str().unwrap()]).is_none() {
        return;
    }
    let results = read(&path).unwrap();
    assert_eq!(results.channel("time").unwrap().values, [0.0, 0.1]);
    assert_eq!(results.channel("f").unwrap().values, [1.5, 2.5]);
    assert_eq!(results.channel("i").unwrap().values, [-1.0, 2.0]);
    assert_eq!(results.channel("j").unwrap().values, [-3.0, 4.0]);
}
