//! Files of models, written by the tests.

/// A pyramid with a square base, each side another colour of grey in flat shading.
pub(crate) const PYRAMID: &str = "\
v -1 0 1
v 1 0 1
v 1 0 -1
v -1 0 -1
v 0 1.5 0
f 1 2 5
f 2 3 5
f 3 4 5
f 4 1 5
f 4 3 2 1
";

/// The same, lower: what a file is changed to.
pub(crate) const LOW_PYRAMID: &str = "\
v -1 0 1
v 1 0 1
v 1 0 -1
v -1 0 -1
v 0 0.5 0
f 1 2 5
f 2 3 5
f 3 4 5
f 4 1 5
f 4 3 2 1
";

/// What is left of a file that was cut short: a face without its vertices.
pub(crate) const BROKEN: &str = "\
v -1 0 1
v 1 0 1
f 1 2 5
";

/// A wavy sheet of 2·n² triangles as binary STL: 84 bytes, and 50 a triangle.
pub(crate) fn sheet(n: u32) -> Vec<u8> {
    let triangles = 2 * n * n;
    let mut file = vec![0; 80];
    file.extend(triangles.to_le_bytes());
    file.reserve(triangles as usize * 50);
    let point = |i: u32, j: u32| {
        let [x, y] = [i, j].map(|k| k as f32 / n as f32 * 2.0 - 1.0);
        [x, y, 0.2 * (1.0 - x * x) * (1.0 - y * y) + 0.05 * ((i / 16 + j / 16) % 2) as f32]
    };
    for (i, j) in (0..n).flat_map(|j| (0..n).map(move |i| (i, j))) {
        let [a, b, c, d] = [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
        for [p, q, r] in [[a, b, c], [a, c, d]] {
            // The normal is left to the reader.
            let numbers = [[0.0; 3], p, q, r];
            file.extend(numbers.as_flattened().iter().flat_map(|number| number.to_le_bytes()));
            file.extend([0; 2]);
        }
    }
    file
}
