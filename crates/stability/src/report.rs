//! What became of the scenes.

use core::fmt;

use crate::{Scene, Table};

/// What became of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// As expected, every pixel.
    Pass,
    /// So many pixels are not as expected, over all pictures of the scene.
    Wrong {
        /// At least 1. A pixel of several triangles, drawn one by one, may count for each.
        pixels: u64,
    },
    /// A depth that was drawn is NaN.
    NotANumber,
    /// The rasteriser panicked; the rest of the scene was not drawn.
    Panic,
    /// The scene does not concern this rasteriser.
    NotAsked,
}

impl fmt::Display for Verdict {
    /// `ok`, the number of wrong pixels, `NaN`, `panic` or `-`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Pass => f.pad("ok"),
            Self::Wrong { pixels } => f.pad(&pixels.to_string()),
            Self::NotANumber => f.pad("NaN"),
            Self::Panic => f.pad("panic"),
            Self::NotAsked => f.pad("-"),
        }
    }
}

/// The verdicts on one rasteriser, scene by scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    rows: Vec<(Scene, Verdict)>,
}

impl Report {
    pub(crate) fn new(rows: impl Iterator<Item = (Scene, Verdict)>) -> Self {
        Self { rows: rows.collect() }
    }

    /// All scenes in their order.
    #[must_use]
    pub fn rows(&self) -> &[(Scene, Verdict)] {
        &self.rows
    }

    /// The verdict on the scene of that name.
    #[must_use]
    pub fn verdict(&self, name: &str) -> Option<Verdict> {
        self.rows.iter().find(|(scene, _)| scene.name == name).map(|&(_, verdict)| verdict)
    }

    /// Whether every scene that was asked passed.
    #[must_use]
    pub fn passed(&self) -> bool {
        self.rows.iter().all(|(_, verdict)| matches!(verdict, Verdict::Pass | Verdict::NotAsked))
    }
}

impl fmt::Display for Report {
    /// A [`Table`] of one column.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut table = Table::new();
        table.add("verdict", self);
        table.fmt(f)
    }
}
