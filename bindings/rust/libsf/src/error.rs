// SPDX-License-Identifier: MIT
// What may go wrong, and with what words.
//
// A status of the library becomes a kind, and the fault that a call may leave beside it the message, the
// line and the byte. Where the reason lies in a reader or writer of the caller's, its own error is the
// source; where a shape cannot be had, the voxels that are in the way come along.

use std::ffi::CStr;
use std::path::Path;
use std::{fmt, io};

use crate::{sys, ErrorKind, Grid};

/// A call that failed: it changed nothing.
pub struct Error {
    kind: ErrorKind,
    message: String,
    line: u32,
    offset: u64,
    pub(crate) culprits: Option<Box<Grid>>,
    pub(crate) cause: Option<io::Error>,
}

/// What a call that can fail returns.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// Which way it failed.
    pub fn kind(&self) -> ErrorKind {
        self.kind
    }

    /// What is wrong, where, and what to do.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// Line of a text file, counted from 1, where that is what is wrong.
    pub fn line(&self) -> Option<u32> {
        (self.line > 0).then_some(self.line)
    }

    /// Byte of a file, counted from 0; 0 where it does not apply.
    pub fn offset(&self) -> u64 {
        self.offset
    }

    /// The voxels that stand in the way, where something must stay and cannot.
    pub fn culprits(&self) -> Option<&Grid> {
        self.culprits.as_deref()
    }

    pub(crate) fn new(kind: ErrorKind, message: impl Into<String>) -> Error {
        Error { kind, message: message.into(), line: 0, offset: 0, culprits: None, cause: None }
    }

    /// The same error, which names the file that it is about.
    pub(crate) fn in_file(mut self, path: &Path) -> Error {
        self.message = format!("{}: {}", path.display(), self.message);
        self
    }

    fn of(status: sys::sf_status) -> Error {
        let said = unsafe { CStr::from_ptr(sys::sf_status_message(status)) };
        Error::new(ErrorKind::of(status), said.to_string_lossy())
    }
}

impl ErrorKind {
    /// Name of a status code, such as "SF_ERR_SHAPE".
    pub fn name(self) -> &'static str {
        unsafe { CStr::from_ptr(sys::sf_status_name(self.c())) }.to_str().unwrap_or("")
    }
}

impl fmt::Display for Error {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str(&self.message)?;
        if self.line > 0 {
            write!(to, " (line {})", self.line)?;
        }
        Ok(())
    }
}

impl fmt::Debug for Error {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "{}: {self}", self.kind.name())
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        self.cause.as_ref().map(|cause| cause as _)
    }
}

impl From<Error> for io::Error {
    fn from(error: Error) -> io::Error {
        let kind = match error.kind {
            ErrorKind::Argument | ErrorKind::Shape => io::ErrorKind::InvalidInput,
            ErrorKind::Format => io::ErrorKind::InvalidData,
            ErrorKind::Memory => io::ErrorKind::OutOfMemory,
            ErrorKind::Unsupported => io::ErrorKind::Unsupported,
            _ => error.cause.as_ref().map_or(io::ErrorKind::Other, io::Error::kind),
        };
        io::Error::new(kind, error)
    }
}

/// Nothing, or what a status stands for.
pub(crate) fn check(status: sys::sf_status) -> Result<()> {
    if status == sys::SF_OK {
        return Ok(());
    }
    Err(Error::of(status))
}

/// The same of a call that may say more.
pub(crate) fn check_fault(status: sys::sf_status, fault: &sys::sf_fault) -> Result<()> {
    check(status).map_err(|mut error| {
        let bytes: Vec<u8> = fault.message.iter().map(|&c| c as u8).take_while(|&b| b != 0).collect();
        if fault.status != sys::SF_OK && !bytes.is_empty() {
            error.message = String::from_utf8_lossy(&bytes).into_owned();
            error.line = fault.line;
            error.offset = fault.offset;
        }
        error
    })
}

/// A fault that says nothing yet.
pub(crate) fn no_fault() -> sys::sf_fault {
    sys::sf_fault {
        status: sys::SF_OK,
        line: 0,
        offset: 0,
        message: [0; sys::SF_FAULT_MESSAGE_SIZE as usize],
    }
}
