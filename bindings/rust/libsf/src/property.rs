// SPDX-License-Identifier: MIT
// Properties: what a place of a graded solid has besides where it is, and the values of one over a mesh.

use std::ffi::CStr;

use crate::error::{check, Result};
use crate::plain::elements;
use crate::{sys, Error, ErrorKind};

#[doc = words!(sf_property)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::Property;
///
/// let density = Property::density();
/// assert_eq!((density.si[0], density.si[1], density.low), (-3, 1, 0.0));
/// assert_eq!(Property::named("hue")?, Property::named("hue")?);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Property {
    /// For people: 1 to 47 bytes.
    pub name: String,
    #[doc = words!(sf_property.uuid)]
    pub uuid: [u8; 16],
    #[doc = words!(sf_property.si)]
    pub si: [i8; 7],
    #[doc = words!(sf_property.low)]
    pub low: f64,
    #[doc = words!(sf_property.high)]
    pub high: f64,
}

impl Property {
    #[doc = words!(sf_property_density)]
    pub fn density() -> Property {
        Property::of(&unsafe { sys::sf_property_density() })
    }

    #[doc = words!(sf_property_young)]
    pub fn young() -> Property {
        Property::of(&unsafe { sys::sf_property_young() })
    }

    #[doc = words!(sf_property_poisson)]
    pub fn poisson() -> Property {
        Property::of(&unsafe { sys::sf_property_poisson() })
    }

    #[doc = words!(sf_property_named)]
    pub fn named(name: &str) -> Result<Property> {
        let mut c = unsafe { sys::sf_property_density() };
        let text = chars::<{ sys::SF_PROPERTY_NAME_SIZE as usize }>(name)?;
        check(unsafe { sys::sf_property_named(text.as_ptr(), &mut c) })?;
        Ok(Property::of(&c))
    }

    pub(crate) fn of(c: &sys::sf_property) -> Property {
        let bytes: Vec<u8> = c.name.iter().map(|&c| c as u8).take_while(|&b| b != 0).collect();
        let name = String::from_utf8_lossy(&bytes).into_owned();
        Property { name, uuid: c.uuid, si: c.si, low: c.low, high: c.high }
    }

    pub(crate) fn c(&self) -> Result<sys::sf_property> {
        let name = chars(&self.name)?;
        Ok(sys::sf_property { name, uuid: self.uuid, si: self.si, low: self.low, high: self.high })
    }
}

/// A name as C has it, in an array of its own.
pub(crate) fn chars<const SIZE: usize>(name: &str) -> Result<[std::ffi::c_char; SIZE]> {
    let bytes = name.as_bytes();
    if bytes.len() >= SIZE || bytes.contains(&0) {
        let said = format!("{name:?}: a name has at most {} bytes, none of them 0", SIZE - 1);
        return Err(Error::new(ErrorKind::Argument, said));
    }
    let mut made = [0; SIZE];
    for (to, &byte) in made.iter_mut().zip(bytes) {
        *to = byte as std::ffi::c_char;
    }
    debug_assert!(unsafe { CStr::from_ptr(made.as_ptr()) }.to_bytes() == bytes);
    Ok(made)
}

#[doc = words!(sf_channel)]
#[derive(Clone, Debug, PartialEq)]
pub struct Channel<'a> {
    /// What it is.
    pub property: Property,
    #[doc = words!(sf_channel.values)]
    pub values: &'a [f64],
    /// For each corner of each cell, in the mesh's order, its value; `None`: a corner has the value of its
    /// point.
    pub indices: Option<&'a [u32]>,
}

impl<'a> Channel<'a> {
    /// A property with a value for each point.
    pub fn of_points(property: Property, values: &'a [f64]) -> Channel<'a> {
        Channel { property, values, indices: None }
    }

    /// # Safety
    /// The arrays hold what is said, and so many corners, for as long as 'a.
    pub(crate) unsafe fn of(c: &sys::sf_channel, corners: usize) -> Channel<'a> {
        Channel {
            property: Property::of(&c.property),
            values: unsafe { elements(c.values, c.value_count) },
            indices: (!c.indices.is_null()).then(|| unsafe { elements(c.indices, corners) }),
        }
    }

    /// As C has it, if the arrays fit a mesh of so many points and corners.
    pub(crate) fn c(&self, points: usize, corners: usize) -> Result<sys::sf_channel> {
        let name = &self.property.name;
        match self.indices {
            None if self.values.len() != points => {
                let said = format!("property {name}: {} values for {points} points", self.values.len());
                return Err(Error::new(ErrorKind::Shape, said));
            }
            Some(indices) if indices.len() != corners => {
                let said = format!("property {name}: {} indices for {corners} corners", indices.len());
                return Err(Error::new(ErrorKind::Shape, said));
            }
            _ => {}
        }
        Ok(sys::sf_channel {
            property: self.property.c()?,
            value_count: self.values.len(),
            values: self.values.as_ptr(),
            indices: self.indices.map_or(std::ptr::null(), <[u32]>::as_ptr),
        })
    }
}
