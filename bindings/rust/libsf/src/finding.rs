// SPDX-License-Identifier: MIT
// What findings cost to fix, and which ones to look at first. They go back to C as they came.

use std::ptr;

use crate::error::{check, Result};
use crate::memory::allocator;
use crate::plain::room;
use crate::task::run;
use crate::{sys, Checked, Error, ErrorKind, Finding, FindingCost, Grid, Task, Terms};

impl Checked {
    fn c(&self) -> Vec<sys::sf_finding> {
        self.findings.iter().map(Finding::c).collect()
    }

    #[doc = words!(sf_findings_cost: grid, terms, added)]
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::{Grid, Lattice, Rule};
    ///
    /// // A post with a shelf at its top, and a voxel that hangs alone.
    /// let lattice = Lattice::new(16, 16, 16, 0.1, 0.1)?;
    /// let grid = Grid::from_fn(&lattice, |layer, y, x| {
    ///     y == 8 && (x == 4 || (layer == 12 && x < 9) || (layer == 3 && x == 12))
    /// })?;
    /// let checked = grid.check(Rule::box3(), None)?;
    /// let mut added = Grid::new(&lattice)?;
    /// let costs = checked.costs(&grid, Rule::box3(), Some(&mut added), None)?;
    /// let mut fixed = grid.clone();
    /// fixed.or(&added)?;
    /// assert!(fixed.check(Rule::box3(), None)?.support_free());
    /// assert_eq!(costs[0].trim_voxels, 1);
    /// assert_eq!(checked.rank(Some(&costs))?[0], 1);
    /// # Ok(())
    /// # }
    /// ```
    pub fn costs<'t>(
        &self,
        grid: &Grid,
        terms: impl Into<Terms<'t>>,
        added: Option<&mut Grid>,
        task: Option<&mut Task<'_>>,
    ) -> Result<Vec<FindingCost>> {
        let placed = terms.into().place(grid.lattice())?;
        let findings = self.c();
        let none = sys::sf_finding_cost { trim_voxels: 0, grow_voxels: 0 };
        let mut costs = vec![none; findings.len()];
        let (list, count, to) = (findings.as_ptr(), findings.len(), costs.as_mut_ptr());
        let added = added.map_or(ptr::null_mut(), Grid::c_mut);
        check(run(task, |task| unsafe {
            sys::sf_findings_cost(grid.c(), &placed.c, list, count, allocator(), task, to, added)
        }))?;
        Ok(costs.iter().map(FindingCost::of).collect())
    }

    #[doc = words!(sf_findings_rank: costs)]
    ///
    /// The indices of the findings, the dearest first.
    pub fn rank(&self, costs: Option<&[FindingCost]>) -> Result<Vec<u32>> {
        let findings = self.c();
        if costs.is_some_and(|costs| costs.len() != findings.len()) {
            let said = format!("costs are not as many as the {} findings", findings.len());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        let costs: Option<Vec<sys::sf_finding_cost>> =
            costs.map(|costs| costs.iter().map(FindingCost::c).collect());
        let mut order = room::<u32>(findings.len())?;
        let by = costs.as_ref().map_or(ptr::null(), Vec::as_ptr);
        let (list, count, to) = (findings.as_ptr(), findings.len(), order.as_mut_ptr());
        check(unsafe { sys::sf_findings_rank(list, by, count, to) })?;
        Ok(order)
    }
}
