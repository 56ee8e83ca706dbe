//! The nearest sRGB code of a shaded code, in whole numbers: nothing is rounded.
//!
//! The curve's exponent is 12/5. So the question whether the light of code c times m/1000 reaches the light halfway
//! between codes k and k + 1 is, with both sides to the fifth power, one between whole numbers of 400 bits:
//!
//! ```text
//!   light(code) = ((code/255 + 0.055) / 1.055)^2.4 = ((1000·code + 14025) / 269025)^(12/5)     above 0.04045·255
//!               = code / 255 / 12.92               = 100·code / 329460                         below
//! ```

use std::cmp::Ordering;

/// Whole numbers of base 2³², the lowest digit first: as many as any product below needs.
type Wide = [u64; 16];

/// A number, and how often it is multiplied.
type Power = (u64, u32);

fn product(factors: &[Power]) -> Wide {
    let mut wide = [0; 16];
    wide[0] = 1;
    for &(factor, times) in factors {
        for _ in 0..times {
            let mut carry = 0;
            for digit in &mut wide {
                let sum = *digit * factor + carry;
                (*digit, carry) = (sum & 0xffff_ffff, sum >> 32);
            }
            assert_eq!(carry, 0, "too many digits");
        }
    }
    wide
}

/// The fifth power of the light of a code given in halves, as numerator and denominator.
fn fifth_power(halves: u64) -> [Power; 2] {
    // 0.04045 · 255 is 10.31475: codes up to 10, and halves up to 20.
    if halves <= 20 {
        [(100 * halves, 5), (2 * 329_460, 5)]
    } else {
        [(1000 * halves + 2 * 14_025, 12), (2 * 269_025, 12)]
    }
}

/// How the light of `code` times `thousandths`/1000 compares with that halfway between `below` and the next code.
fn compare(code: u8, thousandths: u16, below: u8) -> Ordering {
    let [a, b] = fifth_power(2 * u64::from(code));
    let [c, d] = fifth_power(2 * u64::from(below) + 1);
    let light = product(&[a, (thousandths.into(), 5), d]);
    let halfway = product(&[c, (1000, 5), b]);
    light.iter().rev().cmp(halfway.iter().rev())
}

/// The nearest codes of all shades of a code, from 0 to 1000 thousandths, and whether the next lower code is as near.
pub(crate) fn all(code: u8) -> Vec<(u8, bool)> {
    // Ever brighter: the code of one shade is where the search for the next begins.
    let mut at = 0;
    let shades = (0..=1000).map(|thousandths| {
        while at < code && compare(code, thousandths, at) != Ordering::Less {
            at += 1;
        }
        (at, at > 0 && compare(code, thousandths, at - 1) == Ordering::Equal)
    });
    shades.collect()
}
