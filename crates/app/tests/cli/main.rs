//! The program as its users meet it: run, and its files looked at.

mod bad_input;
mod bench;
mod compare;
mod exact;
mod help;
mod info;
mod methods;
mod options;
mod outputs;
mod support;
mod turntable;
