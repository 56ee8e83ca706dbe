//! Every option does what it says, on the decoded picture.

use image::{Rgba, RgbaImage};

use crate::support::{BACKGROUND, Folder, SQUARE, count, cube_stl, extent, rgb};

/// The cube from the front, unlit unless told otherwise: a plain square.
const FRONT: &str = "shape:cube --camera-direction 0,0,-1 --camera-orthographic --resolution 100,100";

fn middle(picture: &RgbaImage) -> Rgba<u8> {
    *picture.get_pixel(picture.width() / 2, picture.height() / 2)
}

#[test]
fn resolution_is_the_pictures_size_and_1024_by_768_without() {
    let folder = Folder::new();
    assert_eq!(folder.render("shape:cube").dimensions(), (1024, 768));
    assert_eq!(folder.render("shape:cube --resolution 37,91").dimensions(), (37, 91));
}

#[test]
fn the_model_is_framed_with_a_margin_of_a_twentieth() {
    let folder = Folder::new();
    let picture = folder.render(FRONT);
    assert_eq!(extent(&picture, BACKGROUND), Some([5, 5, 94, 94]));
    let picture = folder.render("shape:cube --resolution 400,400");
    let [x0, y0, x1, y1] = extent(&picture, BACKGROUND).unwrap();
    assert!(x0 >= 19 && y0 >= 19 && x1 <= 380 && y1 <= 380, "inside the margin");
    assert!(y0 <= 21 || y1 >= 378 || x0 <= 21 || x1 >= 378, "touching it");
}

#[test]
fn color_background_and_shading_give_the_codes() {
    let folder = Folder::new();
    let picture = folder.render(&format!("{FRONT} --shading unlit --color #123456 --background 7,8,9"));
    assert_eq!(count(&picture, rgb(0x12, 0x34, 0x56)), 90 * 90);
    assert_eq!(count(&picture, rgb(7, 8, 9)), 100 * 100 - 90 * 90);
    // Faced by light and eye, a surface shows its colour unchanged in flat shading too.
    assert_eq!(middle(&folder.render(&format!("{FRONT} --color teal"))), rgb(0, 128, 128));
    assert_eq!(middle(&folder.render(FRONT)), rgb(0xcc, 0xcc, 0xcc));
}

#[test]
fn no_background_makes_what_is_not_covered_transparent() {
    let folder = Folder::new();
    let picture = folder.render(&format!("{FRONT} --background none"));
    assert_eq!(count(&picture, rgb(0xcc, 0xcc, 0xcc)), 90 * 90);
    assert_eq!(picture.pixels().filter(|pixel| pixel.0[3] == 0).count(), 100 * 100 - 90 * 90);
}

#[test]
fn samples_soften_edges_and_nothing_else() {
    let folder = Folder::new();
    let arguments = "shape:cube --resolution 100,100 --shading unlit --background black --color white";
    let shades = |picture: &RgbaImage| {
        let mut shades: Vec<u8> = picture.pixels().map(|pixel| pixel.0[0]).collect();
        shades.sort_unstable();
        shades.dedup();
        shades
    };
    assert_eq!(shades(&folder.render(arguments)), [0, 255]);
    // A quarter, a half and three quarters of white light, sRGB-encoded.
    assert_eq!(shades(&folder.render(&format!("{arguments} --samples 4"))), [0, 137, 188, 225, 255]);
    let sixteen = shades(&folder.render(&format!("{arguments} --samples 16")));
    assert!((10..=17).contains(&sixteen.len()), "{sixteen:?}");
}

#[test]
fn position_focal_point_and_view_angle_place_the_camera() {
    let folder = Folder::new().with("square.obj", SQUARE);
    // From 20 units above the plane, 90 degrees wide: 40 units are 100 pixels.
    let picture = folder.render(
        "square.obj --camera-position 5,2.5,22 --camera-focal-point 5,2.5,0 --camera-view-angle 90 \
         --resolution 100,100",
    );
    let [x0, y0, x1, y1] = extent(&picture, BACKGROUND).unwrap();
    assert!((37..=38).contains(&x0) && (61..=62).contains(&x1), "{x0} {x1}");
    assert!((43..=44).contains(&y0) && (55..=56).contains(&y1), "{y0} {y1}");
    // Looking past it shows nothing.
    folder.blank("square.obj --camera-position 5,2.5,22 --camera-direction 0,0,1 --resolution 50,50");
    assert_eq!(extent(&folder.picture("made.png"), BACKGROUND), None);
}

#[test]
fn the_focal_point_is_the_pictures_middle() {
    let folder = Folder::new();
    let picture = folder.render(&format!("{FRONT} --camera-focal-point 1,0,0"));
    // The box around the focal point that holds the cube is 4 wide: the cube is its left half.
    let [x0, _, x1, _] = extent(&picture, BACKGROUND).unwrap();
    assert_eq!((x0, x1), (5, 49));
}

