//! What a file is: by its content first, by what the caller says and by its name only where that says nothing.

use std::path::Path;

use super::Format;
use super::error::{Fault, Parsed, quote};

/// A format, and a note when the name or the caller said something else.
#[derive(Debug)]
pub(super) struct Detected {
    pub(super) format: Format,
    pub(super) note: Option<String>,
}

/// How much of a file's beginning is looked at.
const HEAD: usize = 4096;

pub(super) fn detect(bytes: &[u8], name: &str, said: Option<Format>) -> Parsed<Detected> {
    if bytes.is_empty() {
        return Err(Fault::new("the file is empty: export the model again"));
    }
    let extension = extension(name);
    let by_name = by_extension(&extension);
    match by_content(bytes) {
        Some(Known::Read(format)) => {
            let expected = said.map(Known::Read).or(by_name);
            let note = match expected {
                Some(Known::Read(other)) if other != format => {
                    Some(format!("the content is {format}, not {other}: read as {format}"))
                }
                Some(Known::Refused(other, _)) => {
                    Some(format!("the content is {format}, not {other}: read as {format}"))
                }
                _ => None,
            };
            Ok(Detected { format, note })
        }
        Some(Known::Refused(what, advice)) => Err(refused(what, advice)),
        None => match (said, by_name) {
            (Some(format), _) | (None, Some(Known::Read(format))) => {
                mislabelled(bytes, format)?;
                Ok(Detected { format, note: None })
            }
            (None, Some(Known::Refused(what, advice))) => Err(refused(what, advice)),
            (None, None) => Err(Fault::new(format!(
                "neither the content nor the extension `{}` is that of a known format: give OBJ, STL, PLY or glTF",
                quote(extension.as_bytes(), 20)
            ))),
        },
    }
}

/// A format's name as a user would say it.
enum Known {
    Read(Format),
    /// Name and advice.
    Refused(&'static str, &'static str),
}

fn refused(what: &str, advice: &str) -> Fault {
    Fault::new(format!("{what} is not read: {advice}"))
}

/// A file that its name calls `format`, while its content shows no sign of that: refused when it cannot be.
fn mislabelled(bytes: &[u8], format: Format) -> Parsed<()> {
    let says = match format {
        Format::Ply => "a PLY file begins with the line `ply`",
        Format::Gltf => "a glTF file begins with `glTF` or `{`",
        Format::Obj if bytes[..bytes.len().min(HEAD)].contains(&0) => {
            "an OBJ file is a text, and this is not"
        }
        Format::Obj | Format::Stl => return Ok(()),
    };
    Err(Fault::new(format!("this is no {format} file ({says}): name it by what it is or export it again")))
}

const EXPORT: &str = "export the model as OBJ, STL, PLY or glTF";
const CAD: &str = "it holds curved surfaces; mesh it with a CAD program such as FreeCAD and export STL";
const BLENDER: &str = "open it in a modeller such as Blender and export glTF";
const SLICER: &str = "export the model as STL from the slicer or modeller";
const PACKED: &str = "unpack it first";
const USD: &str = "convert it to glTF, with Blender for example";

