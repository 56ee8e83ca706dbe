//! Small arrays of lanes.
//!
//! Vector code is only fast where it is inlined into the function that `dispatch` made for a level, closures and all;
//! `array::map` is not always.

/// `[f(0), f(1)]`
#[inline(always)]
pub(crate) fn two<T>(f: impl Fn(usize) -> T) -> [T; 2] {
    [f(0), f(1)]
}

/// `[f(0), f(1), f(2)]`
#[inline(always)]
pub(crate) fn three<T>(f: impl Fn(usize) -> T) -> [T; 3] {
    [f(0), f(1), f(2)]
}

/// `[f(0), f(1), f(2), f(3)]`
#[inline(always)]
pub(crate) fn four<T>(f: impl Fn(usize) -> T) -> [T; 4] {
    [f(0), f(1), f(2), f(3)]
}
