//! MTL: the diffuse colours of OBJ's materials.

use std::collections::HashMap;

use super::super::draft::code;
use super::super::text::Lines;
use super::super::words::{Words, float};
use crate::Color;

/// Materials by name. `None`: one without a diffuse colour.
pub(super) type Materials = HashMap<Vec<u8>, Option<Color>>;

/// Adds the materials of an MTL file; true when one of them has a texture. `Kd` is taken as sRGB-encoded, as
/// the programs that write it do; what cannot be understood is passed over, for a colour is no reason to refuse
/// a model. The first definition of a name counts.
pub(super) fn read(bytes: &[u8], materials: &mut Materials) -> bool {
    let mut textures = false;
    let mut current: Option<Vec<u8>> = None;
    for (_, line) in Lines::new(bytes) {
        let mut words = Words::new(line);
        match words.next() {
            Some(b"newmtl") => {
                let name = words.rest().to_vec();
                // A name that is there already keeps its first colour.
                current = (!materials.contains_key(&name)).then_some(name);
                if let Some(name) = &current {
                    materials.insert(name.clone(), None);
                }
            }
            Some(b"Kd") => {
                let Some(material) = current.as_ref().and_then(|name| materials.get_mut(name)) else {
                    continue;
                };
                // `Kd r` alone is grey; `Kd spectral` and `Kd xyz` are not colours that can be shown.
                let Some(r) = words.next().and_then(float) else { continue };
                let (g, b) = (words.next().and_then(float), words.next().and_then(float));
                *material = Some(Color::new(code(r), code(g.unwrap_or(r)), code(b.unwrap_or(r))));
            }
            Some(word) => textures |= word.eq_ignore_ascii_case(b"map_Kd"),
            None => {}
        }
    }
    textures
}

#[cfg(test)]
mod tests {
    use super::{Materials, read};
    use crate::Color;

    #[test]
    fn kd_is_taken_as_srgb_and_rounded() {
        let mut materials = Materials::new();
        let text =
            b"newmtl a b\nKd 0.8 0.5 2\nnewmtl grey\n Kd .25\nnewmtl none\nKd spectral x.rfl\nmap_Kd x.png\n\
            newmtl grey\nKd 1 1 1\n";
        assert!(read(text, &mut materials));
        assert_eq!(materials[&b"a b"[..]], Some(Color::new(204, 128, 255)));
        assert_eq!(materials[&b"grey"[..]], Some(Color::new(64, 64, 64)));
        assert_eq!(materials[&b"none"[..]], None);
    }
}