/// What the first bytes say. Only what no other format can begin with is decided here.
fn by_content(bytes: &[u8]) -> Option<Known> {
    let head = &bytes[..bytes.len().min(HEAD)];
    let has = |what: &[u8]| head.windows(what.len()).any(|window| window == what);
    // Before everything: binary STL, whose 80 bytes of header may say anything, `solid` and `ply` included.
    if stl_length(bytes) == Some(bytes.len() as u64) {
        return Some(Known::Read(Format::Stl));
    }
    if let Some(known) = by_signature(head) {
        return Some(known);
    }
    let text = text_start(head);
    let starts =
        |what: &str| text.len() >= what.len() && text[..what.len()].eq_ignore_ascii_case(what.as_bytes());
    if text.contains(&0) {
        return None;
    }
    if starts("{") && has(b"\"asset\"") || starts("{") && has(b"\"meshes\"") {
        return Some(Known::Read(Format::Gltf));
    }
    if starts("solid") && (has(b"facet") || has(b"endsolid") || has(b"FACET")) || starts("facet normal") {
        return Some(Known::Read(Format::Stl));
    }
    if starts("<") {
        return Some(if has(b"<COLLADA") {
            Known::Refused("COLLADA (DAE)", BLENDER)
        } else if has(b"<X3D") {
            Known::Refused("X3D", BLENDER)
        } else if has(b"<VTKFile") {
            Known::Refused("VTK", EXPORT)
        } else if has(b"<amf") {
            Known::Refused("AMF", SLICER)
        } else if has(b"<svg") {
            Known::Refused("SVG, a drawing,", EXPORT)
        } else {
            Known::Refused("this XML file", EXPORT)
        });
    }
    looks_like_obj(text).then_some(Known::Read(Format::Obj))
}

/// The text after a byte order mark and blanks.
fn text_start(head: &[u8]) -> &[u8] {
    without_mark(head).trim_ascii_start()
}

/// A text without the byte order mark that some editors put in front.
pub(super) fn without_mark(text: &[u8]) -> &[u8] {
    text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text)
}

fn by_signature(head: &[u8]) -> Option<Known> {
    let has = |what: &[u8]| head.windows(what.len()).any(|window| window == what);
    let signatures: [(&[u8], Known); 31] = [
        (b"ply\n", Known::Read(Format::Ply)),
        (b"ply\r", Known::Read(Format::Ply)),
        (b"glTF", Known::Read(Format::Gltf)),
        (b"ISO-10303-21", Known::Refused("STEP", CAD)),
        (b"Kaydara FBX Binary", Known::Refused("FBX", BLENDER)),
        (b"; FBX", Known::Refused("FBX", BLENDER)),
        (b"PXR-USDC", Known::Refused("USD", USD)),
        (b"#usda", Known::Refused("USD", USD)),
        (b"MM\0*", Known::Refused("a TIFF picture", EXPORT)),
        (b"OFF\n", Known::Refused("OFF", EXPORT)),
        (b"OFF\r", Known::Refused("OFF", EXPORT)),
        (b"COFF", Known::Refused("OFF", EXPORT)),
        (b"NOFF", Known::Refused("OFF", EXPORT)),
        (b"# vtk DataFile", Known::Refused("VTK", EXPORT)),
        (b"#VRML", Known::Refused("VRML", BLENDER)),
        (b"#Inventor", Known::Refused("Open Inventor", BLENDER)),
        (b"BLENDER", Known::Refused("a Blender file", "export glTF from Blender")),
        (b"DRACO", Known::Refused("Draco", "decompress it to PLY or OBJ with draco_decoder")),
        (b"xof ", Known::Refused("DirectX X", BLENDER)),
        (b"FORM", Known::Refused("LightWave (LWO)", BLENDER)),
        (b"DBRep_DrawableShape", Known::Refused("Open CASCADE BREP", CAD)),
        (b"3D Geometry File Format", Known::Refused("Rhino 3DM", CAD)),
        (b"\x1f\x8b", Known::Refused("a gzip archive", PACKED)),
        (b"\x28\xb5\x2f\xfd", Known::Refused("a Zstandard archive", PACKED)),
        (b"\xfd7zXZ\0", Known::Refused("an xz archive", PACKED)),
        (b"BZh", Known::Refused("a bzip2 archive", PACKED)),
        (b"7z\xbc\xaf", Known::Refused("a 7-Zip archive", PACKED)),
        (b"\x89PNG", Known::Refused("a PNG picture", EXPORT)),
        (b"\xff\xd8\xff", Known::Refused("a JPEG picture", EXPORT)),
        (b"GIF8", Known::Refused("a GIF picture", EXPORT)),
        (b"%PDF", Known::Refused("PDF", EXPORT)),
    ];
    if head.starts_with(b"PK\x03\x04") {
        return Some(if has(b"3D/") || has(b"3dmodel") {
            Known::Refused("3MF", SLICER)
        } else if has(b".usd") {
            Known::Refused("USD", USD)
        } else {
            Known::Refused("a ZIP archive (3MF, USDZ, …)", "unpack it, or export the model as STL or glTF")
        });
    }
    // 3DS: the main chunk's tag, then its length, which is the file's; the next tag is one of two.
    if head.starts_with(b"MM") && head.len() > 8 && matches!(head[6..8], [2, 0] | [0x3d, 0x3d]) {
        return Some(Known::Refused("3DS", BLENDER));
    }
    if head.starts_with(&[0xff, 0xfe]) || head.starts_with(&[0xfe, 0xff]) {
        return Some(Known::Refused("a text in UTF-16", "save it as UTF-8"));
    }
    signatures.into_iter().find(|(signature, _)| head.starts_with(signature)).map(|(_, known)| known)
}

