// SPDX-License-Identifier: MIT
// Curves and mixtures: what was measured, read forwards and backwards.

use std::fmt;
use std::ptr::{self, NonNull};

use crate::error::{check, check_fault, no_fault, Result};
use crate::grid::own;
use crate::memory::allocator;
use crate::plain::{first, room};
use crate::{sys, CurveSample, Error, ErrorKind, Trend};

#[doc = words!(sf_curve)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Curve, CurveSample, Trend};
///
/// // Stiffness in MPa at five fractions of the harder material.
/// let measured = [(0.0, 0.7), (0.25, 20.0), (0.5, 210.0), (0.75, 900.0), (1.0, 2100.0)];
/// let samples = measured.map(|(x, y)| CurveSample { x, y, weight: 1.0 });
/// let curve = Curve::new(&samples, Trend::Auto)?;
/// let (fraction, miss) = curve.inverse(500.0)?;
/// assert!(fraction > 0.5 && fraction < 0.75 && miss.abs() < 1e-9);
/// assert!((curve.value(fraction)?.0 - 500.0).abs() < 1e-9);
/// // Stiffer than the hardest material nothing is.
/// assert_eq!(curve.inverse(3000.0)?, (1.0, -900.0));
/// # Ok(())
/// # }
/// ```
pub struct Curve {
    c: NonNull<sys::sf_curve>,
}

// It does not change once it is made.
unsafe impl Send for Curve {}
unsafe impl Sync for Curve {}

impl Curve {
    #[doc = words!(sf_curve_create: samples, trend)]
    pub fn new(samples: &[CurveSample], trend: Trend) -> Result<Curve> {
        let mut made = ptr::null_mut();
        let (list, count) = (first(samples), samples.len());
        check(unsafe { sys::sf_curve_create(list, count, trend.c(), allocator(), &mut made) })?;
        Ok(Curve { c: own(made)? })
    }

    #[doc = words!(sf_curve_value: x)]
    ///
    /// The value, and the derivative.
    pub fn value(&self, x: f64) -> Result<(f64, f64)> {
        let (mut y, mut slope) = (0.0, 0.0);
        check(unsafe { sys::sf_curve_value(self.c.as_ptr(), x, &mut y, &mut slope) })?;
        Ok((y, slope))
    }

    #[doc = words!(sf_curve_inverse: y, miss)]
    ///
    /// The place, and the miss.
    pub fn inverse(&self, y: f64) -> Result<(f64, f64)> {
        let (mut x, mut miss) = (0.0, 0.0);
        check(unsafe { sys::sf_curve_inverse(self.c.as_ptr(), y, &mut x, &mut miss) })?;
        Ok((x, miss))
    }

    #[doc = words!(sf_curve_change)]
    pub fn change(&self) -> f64 {
        unsafe { sys::sf_curve_change(self.c.as_ptr()) }
    }
}

