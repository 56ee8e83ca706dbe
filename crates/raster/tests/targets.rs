//! Claim: a target refuses slices that do not hold its pixels, by name and number, and touches no
//! value outside of them.

mod support;

use polosa_raster::{Depth, DepthTest, Flat, StoredDepth, Target, TargetError};
use support::picture::{on_screen, px};

#[test]
fn short_slices_are_refused_with_the_needed_and_the_given_length() {
    // (rows − 1)·stride + width: the last row need not be padded.
    for (width, height, stride, needed) in [(1, 1, 1, 1), (7, 1, 9, 7), (7, 3, 7, 21), (7, 3, 10, 27)] {
        for given in [0, 1, needed - 1, needed, needed + 1] {
            let mut color = vec![0_u8; given];
            let result = Target::new(&mut color, Depth::None, width, height, stride).map(|_| ());
            let error = TargetError::Color { needed, given };
            assert_eq!(
                result,
                if given < needed { Err(error) } else { Ok(()) },
                "{width}×{height}, {stride}"
            );
            let mut color = vec![0_u8; needed];
            let (mut wide, mut narrow) = (vec![0.0; given], vec![0; given]);
            for depth in [Depth::F32(&mut wide), Depth::U16(&mut narrow)] {
                let result = Target::new(&mut color, depth, width, height, stride).map(|_| ());
                let error = TargetError::Depth { needed, given };
                assert_eq!(
                    result,
                    if given < needed { Err(error) } else { Ok(()) },
                    "{width}×{height}, {stride}"
                );
            }
        }
    }
}

#[test]
fn an_error_says_what_is_wrong_in_numbers() {
    let mut color = [0_u8; 5];
    let say = |r: Result<Target<'_, u8>, TargetError>| r.map(|_| ()).unwrap_err().to_string();
    let text = say(Target::new(&mut color, Depth::None, 3, 2, 3));
    assert!(text.contains('5') && text.contains('6'), "{text}");
    let text = say(Target::new(&mut color, Depth::None, 5, 1, 4));
    assert!(text.contains('5') && text.contains('4'), "{text}");
    let text = say(Target::new(&mut color, Depth::None, 70_000, 1, 70_000));
    assert!(text.contains("70000"), "{text}");
    let text = say(Target::band(&mut color, Depth::None, [1, 5], 1, 3..9));
    assert!(text.contains('3') && text.contains('9') && text.contains('5'), "{text}");
}

#[test]
fn sizes_of_zero_or_beyond_the_largest_are_refused() {
    let mut color = [0_u8; 16];
    let largest = polosa_raster::MAX_SIDE;
    for (width, height) in
        [(0, 1), (1, 0), (0, 0), (largest + 1, 1), (1, largest + 1), (u32::MAX, u32::MAX), (1, u32::MAX)]
    {
        let result = Target::new(&mut color, Depth::None, width, height, width as usize).map(|_| ());
        assert_eq!(result, Err(TargetError::Size { width, height }));
    }
    // The largest is allowed; and strides whose product with the rows overflows are an error, not a panic.
    let result = Target::new(&mut color, Depth::None, largest, largest, largest as usize).map(|_| ());
    assert_eq!(result, Err(TargetError::Color { needed: 16_384 * 16_384, given: 16 }));
    let result = Target::new(&mut color, Depth::None, 2, largest, usize::MAX).map(|_| ());
    assert!(matches!(result, Err(TargetError::Color { given: 16, .. })), "{result:?}");
    let result = Target::new(&mut color, Depth::None, 4, 2, 3).map(|_| ());
    assert_eq!(result, Err(TargetError::Stride { stride: 3, width: 4 }));
}

#[test]
fn a_band_names_rows_that_the_picture_has() {
    let mut color = [0_u8; 40];
    let empty = 7;
    for (rows, good) in [
        (0..1, true),
        (3..7, true),
        (0..10, true),
        (9..11, false),
        (4..4, false),
        (empty..3, false),
        (10..10, false),
    ] {
        let result = Target::band(&mut color, Depth::None, [4, 10], 4, rows.clone()).map(|_| ());
        let error = TargetError::Rows { start: rows.start, end: rows.end, height: 10 };
        assert_eq!(result, if good { Ok(()) } else { Err(error) }, "{rows:?}");
    }
}

/// A stride beyond the width and a slice beyond the last row: what lies between and behind is the caller's.
#[test]
fn nothing_outside_of_the_rows_is_touched() {
    let (width, height, stride) = (20_usize, 12_usize, 27_usize);
    let v = [px(-30.0, -30.0, 0.5), px(90.0, -30.0, 0.5), px(-30.0, 90.0, 0.5)];
    for depth_kind in 0..2 {
        let mut color = vec![7_u8; stride * height + 5];
        let (mut wide, mut narrow) = (vec![0.25_f32; color.len()], vec![9_u16; color.len()]);
        let depth = if depth_kind == 0 { Depth::F32(&mut wide) } else { Depth::U16(&mut narrow) };
        let mut target = Target::new(&mut color, depth, 20, 12, stride).unwrap();
        target.clear(1, DepthTest::Greater);
        target.triangles(&on_screen(), &v, &[[0, 1, 2]], &Flat(2));
        target.lines(&on_screen(), &[px(-9.0, 3.0, 0.9), px(99.0, 4.0, 0.9)], &[[0, 1]], 3);
        for k in 0..color.len() {
            let inside = k % stride < width && k / stride < height;
            assert_eq!(color[k] == 7, !inside, "colour {k}");
            let kept = if depth_kind == 0 { wide[k] == 0.25 } else { narrow[k] == 9 };
            assert_eq!(kept, !inside, "depth {k}");
        }
    }
}