#[test]
fn view_up_turns_the_picture() {
    let folder = Folder::new().with("square.obj", SQUARE);
    let arguments = "square.obj --camera-direction 0,0,-1 --camera-orthographic --resolution 100,100";
    let size =
        |picture: &RgbaImage| extent(picture, BACKGROUND).map(|[x0, y0, x1, y1]| (x1 - x0 + 1, y1 - y0 + 1));
    assert_eq!(size(&folder.render(arguments)), Some((90, 45)));
    assert_eq!(size(&folder.render(&format!("{arguments} --camera-view-up 1,0,0"))), Some((45, 90)));
}

#[test]
fn azimuth_and_elevation_go_round_the_model() {
    let folder = Folder::new().with("square.obj", SQUARE);
    let arguments = "square.obj --camera-direction 0,0,-1 --camera-orthographic --resolution 200,200";
    let scale = "--camera-height 20 --camera-focal-point 5,2.5,2";
    let wide = |more: &str| {
        let picture = folder.render(&format!("{arguments} {more} {scale}"));
        extent(&picture, BACKGROUND).map(|[x0, y0, x1, y1]| (x1 - x0 + 1, y1 - y0 + 1))
    };
    assert_eq!(wide(""), Some((100, 50)));
    assert_eq!(wide("--camera-azimuth-angle 60"), Some((50, 50)));
    assert_eq!(wide("--camera-azimuth-angle -60"), Some((50, 50)));
    assert_eq!(wide("--camera-elevation-angle 60"), Some((100, 25)));
    let edge_on = folder.blank(&format!("{arguments} --camera-azimuth-angle 90 {scale}"));
    assert!(edge_on.starts_with("all 2 triangles degenerate"), "{edge_on}");
}

#[test]
fn stl_has_z_upward_and_all_else_y_unless_told_otherwise() {
    let folder = Folder::new().with("cube.stl", cube_stl());
    let size = "--resolution 64,64";
    let stl = folder.render(&format!("cube.stl {size}"));
    assert_eq!(stl, folder.render(&format!("cube.stl --up +Z {size}")));
    // The cube looks the same with another axis upward, seen from the same side of it.
    assert_eq!(extent(&stl, BACKGROUND), extent(&folder.render(&format!("shape:cube {size}")), BACKGROUND));
    let json = |arguments: &str| {
        let text = folder.done(&format!("render {arguments} {size} -o x.png --json")).text();
        let value: serde_json::Value = serde_json::from_str(&text).unwrap();
        [0, 1, 2].map(|i| value["camera"]["direction"][i].as_f64().unwrap().signum())
    };
    assert_eq!(json("cube.stl"), [-1.0, 1.0, -1.0]);
    assert_eq!(json("cube.stl --up +Y"), [-1.0, -1.0, -1.0]);
    assert_eq!(json("shape:cube"), [-1.0, -1.0, -1.0]);
    assert_eq!(json("shape:cube --up -X"), [1.0, -1.0, -1.0]);
    assert_eq!(json("shape:cube cube.stl"), [-1.0, -1.0, -1.0]);
}

#[test]
fn edges_are_drawn_over_the_surface_and_wire_alone() {
    let folder = Folder::new();
    let plain = folder.render(&format!("{FRONT} --shading unlit"));
    let edges = folder.render(&format!("{FRONT} --shading unlit --edges"));
    let wire = folder.render(&format!("{FRONT} --shading unlit --wire"));
    let light = rgb(0xcc, 0xcc, 0xcc);
    assert_eq!(count(&plain, rgb(0, 0, 0)), 0);
    // A square's outline; no diagonal, which is no edge of the cube.
    let black = count(&edges, rgb(0, 0, 0));
    assert!((350..=370).contains(&black), "{black}");
    assert_eq!(middle(&edges), light);
    let lit = count(&wire, light);
    assert!((350..=370).contains(&lit), "{lit}");
    assert_eq!(middle(&wire), BACKGROUND);
    assert_eq!(folder.render(&format!("{FRONT} --shading unlit -e")), edges);
}

#[test]
fn cull_leaves_out_one_side() {
    let folder = Folder::new().with("square.obj", SQUARE);
    let seen = |arguments: &str| {
        let fixed = "--camera-orthographic --resolution 50,50";
        let said = folder.run(&format!("render square.obj {fixed} {arguments} -o made.png"));
        let seen = extent(&folder.picture("made.png"), BACKGROUND).is_some();
        assert_eq!(said.stderr.is_empty(), seen, "{}", said.stderr);
        seen
    };
    for (side, direction) in [("front", "0,0,-1"), ("back", "0,0,1")] {
        for cull in ["none", "front", "back"] {
            let arguments = format!("--camera-direction {direction} --cull {cull}");
            assert_eq!(seen(&arguments), cull != side, "{arguments}");
        }
    }
}

