//! One object's share of the file's tables.

use super::super::draft::MISSING;

/// One part cut out of tables that several parts share: each shared index is given a local one when it is first
/// met. The table of local indices is kept from part to part, marked with the part's number, so that cutting all
/// parts takes time with their corners, not with parts × vertices.
#[derive(Debug)]
pub(super) struct Gather {
    /// (the part that gave the local index, the local index)
    local: Vec<(u32, u32)>,
    part: u32,
}

impl Gather {
    pub(super) fn new(shared: usize) -> Self {
        Self { local: vec![(0, 0); shared], part: 0 }
    }

    /// Begins the next part.
    pub(super) const fn next_part(&mut self) {
        self.part += 1;
    }

    /// The local index; `take` is called with the shared one when it is new to the part, and returns the local.
    pub(super) fn index(&mut self, shared: u32, take: impl FnOnce(usize) -> usize) -> u32 {
        let Some(slot) = self.local.get_mut(shared as usize) else { return MISSING };
        if slot.0 != self.part {
            let local = take(shared as usize);
            *slot = (self.part, u32::try_from(local).unwrap_or(MISSING));
        }
        slot.1
    }

    /// How many shared entries no part has met.
    pub(super) fn unmet(&self) -> usize {
        self.local.iter().filter(|(part, _)| *part == 0).count()
    }
}
