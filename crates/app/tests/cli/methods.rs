//! Methods for comparison by name.

use polosa_raster::reference::{Coverage, Hidden};
use polosa_scene::reference::Shading;

use crate::support::{Folder, count, rgb};

const TORUS: &str = "render shape:torus:40:20 --resolution 160,120";

#[test]
fn help_lists_all_of_them_with_what_they_get_wrong() {
    let help = Folder::new().done("render --help").text();
    // Lines are wrapped.
    let help = help.split_whitespace().collect::<Vec<_>>().join(" ");
    let lists = |name: &str, about: &str| assert!(help.contains(&format!("{name}: {about}")), "{name}");
    Coverage::ALL.iter().for_each(|method| lists(method.name(), method.about()));
    Hidden::ALL.iter().for_each(|method| lists(method.name(), method.about()));
    Shading::ALL.iter().for_each(|method| lists(method.name(), method.about()));
}

#[test]
fn the_exact_ones_draw_the_same_bytes_and_the_others_other_ones() {
    let folder = Folder::new();
    let bytes = |options: &str| {
        folder.done(&format!("{TORUS} -o out.png {options}"));
        folder.bytes("out.png")
    };
    let exact = bytes("");
    for options in ["--fill strips", "--fill edges --hidden exact --shade exact"] {
        assert_eq!(bytes(options), exact, "{options}");
    }
    for options in
        ["--fill whole-pixels", "--hidden order", "--hidden sum", "--shade naive", "--shade power-2.4"]
    {
        assert_ne!(bytes(options), exact, "{options}");
    }
}

#[test]
fn naive_shading_is_too_dark() {
    let folder = Folder::new();
    // A plane that gets half of the light, by ambient alone.
    let options = "--color white --ambient 0.5 --light 0,-1,0 --resolution 40,40 --camera-direction 0,0,-1";
    let shade = |name: &str| folder.render(&format!("shape:cube {options} --shade {name}"));
    assert!(count(&shade("exact"), rgb(188, 188, 188)) > 900);
    assert!(count(&shade("naive"), rgb(127, 127, 127)) > 900);
}

#[test]
fn reports_say_which_they_were() {
    let folder = Folder::new();
    let text = |options: &str| folder.done(&format!("{TORUS} -o out.png {options}")).text();
    assert!(text("--stats --hidden sum").contains("methods     fill strips, hidden sum, shade exact"));
    assert!(!text("--stats").contains("methods"));
    let json = text("--json --fill edges");
    for word in ["\"fill\":\"edges\"", "\"hidden\":\"exact\"", "\"shade\":\"exact\""] {
        assert!(json.contains(word), "{word}: {json}");
    }
}

#[test]
fn where_colours_run_between_vertices_a_note_says_that_faces_have_their_mean() {
    let triangle = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
        property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n\
        property list uchar int vertex_indices\nend_header\n0 0 0 255 0 0\n9 0 0 0 255 0\n0 9 0 0 0 255\n3 0 1 2\n";
    let folder = Folder::new().with("v.ply", triangle);
    let options = "render v.ply -o out.png --resolution 64,64 --shading unlit";
    let said = folder.run(&format!("{options} --fill strips"));
    assert_eq!(said.status, Some(0));
    assert!(said.stderr.contains("their mean"), "{}", said.stderr);
    // A third of each light: code 156.
    assert!(count(&folder.picture("out.png"), rgb(156, 156, 156)) > 500);
    let said = folder.run(options);
    assert!(!said.stderr.contains("mean"), "{}", said.stderr);
}

#[test]
fn an_unknown_name_is_told_which_there_are() {
    let folder = Folder::new();
    for (option, names) in [
        ("--fill", Coverage::ALL.iter().map(|method| method.name()).collect::<Vec<_>>()),
        ("--hidden", Hidden::ALL.iter().map(|method| method.name()).collect()),
        ("--shade", Shading::ALL.iter().map(|method| method.name()).collect()),
    ] {
        let said = folder.run(&format!("{TORUS} -o out.png {option} fast"));
        assert_eq!(said.status, Some(2), "{}", said.stderr);
        for name in names {
            assert!(said.stderr.contains(name), "{option} {name}: {}", said.stderr);
        }
    }
    assert_eq!(folder.names(), [""; 0]);
}

#[test]
fn what_they_cannot_draw_is_refused() {
    let folder = Folder::new();
    for (options, word) in [
        ("--samples 4", "--samples"),
        ("--edges", "--edges"),
        ("--wire", "--wire"),
        ("--threads 2", "--threads"),
        ("--depth-image d.pfm", "--depth-image"),
        ("--id-image i.png", "--id-image"),
        ("--background none", "name a colour"),
    ] {
        let said = folder.run(&format!("{TORUS} -o out.png --hidden order {options}"));
        assert_eq!(said.status, Some(2), "{options}: {}", said.stderr);
        assert!(said.stderr.contains(word), "{options}: {}", said.stderr);
    }
    assert_eq!(folder.names(), [""; 0]);
}
