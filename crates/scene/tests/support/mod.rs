//! Judges for the tests, independent of the code that they judge.

pub(crate) mod shade;
