//! What `polosa compare` tells.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::{CompareArgs, Compared};
use crate::cli::words::{counted, number};
use crate::compare::Comparison;
use crate::error::one_line;

/// For people: some lines.
pub(super) fn text(args: &CompareArgs, compared: &Compared) -> String {
    let mut text = String::new();
    // Writing to a string does not fail.
    let _ = write_text(&mut text, args, compared);
    text
}

fn write_text(text: &mut String, args: &CompareArgs, compared: &Compared) -> std::fmt::Result {
    let [a, b] = names(args);
    let Some(figures) = &compared.figures else {
        let [a_size, b_size] = compared.sizes.map(|[width, height]| format!("{width}×{height}"));
        return writeln!(text, "{a}, {b}: different sizes: {a_size} and {b_size} pixels");
    };
    let verdict = if figures.differing == 0 {
        "identical"
    } else if figures.same {
        "the same within what is allowed"
    } else {
        "different"
    };
    writeln!(text, "{a}, {b}: {verdict}")?;
    let mut line = |what: &str, value: String| writeln!(text, "  {what:<13} {value}");
    line("pixels", format!("{}×{}, {}", figures.width, figures.height, kind(figures)))?;
    if figures.differing == 0 {
        return Ok(());
    }
    let share = 100.0 * figures.differing as f64 / figures.pixels() as f64;
    line("differing", format!("{} of {}, {} %", figures.differing, figures.pixels(), digits(share)))?;
    if args.threshold > 0.0 || args.allow_pixels > 0 {
        let allowed = counted(args.allow_pixels, "is", "are");
        line(
            "beyond",
            format!("{} by more than {}, {allowed} allowed", figures.beyond, number(args.threshold)),
        )?;
    }
    let unit = if figures.largest_code.is_some() { "codes" } else { "in the files' unit" };
    let at = figures.max_at.map(|[x, y]| format!(", first at {x},{y}")).unwrap_or_default();
    if figures.max_difference.is_finite() {
        let largest = number(figures.max_difference);
        let of = figures.largest_code.map_or_else(|| format!(" {unit}"), |code| format!(" of {code} codes"));
        line("largest", format!("{largest}{of}{at}"))?;
        line("mean", format!("{} {unit}", digits(figures.mean_difference)))?;
    } else {
        line("largest", format!("infinite: something in one picture alone{at}"))?;
    }
    if let Some(psnr) = figures.psnr_db {
        line("PSNR", format!("{psnr:.2} dB"))?;
    }
    line(
        "silhouettes",
        figures.silhouette_px.map_or_else(
            || "none to compare: a picture is background alone, or has none".to_owned(),
            |px| format!("{} pixels apart", if px == 0.0 { number(px) } else { format!("{px:.2}") }),
        ),
    )
}

fn kind(figures: &Comparison) -> &'static str {
    match figures.largest_code {
        None => "distances",
        Some(255) => "8 bits a channel",
        Some(_) => "16 bits a channel",
    }
}

/// A number with three digits that count.
fn digits(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return number(value);
    }
    if value < 1e-3 {
        return format!("{value:.2e}");
    }
    let after = [100.0, 10.0, 1.0, 0.1, 0.01].iter().position(|least| value >= *least).unwrap_or(5);
    format!("{value:.after$}")
}

fn names(args: &CompareArgs) -> [String; 2] {
    [&args.a, &args.b].map(|picture| one_line(&picture.name().to_string_lossy()))
}

/// For programs: one line of JSON. What is infinite is null, as JSON has no word for it.
pub(super) fn json(args: &CompareArgs, compared: &Compared) -> String {
    let [a, b] = [0, 1].map(|k| {
        let [width, height] = compared.sizes[k];
        json!({ "name": names(args)[k], "format": compared.formats[k], "width": width, "height": height })
    });
    let figure = |value: fn(&Comparison) -> Value| compared.figures.as_ref().map_or(Value::Null, value);
    let value = json!({
        "a": a,
        "b": b,
        "width": figure(|figures| figures.width.into()),
        "height": figure(|figures| figures.height.into()),
        "pixels": figure(|figures| figures.pixels().into()),
        "largest_code": figure(|figures| figures.largest_code.into()),
        "differing": figure(|figures| figures.differing.into()),
        "beyond_threshold": figure(|figures| figures.beyond.into()),
        "threshold": args.threshold,
        "allowed_pixels": args.allow_pixels,
        "max_difference": figure(|figures| figures.max_difference.into()),
        "max_at": figure(|figures| json!(figures.max_at)),
        "mean_difference": figure(|figures| figures.mean_difference.into()),
        "psnr_db": figure(|figures| figures.psnr_db.into()),
        "silhouette_px": figure(|figures| figures.silhouette_px.into()),
        "same": compared.same(),
    });
    format!("{value}\n")
}

#[cfg(test)]
mod tests {
    use super::digits;

    #[test]
    fn numbers_have_three_digits_that_count() {
        for (value, text) in [
            (0.0, "0"),
            (123.4, "123"),
            (99.96, "100.0"),
            (1.234, "1.23"),
            (0.5, "0.500"),
            (0.012_345, "0.0123"),
            (0.001_234, "0.00123"),
            (0.000_123_4, "1.23e-4"),
        ] {
            assert_eq!(digits(value), text);
        }
    }
}
