//! What is recorded, read again.

use core::num::NonZeroUsize;
use std::fs;
use std::path::Path;
use std::time::Duration;

use gif::{ColorOutput, DecodeOptions, DisposalMethod};
use polosa_scene::{DrawStats, Picture};

use super::{Options, Recorder, To};

/// A frame as it is shown: pixels `0xAARRGGBB`, and its delay in hundredths of a second.
type Shown = (Vec<u32>, u16);

/// Plays a GIF once.
fn play(bytes: &[u8]) -> ([usize; 2], Vec<Shown>) {
    let mut options = DecodeOptions::new();
    options.set_color_output(ColorOutput::RGBA);
    let mut decoder = options.read_info(bytes).unwrap();
    let size = [decoder.width(), decoder.height()].map(usize::from);
    let mut canvas = vec![0; size[0] * size[1]];
    let mut shown = Vec::new();
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        let width = usize::from(frame.width);
        let place =
            |k: usize| (usize::from(frame.top) + k / width) * size[0] + usize::from(frame.left) + k % width;
        for (k, pixel) in frame.buffer.chunks_exact(4).enumerate().filter(|(_, pixel)| pixel[3] > 0) {
            canvas[place(k)] = u32::from_be_bytes([255, pixel[0], pixel[1], pixel[2]]);
        }
        shown.push((canvas.clone(), frame.delay));
        if frame.dispose == DisposalMethod::Background {
            (0..frame.buffer.len() / 4).for_each(|k| canvas[place(k)] = 0);
        }
    }
    (size, shown)
}

fn options(fps: f64, threads: usize) -> Options {
    Options { fps, threads: NonZeroUsize::new(threads) }
}

/// Records frames of a size as a GIF; its bytes.
fn recorded(frames: &[Vec<u32>], size: [u32; 2], options: Options) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.gif");
    let mut recorder = super::to(&path, options).unwrap();
    for frame in frames {
        recorder.frame(frame, size).unwrap();
        assert!(!path.exists(), "it is not there before it is complete");
    }
    recorder.finish().unwrap();
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "nothing else is left");
    fs::read(path).unwrap()
}

/// A square that goes over a background of so many colours, and from frame 5 on stands still.
fn frames(colors: u32) -> Vec<Vec<u32>> {
    let background = |x: u32, y: u32| ((x + 40 * y) % colors * 0x01_0307) & 0xff_ffff;
    let frame = |n: u32| {
        let inside = |x: u32, y: u32| (3 * n..3 * n + 8).contains(&x) && (n..n + 8).contains(&y);
        let color = |x, y| if inside(x, y) { 0xff_8000 } else { background(x, y) };
        (0..30).flat_map(|y| (0..40).map(move |x| color(x, y))).collect()
    };
    (0..8).map(|n| frame(n.min(5))).collect()
}

#[test]
fn an_animation_shows_every_pixel_as_it_was_and_repeats_for_ever() {
    for colors in [1, 2, 100, 255] {
        let frames = frames(colors);
        let bytes = recorded(&frames, [40, 30], options(24.0, 2));
        let (size, shown) = play(&bytes);
        assert_eq!((size, shown.len()), ([40, 30], 8));
        for (n, (shown, frame)) in shown.iter().zip(&frames).enumerate() {
            assert!(
                shown.0.iter().zip(frame).all(|(s, f)| *s == 0xff00_0000 | f),
                "frame {n} of {colors} colours"
            );
        }
        assert_eq!(shown.iter().map(|(_, delay)| *delay).collect::<Vec<_>>(), [4, 4, 5, 4, 4, 4, 4, 4]);
        let repeat = b"NETSCAPE2.0\x03\x01\x00\x00\x00";
        assert!(bytes.windows(repeat.len()).any(|window| window == repeat));
    }
}

#[test]
fn frames_that_have_all_256_colors_are_exact_too() {
    // All pixels but one change, and take all entries of the palette.
    let frame = |n: u32| (0..257_u32).map(|k| if k == 256 { 7 } else { (k + n) % 256 }).collect::<Vec<u32>>();
    let frames = [frame(0), frame(1), frame(2)];
    let (_, shown) = play(&recorded(&frames, [257, 1], options(10.0, 1)));
    for ((shown, _), frame) in shown.iter().zip(&frames) {
        assert!(shown.iter().zip(frame).all(|(s, f)| *s == 0xff00_0000 | f));
    }
}

