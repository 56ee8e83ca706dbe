//! Lines of text formats.

use super::detect::without_mark;

/// The lines of a text with their numbers, from 1; ended by `\n`, `\r\n`, or `\r` alone in a text without `\n`.
#[derive(Clone, Debug)]
pub(super) struct Lines<'a> {
    rest: &'a [u8],
    number: u64,
    end: u8,
}

impl<'a> Lines<'a> {
    pub(super) fn new(text: &'a [u8]) -> Self {
        let end = if text.contains(&b'\n') || !text.contains(&b'\r') { b'\n' } else { b'\r' };
        Self { rest: without_mark(text), number: 0, end }
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (u64, &'a [u8]);

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        if self.rest.is_empty() {
            return None;
        }
        let (line, rest) = match self.rest.iter().position(|&byte| byte == self.end) {
            Some(at) => (&self.rest[..at], &self.rest[at + 1..]),
            None => (self.rest, &self.rest[self.rest.len()..]),
        };
        self.rest = rest;
        self.number += 1;
        Some((self.number, line.strip_suffix(b"\r").unwrap_or(line)))
    }
}

#[cfg(test)]
mod tests {
    use super::Lines;

    #[test]
    fn lines_keep_their_numbers_whatever_ends_them() {
        for text in ["a\nb\n\nc", "a\r\nb\r\n\r\nc\r\n", "a\rb\r\rc", "\u{feff}a\nb\n\nc\n"] {
            let lines: Vec<_> = Lines::new(text.as_bytes()).collect();
            assert_eq!(lines, [(1, &b"a"[..]), (2, b"b"), (3, b""), (4, b"c")], "{text:?}");
        }
        assert_eq!(Lines::new(b"").count(), 0);
    }
}
