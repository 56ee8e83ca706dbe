//! The world: meshes stored once, objects that show them, handles that stay valid.
//!
//! ```text
//!   MeshKey ──▶ mesh ◀─── MeshKey of an object      a thousand objects may show one mesh
//!                              │
//!   ObjectKey ──▶ object: mesh, placement, colour, how it is shown
//! ```
//!
//! Handles are small numbers that can be copied and kept. A handle whose mesh or object was removed names nothing,
//! for ever, also when its place is used again: asking for it gives `None` or an error, never another object.
//!
//! Objects are drawn in the order in which they were added, whatever is removed in between. This decides which of
//! two surfaces at the same depth is seen, so it is explicit: each object has a number that only grows.

use std::collections::BTreeMap;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};

use polosa_math::glam::{DMat4, DQuat, DVec3};
use polosa_math::{Bounds, Placement};
use slotmap::{SlotMap, new_key_type};

use crate::occluder::Occluders;
use crate::outline::Outline;
use crate::{Color, Mesh, Object, Show};

new_key_type! {
    /// The handle of a mesh in a [`World`].
    pub struct MeshKey;

    /// The handle of an object in a [`World`].
    pub struct ObjectKey;
}

/// Why the world refused something.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum WorldError {
    /// The handle's object was removed, or is of another world.
    #[error("there is no such object in the world: it was removed, or belongs to another world")]
    NoObject,
    /// The handle's mesh was removed, or is of another world.
    #[error("there is no such mesh in the world: it was removed, or belongs to another world")]
    NoMesh,
    /// The mesh cannot be removed while objects show it.
    #[error("the mesh is still shown by {objects} of the world's objects: remove them first")]
    MeshInUse {
        /// How many objects show it.
        objects: usize,
    },
}

/// A mesh with what is found out about it once.
#[derive(Clone, Debug)]
struct StoredMesh {
    mesh: Mesh,
    /// Around its finite positions.
    bounds: Bounds,
    outline: OnceLock<Outline>,
    occluders: OnceLock<Occluders>,
}

impl StoredMesh {
    fn new(mesh: Mesh) -> Self {
        let (bounds, _) = Bounds::from_points(mesh.positions().iter().copied());
        Self { mesh, bounds, outline: OnceLock::new(), occluders: OnceLock::new() }
    }
}

/// Meshes, and the objects that show them.
///
/// ```
/// use polosa_math::glam::DVec3;
/// use polosa_math::axis_angle;
/// use polosa_scene::{Color, Object, World, shape};
///
/// let mut world = World::new();
/// let cube = world.add_mesh(shape::cube());
/// let left = world.add(Object::new(cube).at(DVec3::new(-2.0, 0.0, 0.0)))?;
/// let right = world.add(Object::new(cube).at(DVec3::new(2.0, 0.0, 0.0)).colored(Color::WHITE))?;
///
/// world.move_by(left, DVec3::Y)?;
/// world.turn(right, axis_angle(DVec3::Y, 0.5).unwrap())?;
/// world.remove(left);
/// assert!(world.get(left).is_none());
/// assert_eq!(world.objects().count(), 1);
/// # Ok::<(), polosa_scene::WorldError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct World {
    meshes: SlotMap<MeshKey, StoredMesh>,
    /// An object's number in the order of drawing.
    numbers: SlotMap<ObjectKey, u64>,
    objects: BTreeMap<u64, (ObjectKey, Object)>,
    next: u64,
    revision: Revision,
}

/// What a world holds, in a number: two that are equal are of the same content, be it of two worlds. (The other way
/// round nothing follows.)
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Revision(u64);

impl Revision {
    /// One that nothing else has. A number for the whole program, so that a world that takes another's place is seen
    /// to be another one.
    fn new() -> Self {
        static LAST: AtomicU64 = AtomicU64::new(0);
        // Only that no number comes twice matters, not which threads see it when.
        Self(LAST.fetch_add(1, Ordering::Relaxed) + 1)
    }
}

