//! Work on pixels for several threads. Without the feature `parallel` one thread does it all.

use polosa_raster::{Stats, Target};

/// Pieces of fewer items are not worth a thread.
#[cfg(feature = "parallel")]
const LEAST: usize = 1 << 14;

/// Calls `work` for pieces of the items, each with the place of its first, for so many threads.
#[cfg(feature = "parallel")]
pub(crate) fn pieces<T: Send>(threads: usize, items: &mut [T], work: &(impl Fn(usize, &mut [T]) + Sync)) {
    fn halves<T: Send>(most: usize, first: usize, items: &mut [T], work: &(impl Fn(usize, &mut [T]) + Sync)) {
        if items.len() <= most {
            return work(first, items);
        }
        let middle = items.len().div_ceil(most) / 2 * most;
        let (left, right) = items.split_at_mut(middle);
        rayon::join(|| halves(most, first, left, work), || halves(most, first + middle, right, work));
    }
    halves(items.len().div_ceil(threads.max(1)).max(LEAST), 0, items, work);
}

/// Calls `work` for all items; the place of the first is 0.
#[cfg(not(feature = "parallel"))]
pub(crate) fn pieces<T>(_: usize, items: &mut [T], work: &impl Fn(usize, &mut [T])) {
    work(0, items);
}

/// Draws `lines` lines onto a target, each thread on a band of rows; `draw` draws them all onto one.
#[cfg(feature = "parallel")]
pub(crate) fn bands(
    threads: usize,
    lines: usize,
    target: &mut Target<'_, u32>,
    draw: impl Fn(&mut Target<'_, u32>) -> Stats + Sync,
) -> Stats {
    use rayon::prelude::*;

    /// Fewer lines are drawn sooner than threads are woken.
    const WORTH_IT: usize = 500;
    let rows = target.rows().len().div_ceil(threads.max(1));
    if threads <= 1 || lines < WORTH_IT || rows < 16 {
        return draw(target);
    }
    // Each band counts all lines.
    let bands = target.bands(u32::try_from(rows).unwrap_or(u32::MAX)).par_bridge();
    bands.map(|mut band| draw(&mut band)).reduce_with(|one, _| one).unwrap_or_default()
}

/// Draws lines onto a target.
#[cfg(not(feature = "parallel"))]
pub(crate) fn bands(
    _: usize,
    _: usize,
    target: &mut Target<'_, u32>,
    draw: impl Fn(&mut Target<'_, u32>) -> Stats,
) -> Stats {
    draw(target)
}