#[test]
fn light_and_ambient_shade_the_surface() {
    let folder = Folder::new();
    let shade = |arguments: &str| middle(&folder.render(&format!("{FRONT} --color white {arguments}"))).0[0];
    assert_eq!(shade(""), 255);
    // From the side only the ambient share arrives; sRGB-encoded 0.1 is 89, 0.5 is 188.
    assert_eq!(shade("--light 1,0,0"), 89);
    assert_eq!(shade("--light 1,0,0 --ambient 0.5"), 188);
    assert_eq!(shade("--light -1,0,0 --ambient 0"), 0);
    assert_eq!(shade("--light 0,0,-3 --ambient 0"), 0);
    // 60 degrees away, cosine ½.
    assert_eq!(shade("--light 1.7320508075688772,0,1 --ambient 0"), 188);
}

#[test]
fn light_world_takes_the_direction_in_world_coordinates() {
    let folder = Folder::new();
    let shade = |arguments: &str| {
        let fixed = "shape:cube --camera-direction -1,0,0 --resolution 50,50 --color white --ambient 0";
        middle(&folder.render(&format!("{fixed} {arguments}"))).0[0]
    };
    assert_eq!(shade("--light 0,0,1"), 255);
    assert_eq!(shade("--light 0,0,1 --light-world"), 0);
    assert_eq!(shade("--light 1,0,0 --light-world"), 255);
    assert_eq!(shade("--light 1,0,0"), 0);
}

#[test]
fn several_models_make_one_picture_at_their_own_coordinates() {
    let folder = Folder::new()
        .with("a.obj", "mtllib a.mtl\nusemtl a\nv -3 0 0\nv -1 0 0\nv -2 2 0\nf 1 2 3\n")
        .with("a.mtl", "newmtl a\nKd 1 0 0\n")
        .with("b.obj", "v 1 0 0\nv 3 0 0\nv 2 2 0\nf 1 2 3\n");
    let picture = folder
        .render("a.obj b.obj --camera-direction 0,0,-1 --shading unlit --color lime --resolution 90,40");
    let (red, lime) = (rgb(255, 0, 0), rgb(0, 255, 0));
    assert!(count(&picture, red) > 50 && count(&picture, lime) > 50);
    for (x, _, pixel) in picture.enumerate_pixels() {
        assert!(*pixel != red || x < 45);
        assert!(*pixel != lime || x >= 45);
    }
}

#[test]
fn json_keeps_the_numbers_that_were_given() {
    let folder = Folder::new();
    let json = |arguments: &str| {
        folder.done(&format!("render shape:cube {arguments} --resolution 30,20 -o x.png --json")).text()
    };
    let text = json("");
    assert!(text.contains("\"view_angle\":30.0"), "{text}");
    let text = json("--camera-view-angle 33.3 --camera-direction 0,0,-1");
    assert!(text.contains("\"view_angle\":33.3,") || text.contains("\"view_angle\":33.3}"), "{text}");
    assert!(text.contains("\"direction\":[0.0,0.0,-1.0]") && !text.contains("-0.0,"), "{text}");
}

#[test]
fn one_of_a_kind_is_singular() {
    let folder = Folder::new().with("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nwhat\nf 1 2 3\n");
    let text = folder.done("render t.obj -o p.png --stats").text();
    for part in
        ["1 sample each", "1 part, 3 vertices, 1 triangle\n", "skipped 1 unknown statement (at line 4)"]
    {
        assert!(text.contains(part), "{part}: {text}");
    }
}

#[test]
fn stats_and_json_report_the_counts() {
    let folder = Folder::new().with("square.obj", SQUARE);
    let text = folder.done("render square.obj -o p.png --stats").text();
    for part in
        ["p.png: 1024×768", "square.obj: OBJ", "4 vertices, 2 triangles", "2 submitted, 2 drawn", "read "]
    {
        assert!(text.contains(part), "{part}: {text}");
    }
    let text = folder.done("render square.obj shape:cube -o p.png --json --cull back").text();
    assert_eq!(text.lines().count(), 1);
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(value["output"], "p.png");
    assert_eq!(value["models"][0]["triangles"], 2);
    assert_eq!(value["models"][1]["format"], "shape");
    assert_eq!(value["triangles"]["submitted"], 14);
    assert_eq!(value["triangles"]["culled"], 6);
    assert_eq!(value["objects"], 2);
}
