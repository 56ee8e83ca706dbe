//! Where names stand: beside what they name, over nothing else.

/// A rectangle of pixels: left, top, right, bottom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Area(pub(crate) [i32; 4]);

impl Area {
    pub(crate) const fn around([x, y]: [i32; 2], reach: i32) -> Self {
        Self([x - reach, y - reach, x + reach, y + reach])
    }

    pub(crate) const fn overlaps(self, other: Self) -> bool {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
        a < g && e < c && b < h && f < d
    }

    pub(crate) const fn within(self, other: Self) -> bool {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
        a >= e && b >= f && c <= g && d <= h
    }
}

/// Width and height of a text, as far as that is known without its font: rather too much.
pub(crate) fn extent(text: &str, size: i32) -> [i32; 2] {
    let eighths = |c: char| match c {
        'i' | 'l' | 'I' | '.' | ',' | ' ' | 't' | 'f' | 'r' | 'j' | '|' => 3,
        'm' | 'w' | '×' => 7,
        _ if c.is_uppercase() => 6,
        _ => 5,
    };
    let eighths: i32 = text.chars().map(eighths).sum();
    [eighths * size / 8 + size / 2, size * 5 / 4]
}

/// Room that is taken.
#[derive(Clone, Debug)]
pub(crate) struct Taken {
    inside: Area,
    areas: Vec<Area>,
}

impl Taken {
    pub(crate) const fn new(inside: Area) -> Self {
        Self { inside, areas: Vec::new() }
    }

    pub(crate) fn add(&mut self, area: Area) {
        self.areas.push(area);
    }

    /// A line from a point to another.
    pub(crate) fn add_line(&mut self, a: [i32; 2], b: [i32; 2]) {
        let steps = ((b[0] - a[0]).abs().max((b[1] - a[1]).abs()) / 6).max(1);
        for k in 0..=steps {
            let at = |c: usize| a[c] + (b[c] - a[c]) * k / steps;
            self.add(Area::around([at(0), at(1)], 3));
        }
    }

    /// The top left corner of a text beside one of these points, the first for choice; `None` if it would cover
    /// something everywhere. The place is then taken.
    pub(crate) fn beside(
        &mut self,
        points: &[[i32; 2]],
        [width, height]: [i32; 2],
        gap: i32,
    ) -> Option<[i32; 2]> {
        for distance in [gap, 3 * gap] {
            for &[x, y] in points {
                let [left, middle, right] = [x - distance - width, x - width / 2, x + distance];
                let [above, beside, below] = [y - distance - height, y - height / 2, y + distance];
                for [x, y] in [
                    [right, beside],
                    [middle, above],
                    [middle, below],
                    [left, beside],
                    [right, above],
                    [right, below],
                    [left, above],
                    [left, below],
                ] {
                    let area = Area([x, y, x + width, y + height]);
                    if area.within(self.inside) && !self.areas.iter().any(|taken| taken.overlaps(area)) {
                        self.add(area);
                        return Some([x, y]);
                    }
                }
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_cover_nothing_and_each_other_least_of_all() {
        let inside = Area([0, 0, 400, 300]);
        let mut taken = Taken::new(inside);
        let points: Vec<[i32; 2]> = (0..12).map(|k| [30 * k + 20, 150 + 40 * (k % 3)]).collect();
        points.iter().for_each(|&point| taken.add(Area::around(point, 5)));
        let marks = taken.areas.clone();
        let mut placed = Vec::new();
        for &point in &points {
            if let Some([x, y]) = taken.beside(&[point], [70, 20], 6) {
                placed.push(Area([x, y, x + 70, y + 20]));
            }
        }
        assert!(placed.len() >= 8, "{} of 12", placed.len());
        for (k, &area) in placed.iter().enumerate() {
            assert!(area.within(inside));
            assert!(marks.iter().chain(&placed[..k]).all(|other| !other.overlaps(area)), "{area:?}");
        }
    }

    #[test]
    fn where_there_is_no_room_there_is_no_text() {
        let mut taken = Taken::new(Area([0, 0, 100, 100]));
        assert_eq!(taken.beside(&[[50, 50]], [101, 10], 4), None);
        taken.add_line([0, 0], [100, 100]);
        assert_eq!(taken.beside(&[[50, 50]], [90, 60], 4), None);
        assert!(taken.beside(&[[50, 50]], [20, 10], 12).is_some());
    }
}
