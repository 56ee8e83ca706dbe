//! Claim: `docs/stability.md` shows what the gallery draws, and says what it counts and what the suite's table holds.
//!
//! When a method or a picture has changed on purpose, draw the pictures anew with the command that stands in the
//! document, look at them, and mend the figures beside them.

#[expect(dead_code, reason = "its `main` writes files; here the pictures are only drawn")]
#[path = "../gallery/main.rs"]
mod gallery;

use std::fs;
use std::path::{Path, PathBuf};

use polosa::compare::{Image, Pixels, Settings, compare};
use polosa::decode::Decoded;
use polosa_scene::Picture;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The document, each run of white space one space.
fn document() -> String {
    let text = fs::read_to_string(root().join("docs/stability.md")).unwrap();
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// 12345 as 12,345.
fn with_commas(digits: &str) -> String {
    let comma = |k: usize| k > 0 && (digits.len() - k).is_multiple_of(3);
    let each = digits.chars().enumerate();
    each.flat_map(|(k, digit)| comma(k).then_some(',').into_iter().chain([digit])).collect()
}

#[test]
fn the_document_shows_every_picture_of_the_gallery_and_no_other() {
    let text = document();
    let shown: Vec<&str> =
        text.split("](pictures/stability/").skip(1).filter_map(|rest| rest.split(')').next()).collect();
    assert_eq!(shown, gallery::PICTURES.map(|(name, _)| name), "in this order");
    let mut files: Vec<String> = fs::read_dir(root().join("docs/pictures/stability"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    let mut names = gallery::PICTURES.map(|(name, _)| name.to_owned());
    files.sort();
    names.sort();
    assert_eq!(files, names, "files that nothing draws, or pictures that were not written");
}

#[test]
fn pictures_are_drawn_as_committed_and_the_document_says_their_figures() {
    let text = document();
    let mut total = 0;
    for (name, make) in gallery::PICTURES {
        let drawing = make().unwrap_or_else(|error| panic!("{name}: {error}"));
        let path = root().join("docs/pictures/stability").join(name);
        let bytes = fs::metadata(&path).unwrap_or_else(|error| panic!("{name}: {error}")).len();
        assert!(bytes <= 30_000, "{name}: {bytes} bytes");
        total += bytes;

        let file = Decoded::load(&path).unwrap();
        let Picture { width, height, ref pixels, .. } = drawing.picture;
        let drawn = Image::new(width, height, Pixels::Rgb { colors: pixels, alpha: None }).unwrap();
        let comparison = compare(&file.image().unwrap(), &drawn, &Settings::default());
        let comparison = comparison.unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(comparison.differing, 0, "{name}: pixels that are not as committed");

        // Between this picture and the next.
        let section = text.split(&format!("](pictures/stability/{name})")).nth(1).unwrap();
        let section = section.split("](pictures/").next().unwrap();
        assert!(
            section.contains(&drawing.figures),
            "{name}: the document does not say `{}`",
            drawing.figures
        );
    }
    assert!(total <= 500_000, "{total} bytes in all");
}

#[test]
fn the_summary_of_failed_scenes_is_that_of_the_suites_table() {
    let table = fs::read_to_string(root().join("crates/stability/tests/table.txt")).unwrap();
    let text = document();
    let mut methods = 0;
    for block in table.split("\n\n") {
        let cells = |line: &str| -> Vec<String> {
            line.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).map(str::to_owned).collect()
        };
        let mut lines = block.lines();
        // "#", "scene", then the methods.
        let head = cells(lines.next().unwrap());
        let rows: Vec<_> = lines.map(cells).collect();
        for (k, method) in head.iter().enumerate().skip(2) {
            let failed = rows.iter().filter(|row| !["ok", "-"].contains(&row[k].as_str()));
            let failed: Vec<String> =
                failed.map(|row| format!("{} ({})", row[0], with_commas(&row[k]))).collect();
            let failed = if failed.is_empty() { "none".to_owned() } else { failed.join(", ") };
            let row = format!("| {method} | {failed} |");
            assert!(text.contains(&row), "the document does not say\n{row}");
            methods += 1;
        }
    }
    assert_eq!(methods, 21, "two paths of polosa, nine ways to fill, ten to hide");
}
