// SPDX-License-Identifier: MIT
// Random shapes, and the papers' rule written down voxel by voxel, in code that shares nothing with the
// library but the order of the voxels.

// Each program of tests uses a part of it.
#![allow(dead_code)]

use libsf::{Grid, Lattice};

/// Numbers that look random and are the same on every machine (G. Marsaglia, "Xorshift RNGs", 2003).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    pub fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// One of 0 to n - 1.
    pub fn below(&mut self, n: u32) -> u32 {
        ((self.next() >> 33) % u64::from(n)) as u32
    }
}

/// A lattice whose rows end everywhere in a word, and the boxes of matter that make a shape on it.
pub fn lattice(random: &mut Random) -> Lattice {
    let (nx, ny, nz) = (1 + random.below(80), 1 + random.below(12), 1 + random.below(12));
    Lattice::new(nx, ny, nz, 0.5, 0.5).unwrap()
}

pub fn shape(random: &mut Random, lattice: &Lattice) -> Grid {
    let mut solid = Solid::empty(lattice);
    for _ in 0..random.below(9) {
        let mut span = |n: u32| {
            let first = random.below(n);
            (first as usize, (first + 1 + random.below(n - first)) as usize)
        };
        let (x, y, z) = (span(lattice.nx()), span(lattice.ny()), span(lattice.nz()));
        for k in z.0..z.1 {
            for j in y.0..y.1 {
                for i in x.0..x.1 {
                    let place = solid.place(k, j, i);
                    solid.voxels[place] = random.below(8) > 0;
                }
            }
        }
    }
    solid.grid(lattice)
}

/// A shape as bools.
#[derive(Clone, PartialEq, Debug)]
pub struct Solid {
    pub shape: (usize, usize, usize),
    pub voxels: Vec<bool>,
}

impl Solid {
    pub fn empty(lattice: &Lattice) -> Solid {
        let shape = lattice.shape();
        Solid { shape, voxels: vec![false; shape.0 * shape.1 * shape.2] }
    }

    pub fn of(grid: &Grid) -> Solid {
        Solid { shape: grid.lattice().shape(), voxels: grid.to_bools() }
    }

    pub fn grid(&self, lattice: &Lattice) -> Grid {
        Grid::from_bools(lattice, &self.voxels).unwrap()
    }

    pub fn place(&self, k: usize, y: usize, x: usize) -> usize {
        (k * self.shape.1 + y) * self.shape.2 + x
    }

    /// Whether one of the nine voxels below is solid.
    fn carried(&self, k: usize, y: usize, x: usize) -> bool {
        let near = |i: usize, n: usize| i.saturating_sub(1)..(i + 2).min(n);
        near(y, self.shape.1).any(|j| near(x, self.shape.2).any(|i| self.voxels[self.place(k - 1, j, i)]))
    }

    /// The layers above the first that holds matter.
    fn above_bed(&self) -> std::ops::Range<usize> {
        let layer = self.shape.1 * self.shape.2;
        let bed = self.voxels.iter().position(|&solid| solid).map_or(self.shape.0, |first| first / layer);
        (bed + 1).min(self.shape.0)..self.shape.0
    }

    /// How many voxels none of the nine below carries.
    pub fn unsupported(&self) -> u64 {
        let (_, ny, nx) = self.shape;
        let mut count = 0;
        for k in self.above_bed() {
            for y in 0..ny {
                for x in 0..nx {
                    count += u64::from(self.voxels[self.place(k, y, x)] && !self.carried(k, y, x));
                }
            }
        }
        count
    }

    /// What is left when all that hangs is taken away, from the bottom up.
    pub fn trimmed(&self) -> Solid {
        let (_, ny, nx) = self.shape;
        let mut left = self.clone();
        for k in self.above_bed() {
            for y in 0..ny {
                for x in 0..nx {
                    let place = left.place(k, y, x);
                    left.voxels[place] = left.voxels[place] && left.carried(k, y, x);
                }
            }
        }
        left
    }

    /// Whether every voxel of this is one of the other.
    pub fn within(&self, other: &Solid) -> bool {
        self.voxels.iter().zip(&other.voxels).all(|(&mine, &its)| !mine || its)
    }
}
