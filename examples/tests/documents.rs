//! The documents name tests, files and pictures. Here is asked whether these exist.

use std::fs;
use std::path::{Path, PathBuf};

/// The project's folder.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// All documents: their place and their text.
fn documents() -> Vec<(PathBuf, String)> {
    let folders = [
        "",
        "docs",
        "examples",
        "crates/math",
        "crates/raster",
        "crates/scene",
        "crates/stability",
        "crates/app",
    ];
    let files = folders.into_iter().flat_map(|folder| {
        let entries = fs::read_dir(root().join(folder)).unwrap_or_else(|error| panic!("{folder}: {error}"));
        entries.map(|entry| entry.unwrap().path())
    });
    let documents = files.filter(|path| path.extension().is_some_and(|extension| extension == "md"));
    documents.map(|path| (path.clone(), fs::read_to_string(&path).unwrap())).collect()
}

/// What stands between single backticks.
fn quoted(text: &str) -> impl Iterator<Item = &str> {
    text.lines().flat_map(|line| line.split('`').skip(1).step_by(2))
}

#[test]
fn every_test_that_a_document_names_exists() {
    let mut count = 0;
    for (document, text) in documents() {
        for name in quoted(&text) {
            let (file, function) = name.split_once(".rs").unwrap_or(("", ""));
            let starts = |folders: &[&str]| folders.iter().any(|folder| file.starts_with(folder));
            let folder = if starts(&["math/", "raster/", "scene/", "app/", "stability/"]) {
                "crates"
            } else if starts(&["examples/tests/", "benches/tests/"]) {
                ""
            } else {
                continue;
            };
            let path = root().join(folder).join(format!("{file}.rs"));
            let source = fs::read_to_string(&path)
                .unwrap_or_else(|error| panic!("{}: `{name}`: {error}", document.display()));
            if let Some(function) = function.strip_prefix("::") {
                let there = source.contains(&format!("fn {function}("));
                assert!(there, "{}: `{name}` is not there", document.display());
            }
            count += 1;
        }
    }
    assert!(count >= 30, "the README's table names more than {count} tests");
}

#[test]
fn no_link_of_a_document_is_broken() {
    let mut count = 0;
    for (document, text) in documents() {
        for link in text.split("](").skip(1).filter_map(|rest| rest.split([')', '#']).next()) {
            if link.is_empty() || link.starts_with("http") {
                continue;
            }
            let target = document.with_file_name("").join(link);
            assert!(target.exists(), "{}: {link} is not there", document.display());
            count += 1;
        }
    }
    assert!(count >= 10, "the documents have more than {count} links");
}

#[test]
fn no_picture_is_larger_than_200_kb() {
    for entry in fs::read_dir(root().join("docs/pictures")).unwrap() {
        let (path, size) = entry.map(|e| (e.path(), e.metadata().unwrap().len())).unwrap();
        assert!(size < 200_000, "{}: {size} bytes", path.display());
    }
}

#[test]
fn every_example_stands_in_the_table() {
    let table = fs::read_to_string(root().join("examples/README.md")).unwrap();
    let manifest = fs::read_to_string(root().join("examples/Cargo.toml")).unwrap();
    let names: Vec<&str> = manifest.lines().filter_map(|line| line.strip_prefix("name = \"")).collect();
    assert!(names.len() > 8);
    for name in &names[1..] {
        let name = name.trim_end_matches('"');
        assert!(table.contains(&format!("| [{name}](")), "{name} is missing in examples/README.md");
    }
}