/// Meshes.
impl World {
    /// A world without anything.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// What the world holds now: another one as soon as anything may have changed. Whoever keeps the revision of
    /// what was drawn knows when there is nothing to draw anew.
    #[must_use]
    pub const fn revision(&self) -> Revision {
        self.revision
    }

    /// Stores a mesh. It is not seen before an object shows it.
    pub fn add_mesh(&mut self, mesh: Mesh) -> MeshKey {
        self.revision = Revision::new();
        self.meshes.insert(StoredMesh::new(mesh))
    }

    /// A stored mesh.
    #[must_use]
    pub fn mesh(&self, key: MeshKey) -> Option<&Mesh> {
        self.meshes.get(key).map(|stored| &stored.mesh)
    }

    /// The box around a mesh's finite positions, in its own coordinates; found out once, when it was added.
    #[must_use]
    pub fn mesh_bounds(&self, key: MeshKey) -> Option<Bounds> {
        self.meshes.get(key).map(|stored| stored.bounds)
    }

    /// What drawing a mesh's edges needs; found out when it is first asked for.
    pub(crate) fn outline(&self, key: MeshKey) -> Option<&Outline> {
        self.meshes.get(key).map(|stored| stored.outline.get_or_init(|| Outline::of(&stored.mesh)))
    }

    /// Finds out now, for all meshes, what drawing their edges needs; else the first frame that shows them does, which
    /// then takes that much longer.
    pub fn prepare_edges(&self) {
        self.meshes.keys().for_each(|key| _ = self.outline(key));
    }

    /// The balls inside a mesh, behind which it hides itself; found out when they are first asked for, which takes
    /// about as long as drawing the mesh some tens of times. From then on
    /// [`Renderer::frame`](crate::Renderer::frame) leaves out what they hide, which changes no pixel.
    #[must_use]
    pub fn occluders(&self, key: MeshKey) -> Option<&Occluders> {
        self.meshes.get(key).map(|stored| stored.occluders.get_or_init(|| Occluders::of(&stored.mesh)))
    }

    /// The same, if somebody has asked for them before.
    pub(crate) fn known_occluders(&self, key: MeshKey) -> Option<&Occluders> {
        self.meshes.get(key)?.occluders.get()
    }

    /// All meshes, shown or not.
    pub fn meshes(&self) -> impl Iterator<Item = (MeshKey, &Mesh)> {
        self.meshes.iter().map(|(key, stored)| (key, &stored.mesh))
    }

    /// Puts another mesh in the place of one: all objects that showed the old one show the new one. The old one.
    ///
    /// # Errors
    ///
    /// [`WorldError::NoMesh`].
    pub fn replace_mesh(&mut self, key: MeshKey, mesh: Mesh) -> Result<Mesh, WorldError> {
        let stored = self.meshes.get_mut(key).ok_or(WorldError::NoMesh)?;
        self.revision = Revision::new();
        Ok(std::mem::replace(stored, StoredMesh::new(mesh)).mesh)
    }

    /// Takes a mesh out of the world that no object shows any more.
    ///
    /// # Errors
    ///
    /// [`WorldError::NoMesh`], and [`WorldError::MeshInUse`] while objects show it: they would lose their shape.
    pub fn remove_mesh(&mut self, key: MeshKey) -> Result<Mesh, WorldError> {
        let objects = self.objects.values().filter(|(_, object)| object.mesh == key).count();
        if objects > 0 {
            return Err(WorldError::MeshInUse { objects });
        }
        self.revision = Revision::new();
        self.meshes.remove(key).map(|stored| stored.mesh).ok_or(WorldError::NoMesh)
    }
}

/// Objects.
impl World {
    /// Adds an object; it is drawn after all that are there.
    ///
    /// # Errors
    ///
    /// [`WorldError::NoMesh`] when the object's mesh is not in this world.
    pub fn add(&mut self, object: Object) -> Result<ObjectKey, WorldError> {
        if !self.meshes.contains_key(object.mesh) {
            return Err(WorldError::NoMesh);
        }
        self.revision = Revision::new();
        let number = self.next;
        self.next += 1;
        let key = self.numbers.insert(number);
        self.objects.insert(number, (key, object));
        Ok(key)
    }