#[test]
fn with_more_colors_what_stands_still_does_not_flicker_and_nothing_is_far_off() {
    let frames = frames(1200);
    let (_, shown) = play(&recorded(&frames, [40, 30], options(24.0, 1)));
    for n in 1..frames.len() {
        for (k, (now, before)) in frames[n].iter().zip(&frames[n - 1]).enumerate() {
            if now == before {
                assert_eq!(shown[n].0[k], shown[n - 1].0[k], "pixel {k} of frame {n}");
            }
        }
    }
    let codes = |color: u32| color.to_be_bytes().map(i32::from);
    for ((shown, _), frame) in shown.iter().zip(&frames) {
        let pairs = shown.iter().zip(frame).map(|(s, f)| (codes(*s), codes(*f)));
        let error: i32 = pairs.map(|(s, f)| (1..4).map(|k| (s[k] - f[k]).pow(2)).sum::<i32>()).sum();
        // 1,200 colours in steps of (1, 3, 7), 4.7 of them to an entry, have this variance.
        let variance = (1 + 9 + 49) as f64 * 4.7 * 4.7 / 12.0;
        assert!(f64::from(error) < 1200.0 * variance, "{error}");
    }
}

#[test]
fn transparent_pixels_are_let_through_in_every_frame() {
    let picture = |n: usize| {
        let alpha: Vec<u8> = (0..12).map(|k| if k % 4 == n { 255 } else { 0 }).collect();
        let stats = DrawStats::default();
        let pixels = vec![0x20_4060; 12];
        Picture { width: 4, height: 3, pixels, alpha: Some(alpha), distances: None, ids: None, stats }
    };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.gif");
    let mut recorder = super::to(&path, options(10.0, 2)).unwrap();
    // The last one is empty.
    (0..5).for_each(|n| recorder.picture(picture(n)).unwrap());
    let mixed = recorder.frame(&[0; 12], [4, 3]).unwrap_err().to_string();
    assert!(mixed.contains("transparency"), "{mixed}");
    recorder.finish().unwrap();
    let (_, shown) = play(&fs::read(path).unwrap());
    assert_eq!(shown.len(), 5);
    for (n, (shown, _)) in shown.iter().enumerate() {
        let expected = |k: usize| if k % 4 == n { 0xff20_4060 } else { 0 };
        assert!(shown.iter().enumerate().all(|(k, pixel)| *pixel == expected(k)), "frame {n}");
    }
}

#[test]
fn any_number_of_threads_writes_the_same_bytes() {
    for colors in [100, 1200] {
        let frames = frames(colors);
        let one = recorded(&frames, [40, 30], options(24.0, 1));
        for threads in [2, 3, 8] {
            assert!(recorded(&frames, [40, 30], options(24.0, threads)) == one, "{threads} threads");
        }
    }
}

#[test]
fn times_of_a_recording_in_real_time_are_kept() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.gif");
    let mut recorder = super::to(&path, options(60.0, 1)).unwrap();
    for (color, time) in [(1, 0), (2, 10), (3, 15), (4, 700_000)] {
        recorder.frame_at(&[color], [1, 1], Duration::from_millis(time)).unwrap();
    }
    recorder.finish_at(Duration::from_millis(700_500)).unwrap();
    let (_, shown) = play(&fs::read(path).unwrap());
    let told: Vec<_> = shown.iter().map(|(pixels, delay)| (pixels[0] & 0xff, *delay)).collect();
    // The second comes too soon, and makes room for the third; no frame is shown for longer than 655.35 s.
    assert_eq!(told, [(1, 2), (3, 65_535), (3, 4_463), (4, 50)]);
}

