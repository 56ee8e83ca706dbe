//! How far two silhouettes are from each other.
//!
//! ```text
//!   shown          outline        from each `o` of A to the nearest of B, and from each of B to the nearest of A:
//!   . . . . . .    . . . . . .    the farthest of these ways is the Hausdorff distance
//!   . # # # # .    . o o o o .
//!   . # # # # .    . o . . o .    nearest in a column:  ways up and down, two sweeps over the picture
//!   . # # # # .    . o o o o .    nearest in a row:     the lower envelope of the columns' parabolas
//!   . . . . . .    . . . . . .                          (x − column)² + way², one sweep over the row
//! ```
//!
//! The distance transform is that of Meijster, Roerdink and Hesselink ("A general algorithm for computing distance
//! transforms in linear time", 2000): squares of distances, in whole numbers, exact, in a time that grows with the
//! number of pixels however far apart the silhouettes are.

/// The Hausdorff distance of two silhouettes' outlines in pixels; `None` when one has none. Both have rows of
/// `width` values, at least one and at most [`MAX_PIXELS`](super::MAX_PIXELS) in all.
pub(super) fn distance(a: &[bool], b: &[bool], width: usize) -> Option<f64> {
    let [a, b] = [a, b].map(|shown| outline(shown, width));
    if !(a.contains(&true) && b.contains(&true)) {
        return None;
    }
    let squared = farthest(&a, &b, width).max(farthest(&b, &a, width));
    // Whole, below 2⁵⁷; the root of what is below 2⁵³ is correctly rounded.
    Some((squared as f64).sqrt())
}

/// The pixels that show something beside one that does not.
fn outline(shown: &[bool], width: usize) -> Vec<bool> {
    let mut outline = vec![false; shown.len()];
    let height = shown.len() / width;
    // No list of rows: of narrow pictures it would be many times as large as the pictures.
    let row_at = |y: usize| &shown[y * width..][..width];
    for (y, outline) in outline.chunks_exact_mut(width).enumerate() {
        // At the edges a pixel stands for the neighbour that nothing is known of.
        let [above, row, below] = [y.saturating_sub(1), y, (y + 1).min(height - 1)].map(row_at);
        for (((edge, shown), above), below) in outline.iter_mut().zip(row).zip(above).zip(below) {
            *edge = shown & !(above & below);
        }
        // The neighbours to the left and to the right, by the row against itself, moved by one.
        for ((edge, shown), left) in outline[1..].iter_mut().zip(&row[1..]).zip(row) {
            *edge |= shown & !left;
        }
        for ((edge, shown), right) in outline.iter_mut().zip(row).zip(&row[1..]) {
            *edge |= shown & !right;
        }
    }
    outline
}

/// The square of the longest way from a pixel of `from` to the nearest of `to`, which has at least one.
fn farthest(from: &[bool], to: &[bool], width: usize) -> i64 {
    // On a pixel that both outlines have nobody goes anywhere: where pictures agree nothing is computed.
    let asks = |(from, to): (&bool, &bool)| from & !to;
    let rows = || from.chunks_exact(width).zip(to.chunks_exact(width));
    let asking =
        |(from, to): (&[bool], &[bool])| from.iter().zip(to).fold(false, |any, pair| any | asks(pair));
    let Some(first) = rows().position(asking) else { return 0 };
    let last = rows().rposition(asking).unwrap_or(first);

    let columns = columns(to, width, first, last);
    // As large as they can become, so that none doubles when it is full: whoever asked for memory knows how much.
    let mut sites = Vec::with_capacity(width);
    sites.extend((0..width).filter(|x| columns[*x] != FAR));
    let mut envelope = Vec::with_capacity(sites.len());
    let mut farthest = 0;
    for ((from, to), columns) in rows().skip(first).zip(columns.chunks_exact(width)) {
        if !asking((from, to)) {
            continue;
        }
        lower_envelope(columns, &sites, &mut envelope);
        let mut arcs = envelope.iter().peekable();
        let mut arc = Arc { site: 0, start: 0 };
        for (x, _) in (0..).zip(from.iter().zip(to)).filter(|(_, pair)| asks(*pair)) {
            while let Some(next) = arcs.next_if(|next| next.start <= x) {
                arc = *next;
            }
            farthest = farthest.max(parabola(columns, arc.site, x));
        }
    }
    farthest
}

/// No pixel in this column.
const FAR: u32 = u32::MAX;

/// For every pixel of the rows from `first` to `last` the way up or down to the nearest of `to` in its column.
fn columns(to: &[bool], width: usize, first: usize, last: usize) -> Vec<u32> {
    let mut ways = vec![FAR; (last + 1 - first) * width];
    let mut way = vec![FAR; width];
    let mut step = |y: usize| {
        for (way, to) in way.iter_mut().zip(&to[y * width..]) {
            *way = if *to { 0 } else { way.saturating_add(1) };
        }
        if (first..=last).contains(&y) {
            for (kept, way) in ways[(y - first) * width..].iter_mut().zip(&way) {
                *kept = (*kept).min(*way);
            }
        }
    };
    let height = to.len() / width;
    (0..height).for_each(&mut step);
    // The sweep up begins with the ways that the sweep down ended with: they are never shorter than the true ones,
    // and where a column has no pixel there is still none.
    (first..height).rev().for_each(&mut step);
    ways
}