    /// Takes an object out of the world. Its mesh stays, for other objects to show.
    pub fn remove(&mut self, key: ObjectKey) -> Option<Object> {
        let number = self.numbers.remove(key)?;
        self.revision = Revision::new();
        self.objects.remove(&number).map(|(_, object)| object)
    }

    /// Takes out all objects and all meshes. Handles from before name nothing.
    pub fn clear(&mut self) {
        self.revision = Revision::new();
        self.objects.clear();
        self.numbers.clear();
        self.meshes.clear();
    }

    /// An object.
    #[must_use]
    pub fn get(&self, key: ObjectKey) -> Option<&Object> {
        self.objects.get(self.numbers.get(key)?).map(|(_, object)| object)
    }

    /// An object, to change.
    #[must_use]
    pub fn get_mut(&mut self, key: ObjectKey) -> Option<&mut Object> {
        let (_, object) = self.objects.get_mut(self.numbers.get(key)?)?;
        self.revision = Revision::new();
        Some(object)
    }

    /// All objects, visible or not, in the order of drawing: as they were added.
    pub fn objects(&self) -> impl DoubleEndedIterator<Item = (ObjectKey, &Object)> + ExactSizeIterator {
        self.objects.values().map(|(key, object)| (*key, object))
    }

    /// All objects in the order of drawing, to change.
    pub fn objects_mut(
        &mut self,
    ) -> impl DoubleEndedIterator<Item = (ObjectKey, &mut Object)> + ExactSizeIterator {
        self.revision = Revision::new();
        self.objects.values_mut().map(|(key, object)| (*key, object))
    }

    /// The object's number in the order of drawing: it stays the same, and later objects have larger ones.
    #[must_use]
    pub fn order(&self, key: ObjectKey) -> Option<u64> {
        self.numbers.get(key).copied()
    }

    /// An object, or the error that there is none.
    fn object(&mut self, key: ObjectKey) -> Result<&mut Object, WorldError> {
        self.get_mut(key).ok_or(WorldError::NoObject)
    }

    /// Shows another mesh at the object's place.
    ///
    /// # Errors
    ///
    /// [`WorldError::NoObject`], [`WorldError::NoMesh`].
    pub fn set_mesh(&mut self, key: ObjectKey, mesh: MeshKey) -> Result<(), WorldError> {
        if !self.meshes.contains_key(mesh) {
            return Err(WorldError::NoMesh);
        }
        self.object(key)?.mesh = mesh;
        Ok(())
    }

    /// Moves an object along the world's axes.
    ///
    /// # Errors
    ///
    /// [`WorldError::NoObject`].
    pub fn move_by(&mut self, key: ObjectKey, offset: DVec3) -> Result<(), WorldError> {
        let object = self.object(key)?;
        object.placement = object.placement.moved(offset);
        Ok(())
    }

    /// Moves an object so that the centre of its mesh's bounds comes to lie in a point of the world.
    ///
    /// # Errors
    ///
    /// [`WorldError::NoObject`].
    pub fn move_to(&mut self, key: ObjectKey, point: DVec3) -> Result<(), WorldError> {
        let center = self.center(key).ok_or(WorldError::NoObject)?;
        self.move_by(key, point - center)
    }

    /// Turns an object about its own centre, that of its mesh's bounds; the axis is the world's.
    ///
    /// # Errors
    ///
    /// [`WorldError::NoObject`].
    pub fn turn(&mut self, key: ObjectKey, by: DQuat) -> Result<(), WorldError> {
        let center = self.center(key).ok_or(WorldError::NoObject)?;
        self.turn_about(key, by, center)
    }

    /// Turns an object about any point of the world.
    ///
    /// # Errors
    ///
    /// [`WorldError::NoObject`].
    pub fn turn_about(&mut self, key: ObjectKey, by: DQuat, point: DVec3) -> Result<(), WorldError> {
        let object = self.object(key)?;
        object.placement = object.placement.turned_about(by, point);
        Ok(())
    }