/// The length that a binary STL file with this header has; `None` when there is no room for a header.
pub(super) fn stl_length(bytes: &[u8]) -> Option<u64> {
    let count = bytes.get(80..84)?;
    Some(84 + 50 * u64::from(u32::from_le_bytes([count[0], count[1], count[2], count[3]])))
}

/// Whether the first statements are those of OBJ, comments left out.
fn looks_like_obj(text: &[u8]) -> bool {
    text.split(|&byte| byte == b'\n' || byte == b'\r')
        .map(<[u8]>::trim_ascii)
        .filter(|line| !line.is_empty() && !line.starts_with(b"#"))
        .take(1)
        .all(|line| {
            let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
            let number = |word: Option<&[u8]>| {
                word.is_some_and(|word| matches!(word[0], b'0'..=b'9' | b'-' | b'+' | b'.'))
            };
            match words.next() {
                Some(b"v" | b"vt" | b"vn" | b"vp" | b"f" | b"l" | b"p") => number(words.next()),
                Some(b"o" | b"g" | b"s" | b"mtllib" | b"usemtl") => true,
                _ => false,
            }
        })
        && text.iter().any(|byte| !byte.is_ascii_whitespace())
}

fn by_extension(extension: &str) -> Option<Known> {
    Some(match extension {
        "obj" => Known::Read(Format::Obj),
        "stl" => Known::Read(Format::Stl),
        "ply" => Known::Read(Format::Ply),
        "gltf" | "glb" => Known::Read(Format::Gltf),
        "3mf" => Known::Refused("3MF", SLICER),
        "amf" => Known::Refused("AMF", SLICER),
        "step" | "stp" => Known::Refused("STEP", CAD),
        "iges" | "igs" => Known::Refused("IGES", CAD),
        "brep" => Known::Refused("Open CASCADE BREP", CAD),
        "3dm" => Known::Refused("Rhino 3DM", CAD),
        "fbx" => Known::Refused("FBX", BLENDER),
        "usd" | "usda" | "usdc" | "usdz" => Known::Refused("USD", USD),
        "3ds" => Known::Refused("3DS", BLENDER),
        "dae" => Known::Refused("COLLADA (DAE)", BLENDER),
        "blend" => Known::Refused("a Blender file", "export glTF from Blender"),
        "lwo" => Known::Refused("LightWave (LWO)", BLENDER),
        "x3d" => Known::Refused("X3D", BLENDER),
        "wrl" | "vrml" => Known::Refused("VRML", BLENDER),
        "x" => Known::Refused("DirectX X", BLENDER),
        "off" => Known::Refused("OFF", EXPORT),
        "vtk" | "vtp" | "vtu" => Known::Refused("VTK", EXPORT),
        "drc" => Known::Refused("Draco", "decompress it to PLY or OBJ with draco_decoder"),
        "mtl" => Known::Refused("MTL, the materials of an OBJ file,", "name the OBJ file"),
        "dxf" | "dwg" => Known::Refused("AutoCAD (DXF, DWG)", CAD),
        "pts" | "xyz" | "las" | "laz" | "pcd" => {
            Known::Refused("a point cloud", "mesh it first and export PLY")
        }
        _ => return None,
    })
}

