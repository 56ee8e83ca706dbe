//! One entry of a PLY element, as the library fills it in.

use ply_rs_bw::ply::{BeginList, Property, PropertyAccess, PropertyAccessResult};

use super::super::draft::code;
use super::super::error::{Fault, Parsed};
use crate::Color;

/// A vertex, a face, or anything else: what the properties' names ask for.
#[derive(Debug)]
pub(super) struct Element {
    pub(super) position: [f32; 3],
    pub(super) normal: Option<[f32; 3]>,
    pub(super) uv: Option<[f32; 2]>,
    color: [Option<u8>; 3],
    list: List,
}

/// The corners of a face, in the types that files use; others are converted.
#[derive(Debug)]
enum List {
    None,
    Signed(Vec<i32>),
    Unsigned(Vec<u32>),
    /// A list of numbers that cannot be indices.
    Unusable,
}

impl Element {
    /// The colour, when all three channels were there.
    pub(super) fn color(&self) -> Option<Color> {
        let [Some(r), Some(g), Some(b)] = self.color else { return None };
        Some(Color::new(r, g, b))
    }

    /// The indices; a negative one as the error that it usually is.
    pub(super) fn indices(&self) -> Parsed<impl ExactSizeIterator<Item = Result<u32, i64>>> {
        let (signed, unsigned): (&[i32], &[u32]) = match &self.list {
            List::None => (&[], &[]),
            List::Signed(list) => (list, &[]),
            List::Unsigned(list) => (&[], list),
            List::Unusable => return Err(Fault::new("the vertex indices of the faces are not integers")),
        };
        let length = signed.len() + unsigned.len();
        Ok((0..length).map(move |at| match signed.get(at) {
            Some(&index) => u32::try_from(index).map_err(|_| i64::from(index)),
            None => Ok(unsigned[at]),
        }))
    }

    fn channel(&mut self, name: &str) -> Option<&mut Option<u8>> {
        let channel = match name.strip_prefix("diffuse_").unwrap_or(name) {
            "red" | "r" => 0,
            "green" | "g" => 1,
            "blue" | "b" => 2,
            _ => return None,
        };
        Some(&mut self.color[channel])
    }

    fn number(&mut self, name: &str, value: f32) {
        match name {
            "x" => self.position[0] = value,
            "y" => self.position[1] = value,
            "z" => self.position[2] = value,
            "nx" => self.normal.get_or_insert_default()[0] = value,
            "ny" => self.normal.get_or_insert_default()[1] = value,
            "nz" => self.normal.get_or_insert_default()[2] = value,
            "s" | "u" | "texture_u" => self.uv.get_or_insert_default()[0] = value,
            // From the picture's bottom edge up in PLY, from its top edge down in a mesh.
            "t" | "v" | "texture_v" => self.uv.get_or_insert_default()[1] = 1.0 - value,
            _ => {}
        }
    }
}

fn is_indices(name: &str) -> bool {
    matches!(name, "vertex_indices" | "vertex_index")
}

impl PropertyAccess for Element {
    fn new() -> Self {
        Self { position: [0.0; 3], normal: None, uv: None, color: [None; 3], list: List::None }
    }

    fn set_float(&mut self, name: &str, value: f32) -> PropertyAccessResult {
        match self.channel(name) {
            Some(channel) => *channel = Some(code(value)),
            None => self.number(name, value),
        }
        PropertyAccessResult::Set
    }

    fn set_uchar(&mut self, name: &str, value: u8) -> PropertyAccessResult {
        match self.channel(name) {
            Some(channel) => *channel = Some(value),
            None => self.number(name, f32::from(value)),
        }
        PropertyAccessResult::Set
    }

    fn begin_list_int(&mut self, name: &str, _len: usize) -> BeginList<'_, i32> {
        if !is_indices(name) {
            return BeginList::UseSetter;
        }
        self.list = List::Signed(Vec::new());
        match &mut self.list {
            List::Signed(list) => BeginList::Fill(list),
            _ => BeginList::UseSetter,
        }
    }

    fn begin_list_uint(&mut self, name: &str, _len: usize) -> BeginList<'_, u32> {
        if !is_indices(name) {
            return BeginList::UseSetter;
        }
        self.list = List::Unsigned(Vec::new());
        match &mut self.list {
            List::Unsigned(list) => BeginList::Fill(list),
            _ => BeginList::UseSetter,
        }
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let value = match property {
            Property::Char(value) => f32::from(value),
            Property::UChar(value) => f32::from(value),
            Property::Short(value) => f32::from(value),
            Property::UShort(value) => {
                if let Some(channel) = self.channel(name) {
                    *channel = Some(code(f32::from(value) / 65535.0));
                }
                f32::from(value)
            }
            Property::Int(value) => value as f32,
            Property::UInt(value) => value as f32,
            Property::Float(value) => value,
            Property::Double(value) => {
                if let Some(channel) = self.channel(name) {
                    *channel = Some(code(value as f32));
                }
                value as f32
            }
            list if is_indices(name) => {
                self.list = match list {
                    Property::ListChar(list) => List::Signed(list.into_iter().map(i32::from).collect()),
                    Property::ListUChar(list) => List::Unsigned(list.into_iter().map(u32::from).collect()),
                    Property::ListShort(list) => List::Signed(list.into_iter().map(i32::from).collect()),
                    Property::ListUShort(list) => List::Unsigned(list.into_iter().map(u32::from).collect()),
                    Property::ListInt(list) => List::Signed(list),
                    Property::ListUInt(list) => List::Unsigned(list),
                    _ => List::Unusable,
                };
                return PropertyAccessResult::Set;
            }
            _ => return PropertyAccessResult::Ignored,
        };
        self.number(name, value);
        PropertyAccessResult::Set
    }
}
