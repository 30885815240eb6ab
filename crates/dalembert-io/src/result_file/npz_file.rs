//! NPZ result files: a zip archive with one NumPy array a channel, named by the channel.

use super::{Meta, ReadError, WriteError, atomic, npy, sidecar};
use dalembert::results::{Channel, Results};
use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::Path;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

pub(super) fn write(path: &Path, results: &Results) -> Result<(), WriteError> {
    atomic::write_file(path, |w| {
        // Beyond 4 GiB an entry needs the large layout; half of that leaves room for its headers.
        let large = results.len() > (1 << 31) / size_of::<f64>();
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Deflated)
            .large_file(large);
        let mut archive = ZipWriter::new(w);
        for channel in &results.channels {
            archive
                .start_file(format!("{}.npy", channel.name), options)
                .map_err(io::Error::from)?;
            npy::write(&mut archive, &channel.values)?;
        }
        archive.finish().map_err(io::Error::from)?;
        Ok(())
    })
    .map_err(|source| WriteError::Io {
        path: path.to_owned(),
        source,
    })
}

pub(super) fn read(path: &Path) -> Result<(Results, Meta), ReadError> {
    let io = |source| ReadError::Io {
        path: path.to_owned(),
        source,
    };
    let zip = |source| ReadError::Zip {
        path: path.to_owned(),
        source,
    };
    let file = File::open(path).map_err(io)?;
    let mut archive = ZipArchive::new(BufReader::new(file)).map_err(zip)?;
    let mut channels = Vec::with_capacity(archive.len());
    for index in 0..archive.len() {
        let mut entry = archive.by_index(index).map_err(zip)?;
        let name = entry.name().map_err(zip)?;
        let name = name.strip_suffix(".npy").unwrap_or(&name).to_owned();
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes).map_err(io)?;
        let values = npy::read(&bytes).map_err(|source| ReadError::Npy {
            path: path.to_owned(),
            array: name.clone(),
            source,
        })?;
        channels.push(Channel {
            name,
            values,
            ..Channel::default()
        });
    }
    let mut results = Results {
        channels,
        ..Results::default()
    };
    let mut meta = Meta {
        model_sha256: None,
        generator: None,
    };
    let text = sidecar::text(path);
    if let Some(document) = text.as_deref().and_then(sidecar::parse) {
        sidecar::describe(&document, &mut results, false);
        meta = document.meta();
    } else {
        // Nobody says which channels may have gaps.
        for channel in &mut results.channels {
            channel.gaps = channel.values.iter().any(|x| x.is_nan());
        }
    }
    Ok((results, meta))
}