fn extension(name: &str) -> String {
    Path::new(name).extension().map(|e| e.to_string_lossy().to_ascii_lowercase()).unwrap_or_default()
}

/// A file's name without folders and extension: what a part without a name of its own is called.
pub(super) fn stem(name: &str) -> String {
    let stem = Path::new(name).file_stem().map(|stem| stem.to_string_lossy().into_owned());
    stem.filter(|stem| !stem.is_empty() && stem != "-").unwrap_or_else(|| "model".to_owned())
}

#[cfg(test)]
mod tests {
    use super::{Format, detect};

    fn format(bytes: &[u8], name: &str) -> Format {
        detect(bytes, name, None).unwrap().format
    }

    fn refusal(bytes: &[u8], name: &str) -> String {
        let fault = detect(bytes, name, None).unwrap_err();
        crate::import::ImportError::new(name, fault).to_string()
    }

    #[test]
    fn the_content_decides_and_a_wrong_name_is_noted() {
        assert_eq!(format(b"# by hand\n\nv 0 0 0\n", "a.stl"), Format::Obj);
        assert_eq!(format(b"ply\nformat ascii 1.0\n", "a"), Format::Ply);
        assert_eq!(format(b"solid x\n facet normal 0 0 1\n", "-"), Format::Stl);
        assert_eq!(format(b" {\"asset\":{}}", "-"), Format::Gltf);
        let mut binary = vec![0; 84];
        binary[..9].copy_from_slice(b"solid ply");
        assert_eq!(format(&binary, "a.obj"), Format::Stl, "a binary header may say anything");
        let detected = detect(b"v 0 0 0\n", "a.ply", None).unwrap();
        assert!(detected.note.unwrap().contains("OBJ, not PLY"));
        assert!(detect(b"v 0 0 0\n", "a.ply", Some(Format::Obj)).unwrap().note.is_none());
    }

    #[test]
    fn known_formats_are_refused_by_name_with_advice() {
        for (bytes, name, what) in [
            (&b"PK\x03\x04......3D/3dmodel.model"[..], "a.obj", "3MF"),
            (b"?", "part.3mf", "3MF"),
            (b"ISO-10303-21;", "a", "STEP"),
            (b"Kaydara FBX Binary  \0", "a.fbx", "FBX"),
            (b"; FBX 7.3", "a.fbx", "FBX"),
            (b"#usda 1.0", "a.usd", "USD"),
            (b"MM\x20\0\0\0\x3d\x3d\0\0", "a.3ds", "3DS"),
            (b"<?xml version='1.0'?><COLLADA>", "a.dae", "COLLADA"),
            (b"OFF\n3 1 0\n", "a.off", "OFF"),
            (b"# vtk DataFile Version 3.0", "a.vtk", "VTK"),
            (b"\x89PNG\r\n", "a.stl", "PNG"),
            (b"\x1f\x8b\x08", "a.obj.gz", "gzip"),
            (b"\xff\xfev\0", "a.obj", "UTF-16"),
        ] {
            let line = refusal(bytes, name);
            assert!(line.contains(what) && line.contains("is not read: "), "{line}");
            assert!(!line.contains('\n'));
        }
    }

    #[test]
    fn an_unknown_file_is_told_what_would_be_read() {
        assert!(refusal(b"hello", "a.txt").contains("give OBJ, STL, PLY or glTF"));
        assert!(refusal(b"", "a.obj").contains("empty"));
        assert!(refusal(b"hello", "a.ply").contains("begins with the line `ply`"));
        assert!(refusal(b"\0\x01\x02", "a.obj").contains("is a text"));
    }
}
