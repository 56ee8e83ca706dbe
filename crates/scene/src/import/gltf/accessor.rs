//! Accessors: numbers in buffers, of several types, with strides, sparse or not.
//!
//! Own code, since the library's reader panics where an accessor reaches beyond its buffer, and trusts that
//! positions are floats (with `KHR_mesh_quantization` they need not be). All ranges are checked before anything is
//! read or allocated.

use gltf::accessor::{Accessor, DataType};

use super::super::error::{Fault, Parsed, Place};

/// The bytes of all buffers, by number.
pub(super) type Buffers = [Vec<u8>];

/// A run of equally spaced entries.
struct Entries<'a> {
    bytes: &'a [u8],
    stride: usize,
    count: usize,
    kind: DataType,
}

fn fault(accessor: &Accessor<'_>, message: &str) -> Fault {
    Fault::new(format!("{message}: the file is broken, export it again"))
        .at(Place::Item("accessor", accessor.index() as u64))
}

const fn width(kind: DataType) -> usize {
    match kind {
        DataType::I8 | DataType::U8 => 1,
        DataType::I16 | DataType::U16 => 2,
        DataType::U32 | DataType::F32 => 4,
    }
}

impl<'a> Entries<'a> {
    /// `None` when they reach beyond the view or the buffer.
    fn new(
        buffers: &'a Buffers,
        view: &gltf::buffer::View<'_>,
        offset: usize,
        (kind, components, count): (DataType, usize, usize),
    ) -> Option<Self> {
        let buffer = buffers.get(view.buffer().index())?;
        let end = view.offset().checked_add(view.length())?;
        let bytes = buffer.get(view.offset()..end)?.get(offset..)?;
        let size = width(kind) * components;
        let stride = view.stride().unwrap_or(size);
        let needed = match count {
            0 => 0,
            _ => stride.checked_mul(count - 1)?.checked_add(size)?,
        };
        // A stride below the entry's size would make entries overlap, and many of them out of few bytes.
        (stride >= size && needed <= bytes.len()).then_some(Self { bytes, stride, count, kind })
    }

    /// One component: the number itself, or for `normalized` integers the fraction that they stand for.
    fn float(&self, entry: usize, component: usize, normalized: bool) -> f32 {
        let at = entry * self.stride + component * width(self.kind);
        let b = &self.bytes[at..];
        let scale = |value: f32, most: f32| if normalized { (value / most).max(-1.0) } else { value };
        match self.kind {
            DataType::I8 => scale(f32::from(b[0].cast_signed()), 127.0),
            DataType::U8 => scale(f32::from(b[0]), 255.0),
            DataType::I16 => scale(f32::from(i16::from_le_bytes([b[0], b[1]])), 32767.0),
            DataType::U16 => scale(f32::from(u16::from_le_bytes([b[0], b[1]])), 65535.0),
            DataType::U32 => u32::from_le_bytes([b[0], b[1], b[2], b[3]]) as f32,
            DataType::F32 => f32::from_le_bytes([b[0], b[1], b[2], b[3]]),
        }
    }

    fn index(&self, entry: usize) -> Option<u32> {
        let b = &self.bytes[entry * self.stride..];
        match self.kind {
            DataType::U8 => Some(u32::from(b[0])),
            DataType::U16 => Some(u32::from(u16::from_le_bytes([b[0], b[1]]))),
            DataType::U32 => Some(u32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            _ => None,
        }
    }
}

const BEYOND: &str = "it reaches beyond its buffer";

/// The accessor's own entries; `None` for a sparse one without any, whose entries are zeros.
fn dense<'a>(accessor: &Accessor<'_>, buffers: &'a Buffers) -> Parsed<Option<Entries<'a>>> {
    let shape = (accessor.data_type(), accessor.dimensions().multiplicity(), accessor.count());
    match accessor.view() {
        Some(view) => Entries::new(buffers, &view, accessor.offset(), shape)
            .map(Some)
            .ok_or_else(|| fault(accessor, BEYOND)),
        // Zeros cost no bytes in the file: allow as many as all buffers could hold.
        None if accessor.count() > buffers.iter().map(Vec::len).sum::<usize>() => {
            Err(fault(accessor, "it has more entries than the buffers have bytes"))
        }
        None => Ok(None),
    }
}

/// Calls `put` with entry number, replacement entries and the number in them, for each sparse replacement.
fn sparse(
    accessor: &Accessor<'_>,
    buffers: &Buffers,
    mut put: impl FnMut(usize, &Entries<'_>, usize) -> Parsed<()>,
) -> Parsed<()> {
    let Some(sparse) = accessor.sparse() else { return Ok(()) };
    let (indices, values, count) = (sparse.indices(), sparse.values(), sparse.count());
    let kind = match indices.index_type() {
        gltf::accessor::sparse::IndexType::U8 => DataType::U8,
        gltf::accessor::sparse::IndexType::U16 => DataType::U16,
        gltf::accessor::sparse::IndexType::U32 => DataType::U32,
    };
    let shape = (accessor.data_type(), accessor.dimensions().multiplicity(), count);
    let places = Entries::new(buffers, &indices.view(), indices.offset(), (kind, 1, count));
    let values = Entries::new(buffers, &values.view(), values.offset(), shape);
    let (Some(places), Some(values)) = (places, values) else { return Err(fault(accessor, BEYOND)) };
    for number in 0..places.count {
        let entry = places.index(number).unwrap_or(u32::MAX) as usize;
        if entry >= accessor.count() {
            return Err(fault(accessor, "a sparse index names an entry that is not there"));
        }
        put(entry, &values, number)?;
    }
    Ok(())
}

/// The entries as vectors of `N` components; further ones, such as alpha, are dropped.
pub(super) fn vectors<const N: usize>(accessor: &Accessor<'_>, buffers: &Buffers) -> Parsed<Vec<[f32; N]>> {
    let components = accessor.dimensions().multiplicity();
    if components < N {
        return Err(fault(accessor, "its entries have too few components"));
    }
    let normalized = accessor.normalized();
    let vector = |entries: &Entries<'_>, entry: usize| {
        let mut vector = [0.0; N];
        for (component, slot) in vector.iter_mut().enumerate() {
            *slot = entries.float(entry, component, normalized);
        }
        vector
    };
    let mut vectors: Vec<[f32; N]> = match dense(accessor, buffers)? {
        Some(entries) => (0..entries.count).map(|entry| vector(&entries, entry)).collect(),
        None => vec![[0.0; N]; accessor.count()],
    };
    sparse(accessor, buffers, |entry, values, number| {
        vectors[entry] = vector(values, number);
        Ok(())
    })?;
    Ok(vectors)
}

/// The entries as indices.
pub(super) fn indices(accessor: &Accessor<'_>, buffers: &Buffers) -> Parsed<Vec<u32>> {
    let wrong = || fault(accessor, "indices must be unsigned integers");
    let mut indices: Vec<u32> = match dense(accessor, buffers)? {
        Some(entries) => {
            (0..entries.count).map(|entry| entries.index(entry).ok_or_else(wrong)).collect::<Parsed<_>>()?
        }
        None => vec![0; accessor.count()],
    };
    sparse(accessor, buffers, |entry, values, number| {
        indices[entry] = values.index(number).ok_or_else(wrong)?;
        Ok(())
    })?;
    Ok(indices)
}
