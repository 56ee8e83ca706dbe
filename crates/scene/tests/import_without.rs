//! A build without an importer refuses its format and names the feature.

#[cfg(not(feature = "obj"))]
#[test]
fn a_build_without_obj_names_the_feature() {
    let error = polosa_scene::import::read(b"v 0 0 0\n", "a.obj", None, None).unwrap_err();
    assert!(
        error.to_string().contains("does not read OBJ: build polosa-scene with its feature `obj`"),
        "{error}"
    );
}

#[cfg(not(feature = "gltf"))]
#[test]
fn a_build_without_gltf_names_the_feature() {
    let error = polosa_scene::import::read(b"glTF", "a.glb", None, None).unwrap_err();
    assert!(error.to_string().contains("feature `gltf`"), "{error}");
}
