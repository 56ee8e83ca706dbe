//! Controls: state machines from events to cameras, lights and values. None knows of a window.

pub mod navigation;
pub mod slider;
