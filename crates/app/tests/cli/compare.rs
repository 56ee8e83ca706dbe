//! `polosa compare`.

use image::{ImageBuffer, Luma, Rgb, Rgba, RgbaImage};
use serde_json::{Value, json};

use crate::support::{Folder, Said, rgb};

const BLACK: Rgba<u8> = rgb(0, 0, 0);
const GREY: Rgba<u8> = rgb(120, 120, 120);

/// A grey square of 4×3 pixels with its upper left corner at (x, 2), on black, 12×8 pixels in all.
fn square(x: u32) -> RgbaImage {
    RgbaImage::from_fn(
        12,
        8,
        |i, j| if (x..x + 4).contains(&i) && (2..5).contains(&j) { GREY } else { BLACK },
    )
}

/// [`square`] at 3, and the same with one pixel of the square and one of the background changed.
fn folder() -> Folder {
    let folder = Folder::new();
    let a = square(3);
    a.save(folder.path("a.png")).unwrap();
    let mut b = a;
    b.put_pixel(4, 3, rgb(120, 123, 120));
    b.put_pixel(11, 7, rgb(1, 0, 0));
    b.save(folder.path("b.png")).unwrap();
    folder
}

fn json_of(folder: &Folder, arguments: &str, status: i32) -> Value {
    let said = folder.run(&format!("compare {arguments} --json"));
    assert_eq!((said.status, said.stderr.as_str()), (Some(status), ""), "{arguments}");
    assert_eq!(said.text().lines().count(), 1);
    serde_json::from_str(&said.text()).unwrap()
}

/// Runs and expects trouble: a line on standard error each, nothing else.
fn trouble(folder: &Folder, arguments: &str) -> Said {
    let said = folder.run(&format!("compare {arguments}"));
    assert_eq!(said.status, Some(2), "{arguments}: {said:?}");
    assert!(said.stdout.is_empty() && !said.stderr.contains("defect"), "{arguments}: {said:?}");
    said
}

#[test]
fn the_exit_status_is_that_of_cmp() {
    let folder = folder();
    for (arguments, status) in [
        ("a.png a.png", 0),
        ("a.png b.png", 1),
        ("a.png b.png --threshold 2", 1),
        ("a.png b.png --threshold 3", 0),
        ("a.png b.png --threshold 2.5 --allow-pixels 1", 0),
        ("a.png b.png --allow-pixels 1", 1),
        ("a.png b.png --allow-pixels 2", 0),
        ("a.png missing.png", 2),
        ("a.png", 2),
        ("a.png b.png --threshold -1", 2),
        ("a.png b.png --threshold nan", 2),
        ("a.png b.png --allow-pixels 1.5", 2),
        ("a.png b.png --background puce", 2),
        ("a.png b.png --quiet --json", 2),
        ("- -", 2),
    ] {
        let said = folder.run(&format!("compare {arguments}"));
        assert_eq!(said.status, Some(status), "{arguments}: {said:?}");
        assert_eq!(said.stderr.is_empty(), status < 2, "{arguments}: {said:?}");
    }
}

#[test]
fn json_has_every_figure() {
    let folder = folder();
    let found = json_of(&folder, "a.png b.png", 1);
    let name = |name| json!({ "name": name, "format": "PNG", "width": 12, "height": 8 });
    assert_eq!((&found["a"], &found["b"]), (&name("a.png"), &name("b.png")));
    for (key, expected) in [
        ("width", json!(12)),
        ("height", json!(8)),
        ("pixels", json!(96)),
        ("largest_code", json!(255)),
        ("differing", json!(2)),
        ("beyond_threshold", json!(2)),
        ("max_difference", json!(3.0)),
        ("max_at", json!([4, 3])),
        ("mean_difference", json!(4.0 / 288.0)),
        // From (11, 7), which is no background in b.png alone, to the corner (6, 4).
        ("silhouette_px", json!(34.0_f64.sqrt())),
        ("same", json!(false)),
    ] {
        assert_eq!(found[key], expected, "{key}");
    }
    // 10·log₁₀(255² · 288 / (9 + 1)) = 10·log₁₀(1 872 720)
    assert!((found["psnr_db"].as_f64().unwrap() - 62.724_73).abs() < 1e-4, "{found}");
    let found = json_of(&folder, "a.png b.png --threshold 1 --allow-pixels 1", 0);
    let some = ["differing", "beyond_threshold", "silhouette_px", "same", "threshold", "allowed_pixels"];
    assert_eq!(
        some.map(|key| &found[key]),
        [&json!(2), &json!(1), &json!(0.0), &json!(true), &json!(1.0), &json!(1)]
    );
}

