//! Which surface is seen: the methods by name.

use super::names::methods;

methods! {
    /// A way to decide which of two triangles is seen at a pixel. Larger depth is nearer.
    ///
    /// What is stored is cleared to −∞, as the seeds have it, and strictly nearer wins. Only the exact method in
    /// [`draw`](super::draw) is cleared as [`Target::clear`](crate::Target::clear) does it: to 0, the far plane.
    Hidden, "way to hide" {
        Exact, "exact", "f32 from exact edge values, the default: within 5·2⁻²⁴ of the plane, slivers included";
        Order, "order", "S0's first stage, S2: none, what is drawn last stays; right only for one convex solid with back faces culled";
        Painter, "painter", "far to near by the depth of the centroid: wrong where triangles cross or overlap in a ring";
        Sum, "sum", "S3: z1 + z2 + z3, one depth a triangle: wrong where triangles cross, or are long";
        StripLinear, "strip-linear", "S4 as meant: f64 between the ends of the vertical strip; accurate, in a memory twice as large";
        StripPrinted, "strip-printed", "S4 as printed: without the strip's own depth, so that parallel planes tie";
        Barycentric, "barycentric", "S0: f64 from the weights at each pixel; accurate, and three divisions a pixel";
        PlaneF32Origin, "plane-f32-origin", "an f32 plane from the screen's corner: small triangles far from it lose most digits";
        PlaneF32Vertex, "plane-f32-vertex", "an f32 plane from the first vertex: slivers lose most digits";
        PlaneF64, "plane-f64", "an f64 plane from the first vertex, rounded once to f32: half a unit of 2⁻²⁴ of the largest depth";
    }
}

impl Hidden {
    /// Whether what is nearer is found by a depth that is kept for each pixel.
    #[must_use]
    pub const fn has_buffer(self) -> bool {
        !matches!(self, Self::Order | Self::Painter)
    }
}
