// SPDX-License-Identifier: MIT
// What belongs to another object and is lent to be read.

use std::fmt;
use std::marker::PhantomData;
use std::mem::ManuallyDrop;
use std::ops::Deref;

/// Something that belongs to another object, which it borrows: to be read, and cloned where it has to last.
pub struct Lent<'a, T> {
    inner: ManuallyDrop<T>,
    owner: PhantomData<&'a T>,
}

impl<T> Lent<'_, T> {
    /// The owner must keep it as it is for as long as the lifetime that this gets.
    pub(crate) fn new(inner: ManuallyDrop<T>) -> Self {
        Lent { inner, owner: PhantomData }
    }
}

impl<T> Deref for Lent<'_, T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.inner
    }
}

impl<T: fmt::Debug> fmt::Debug for Lent<'_, T> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        (**self).fmt(to)
    }
}