#[test]
fn identical_pictures_have_no_ratio() {
    let found = json_of(&folder(), "a.png a.png", 0);
    let some =
        ["differing", "max_difference", "max_at", "mean_difference", "psnr_db", "silhouette_px", "same"];
    let expected = [json!(0), json!(0.0), Value::Null, json!(0.0), Value::Null, json!(0.0), json!(true)];
    assert_eq!(some.map(|key| found[key].clone()), expected);
}

#[test]
fn the_report_is_a_few_lines_for_people() {
    let folder = folder();
    assert_eq!(
        folder.done("compare a.png a.png").text(),
        "a.png, a.png: identical\n  pixels        12×8, 8 bits a channel\n"
    );
    let said = folder.run("compare a.png b.png --threshold 1");
    let expected = "\
a.png, b.png: different
  pixels        12×8, 8 bits a channel
  differing     2 of 96, 2.08 %
  beyond        1 by more than 1, 0 are allowed
  largest       3 of 255 codes, first at 4,3
  mean          0.0139 codes
  PSNR          62.72 dB
  silhouettes   0 pixels apart
";
    assert_eq!(said.text(), expected);
    let said = folder.done("compare a.png b.png --allow-pixels 2").text();
    assert!(said.starts_with("a.png, b.png: the same within what is allowed\n"), "{said}");
    assert!(said.contains("silhouettes   5.83 pixels apart"), "{said}");
}

#[test]
fn quiet_says_nothing_but_trouble() {
    let folder = folder();
    for (arguments, status) in [("a.png a.png", 0), ("a.png b.png -q", 1)] {
        let said = folder.run(&format!("compare {arguments} --quiet").replace("-q --quiet", "-q"));
        assert_eq!((said.status, said.text().as_str(), said.stderr.as_str()), (Some(status), "", ""));
    }
    assert!(trouble(&folder, "a.png missing.png --quiet").stderr.contains("missing.png: no such file"));
}

#[test]
fn silhouettes_are_as_far_apart_as_what_was_moved() {
    let folder = folder();
    square(6).save(folder.path("moved.png")).unwrap();
    assert_eq!(json_of(&folder, "a.png moved.png", 1)["silhouette_px"], 3.0);
    // A picture of nothing has no silhouette.
    RgbaImage::from_pixel(12, 8, BLACK).save(folder.path("blank.png")).unwrap();
    assert_eq!(json_of(&folder, "a.png blank.png", 1)["silhouette_px"], Value::Null);
    let said = folder.run("compare a.png blank.png").text();
    assert!(said.contains("silhouettes   none to compare"), "{said}");
    // What fills the corner needs a word about the background.
    square(0).save(folder.path("left.png")).unwrap();
    RgbaImage::from_fn(12, 8, |x, y| if x < 6 && y < 5 { GREY } else { BLACK })
        .save(folder.path("c.png"))
        .unwrap();
    let found = json_of(&folder, "c.png left.png --background #000", 1);
    assert_eq!(found["silhouette_px"], 8.0_f64.sqrt(), "from (5, 0) to (3, 2)");
    assert_eq!(json_of(&folder, "c.png c.png --background none", 0)["silhouette_px"], Value::Null);
}

