//! Several methods side by side.

use core::fmt;

use crate::{Report, Verdict};

/// Characters in a line of a printed table, as a rule.
const LINE: usize = 110;

/// Scenes × methods. Rows are sorted by number, methods stand in the order in which they came.
///
/// ```
/// use polosa_stability::{Table, Verdict};
///
/// let mut table = Table::new();
/// table.set(18, "a stripe, affine attributes", "mine", Verdict::Wrong { pixels: 812 });
/// assert!(table.to_string().contains("812"));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    methods: Vec<String>,
    rows: Vec<Row>,
}

/// A scene of a [`Table`] and what each method made of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The number of the scene; several may share one.
    pub number: u32,
    /// Its name.
    pub scene: String,
    /// A verdict for each method; those that were not asked for may be missing at the end.
    pub verdicts: Vec<Verdict>,
}

impl Table {
    /// A table without rows and methods.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Enters all verdicts of a report under the name of a method.
    pub fn add(&mut self, method: &str, report: &Report) {
        for (scene, verdict) in report.rows() {
            self.set(scene.number, scene.name, method, *verdict);
        }
    }

    /// Enters one verdict, of this suite or of a test of your own; rows and methods are made as they are named.
    pub fn set(&mut self, number: u32, scene: &str, method: &str, verdict: Verdict) {
        let column = self.methods.iter().position(|m| m == method).unwrap_or_else(|| {
            self.methods.push(method.to_owned());
            self.methods.len() - 1
        });
        let row =
            self.rows.iter().position(|r| r.number == number && r.scene == scene).unwrap_or_else(|| {
                let at = self.rows.partition_point(|row| row.number <= number);
                self.rows.insert(at, Row { number, scene: scene.to_owned(), verdicts: Vec::new() });
                at
            });
        let verdicts = &mut self.rows[row].verdicts;
        if verdicts.len() <= column {
            verdicts.resize(column + 1, Verdict::NotAsked);
        }
        verdicts[column] = verdict;
    }

    /// The names of the methods.
    #[must_use]
    pub fn methods(&self) -> &[String] {
        &self.methods
    }

    /// The rows, sorted by number.
    #[must_use]
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// The verdict on a method in a scene; [`Verdict::NotAsked`] where there is none.
    #[must_use]
    pub fn get(&self, scene: &str, method: &str) -> Verdict {
        let column = self.methods.iter().position(|m| m == method);
        let row = self.rows.iter().find(|row| row.scene == scene);
        let verdict = row.zip(column).and_then(|(row, column)| row.verdicts.get(column));
        verdict.copied().unwrap_or(Verdict::NotAsked)
    }
}

impl fmt::Display for Table {
    /// As many methods side by side as fit a line, then the next ones below.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let scenes =
            self.rows.iter().map(|row| row.scene.chars().count()).max().unwrap_or(0).max("scene".len());
        let cell = |row: &Row, k: usize| row.verdicts.get(k).unwrap_or(&Verdict::NotAsked).to_string();
        let width = |k: usize| {
            let cells = self.rows.iter().map(|row| cell(row, k).len());
            cells.chain([self.methods[k].chars().count()]).max().unwrap_or(0)
        };
        let mut first = 0;
        while first < self.methods.len() {
            let (mut end, mut line) = (first, 4 + scenes);
            while end < self.methods.len() && (end == first || line + 2 + width(end) <= LINE) {
                line += 2 + width(end);
                end += 1;
            }
            if first > 0 {
                writeln!(f)?;
            }
            write!(f, "{:>2}  {:scenes$}", "#", "scene")?;
            for k in first..end {
                write!(f, "  {:>1$}", self.methods[k], width(k))?;
            }
            writeln!(f)?;
            for row in &self.rows {
                write!(f, "{:2}  {:scenes$}", row.number, row.scene)?;
                for k in first..end {
                    write!(f, "  {:>1$}", cell(row, k), width(k))?;
                }
                writeln!(f)?;
            }
            first = end;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Table, Verdict};

    #[test]
    fn rows_are_sorted_and_gaps_are_not_asked() {
        let mut table = Table::new();
        table.set(7, "quads", "a", Verdict::Pass);
        table.set(2, "line", "b", Verdict::Wrong { pixels: 10_201 });
        table.set(2, "other", "b", Verdict::Panic);
        table.set(7, "quads", "b", Verdict::NotANumber);
        let expected =
            " #  scene   a      b\n 2  line    -  10201\n 2  other   -  panic\n 7  quads  ok    NaN\n";
        assert_eq!(table.to_string(), expected);
        assert_eq!(table.get("line", "a"), Verdict::NotAsked);
        assert_eq!(table.get("line", "b"), Verdict::Wrong { pixels: 10_201 });
    }

    #[test]
    fn more_methods_than_fit_a_line_go_below() {
        let mut table = Table::new();
        for method in ["a".repeat(60), "b".repeat(60)] {
            table.set(1, "quad", &method, Verdict::Pass);
        }
        let text = table.to_string();
        assert_eq!(text.lines().count(), 5, "{text}");
    }
}