/// A piece of the envelope: from `start` on, the pixel nearest to x is in the column `site`.
#[derive(Clone, Copy)]
struct Arc {
    site: usize,
    start: i64,
}

/// The square of the way from (x, this row) to the nearest pixel in a column.
fn parabola(columns: &[u32], site: usize, x: i64) -> i64 {
    let (along, up) = (x - site as i64, i64::from(columns[site]));
    along * along + up * up
}

/// Which column is nearest from where on, for a row whose ways in the columns are given. `sites`, ascending, are the
/// columns that have any pixel.
fn lower_envelope(columns: &[u32], sites: &[usize], arcs: &mut Vec<Arc>) {
    arcs.clear();
    let end = columns.len() as i64;
    for &site in sites {
        // What is higher than the new parabola where it begins is so everywhere after: the new one is on its right.
        while arcs
            .pop_if(|top| parabola(columns, top.site, top.start) > parabola(columns, site, top.start))
            .is_some()
        {}
        let start = match arcs.last() {
            None => 0,
            Some(top) => {
                let [i, u] = [top.site, site].map(|column| column as i64);
                let [way_i, way_u] = [i, u].map(|column| i64::from(columns[column as usize]));
                // Up to here, where (x − i)² + way_i² = (x − u)² + way_u², rounded down, the old one is no higher.
                1 + (u * u - i * i + way_u * way_u - way_i * way_i).div_euclid(2 * (u - i))
            }
        };
        if start < end {
            arcs.push(Arc { site, start });
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::{distance, outline};

    fn parse(rows: &[&str]) -> Vec<bool> {
        rows.concat().bytes().map(|byte| byte == b'#').collect()
    }

    /// By the definition: every pixel against every other.
    fn naive(a: &[bool], b: &[bool], width: usize) -> Option<f64> {
        let points = |shown: &[bool]| -> Vec<[i64; 2]> {
            let height = shown.len() / width;
            let at = |x: i64, y: i64| {
                let inside = (0..width as i64).contains(&x) && (0..height as i64).contains(&y);
                !inside || shown[y as usize * width + x as usize]
            };
            let all = (0..shown.len()).map(|i| [(i % width) as i64, (i / width) as i64]);
            let around = |[x, y]: [i64; 2]| [[x - 1, y], [x + 1, y], [x, y - 1], [x, y + 1]];
            all.filter(|&[x, y]| at(x, y) && around([x, y]).iter().any(|&[x, y]| !at(x, y))).collect()
        };
        let [a, b] = [points(a), points(b)];
        let way = |[x, y]: [i64; 2], [u, v]: [i64; 2]| (x - u) * (x - u) + (y - v) * (y - v);
        let farthest = |from: &[[i64; 2]], to: &[[i64; 2]]| {
            let nearest = from.iter().map(|p| to.iter().map(|q| way(*p, *q)).min());
            nearest.collect::<Option<Vec<i64>>>().and_then(|ways| ways.into_iter().max())
        };
        Some((farthest(&a, &b)?.max(farthest(&b, &a)?) as f64).sqrt())
    }

    #[test]
    fn an_outline_is_what_has_background_beside_it_in_the_picture() {
        let shown = parse(&["......", ".####.", ".####.", ".####.", "......"]);
        let expected = parse(&["......", ".####.", ".#..#.", ".####.", "......"]);
        assert_eq!(outline(&shown, 6), expected);
        // Beyond the edges nothing is known, and corners touch only at a point.
        let shown = parse(&["###.", "###.", "####"]);
        assert_eq!(outline(&shown, 4), parse(&["..#.", "..#.", "...#"]));
        assert_eq!(outline(&[true], 1), [false]);
    }

    #[test]
    fn distances_of_small_silhouettes_are_those_of_the_hand() {
        let dot = parse(&["#....", ".....", ".....", "....."]);
        let far = parse(&[".....", ".....", ".....", "....#"]);
        assert_eq!(distance(&dot, &far, 5), Some(5.0), "3 down and 4 across");
        let both = parse(&["#....", ".....", ".....", "....#"]);
        assert_eq!(distance(&dot, &both, 5), Some(5.0), "one is where it was, the other is new");
        assert_eq!(distance(&both, &dot, 5), Some(5.0));
        assert_eq!(distance(&both, &both, 5), Some(0.0));
        let (none, all) = ([false; 20], [true; 20]);
        for (a, b) in [(&none[..], &dot[..]), (&dot, &none), (&none, &none), (&all, &dot), (&all, &all)] {
            assert_eq!(distance(a, b, 5), None);
        }
    }

    /// Two silhouettes of one size, dense or sparse.
    fn silhouettes() -> impl Strategy<Value = (usize, Vec<bool>, Vec<bool>)> {
        let density = || prop_oneof![Just(0.02), Just(0.3), Just(0.9)];
        (1..24_usize, 1..24_usize, density(), density()).prop_flat_map(|(width, height, a, b)| {
            let shown =
                |density| proptest::collection::vec(proptest::bool::weighted(density), width * height);
            (Just(width), shown(a), shown(b))
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn distances_are_those_of_the_definition((width, a, b) in silhouettes()) {
            prop_assert_eq!(distance(&a, &b, width), naive(&a, &b, width));
            prop_assert_eq!(distance(&a, &b, width), distance(&b, &a, width));
        }
    }
}
