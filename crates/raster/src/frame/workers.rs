//! Work for several threads, without allocating: halves are given away until each thread has a piece.

use crate::Stats;

/// Calls `work` for each item with its number, at the same time where there are threads; the sum of what it counts.
#[cfg(feature = "parallel")]
pub(crate) fn shared<T: Send>(items: &mut [T], work: &(impl Fn(usize, &mut T) -> Stats + Sync)) -> Stats {
    fn halves<T: Send>(
        items: &mut [T],
        first: usize,
        work: &(impl Fn(usize, &mut T) -> Stats + Sync),
    ) -> Stats {
        match items {
            [] => Stats::default(),
            [item] => work(first, item),
            _ => {
                let middle = items.len() / 2;
                let (left, right) = items.split_at_mut(middle);
                let (left, right) =
                    rayon::join(|| halves(left, first, work), || halves(right, first + middle, work));
                left + right
            }
        }
    }
    halves(items, 0, work)
}

/// Calls `work` for each item with its number; the sum of what it counts.
#[cfg(not(feature = "parallel"))]
pub(crate) fn shared<T: Send>(items: &mut [T], work: &(impl Fn(usize, &mut T) -> Stats + Sync)) -> Stats {
    items.iter_mut().enumerate().fold(Stats::default(), |sum, (number, item)| sum + work(number, item))
}

/// Calls `work` for each piece of so many items, with the piece's number.
pub(crate) fn chunks<T: Send>(items: &mut [T], length: usize, work: &(impl Fn(usize, &mut [T]) + Sync)) {
    #[cfg(feature = "parallel")]
    {
        fn halves<T: Send>(
            items: &mut [T],
            length: usize,
            first: usize,
            work: &(impl Fn(usize, &mut [T]) + Sync),
        ) {
            let pieces = items.len().div_ceil(length);
            if pieces <= 1 {
                return work(first, items);
            }
            let (left, right) = items.split_at_mut(pieces / 2 * length);
            rayon::join(
                || halves(left, length, first, work),
                || halves(right, length, first + pieces / 2, work),
            );
        }
        halves(items, length.max(1), 0, work);
    }
    #[cfg(not(feature = "parallel"))]
    for (number, piece) in items.chunks_mut(length.max(1)).enumerate() {
        work(number, piece);
    }
}

/// Things to be done, one at a time for whoever comes next.
#[cfg(feature = "parallel")]
#[derive(Debug)]
pub(crate) struct Queue<I>(std::sync::Mutex<I>);

#[cfg(feature = "parallel")]
impl<I: Iterator> Queue<I> {
    pub(crate) const fn new(items: I) -> Self {
        Self(std::sync::Mutex::new(items))
    }

    /// The next thing to be done.
    pub(crate) fn next(&self) -> Option<I::Item> {
        self.0.lock().unwrap_or_else(std::sync::PoisonError::into_inner).next()
    }
}