#[test]
fn pictures_of_two_sizes_differ_and_their_picture_shows_both() {
    let folder = folder();
    RgbaImage::from_pixel(10, 9, BLACK).save(folder.path("small.png")).unwrap();
    let said = folder.run("compare a.png small.png --diff d.png");
    assert_eq!(said.status, Some(1));
    assert_eq!(said.text(), "a.png, small.png: different sizes: 12×8 and 10×9 pixels\n");
    let found = json_of(&folder, "a.png small.png --threshold 255 --allow-pixels 1000000", 1);
    assert_eq!(
        (&found["same"], &found["width"], &found["differing"]),
        (&json!(false), &Value::Null, &Value::Null)
    );
    assert_eq!((&found["a"]["width"], &found["b"]["height"]), (&json!(12), &json!(9)));
    let diff = folder.picture("d.png");
    assert_eq!(diff.dimensions(), (12, 9));
    for (x, y, pixel) in diff.enumerate_pixels() {
        if x >= 10 || y >= 8 {
            assert_eq!(*pixel, rgb(255, 0, 255), "{x} {y}");
        }
    }
}

#[test]
fn the_difference_picture_shows_what_differs_on_what_is_the_same() {
    let folder = folder();
    let said = folder.run("compare a.png b.png --threshold 1 --diff d.png");
    assert_eq!((said.status, said.stderr.as_str()), (Some(1), ""));
    let diff = folder.picture("d.png");
    for (x, y, pixel) in diff.enumerate_pixels() {
        let expected = match (x, y) {
            (4, 3) => rgb(255, 3, 0),
            (11, 7) => rgb(0x30, 0x60, 0xff),
            (3..7, 2..5) => rgb(40, 40, 40),
            _ => BLACK,
        };
        assert_eq!(*pixel, expected, "{x} {y}");
    }
    // To standard output, with the report beside it.
    let said = folder.run("compare a.png b.png --threshold 1 --diff - --json");
    assert_eq!(said.stdout, folder.bytes("d.png"));
    assert_eq!(serde_json::from_str::<Value>(&said.stderr).unwrap()["differing"], 2);
    // It is there, too, when nothing differs: an old one would tell of what is past.
    folder.done("compare a.png a.png --diff d.png");
    assert!(folder.picture("d.png").pixels().all(|pixel| pixel.0[0] <= 40));
}

#[test]
fn a_difference_picture_that_cannot_be_written_is_trouble_and_leaves_what_was_there() {
    let folder = folder();
    let before = folder.names();
    for (diff, substance) in [
        ("none/d.png", "none/d.png: cannot be written: no such folder"),
        (".", "no extension"),
        ("d.xyz", ".xyz"),
        ("d.jpg", "blurs"),
        ("a.png", "written over a picture that is compared"),
        ("./b.png", "written over a picture that is compared"),
    ] {
        let said = trouble(&folder, &format!("a.png b.png --diff {diff}"));
        assert_eq!(said.stderr.lines().count(), 1, "{}", said.stderr);
        assert!(said.stderr.contains(substance), "{diff}: {}", said.stderr);
        assert_eq!(folder.names(), before);
    }
    let kept = folder.bytes("a.png");
    trouble(&folder, "a.png missing.png --diff d.png");
    assert_eq!((folder.names(), folder.bytes("a.png")), (before, kept), "nothing to show, nothing written");
}

#[test]
fn what_cannot_be_read_is_trouble_with_a_line_each() {
    let folder =
        folder().with("text.png", "hello\n").with("empty.png", "").with("huge.ppm", "P6 99999 99999 255 ");
    let png = folder.bytes("a.png");
    let folder = folder.with("cut.png", &png[..png.len() / 2]);
    std::fs::create_dir(folder.path("folder")).unwrap();
    for (name, substance) in [
        ("missing.png", "no such file"),
        ("folder", "is a folder"),
        ("empty.png", "is empty"),
        ("text.png", "no picture that is known here"),
        ("cut.png", "PNG"),
        ("huge.ppm", "99999×99999 pixels"),
    ] {
        for arguments in [format!("{name} a.png"), format!("a.png {name}")] {
            let said = trouble(&folder, &arguments);
            assert!(said.stderr.starts_with(&format!("polosa: {name}: ")), "{}", said.stderr);
            assert!(said.stderr.contains(substance) && said.stderr.lines().count() == 1, "{}", said.stderr);
        }
    }
    assert_eq!(trouble(&folder, "missing.png text.png").stderr.lines().count(), 2, "both are told");
}