impl Drop for Curve {
    fn drop(&mut self) {
        unsafe { sys::sf_curve_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Curve {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("Curve").field("change", &self.change()).finish_non_exhaustive()
    }
}

/// Fractions that have wanted properties, or the nearest that some have.
#[derive(Clone, Debug, PartialEq)]
pub struct Mixed {
    /// One for each material: at least 0, of sum 1.
    pub fractions: Vec<f64>,
    /// The properties of that mixture.
    pub obtained: Vec<f64>,
    /// How far these are from the wanted, in scales.
    pub miss: f64,
}

#[doc = words!(sf_mixture)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::Mixture;
///
/// // Three materials; their stiffness in MPa and their density in g/cm3, pure and in one blend.
/// let fractions = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.2, 0.4, 0.4]];
/// let measured = [[2000.0, 1.2], [1.0, 1.1], [900.0, 0.9], [450.0, 1.0]];
/// let mixture = Mixture::new(&fractions, &measured, None)?;
/// let (found, miss) = mixture.properties(&[0.2, 0.4, 0.4])?;
/// assert!((found[0] - 450.0).abs() < 1e-9 && miss == 0.0);
/// let mixed = mixture.fractions(&[1000.0, 1.05], None)?;
/// assert!(mixed.miss < 1e-9);
/// assert!((mixed.fractions.iter().sum::<f64>() - 1.0).abs() < 1e-12);
/// # Ok(())
/// # }
/// ```
pub struct Mixture {
    c: NonNull<sys::sf_mixture>,
    materials: usize,
    properties: usize,
}

// It does not change once it is made.
unsafe impl Send for Mixture {}
unsafe impl Sync for Mixture {}

impl Mixture {
    #[doc = words!(sf_mixture_create)]
    ///
    /// - `fractions`: of each measured mixture one for each material, at least 0 and of sum 1
    /// - `properties`: of each measured mixture what it is like
    /// - `scales`: what of each property counts as one unit of error; `None`: the span that was measured
    pub fn new<const MATERIALS: usize, const PROPERTIES: usize>(
        fractions: &[[f64; MATERIALS]],
        properties: &[[f64; PROPERTIES]],
        scales: Option<&[f64; PROPERTIES]>,
    ) -> Result<Mixture> {
        if fractions.len() != properties.len() {
            let said = format!("{} mixtures, and properties of {}", fractions.len(), properties.len());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        let samples = sys::sf_mixture_samples {
            material_count: MATERIALS,
            property_count: PROPERTIES,
            count: fractions.len(),
            fractions: fractions.as_ptr().cast(),
            properties: properties.as_ptr().cast(),
            scales: scales.map_or(ptr::null(), |scales| scales.as_ptr()),
        };
        let (mut made, mut fault) = (ptr::null_mut(), no_fault());
        let created = unsafe { sys::sf_mixture_create(&samples, allocator(), &mut made, &mut fault) };
        check_fault(created, &fault)?;
        Ok(Mixture { c: own(made)?, materials: MATERIALS, properties: PROPERTIES })
    }

    fn c(&self) -> *const sys::sf_mixture {
        self.c.as_ptr()
    }

    /// Refuses numbers that are not as many as there are materials or properties.
    fn fitting(given: usize, needed: usize, what: &str) -> Result<()> {
        if given != needed {
            return Err(Error::new(ErrorKind::Shape, format!("{given} {what}, and {needed} are needed")));
        }
        Ok(())
    }

    #[doc = words!(sf_mixture_simplex_count)]
    pub fn simplex_count(&self) -> usize {
        unsafe { sys::sf_mixture_simplex_count(self.c()) }
    }

    #[doc = words!(sf_mixture_simplex: simplex)]
    pub fn simplex(&self, simplex: usize) -> Result<Vec<u32>> {
        let mut corners = room::<u32>(self.materials)?;
        check(unsafe { sys::sf_mixture_simplex(self.c(), simplex, corners.as_mut_ptr()) })?;
        Ok(corners)
    }

    #[doc = words!(sf_mixture_properties: fractions, miss)]
    ///
    /// The properties, and the miss.
    pub fn properties(&self, fractions: &[f64]) -> Result<(Vec<f64>, f64)> {
        Mixture::fitting(fractions.len(), self.materials, "fractions")?;
        let (mut found, mut miss) = (room::<f64>(self.properties)?, 0.0);
        let (from, to) = (fractions.as_ptr(), found.as_mut_ptr());
        check(unsafe { sys::sf_mixture_properties(self.c(), from, to, &mut miss) })?;
        Ok((found, miss))
    }

    #[doc = words!(sf_mixture_fractions: wanted, hint)]
    pub fn fractions(&self, wanted: &[f64], hint: Option<&mut usize>) -> Result<Mixed> {
        Mixture::fitting(wanted.len(), self.properties, "properties")?;
        let (mut fractions, mut obtained) = (room::<f64>(self.materials)?, room::<f64>(self.properties)?);
        let mut miss = 0.0;
        let (to, has) = (fractions.as_mut_ptr(), obtained.as_mut_ptr());
        let hint = hint.map_or(ptr::null_mut(), |hint| hint as *mut usize);
        check(unsafe { sys::sf_mixture_fractions(self.c(), wanted.as_ptr(), hint, to, has, &mut miss) })?;
        Ok(Mixed { fractions, obtained, miss })
    }
}

impl Drop for Mixture {
    fn drop(&mut self) {
        unsafe { sys::sf_mixture_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Mixture {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (materials, properties) = (self.materials, self.properties);
        write!(
            to,
            "Mixture({materials} materials, {properties} properties, {} simplices)",
            self.simplex_count()
        )
    }
}
