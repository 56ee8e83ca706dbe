//! Who is not beaten: the points than which none is both faster and more accurate.

/// The places of the points on the Pareto front, where less is better in both coordinates, by the first coordinate.
/// Of equal points the first is on it; those that are not numbers are not.
pub(crate) fn front(points: &[[f64; 2]]) -> Vec<usize> {
    let mut order: Vec<usize> =
        (0..points.len()).filter(|&k| points[k].iter().all(|v| !v.is_nan())).collect();
    order.sort_by(|&a, &b| {
        let [a, b] = [points[a], points[b]];
        a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]))
    });
    let mut least = f64::INFINITY;
    order.retain(|&k| {
        let better = points[k][1] < least;
        least = least.min(points[k][1]);
        better
    });
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_on_the_front_unless_another_is_as_good_in_both() {
        let points = [
            [3.0, 0.0],
            [1.0, 5.0],
            [2.0, 5.0],
            [2.0, 1.0],
            [9.0, 0.0],
            [1.0, 5.0],
            [0.5, f64::NAN],
            [1.0, 7.0],
        ];
        assert_eq!(front(&points), [1, 3, 0]);
        for (k, p) in points.iter().enumerate().filter(|(_, p)| !p[1].is_nan()) {
            let beaten = points
                .iter()
                .enumerate()
                .any(|(other, q)| q[0] <= p[0] && q[1] <= p[1] && (q != p || other < k));
            assert_eq!(front(&points).contains(&k), !beaten, "{p:?}");
        }
        assert!(front(&[]).is_empty());
    }
}