    /// Scales an object along its own axes about its own centre, which stays where it is; negative factors mirror.
    ///
    /// # Errors
    ///
    /// [`WorldError::NoObject`].
    pub fn scale(&mut self, key: ObjectKey, factors: DVec3) -> Result<(), WorldError> {
        let center = self.center(key).ok_or(WorldError::NoObject)?;
        let object = self.object(key)?;
        object.placement = object.placement.scaled(factors);
        self.move_to(key, center)
    }

    /// Gives an object a colour, or with `None` takes it away.
    ///
    /// # Errors
    ///
    /// [`WorldError::NoObject`].
    pub fn recolor(&mut self, key: ObjectKey, color: Option<Color>) -> Result<(), WorldError> {
        self.object(key)?.color = color;
        Ok(())
    }

    /// Shows an object as wire, surface or both.
    ///
    /// # Errors
    ///
    /// [`WorldError::NoObject`].
    pub fn show(&mut self, key: ObjectKey, show: Show) -> Result<(), WorldError> {
        self.object(key)?.show = show;
        Ok(())
    }

    /// Where an object stands.
    #[must_use]
    pub fn placement(&self, key: ObjectKey) -> Option<Placement> {
        self.get(key).map(|object| object.placement)
    }

    /// Puts an object at a place, turn and scale included.
    ///
    /// # Errors
    ///
    /// [`WorldError::NoObject`].
    pub fn set_placement(&mut self, key: ObjectKey, placement: Placement) -> Result<(), WorldError> {
        self.object(key)?.placement = placement;
        Ok(())
    }
}

/// Geometry in the world's coordinates.
impl World {
    /// The centre of an object's mesh's bounds; for a mesh without finite positions the object's origin.
    #[must_use]
    pub fn center(&self, key: ObjectKey) -> Option<DVec3> {
        let object = self.get(key)?;
        let center = self.mesh_bounds(object.mesh)?.center().unwrap_or(DVec3::ZERO);
        Some(object.placement.to_world(center))
    }

    /// An object's edges: both ends of each.
    pub fn edges(&self, key: ObjectKey) -> Option<impl ExactSizeIterator<Item = [DVec3; 2]>> {
        let (mesh, matrix) = self.placed_mesh(key)?;
        let edges = mesh.edges();
        Some((0..edges.len()).map(move |i| edges[i].map(|index| position(mesh, &matrix, index))))
    }

    /// An object's faces: the three corners of each triangle.
    pub fn faces(&self, key: ObjectKey) -> Option<impl ExactSizeIterator<Item = [DVec3; 3]>> {
        let (mesh, matrix) = self.placed_mesh(key)?;
        Some(mesh.triangles().iter().map(move |t| t.map(|index| position(mesh, &matrix, index))))
    }

    /// A box around an object: that around the corners of its mesh's box. It holds the object, and is the smallest
    /// that does when the object is not turned.
    #[must_use]
    pub fn object_bounds(&self, key: ObjectKey) -> Option<Bounds> {
        self.get(key).map(|object| self.bounds_of(object))
    }

    /// A box around all visible objects; empty around none.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        self.objects()
            .filter(|(_, object)| object.visible)
            .fold(Bounds::EMPTY, |bounds, (_, object)| bounds.union(&self.bounds_of(object)))
    }

    fn bounds_of(&self, object: &Object) -> Bounds {
        let bounds = self.mesh_bounds(object.mesh).unwrap_or_default();
        bounds.transformed(&object.placement.matrix())
    }

    fn placed_mesh(&self, key: ObjectKey) -> Option<(&Mesh, DMat4)> {
        let object = self.get(key)?;
        Some((self.mesh(object.mesh)?, object.placement.matrix()))
    }
}

fn position(mesh: &Mesh, matrix: &DMat4, index: u32) -> DVec3 {
    let position = DVec3::from_array(mesh.positions()[index as usize].map(f64::from));
    (*matrix * position.extend(1.0)).truncate()
}
