//! Colours: 8-bit sRGB codes, as files and pictures have them.

use core::fmt;
use core::str::FromStr;

/// An opaque colour as three sRGB-encoded bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Color {
    /// Red, sRGB-encoded.
    pub r: u8,
    /// Green, sRGB-encoded.
    pub g: u8,
    /// Blue, sRGB-encoded.
    pub b: u8,
}

impl Color {
    /// Black.
    pub const BLACK: Self = Self::new(0, 0, 0);
    /// White.
    pub const WHITE: Self = Self::new(255, 255, 255);
    /// What a model without colours of its own is drawn in.
    pub const LIGHT_GREY: Self = Self::new(0xcc, 0xcc, 0xcc);

    /// A colour from its sRGB codes.
    #[must_use]
    pub const fn new(r: u8, g: u8, b: u8) -> Self {
        Self { r, g, b }
    }

    /// A colour from `0x00RRGGBB`; the top byte is ignored.
    #[must_use]
    pub const fn from_u32(rgb: u32) -> Self {
        let [_, r, g, b] = rgb.to_be_bytes();
        Self { r, g, b }
    }

    /// The colour as a pixel, `0x00RRGGBB`.
    #[must_use]
    pub const fn to_u32(self) -> u32 {
        u32::from_be_bytes([0, self.r, self.g, self.b])
    }
}

/// A text that is no colour; says what one looks like.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParseColorError(String);

impl fmt::Display for ParseColorError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "`{}` is no colour: write #RRGGBB, #RGB, R,G,B with bytes from 0 to 255, or one of {}",
            self.0,
            NAMES.map(|(name, _)| name).join(", ")
        )
    }
}

impl core::error::Error for ParseColorError {}

/// The CSS basic colours, by the names that CSS gives them.
const NAMES: [(&str, u32); 16] = [
    ("black", 0x0000_0000),
    ("silver", 0x00c0_c0c0),
    ("gray", 0x0080_8080),
    ("white", 0x00ff_ffff),
    ("maroon", 0x0080_0000),
    ("red", 0x00ff_0000),
    ("purple", 0x0080_0080),
    ("fuchsia", 0x00ff_00ff),
    ("green", 0x0000_8000),
    ("lime", 0x0000_ff00),
    ("olive", 0x0080_8000),
    ("yellow", 0x00ff_ff00),
    ("navy", 0x0000_0080),
    ("blue", 0x0000_00ff),
    ("teal", 0x0000_8080),
    ("aqua", 0x0000_ffff),
];

impl FromStr for Color {
    type Err = ParseColorError;

    fn from_str(text: &str) -> Result<Self, ParseColorError> {
        let error = || ParseColorError(text.chars().take(40).collect());
        if let Some((_, rgb)) = NAMES.iter().find(|(name, _)| name.eq_ignore_ascii_case(text)) {
            return Ok(Self::from_u32(*rgb));
        }
        if let Some(hex) = text.strip_prefix('#') {
            if !hex.bytes().all(|b| b.is_ascii_hexdigit()) {
                return Err(error());
            }
            let value = u32::from_str_radix(hex, 16).map_err(|_| error())?;
            return match hex.len() {
                6 => Ok(Self::from_u32(value)),
                3 => {
                    let digit = |shift: u32| ((value >> shift & 15) * 17).to_le_bytes()[0];
                    Ok(Self::new(digit(8), digit(4), digit(0)))
                }
                _ => Err(error()),
            };
        }
        let mut parts = text.split(',').map(|part| part.trim().parse::<u8>());
        match (parts.next(), parts.next(), parts.next(), parts.next()) {
            (Some(Ok(r)), Some(Ok(g)), Some(Ok(b)), None) => Ok(Self::new(r, g, b)),
            _ => Err(error()),
        }
    }
}

impl fmt::Display for Color {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{:02x}{:02x}{:02x}", self.r, self.g, self.b)
    }
}

#[cfg(test)]
mod tests {
    use super::Color;

    #[test]
    fn texts_become_colors_and_back() {
        for (text, rgb) in
            [("#2b2b2b", 0x2b_2b2b), ("#f80", 0xff_8800), ("255, 0,7", 0xff_0007), ("Teal", 0x8080)]
        {
            assert_eq!(text.parse(), Ok(Color::from_u32(rgb)), "{text}");
        }
        assert_eq!(Color::from_u32(0x12_3456).to_string(), "#123456");
        assert_eq!(Color::from_u32(0x12_3456).to_u32(), 0x12_3456);
    }

    #[test]
    fn other_texts_are_refused_with_advice() {
        for text in ["", "#", "#12", "#+12345", "256,0,0", "1,2", "1,2,3,4", "grey-ish", "#éé"] {
            let error = text.parse::<Color>().unwrap_err().to_string();
            assert!(error.contains("#RRGGBB"), "{error}");
        }
    }
}
