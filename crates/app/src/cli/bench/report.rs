//! What `polosa bench` tells.

use std::fmt::Write as _;
use std::time::Duration;

use serde_json::{Value, json};

use super::measure::{milliseconds, per_second};
use super::{BUILT_IN, Measured, ModelFacts, Timed};
use crate::cli::words::counted;
use crate::error::one_line;

/// The length of the bar for the whole of a frame.
const BAR: usize = 30;

/// For people: some lines.
pub(super) fn text(measured: &Measured) -> String {
    let mut text = String::new();
    // Writing to a string does not fail.
    let _ = write_text(&mut text, measured);
    text
}

fn write_text(text: &mut String, measured: &Measured) -> std::fmt::Result {
    let Measured { settings, timed, .. } = measured;
    let Timed { frames, stats, .. } = timed;
    let name = measured.models.first().map_or(BUILT_IN, |model| &model.name);
    let others = match measured.models.len() {
        0 | 1 => String::new(),
        count => format!(" and {}", counted(count as u64 - 1, "other", "others")),
    };
    let threads = counted(measured.threads.get() as u64, "thread", "threads");
    writeln!(text, "{name}{others}: {}×{} pixels, {threads}", settings.width, settings.height)?;
    let mut line = |what: &str, value: String| writeln!(text, "  {what:<12}{value}");
    for model in &measured.models {
        line("model", model.text())?;
        for remark in &model.remarks {
            line("", one_line(remark))?;
        }
    }
    if stats.triangles.submitted > 0 {
        line("triangles", format!("{}, {} drawn", measured.triangles, stats.triangles.drawn))?;
    }
    if stats.lines.submitted > 0 {
        line("edges", format!("{}, {} drawn", stats.lines.submitted, stats.lines.drawn))?;
    }
    let drawn = frames.count();
    let of = if drawn < timed.asked { format!(" of {} in 5 s", timed.asked) } else { String::new() };
    line("frames", format!("{drawn}{of}, after {} to warm up", timed.warm_up))?;

    let median = frames.median();
    line("median", format!("{} ms, {} frames/s", ms(median), digits(per_second(1.0, median))))?;
    let quarters = [1, 3].map(|k| ms(frames.quantile(k)));
    line(
        "spread",
        format!(
            "{} to {} ms, half of all {} to {} ms",
            ms(frames.min()),
            ms(frames.max()),
            quarters[0],
            quarters[1]
        ),
    )?;
    let [triangles, pixels] = rates(measured).map(digits);
    line("speed", format!("{triangles} million triangles/s, {pixels} million pixels/s"))?;
    for &(stage, time) in &timed.stages {
        let share = milliseconds(time) / milliseconds(median.max(Duration::from_nanos(1)));
        let bar = "█".repeat(((share * BAR as f64).round() as usize).min(BAR));
        line(stage, format!("{:>7} ms {:>4.0} %  {bar}", ms(time), share * 100.0))?;
    }
    let memset = measured.memset;
    line(
        "memset",
        format!(
            "{:>7} ms for as many bytes, {} GB/s on one thread",
            ms(memset.time),
            digits(memset.gigabytes_per_second())
        ),
    )?;
    if let Some(cpu) = cpu() {
        line("processor", cpu)?;
    }
    line("fingerprint", format!("{:016x}: pictures that share it are equal", measured.fingerprint))?;
    for note in &measured.notes {
        line("note", one_line(note))?;
    }
    Ok(())
}

/// For programs: one line of JSON.
pub(super) fn json(measured: &Measured) -> String {
    let Measured { settings, timed, memset, .. } = measured;
    let Timed { frames, stats, .. } = timed;
    let models: Vec<Value> = measured.models.iter().map(ModelFacts::json).collect();
    let stages: serde_json::Map<String, Value> =
        timed.stages.iter().map(|&(stage, time)| (stage.to_owned(), milliseconds(time).into())).collect();
    let quartiles = [1, 3].map(|k| milliseconds(frames.quantile(k)));
    let [triangles, pixels] = rates(measured);
    let value = json!({
        "models": models,
        "triangles": measured.triangles,
        "triangles_drawn": stats.triangles.drawn,
        "edges": stats.lines.submitted,
        "width": settings.width,
        "height": settings.height,
        "threads": measured.threads,
        "frames": frames.count(),
        "warm_up_frames": timed.warm_up,
        "median_ms": milliseconds(frames.median()),
        "min_ms": milliseconds(frames.min()),
        "max_ms": milliseconds(frames.max()),
        "quartiles_ms": quartiles,
        "mtri_per_s": triangles,
        "mpix_per_s": pixels,
        "stages_ms": stages,
        "memset_ms": milliseconds(memset.time),
        "memset_gb_per_s": memset.gigabytes_per_second(),
        "cpu": cpu(),
        "version": env!("CARGO_PKG_VERSION"),
        "fingerprint": format!("{:016x}", measured.fingerprint),
        "notes": measured.notes,
    });
    format!("{value}\n")
}

/// Millions of triangles, and of pixels, per second of the median frame.
fn rates(measured: &Measured) -> [f64; 2] {
    let pixels = f64::from(measured.settings.width) * f64::from(measured.settings.height);
    [measured.triangles as f64, pixels].map(|count| per_second(count, measured.timed.frames.median()) / 1e6)
}

/// Milliseconds for people.
fn ms(time: Duration) -> String {
    digits(milliseconds(time))
}

/// A number with three digits, or more where they stand before the point.
fn digits(value: f64) -> String {
    let after = if value < 1.0 {
        3
    } else if value < 10.0 {
        2
    } else {
        usize::from(value < 100.0)
    };
    format!("{value:.after$}")
}

/// The processor's name where the system tells it as a file.
fn cpu() -> Option<String> {
    let text = std::fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(one_line(line.split_once(':')?.1.trim()))
}

#[cfg(test)]
mod tests {
    use super::digits;

    #[test]
    fn numbers_have_three_digits_or_more() {
        for (value, text) in
            [(0.0, "0.000"), (0.0314, "0.031"), (1.234, "1.23"), (45.67, "45.7"), (1234.5, "1234")]
        {
            assert_eq!(digits(value), text);
        }
    }
}
