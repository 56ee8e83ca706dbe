//! How a world is drawn, as far as its objects leave it open.

use polosa_raster::{Cull, Rect, Sample, State};

use crate::Color;
use crate::light::Shading;

/// Settings of a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Style {
    /// How surfaces are shaded.
    pub shading: Shading,
    /// Which sides of surfaces are left out; none by default.
    pub cull: Cull,
    /// The colour of what has none of its own.
    pub color: Color,
    /// The colour of edges that are drawn over a surface. Wire alone takes the object's.
    pub edge_color: Color,
    /// Draw only inside this rectangle; everywhere by default.
    pub scissor: Option<Rect>,
    /// Where pixels are sampled; at their centre by default.
    pub sample: Sample,
}

impl Default for Style {
    fn default() -> Self {
        Self {
            shading: Shading::default(),
            cull: Cull::default(),
            color: Color::LIGHT_GREY,
            edge_color: Color::BLACK,
            scissor: None,
            sample: Sample::CENTER,
        }
    }
}

impl Style {
    pub(crate) fn state(&self) -> State {
        State { cull: self.cull, scissor: self.scissor, sample: self.sample, ..State::default() }
    }
}
