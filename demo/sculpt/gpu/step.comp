// SPDX-License-Identifier: MIT
// Step: a place in the history for the stroke that ends, or the step that is undone or done again.
//
// Steps lie in a ring one behind the other, each in one piece; one that does not fit before the end
// goes to the beginning. What lies where it goes is the oldest, and is forgotten. A stroke that
// changed nothing is no step. One that is larger than the ring is done and cannot be undone, and all
// before it are forgotten. Mirrors libsf/sculpt/ring.c, which counts bytes of runs where this
// counts words that changed, so that the two need not forget the same steps.
//
// One invocation: this is bookkeeping that the host would need to ask the GPU for.
#include "grid.glsl"
#include "state.glsl"

layout(local_size_x = 1) in;
layout(location = 2) uniform uint verb;

const uint COUNT = 0u, END = 1u, GIVE_UP = 2u, UNDO = 3u, REDO = 4u;

void forget_first()
{
    ledger.first++;
    ledger.forgotten++;
}

bool has_oldest()
{
    return ledger.first < ledger.here;
}

uint oldest_start()
{
    return ledger.steps[ledger.first % STEPS].start;
}

// Where a step of this many words goes, after forgetting what is in its way.
uint make_room(uint words)
{
    uint head = 0u;
    if (has_oldest()) {
        history_step last = ledger.steps[(ledger.here - 1u) % STEPS];
        head = last.start + last.count * RECORD;
    }
    if (head + words > ledger.capacity) {
        while (has_oldest() && oldest_start() >= head) {
            forget_first();
        }
        head = 0u;
    }
    while (has_oldest() && oldest_start() >= head && oldest_start() < head + words) {
        forget_first();
    }
    if (ledger.here - ledger.first >= STEPS) {
        forget_first();
    }
    return head;
}

void add_step()
{
    uint count = ledger.changed_words;
    ledger.cursor = 0u;
    ledger.start = NONE;
    if (count == 0u) {
        return;
    }
    ledger.end = ledger.here;
    if (count > ledger.capacity / RECORD) {
        ledger.forgotten += ledger.here - ledger.first + 1u;
        ledger.first = ledger.here = ledger.end = 0u;
        return;
    }
    ledger.start = make_room(count * RECORD);
    ledger.steps[ledger.here % STEPS] = history_step(ledger.start, count);
    ledger.here++;
    ledger.end = ledger.here;
}

void pick(bool is_there, uint which)
{
    history_step s = ledger.steps[which % STEPS];
    ledger.apply_start = s.start;
    ledger.apply_count = is_there ? s.count : 0u;
    ledger.edit = ledger.touched = ledger.changed = empty_box();
}

void main()
{
    switch (verb) {
    case COUNT:
        ledger.added_voxels = ledger.removed_voxels = ledger.lost_voxels = 0u;
        ledger.kept_back_voxels = ledger.changed_words = 0u;
        break;
    case END:
        add_step();
        ledger.changed = ledger.touched;
        break;
    case GIVE_UP:
        ledger.start = NONE;
        ledger.changed = ledger.touched;
        break;
    case UNDO:
        pick(has_oldest(), ledger.here - 1u);
        ledger.here -= has_oldest() ? 1u : 0u;
        break;
    default:
        pick(ledger.here < ledger.end, ledger.here);
        ledger.here += ledger.here < ledger.end ? 1u : 0u;
        break;
    }
}
