//! The world as C sees it: words that C allocates and this file looks into.
//!
//! All `unsafe` code is here. It rests on one tag: `put` writes it together with a whole `Scene`, and
//! nothing else does, so that zeroed storage (every `static` of C) is told from a world without looking
//! at anything that might be invalid. A world holds no address: C may copy it as a struct.

use core::mem::MaybeUninit;
use core::ptr;

use fixstep::fixed::types::I16F16;
use fixstep::{BodyId, Gravity, LinearDrag, Point, World};

use crate::{FIXSTEP_CAPACITY, Status};

/// Words of a world.
pub const FIXSTEP_WORDS: usize = 111;

/// The memory of a world: a static, or `fixstep_world w = {0};`. What is inside is the library's;
/// a copy is a snapshot. Every call but fixstep_init refuses one that is all zero; memory that was never set
/// must not be handed to another.
#[repr(C)]
pub struct Storage {
    /// Not to be touched.
    pub opaque: [MaybeUninit<u64>; FIXSTEP_WORDS],
}

/// Zero, as a static of C.
impl Default for Storage {
    fn default() -> Storage {
        Storage {
            opaque: [MaybeUninit::new(0); FIXSTEP_WORDS],
        }
    }
}

/// In `tag` when a `Scene` follows: 64 bits that memory does not hold by chance.
const TAG: u64 = 0x8f1c_6b5e_49d3_a276;

type Forces = (Gravity<I16F16>, LinearDrag<I16F16>);

/// What is in the storage.
#[repr(C)]
pub(crate) struct Scene {
    tag: u64,
    pub(crate) world: World<Point<I16F16>, FIXSTEP_CAPACITY>,
    pub(crate) forces: Forces,
}

// Without waste: a firmware pays for the words.
const _: () = assert!(size_of::<Storage>() == size_of::<Scene>());
const _: () = assert!(align_of::<Storage>() >= align_of::<Scene>());

/// Starts a scene in the storage, whatever it held.
pub(crate) fn put(storage: &mut Storage, forces: Forces) {
    let scene = ptr::from_mut(storage).cast::<Scene>();
    // SAFETY: the storage is as large and as aligned as a `Scene` (asserted above), and ours alone by
    // `&mut`. Each field is written, none is read or dropped: none has a destructor. The parts go in
    // one by one, so that in release code the stack holds no world.
    unsafe {
        (&raw mut (*scene).world).write(World::new());
        (&raw mut (*scene).forces).write(forces);
        (&raw mut (*scene).tag).write(TAG);
    }
}

/// The scene in the storage.
pub(crate) fn scene(storage: Option<&Storage>) -> Result<&Scene, Status> {
    let storage = storage.ok_or(Status::Null)?;
    has_tag(storage)?;
    // SAFETY: the tag says that `put` has made a `Scene` here, or in the storage this is a copy of;
    // size and alignment as there.
    Ok(unsafe { &*ptr::from_ref(storage).cast::<Scene>() })
}

/// The scene in the storage, to be changed.
pub(crate) fn scene_mut(storage: Option<&mut Storage>) -> Result<&mut Scene, Status> {
    let storage = storage.ok_or(Status::Null)?;
    has_tag(storage)?;
    // SAFETY: as in `scene`; the borrow of the storage goes over to the scene.
    Ok(unsafe { &mut *ptr::from_mut(storage).cast::<Scene>() })
}

fn has_tag(storage: &Storage) -> Result<(), Status> {
    let [first, ..] = &storage.opaque;
    // SAFETY: the header asks for storage that was zeroed, or that `put` has filled.
    match unsafe { first.assume_init() } {
        TAG => Ok(()),
        _ => Err(Status::NotInitialised),
    }
}

/// The body of that serial number.
pub(crate) fn named(scene: &Scene, id: u32) -> Result<BodyId, Status> {
    let ids = scene.world.ids();
    let place = ids.binary_search_by_key(&id, |id| id.serial());
    place
        .ok()
        .and_then(|place| ids.get(place).copied())
        .ok_or(Status::Stale)
}

/// Defined nowhere. In a release build no panic is left and nothing asks for it. A debug build has some, and
/// its C linker says why it is not to be used.
#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    unsafe extern "C" {
        safe fn fixstep_c_can_panic_build_it_with_release() -> !;
    }
    fixstep_c_can_panic_build_it_with_release()
}
