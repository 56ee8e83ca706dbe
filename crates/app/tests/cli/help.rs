//! The help is complete.

use crate::support::Folder;

/// What every command has that draws.
const VIEW: &[&str] = &[
    "--resolution",
    "--threads",
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
    "--json",
    "Examples:\n  polosa",
    "shape:teapot",
    "shape:uv-sphere",
    "1024,768",
    "#2b2b2b",
    "#cccccc",
    "[default: 30]",
    "[default: 0.1]",
    "[default: flat]",
];

#[test]
fn help_mentions_every_option_with_its_default() {
    let own: [(&str, &[&str]); 3] = [
        (
            "render",
            &["Draws models as a picture\n", "--output", "{stem}", "--depth-image", "--id-image", "--stats"],
        ),
        (
            "turntable",
            &[
                "turn round once, as an animation",
                "--output",
                "OUT_%04d.png",
                "--frames",
                "[default: 72]",
                "--fps",
                "[default: 24]",
                "--axis",
                "counter-clockwise",
                "--stats",
            ],
        ),
        (
            "bench",
            &["Measures how fast this machine draws models\n", "--frames", "[default: 50,", "built-in"],
        ),
    ];
    for (command, own) in own {
        let help = Folder::new().done(&format!("{command} --help")).text();
        for part in VIEW.iter().chain(own) {
            assert!(help.contains(part), "{command}: {part}");
        }
    }
}

#[test]
fn every_command_has_help_and_the_program_a_version() {
    let folder = Folder::new();
    assert!(folder.done("--help").text().contains("render") && folder.done("-h").text().contains("info"));
    assert!(folder.done("--help").text().contains("bench"));
    assert!(folder.done("info --help").text().contains("watertight"));
    assert_eq!(folder.done("--version").text(), concat!("polosa ", env!("CARGO_PKG_VERSION"), "\n"));
}
