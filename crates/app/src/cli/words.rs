//! Numbers as people read them.

/// So many of something.
pub(super) fn counted(count: u64, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

/// A number with all its digits; as a power of ten where plain digits would be a row of zeros.
pub(super) fn number(value: f64) -> String {
    // −0 + 0 is 0.
    let value = value + 0.0;
    let plain = value == 0.0 || (1e-4..=1e6).contains(&value.abs());
    if plain { value.to_string() } else { format!("{value:e}") }
}

#[cfg(test)]
mod tests {
    use super::{counted, number};

    #[test]
    fn one_is_singular() {
        assert_eq!(counted(1, "vertex", "vertices"), "1 vertex");
        assert_eq!(counted(0, "vertex", "vertices"), "0 vertices");
    }

    #[test]
    fn very_large_and_very_small_numbers_are_powers_of_ten() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.5, "1.5"),
            (-1e6, "-1000000"),
            (1e-4, "0.0001"),
            (1_000_001.0, "1.000001e6"),
            (-5.0777e-17, "-5.0777e-17"),
            (9.9e-5, "9.9e-5"),
        ] {
            assert_eq!(number(value), text);
        }
    }
}
