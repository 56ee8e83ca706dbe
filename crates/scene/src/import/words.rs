//! Words and numbers of a line.

/// Blanks, tabs, and the control characters with them: one comparison, and none of them belongs to a word.
const fn is_space(byte: u8) -> bool {
    byte <= b' '
}

/// The words of a line, between spaces and tabs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Words<'a> {
    rest: &'a [u8],
}

impl<'a> Words<'a> {
    pub(super) const fn new(line: &'a [u8]) -> Self {
        Self { rest: line }
    }

    /// What is left of the line, without the spaces around it.
    pub(super) const fn rest(&self) -> &'a [u8] {
        self.rest.trim_ascii()
    }
}

impl<'a> Iterator for Words<'a> {
    type Item = &'a [u8];

    #[inline]
    fn next(&mut self) -> Option<&'a [u8]> {
        let mut start = 0;
        while start < self.rest.len() && is_space(self.rest[start]) {
            start += 1;
        }
        let mut end = start;
        while end < self.rest.len() && !is_space(self.rest[end]) {
            end += 1;
        }
        let word = &self.rest[start..end];
        self.rest = &self.rest[end..];
        (!word.is_empty()).then_some(word)
    }
}

/// A number, rounded correctly to `f32`; `nan`, `inf` and what the older Microsoft run-time wrote for them
/// (`-1.#IND`, `1.#INF`) are numbers too.
///
/// Most numbers are short; those are exact quotients of two exact floats, which one division rounds correctly
/// (Clinger's fast path). The standard library's parser, correct for all, reads the rest.
#[inline]
pub(super) fn float(word: &[u8]) -> Option<f32> {
    short(word).or_else(|| long(word))
}

/// `-12.345`: digits that make an integer below 2²⁴, ten of them after the point at most.
#[inline]
fn short(word: &[u8]) -> Option<f32> {
    /// Powers of ten up to 10¹⁰ = 2¹⁰ · 5¹⁰ are exact in `f32`, since 5¹⁰ < 2²⁴.
    const POWERS: [f32; 11] = [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10];
    let (negative, digits) = match word {
        [b'-', digits @ ..] => (true, digits),
        digits => (false, digits),
    };
    // 18 characters keep the integer within 64 bits.
    if digits.len() > 18 || !digits.first()?.is_ascii_digit() {
        return None;
    }
    let (mut integer, mut point) = (0_u64, None);
    for (at, &byte) in digits.iter().enumerate() {
        match byte {
            b'0'..=b'9' => integer = integer * 10 + u64::from(byte - b'0'),
            b'.' if point.is_none() => point = Some(at + 1),
            _ => return None,
        }
    }
    let power = *POWERS.get(point.map_or(0, |point| digits.len() - point))?;
    if integer >= 1 << 24 {
        return None;
    }
    let value = integer as f32 / power;
    Some(if negative { -value } else { value })
}

fn long(word: &[u8]) -> Option<f32> {
    let text = core::str::from_utf8(word).ok()?;
    text.parse().ok().or_else(|| {
        let (sign, special) = match text.strip_prefix('-') {
            Some(rest) => (-1.0, rest),
            None => (1.0, text),
        };
        let special = special.strip_prefix("1.#")?;
        if special.starts_with("INF") {
            Some(sign * f32::INFINITY)
        } else if ["IND", "QNAN", "SNAN"].iter().any(|name| special.starts_with(name)) {
            Some(f32::NAN)
        } else {
            None
        }
    })
}

#[cfg(test)]
mod tests {
    use super::{Words, float, short};

    #[test]
    fn words_stand_between_any_spaces() {
        let words: Vec<_> = Words::new(b"  v \t1  2\x0c3 ").collect();
        assert_eq!(words, [&b"v"[..], b"1", b"2", b"3"]);
        let mut words = Words::new(b"usemtl  a red one ");
        words.next();
        assert_eq!(words.rest(), b"a red one");
    }

    #[test]
    fn numbers_are_rounded_correctly_and_specials_are_read() {
        // Halfway between two f32, decided by the last digit: reading through f64 gets the second one wrong.
        for (text, bits) in [
            ("1.00000005960464477539062500001", 0x3f80_0001_u32),
            ("1.000000059604644775390625", 0x3f80_0000),
        ] {
            assert_eq!(float(text.as_bytes()).unwrap().to_bits(), bits, "{text}");
        }
        assert_eq!(float(b"-1.5E+2"), Some(-150.0));
        assert_eq!(float(b"-1.#INF00"), Some(f32::NEG_INFINITY));
        for text in [&b"nan"[..], b"-1.#IND", b"1.#QNAN0", b"-NaN"] {
            assert!(float(text).unwrap().is_nan());
        }
        for text in [&b""[..], b"1,5", b"0x10", b"1.#", b"\xff", b"--1"] {
            assert_eq!(float(text), None);
        }
    }

    proptest::proptest! {
        #[test]
        fn short_numbers_are_what_the_standard_library_reads(
            integer in 0_u32..1 << 24, after in 0_usize..12, negative: bool,
        ) {
            let digits = format!("{integer:0>width$}", width = after + 1);
            let (before, fraction) = digits.split_at(digits.len() - after);
            let text = format!("{}{before}.{fraction}", if negative { "-" } else { "" });
            if let Some(value) = short(text.as_bytes()) {
                proptest::prop_assert_eq!(value.to_bits(), text.parse::<f32>().unwrap().to_bits(), "{}", text);
            } else {
                proptest::prop_assert!(after > 10 || text.len() > 18, "{}", text);
            }
        }
    }
}
