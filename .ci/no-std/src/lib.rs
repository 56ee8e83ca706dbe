//! Draws a triangle without the standard library and without an allocator.
#![no_std]

use core::panic::PanicInfo;

use polosa_raster::{Depth, Flat, State, Target};

/// Fills 64 pixels; called from nowhere, it only has to link.
pub fn draw(pixels: &mut [u16; 64], depth: &mut [u16; 64]) -> u64 {
    let corners = [[-1.0, 1.0, 0.5, 1.0], [-1.0, -1.0, 0.5, 1.0], [1.0, 1.0, 0.5, 1.0]];
    match Target::new(pixels, Depth::U16(depth), 8, 8, 8) {
        Ok(mut target) => target.triangles(&State::default(), &corners, &[[0, 1, 2]], &Flat(0xffff)).drawn,
        Err(_) => 0,
    }
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    loop {}
}
