//! MTL: the diffuse colours of OBJ's materials.

use std::collections::HashMap;

use super::super::draft::code;
use super::super::error::quote;
use super::super::text::Lines;
use super::super::words::{Words, float};
use super::library::MOST_NOTES;
use crate::Color;

/// Materials by name. `None`: one without a diffuse colour.
pub(super) type Materials = HashMap<Vec<u8>, Option<Color>>;

/// Adds the materials of an MTL file called `file`; true when one of them has a texture. `Kd` is taken as
/// sRGB-encoded, as the programs that write it do; what cannot be understood is passed over with a note, for a
/// colour is no reason to refuse a model. The first definition of a name counts.
pub(super) fn read(bytes: &[u8], file: &str, materials: &mut Materials, notes: &mut Vec<String>) -> bool {
    let mut textures = false;
    let mut current: Option<Vec<u8>> = None;
    for (number, line) in Lines::new(bytes) {
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
                let mut note = |what: &str| {
                    if notes.len() < MOST_NOTES {
                        notes.push(format!(
                            "{file}: line {number}: `{}` {what}",
                            quote(line.trim_ascii(), 60)
                        ));
                    }
                };
                let Some([r, g, b]) = rgb(words) else {
                    note("is not a colour that can be shown; passed over");
                    continue;
                };
                if [r, g, b].iter().any(|&value| !is_code(value)) {
                    note("is not between 0 and 1; drawn as the nearest colour that is");
                }
                *material = Some(Color::new(code(r), code(g), code(b)));
            }
            Some(word) => textures |= word.eq_ignore_ascii_case(b"map_Kd"),
            None => {}
        }
    }
    textures
}

/// Three numbers, or one, which is grey. `Kd spectral` and `Kd xyz` have none here.
fn rgb(mut words: Words<'_>) -> Option<[f32; 3]> {
    let r = float(words.next()?)?;
    let mut next = || words.next().map_or(Some(r), float);
    Some([r, next()?, next()?])
}

/// Whether a value is one of the 256 codes once it is rounded: what exporters write a little above 1 is meant to
/// be 1.
fn is_code(value: f32) -> bool {
    (0.0..=255.0).contains(&(f64::from(value) * 255.0).round())
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
        assert!(read(text, "m.mtl", &mut materials, &mut Vec::new()));
        assert_eq!(materials[&b"a b"[..]], Some(Color::new(204, 128, 255)));
        assert_eq!(materials[&b"grey"[..]], Some(Color::new(64, 64, 64)));
        assert_eq!(materials[&b"none"[..]], None);
    }

    #[test]
    fn what_is_no_color_is_noted_with_file_and_line() {
        for (statement, what) in [
            ("Kd 2 -1 nan", Some("m.mtl: line 2: `Kd 2 -1 nan` is not between 0 and 1")),
            ("Kd 0 inf 0", Some("is not between 0 and 1")),
            ("Kd red", Some("line 2: `Kd red` is not a colour")),
            ("Kd 1 x 0", Some("is not a colour")),
            ("Kd", Some("is not a colour")),
            ("Kd 1.000001 -0.0000001 0", None),
            ("Kd 0.5", None),
        ] {
            let mut notes = Vec::new();
            read(format!("newmtl a\n{statement}\n").as_bytes(), "m.mtl", &mut Materials::new(), &mut notes);
            match what {
                Some(what) => assert!(notes.len() == 1 && notes[0].contains(what), "{statement}: {notes:?}"),
                None => assert!(notes.is_empty(), "{statement}: {notes:?}"),
            }
        }
    }
}
