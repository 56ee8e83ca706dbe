//! Claim: polosa passes every scene, and each method kept for comparison fails exactly where `table.txt` says.
//!
//! What is judged of a method is what `polosa_raster::reference::draw` draws with it: triangles that reach beyond
//! ±32,768 px are cut by polosa's clipper first, those of the methods in floats too. So the row of the fan with
//! R = 1,000,000 px is not that of the methods alone: without the clipper `float-edges` leaves 49 holes in one such fan
//! and draws 60 pixels twice (`docs/stability.md`).
//!
//! When a method or a scene has changed on purpose:
//! `UPDATE_TABLE=1 cargo test -p polosa-stability --test ours` writes the table anew; read the difference.

use std::iter;

use polosa_stability::Verdict;

#[path = "support/ours.rs"]
mod support;

use support::table;

#[test]
fn the_table_of_failures_is_as_recorded() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/table.txt");
    let table = table();
    for row in table.rows() {
        for ours in ["immediate", "frame", "fill strips", "fill edges", "hidden exact"] {
            let verdict = table.get(&row.scene, ours);
            assert!(matches!(verdict, Verdict::Pass | Verdict::NotAsked), "{ours}: {}: {verdict}", row.scene);
        }
        for ours in ["immediate", "frame"] {
            assert_eq!(
                table.get(&row.scene, ours),
                Verdict::Pass,
                "{ours} is asked everything: {}",
                row.scene
            );
        }
    }
    let found = table.to_string();
    if std::env::var_os("UPDATE_TABLE").is_some() {
        std::fs::write(path, &found).unwrap();
    }
    let recorded = std::fs::read_to_string(path).unwrap_or_default();
    let mut lines = found.lines().zip(recorded.lines().chain(iter::repeat("")));
    if found != recorded {
        let first = lines.find(|(found, recorded)| found != recorded);
        panic!(
            "the table is not that of tests/table.txt; first difference, found and recorded:\n{first:#?}\n\
             If a method or a scene has changed on purpose, write it anew with\n\
             UPDATE_TABLE=1 cargo test -p polosa-stability --test ours\nand read the difference.\n\n{found}"
        );
    }
}
