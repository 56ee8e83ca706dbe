//! The bytes behind a glTF file: the binary chunk, `data:` URIs, files beside it.

use std::path::Path;

use base64::Engine as _;
use base64::alphabet;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};

use super::super::error::{Fault, Parsed, Place, quote};
use super::super::side;

/// Exporters leave the padding out now and then.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &alphabet::STANDARD,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

/// All buffers, each at least as long as it says.
pub(super) fn load(
    document: &gltf::Document,
    mut chunk: Option<Vec<u8>>,
    folder: Option<&Path>,
) -> Parsed<Vec<Vec<u8>>> {
    let mut buffers = Vec::with_capacity(document.buffers().len());
    for buffer in document.buffers() {
        let place = Place::Item("buffer", buffer.index() as u64);
        let bytes = match buffer.source() {
            gltf::buffer::Source::Bin => chunk
                .take()
                .ok_or_else(|| Fault::new("it has neither a URI nor a binary chunk: export the model again")),
            gltf::buffer::Source::Uri(uri) => from_uri(uri, folder),
        }
        .map_err(|fault| fault.at(place))?;
        if bytes.len() < buffer.length() {
            let (there, said) = (bytes.len(), buffer.length());
            return Err(Fault::new(format!(
                "it should have {said} bytes and has {there}: it is cut off; copy or export it again"
            ))
            .at(place));
        }
        buffers.push(bytes);
    }
    Ok(buffers)
}

fn from_uri(uri: &str, folder: Option<&Path>) -> Parsed<Vec<u8>> {
    if let Some(data) = uri.strip_prefix("data:") {
        let Some((_, encoded)) = data.split_once(";base64,") else {
            return Err(Fault::new("its data: URI is not base64: export the model again"));
        };
        return BASE64.decode(encoded).map_err(|error| {
            Fault::new(format!("its data: URI is broken ({error}): export the model again"))
        });
    }
    if uri.contains("://") {
        let uri = quote(uri.as_bytes(), 100);
        return Err(Fault::new(format!("`{uri}` is not beside the model: download it and export a .glb")));
    }
    let name = percent_encoding::percent_decode_str(uri).decode_utf8_lossy();
    side::read(folder, &name)
}
