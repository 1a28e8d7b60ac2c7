// SPDX-License-Identifier: MIT
// Arrays of ndarray's: a grid's words as they lie, and bools, one for each voxel, in (layer, y, x) order.

use ndarray::{Array3, ArrayView3, ArrayViewMut3};

use crate::error::Result;
use crate::{Error, ErrorKind, Grid, Lattice};

impl Grid {
    /// A grid of an array of bools in (layer, y, x) order.
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::{Grid, Lattice};
    /// use ndarray::{s, Array3};
    ///
    /// let mut array = Array3::from_elem((4, 8, 16), false);
    /// array.slice_mut(s![.., 2..4, 3..13]).fill(true);
    /// let mut grid = Grid::from_array(&Lattice::new(16, 8, 4, 0.1, 0.1)?, array.view())?;
    /// assert_eq!(grid.count(), 4 * 2 * 10);
    /// // A word has 64 voxels, the first in its lowest bit.
    /// assert_eq!(grid.word_view()[[0, 2, 0]], 0b1_1111_1111_1000);
    /// grid.word_view_mut()[[3, 7, 0]] |= 1;
    /// assert!(grid.to_array()[[3, 7, 0]]);
    /// # Ok(())
    /// # }
    /// ```
    pub fn from_array(lattice: &Lattice, solid: ArrayView3<'_, bool>) -> Result<Grid> {
        if solid.dim() != lattice.shape() {
            let said = format!("an array of {:?}, and {:?} is needed", solid.dim(), lattice.shape());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        Grid::from_fn(lattice, |layer, y, x| solid[[layer as usize, y as usize, x as usize]])
    }

    /// The voxels as bools in (layer, y, x) order.
    pub fn to_array(&self) -> Array3<bool> {
        Array3::from_shape_vec(self.lattice().shape(), self.to_bools()).expect("a bool for each voxel")
    }

    /// The grid's own memory: nz layers of ny rows of words, 64 voxels each.
    pub fn word_view(&self) -> ArrayView3<'_, u64> {
        ArrayView3::from_shape(self.word_shape(), self.words()).expect("words for each row")
    }

    /// The same, to be written.
    pub fn word_view_mut(&mut self) -> ArrayViewMut3<'_, u64> {
        ArrayViewMut3::from_shape(self.word_shape(), self.words_mut()).expect("words for each row")
    }

    fn word_shape(&self) -> (usize, usize, usize) {
        let (nz, ny, _) = self.lattice().shape();
        (nz, ny, self.stride())
    }
}
