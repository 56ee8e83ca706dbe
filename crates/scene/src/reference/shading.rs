//! From a colour and an amount of light to the code in the picture, in six ways.
//!
//! A code is no amount of light: sRGB code 128 is 22 % of the light of 255. So a surface that gets half of the light
//! is to be decoded, halved and encoded:
//!
//! ```text
//!   code ──decode──▶ light ──× s──▶ light ──encode──▶ code       exact, tables
//!   code ──^2.4────▶       ──× s──▶       ──^(1/2.4)─▶ cut off    a power instead of the curve (S0; S3: 2.2)
//!   code ────────────────── × s ───────────────────▶ cut off    no curve at all: too dark
//! ```

use core::fmt;
use core::str::FromStr;
use std::sync::LazyLock;

use crate::{Color, srgb};

/// A way to shade an 8-bit sRGB code by an amount of light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Shading {
    /// Decoded, multiplied and encoded to the nearest code: what the rest of the crate does.
    #[default]
    Exact,
    /// `(int)(c·s)`, as if codes were light (S0 and S3 at their fourth stage).
    Naive,
    /// `(int)((c^2.4·s)^(1/2.4))`, in `f64` (S0).
    Power24,
    /// `(int)((c^2.2·s)^(1/2.2))`, in `f64` (S3).
    Power22,
    /// Encoded by a table of 2¹² codes, even in light.
    Table4096,
    /// Encoded by a table of 2¹⁶ codes, even in light.
    Table65536,
}

impl Shading {
    /// All of them, the exact one first.
    pub const ALL: &[Self] =
        &[Self::Exact, Self::Naive, Self::Power24, Self::Power22, Self::Table4096, Self::Table65536];

    /// Its name on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Naive => "naive",
            Self::Power24 => "power-2.4",
            Self::Power22 => "power-2.2",
            Self::Table4096 => "table-4096",
            Self::Table65536 => "table-65536",
        }
    }

    /// In one line: from which seed, and what it gets wrong.
    #[must_use]
    pub const fn about(self) -> &'static str {
        match self {
            Self::Exact => "the nearest sRGB code: the default; nothing wrong",
            Self::Naive => "codes multiplied as if they were light (S0, S3): up to 74 codes too dark",
            Self::Power24 => "exponent 2.4 for the curve (S0): up to 13 codes off, too bright in the dark",
            Self::Power22 => "exponent 2.2 for the curve (S3): up to 9 codes off",
            Self::Table4096 => "the curve from 4,096 entries: up to 1 code off, in the dark",
            Self::Table65536 => {
                "the curve from 65,536 entries: 1 code off where two codes are nearly equally near"
            }
        }
    }

    /// The code of a surface of code `code` that gets the share `light` of all light.
    ///
    /// `light` is linear, from 0 to 1; what is outside goes to the nearer end, NaN to 0.
    #[must_use]
    pub fn shade(self, code: u8, light: f32) -> u8 {
        let light = if light > 0.0 { light.min(1.0) } else { 0.0 };
        match self {
            Self::Exact => srgb::encode(srgb::decode(code) * light),
            Self::Naive => (f64::from(code) * f64::from(light)) as u8,
            Self::Power24 => power(code, light, 2.4),
            Self::Power22 => power(code, light, 2.2),
            Self::Table4096 => looked_up(&TABLE_4096, code, light),
            Self::Table65536 => looked_up(&TABLE_65536, code, light),
        }
    }

    /// The same for the three channels of a colour `0x00RRGGBB`; the top byte comes out 0.
    #[must_use]
    pub fn shade_color(self, color: u32, light: f32) -> u32 {
        let Color { r, g, b } = Color::from_u32(color);
        let [r, g, b] = [r, g, b].map(|code| self.shade(code, light));
        Color::new(r, g, b).to_u32()
    }
}

/// S0's and S3's formula. The result is cut off, as `(int)` does; at full light all codes come back unchanged.
fn power(code: u8, light: f32, exponent: f64) -> u8 {
    libm::pow(libm::pow(code.into(), exponent) * f64::from(light), 1.0 / exponent) as u8
}

/// Entry i is the nearest code of the light i / (N − 1).
type Table = LazyLock<Vec<u8>>;

static TABLE_4096: Table = LazyLock::new(|| table(1 << 12));
static TABLE_65536: Table = LazyLock::new(|| table(1 << 16));

fn table(entries: u32) -> Vec<u8> {
    (0..entries).map(|i| srgb::encode((f64::from(i) / f64::from(entries - 1)) as f32)).collect()
}

/// The nearest entry's code.
fn looked_up(table: &[u8], code: u8, light: f32) -> u8 {
    let last = table.len() - 1;
    let index = (srgb::decode(code) * light * last as f32 + 0.5) as usize;
    table[index.min(last)]
}

impl fmt::Display for Shading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A text that names no way of shading; says which there are.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no shading `{name}`: use one of {known}", name = .0, known = names())]
pub struct UnknownShading(String);

fn names() -> String {
    Shading::ALL.iter().map(|shading| shading.name()).collect::<Vec<_>>().join(", ")
}

impl FromStr for Shading {
    type Err = UnknownShading;

    fn from_str(text: &str) -> Result<Self, UnknownShading> {
        let known = Self::ALL.iter().copied().find(|shading| shading.name() == text);
        // A text from outside is repeated in short.
        known.ok_or_else(|| UnknownShading(text.chars().take(40).collect()))
    }
}