#[test]
fn a_sequence_is_a_file_a_frame_from_number_1_on() {
    let folder = tempfile::tempdir().unwrap();
    let frames = frames(1200);
    for (pattern, names) in [("a_%04d.png", ["a_0001.png", "a_0008.png"]), ("b%d.bmp", ["b1.bmp", "b8.bmp"])]
    {
        let mut recorder = super::to(folder.path().join(pattern), options(1000.0, 3)).unwrap();
        frames.iter().for_each(|frame| recorder.frame(frame, [40, 30]).unwrap());
        recorder.finish().unwrap();
        for (name, frame) in names.into_iter().zip([&frames[0], &frames[7]]) {
            let picture = image::open(folder.path().join(name)).unwrap().into_rgb8();
            let pixels = picture.pixels().map(|p| u32::from_be_bytes([0, p.0[0], p.0[1], p.0[2]]));
            assert!(pixels.eq(frame.iter().copied()), "{name}");
        }
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 16);
}

#[test]
fn a_frame_of_another_size_is_left_out_and_the_recording_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.gif");
    let mut recorder = super::to(&path, options(10.0, 1)).unwrap();
    recorder.frame(&[1; 6], [3, 2]).unwrap();
    let error = recorder.frame(&[2; 6], [2, 3]).unwrap_err().to_string();
    assert!(error.contains("2×3") && error.contains("3×2"), "{error}");
    for (pixels, size) in
        [(&[1_u32; 6][..], [3, 3]), (&[], [0, 0]), (&[], [u32::MAX; 2]), (&[1; 6], [u32::MAX, 2])]
    {
        assert!(recorder.frame(pixels, size).is_err(), "{size:?}");
    }
    recorder.frame(&[3; 6], [3, 2]).unwrap();
    assert_eq!(recorder.frames(), 2);
    recorder.finish().unwrap();
    let (_, shown) = play(&fs::read(path).unwrap());
    assert_eq!(shown, [(vec![0xff00_0001; 6], 10), (vec![0xff00_0003; 6], 10)]);
}

#[test]
fn what_is_dropped_or_has_no_frame_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("x.gif"), "old").unwrap();
    let mut recorder = super::to(path("x.gif"), options(10.0, 1)).unwrap();
    (0..5).for_each(|n| recorder.frame(&[n; 4], [2, 2]).unwrap());
    drop(recorder);
    for name in ["x.gif", "y_%d.png"] {
        let error = super::to(path(name), options(10.0, 1)).unwrap().finish().unwrap_err().to_string();
        assert!(error.contains("no frame"), "{error}");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    assert_eq!(fs::read(path("x.gif")).unwrap(), b"old");
}

#[test]
fn a_rate_that_is_none_is_wrong_usage() {
    for fps in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-9] {
        let error = Recorder::create(&To::path(Path::new("x.gif")).unwrap(), options(fps, 1)).unwrap_err();
        assert_eq!(error.exit_status(), 2, "{fps}: {error}");
    }
}

#[test]
fn what_prevents_writing_is_found_before_the_first_frame_or_named_after_it() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["none/x.gif", "none/x_%d.png"] {
        let error = super::to(folder.path().join(name), options(10.0, 1)).unwrap_err().to_string();
        assert!(error.contains("no such folder"), "{error}");
    }
    // The second file of the sequence cannot be written: that is told while or after others are.
    fs::create_dir(folder.path().join("x_2.png")).unwrap();
    let mut recorder = super::to(folder.path().join("x_%d.png"), options(10.0, 1)).unwrap();
    let added: Result<Vec<()>, _> = (0..50).map(|n| recorder.frame(&[n; 4], [2, 2])).collect();
    let error = added.unwrap_err().to_string();
    assert!(error.contains("x_2.png: cannot be written"), "{error}");
    assert!(recorder.finish().is_err());
    let names = fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name());
    assert!(
        names.into_iter().all(|name| name.to_str().unwrap().ends_with("png")),
        "no temporary file is left"
    );
}

#[cfg(unix)]
#[test]
fn a_full_disk_is_told_once() {
    let mut recorder = super::to("/dev/full", options(10.0, 1)).unwrap();
    let frames: Vec<Vec<u32>> =
        (0..9).map(|n| (0..40_000).map(|k| (k * n * 7919) & 0xff_ffff).collect()).collect();
    let failed = frames.iter().find_map(|frame| recorder.frame(frame, [200, 200]).err());
    let error = failed.unwrap_or_else(|| recorder.finish().unwrap_err()).to_string();
    assert!(error.starts_with("/dev/full: ") && error.contains("no space"), "{error}");
}
