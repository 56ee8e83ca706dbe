//! The help is complete.

use crate::support::Folder;

#[test]
fn help_mentions_every_option_with_its_default() {
    let help = Folder::new().done("render --help").text();
    for option in [
        "--output",
        "--resolution",
        "--camera-position",
        "--camera-focal-point",
        "--camera-direction",
        "--camera-view-up",
        "--camera-azimuth-angle",
        "--camera-elevation-angle",
        "--camera-view-angle",
        "--camera-orthographic",
        "--camera-height",
        "--up",
        "--shading",
        "--edges",
        "--wire",
        "--cull",
        "--color",
        "--background",
        "--light",
        "--light-world",
        "--ambient",
        "--samples",
        "--depth-image",
        "--id-image",
        "--stats",
        "--json",
        "{stem}",
        "Examples:",
        "shape:teapot",
        "shape:uv-sphere",
    ] {
        assert!(help.contains(option), "{option}");
    }
    for default in ["1024,768", "#2b2b2b", "#cccccc", "[default: 30]", "[default: 0.1]", "[default: flat]"] {
        assert!(help.contains(default), "{default}");
    }
}

#[test]
fn every_command_has_help_and_the_program_a_version() {
    let folder = Folder::new();
    assert!(folder.done("--help").text().contains("render") && folder.done("-h").text().contains("info"));
    assert!(folder.done("info --help").text().contains("watertight"));
    assert_eq!(folder.done("--version").text(), concat!("polosa ", env!("CARGO_PKG_VERSION"), "\n"));
}
