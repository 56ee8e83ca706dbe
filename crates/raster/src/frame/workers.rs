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

/// Gives each of the things to do to the hand that is free.
#[cfg(feature = "parallel")]
pub(crate) fn taken_in_turn<H: Send, I: Iterator<Item: Send> + Send>(
    hands: &mut [H],
    things: I,
    work: &(impl Fn(&mut H, I::Item) + Sync),
) {
    use std::sync::{Mutex, PoisonError};

    let things = Mutex::new(things);
    // The lock is held only while the next thing is taken.
    let next = || things.lock().unwrap_or_else(PoisonError::into_inner).next();
    shared(hands, &|_, hand| {
        while let Some(thing) = next() {
            work(hand, thing);
        }
        Stats::default()
    });
}

/// Gives each of the things to do to the first hand.
#[cfg(not(feature = "parallel"))]
pub(crate) fn taken_in_turn<H: Send, I: Iterator<Item: Send> + Send>(
    hands: &mut [H],
    things: I,
    work: &(impl Fn(&mut H, I::Item) + Sync),
) {
    if let Some(hand) = hands.first_mut() {
        things.for_each(|thing| work(hand, thing));
    }
}
