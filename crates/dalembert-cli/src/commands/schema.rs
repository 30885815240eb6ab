//! `dalembert schema`.

use crate::failure::Failure;

/// Prints the JSON Schema of model files.
pub fn run() -> Result<(), Failure> {
    say!("{:#}", dalembert_io::model_file::schema());
    Ok(())
}
