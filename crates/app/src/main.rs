//! The program `polosa`; everything is in the library.
#![forbid(unsafe_code)]

use std::process::ExitCode;

fn main() -> ExitCode {
    polosa::cli::run(std::env::args_os())
}