#[test]
fn what_is_cut_short_is_trouble_in_every_format() {
    let mut folder = Folder::new();
    for extension in ["png", "jpg", "bmp", "tga", "qoi", "ppm"] {
        folder.done(&format!("render shape:teapot --resolution 40,30 -o a.{extension}"));
    }
    folder.done("render shape:teapot --resolution 40,30 -o b.png --depth-image a.pfm");
    for extension in ["png", "jpg", "bmp", "tga", "qoi", "ppm", "pfm"] {
        let name = format!("a.{extension}");
        let bytes = folder.bytes(&name);
        for left in [bytes.len() / 2, bytes.len() - 9, bytes.len() - 1] {
            folder = folder.with("cut", &bytes[..left]);
            let said = trouble(&folder, &format!("{name} cut"));
            assert!(said.stderr.starts_with("polosa: cut: "), "{extension} {left}: {}", said.stderr);
        }
        folder.done(&format!("compare {name} {name}"));
    }
}

#[test]
fn colors_beside_distances_are_trouble_whatever_their_sizes() {
    let folder = folder().with("one.pfm", b"Pf\n1 1\n-1.0\n\0\0\x80\x3f");
    for arguments in ["a.png one.pfm", "one.pfm a.png", "a.png one.pfm --diff d.png"] {
        let said = trouble(&folder, arguments);
        assert!(said.stderr.contains("one holds colours and the other distances"), "{}", said.stderr);
    }
}

#[test]
fn a_difference_picture_too_large_is_refused_by_name() {
    let side = 100_000;
    let picture = |size: String| [format!("P5 {size} 255 ").as_bytes(), &vec![7; side]].concat();
    let folder = Folder::new()
        .with("wide.pgm", picture(format!("{side} 1")))
        .with("high.pgm", picture(format!("1 {side}")));
    assert_eq!(folder.run("compare wide.pgm high.pgm").status, Some(1));
    let said = trouble(&folder, "wide.pgm high.pgm --diff d.png");
    assert!(said.stderr.contains("--diff") && said.stderr.contains("100000×100000"), "{}", said.stderr);
}

#[cfg(target_os = "linux")]
#[test]
fn a_report_that_there_is_no_room_for_is_trouble() {
    let folder = folder();
    for (arguments, status) in [("a.png a.png", 2), ("a.png b.png --json", 2), ("a.png b.png --quiet", 1)] {
        let full = std::fs::File::create("/dev/full").unwrap();
        let mut command = folder.command();
        command.arg("compare").args(arguments.split(' ')).stdout(full);
        let said = crate::support::said(command.output().unwrap());
        assert_eq!(said.status, Some(status), "{arguments}: {said:?}");
        assert_eq!(said.stderr.contains("standard output: cannot be written"), status == 2, "{said:?}");
    }
}

#[test]
fn what_render_writes_is_read_whatever_its_name_says() {
    let folder = Folder::new();
    let options = "shape:teapot --resolution 40,30";
    folder.done(&format!("render {options} -o a.png --depth-image d.pfm"));
    for extension in ["bmp", "tga", "qoi", "ppm", "png"] {
        folder.done(&format!("render {options} -o b.{extension}"));
        std::fs::rename(folder.path(&format!("b.{extension}")), folder.path("b")).unwrap();
        let said = folder.done("compare a.png b");
        assert!(said.text().starts_with("a.png, b: identical\n"), "{extension}: {}", said.text());
    }
    folder.done(&format!("render {options} -o c.jpg"));
    let found = json_of(&folder, "a.png c.jpg --threshold 60", 0);
    assert!(found["psnr_db"].as_f64().unwrap() > 25.0, "{found}");
    folder.done("compare d.pfm d.pfm");
    let said = folder.run_with("compare a.png -", &folder.bytes("a.png"));
    assert_eq!(
        (said.status, said.text().lines().next()),
        (Some(0), Some("a.png, standard input: identical"))
    );
    let said = trouble(&folder, "a.png d.pfm");
    assert!(said.stderr.contains("one holds colours and the other distances"), "{}", said.stderr);
}

