//! Writing to the standard output.

use std::fmt::Arguments;
use std::io::{ErrorKind, Write};

/// Prints a line; a reader that has gone away (`| head`) ends the program quietly.
macro_rules! say {
    () => { $crate::say::write(format_args!("\n")) };
    ($($arg:tt)*) => { $crate::say::write(format_args!("{}\n", format_args!($($arg)*))) };
}

/// Prints text without an end of line.
macro_rules! say_on {
    ($($arg:tt)*) => { $crate::say::write(format_args!($($arg)*)) };
}

/// Writes to the standard output.
pub fn write(text: Arguments<'_>) {
    let written = std::io::stdout().lock().write_fmt(text);
    match written {
        Ok(()) => {}
        Err(e) if e.kind() == ErrorKind::BrokenPipe => std::process::exit(0),
        Err(e) => {
            eprintln!("error: the output cannot be written: {e}");
            std::process::exit(4);
        }
    }
}
