//! What a function answers.

use fixstep::{Error, Full, Stale};

/// What a call answers. All but FIXSTEP_STATUS_OK have changed nothing.
#[must_use]
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Done.
    Ok = 0,
    /// A pointer is null.
    Null = 1,
    /// The world was not given to fixstep_init.
    NotInitialised = 2,
    /// A mass or drag that the library cannot hold: zero, negative, too small or too large.
    BadValue = 3,
    /// No room for another point.
    Full = 4,
    /// No point of that id, or no more.
    Stale = 5,
}

impl Status {
    /// Runs `call`, in which `?` hands an error to C.
    #[inline(always)]
    pub(crate) fn of(call: impl FnOnce() -> Result<(), Status>) -> Status {
        match call() {
            Ok(()) => Status::Ok,
            Err(status) => status,
        }
    }
}

/// All but those below are about values.
impl From<Error> for Status {
    fn from(_: Error) -> Status {
        Status::BadValue
    }
}

impl<B> From<Full<B>> for Status {
    fn from(_: Full<B>) -> Status {
        Status::Full
    }
}

impl From<Stale> for Status {
    fn from(_: Stale) -> Status {
        Status::Stale
    }
}