#[test]
fn distances_are_compared_in_their_own_unit() {
    let pfm = |values: [f32; 4]| {
        let mut bytes = b"Pf\n2 2\n-1.0\n".to_vec();
        bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
        bytes
    };
    let inf = f32::INFINITY;
    let folder = Folder::new()
        .with("a.pfm", pfm([1.0, 2.0, inf, 4.0]))
        .with("b.pfm", pfm([1.0, 2.0, inf, 4.25]))
        .with("c.pfm", pfm([1.0, 2.0, inf, inf]));
    let found = json_of(&folder, "a.pfm b.pfm", 1);
    assert_eq!((&found["max_difference"], &found["mean_difference"]), (&json!(0.25), &json!(0.0625)));
    assert_eq!(
        (&found["max_at"], &found["psnr_db"]),
        (&json!([1, 0]), &Value::Null),
        "rows go up in the file"
    );
    json_of(&folder, "a.pfm b.pfm --threshold 0.25", 0);
    // Something in one alone is infinitely different, and changes the silhouette.
    let found = json_of(&folder, "a.pfm c.pfm --threshold 1e30", 1);
    assert_eq!((&found["differing"], &found["max_difference"]), (&json!(1), &Value::Null));
    assert_eq!(found["silhouette_px"], 1.0);
    let said = folder.run("compare a.pfm c.pfm").text();
    assert!(
        said.contains("distances") && said.contains("infinite: something in one picture alone, first at 1,0"),
        "{said}"
    );
    let said = trouble(&folder, "a.pfm b.pfm --background none");
    assert!(said.stderr.contains("always what is infinite"), "{}", said.stderr);
}

#[test]
fn sixteen_bits_are_compared_at_sixteen_bits() {
    let folder = Folder::new();
    let deep = |code: u16| ImageBuffer::from_pixel(2, 1, Rgb([code, 0, 65_535]));
    deep(257 * 7).save(folder.path("a.png")).unwrap();
    deep(257 * 7 + 1).save(folder.path("b.png")).unwrap();
    RgbaImage::from_pixel(2, 1, rgb(7, 0, 255)).save(folder.path("c.png")).unwrap();
    let found = json_of(&folder, "a.png b.png", 1);
    assert_eq!((&found["max_difference"], &found["largest_code"]), (&json!(1.0), &json!(65_535)));
    assert!(folder.done("compare c.png a.png").text().contains("16 bits a channel"));
    json_of(&folder, "c.png b.png --threshold 1", 0);
    let grey: ImageBuffer<Luma<u8>, _> = ImageBuffer::from_pixel(2, 1, Luma([9]));
    grey.save(folder.path("grey.png")).unwrap();
    RgbaImage::from_pixel(2, 1, rgb(9, 9, 9)).save(folder.path("color.png")).unwrap();
    folder.done("compare grey.png color.png");
}

#[test]
fn transparency_is_compared() {
    let folder = Folder::new();
    for (name, options) in [("a.png", "--background none"), ("b.png", "")] {
        folder.done(&format!("render shape:cube -o {name} --resolution 40,30 {options}"));
    }
    let found = json_of(&folder, "a.png b.png", 1);
    assert_eq!(found["max_difference"], 255.0);
    // The same cube: with the background of each named, the outline of the one is that of the other.
    assert_eq!(json_of(&folder, "a.png a.png --background none", 0)["silhouette_px"], 0.0);
    folder.done("compare a.png b.png --threshold 255");
}

#[test]
fn help_tells_the_exit_status_and_every_option() {
    let help = Folder::new().done("compare --help").text();
    for part in [
        "--threshold",
        "--allow-pixels",
        "--background",
        "--diff",
        "--json",
        "-q, --quiet",
        "[default: 0]",
        "0 when the pictures are the same, 1 when they differ, 2 for trouble",
        "silhouettes",
        "Examples:\n  polosa compare",
    ] {
        assert!(help.contains(part), "{part}: {help}");
    }
    assert!(Folder::new().done("--help").text().contains("compare"));
}