#[test]
fn pixels_are_read_by_their_place_in_the_whole_picture() {
    let mut color: Vec<u16> = (0..40).collect();
    let mut depth: Vec<f32> = (0..40).map(|k| k as f32 / 64.0).collect();
    let target = Target::band(&mut color, Depth::F32(&mut depth), [6, 100], 8, 50..55).unwrap();
    assert_eq!((target.width(), target.height(), target.rows()), (6, 100, &(50..55)));
    assert_eq!(target.color_at(0, 50), Some(0));
    assert_eq!(target.color_at(5, 54), Some(37));
    assert_eq!(target.depth_at(3, 52), Some(StoredDepth::F32(19.0 / 64.0)));
    for (x, y) in [(6, 50), (0, 49), (0, 55), (u32::MAX, 50), (0, u32::MAX)] {
        assert_eq!((target.color_at(x, y), target.depth_at(x, y)), (None, None), "({x}, {y})");
    }
    let target = Target::new(&mut color, Depth::None, 2, 2, 2).unwrap();
    assert_eq!(target.depth_at(0, 0), None, "without depth");
}

/// Any `Copy` value is a pixel.
#[test]
fn a_pixel_may_be_any_copy_value() {
    #[derive(Clone, Copy, Debug, PartialEq)]
    enum Ink {
        Paper,
        Ink([f64; 3], char),
    }
    let mut color = [Ink::Paper; 16];
    let mut target = Target::new(&mut color, Depth::None, 4, 4, 4).unwrap();
    let v = [px(0.0, 0.0, 0.5), px(4.0, 0.0, 0.5), px(0.0, 4.0, 0.5)];
    target.triangles(&on_screen(), &v, &[[0, 1, 2]], &Flat(Ink::Ink([0.1, 0.2, 0.3], 'ю')));
    assert_eq!(color[0], Ink::Ink([0.1, 0.2, 0.3], 'ю'));
    assert_eq!(color[15], Ink::Paper);
}

#[test]
fn bands_of_a_target_are_its_rows_and_nothing_else() {
    for (rows, stride, start, end) in [(1, 5, 0, 9), (4, 7, 0, 9), (4, 5, 2, 9), (100, 6, 3, 4), (0, 5, 0, 9)]
    {
        let (mut color, mut depth) = (vec![0; stride * 9], vec![0_u16; stride * 9]);
        let mut whole = Target::band(&mut color, Depth::U16(&mut depth), [5, 9], stride, start..end).unwrap();
        let mut next = start;
        for (number, mut band) in (1..).zip(whole.bands(rows)) {
            assert_eq!((band.rows().start, band.width(), band.height(), band.stride()), (next, 5, 9, stride));
            assert_eq!(band.rows().end, end.min(next + rows.max(1)));
            next = band.rows().end;
            band.clear(number, DepthTest::Less);
        }
        assert_eq!(next, end);
        for y in start..end {
            let number = (y - start) / rows.max(1) + 1;
            assert_eq!(whole.color_at(4, y), Some(number));
            assert_eq!(whole.depth_at(0, y), Some(StoredDepth::U16(u16::MAX)));
        }
    }
}

#[test]
fn depth_may_be_kept_elsewhere_for_a_while() {
    let (mut color, mut depth) = ([0; 20], [0.25; 19]);
    let mut target = Target::new(&mut color, Depth::None, 4, 4, 5).unwrap();
    let error = target.with_depth(Depth::F32(&mut [0.0; 18])).unwrap_err();
    assert_eq!(error, TargetError::Depth { needed: 19, given: 18 });
    let mut with_depth = target.with_depth(Depth::F32(&mut depth)).unwrap();
    assert_eq!(with_depth.depth_at(3, 3), Some(StoredDepth::F32(0.25)));
    with_depth.clear(7, DepthTest::Greater);
    assert_eq!((target.color_at(3, 3), target.depth_at(3, 3)), (Some(7), None));
}

#[test]
fn one_row_may_have_any_stride() {
    let mut color = [0_u8; 4];
    let mut target = Target::new(&mut color, Depth::None, 4, 1, usize::MAX).unwrap();
    for rows in [1, 2, u32::MAX] {
        let mut bands = target.bands(rows).map(|band| band.rows().clone());
        assert_eq!((bands.next(), bands.next()), (Some(0..1), None), "bands of {rows} rows");
    }
    let mut depth = [0.0; 4];
    target.with_depth(Depth::F32(&mut depth)).unwrap().clear(7, DepthTest::Greater);
    assert_eq!(color, [7; 4]);
}
