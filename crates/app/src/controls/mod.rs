//! Controls: state machines from events to cameras, lights and values. None knows of a window.

pub mod fly;
pub mod navigation;
mod orbit;
pub mod slider;
mod zoom;

pub(crate) use self::zoom::seen;
