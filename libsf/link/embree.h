// SPDX-License-Identifier: MIT
// What the parts of the adapter to Embree share: a prepared mesh, and its rays.

#ifndef SF_LINK_INSIDE_EMBREE_H
#define SF_LINK_INSIDE_EMBREE_H

#include <sf/link/embree.h>

#include "link/embree_version.h"

#include <vector>

struct sf_embree {
    sf_allocator allocator;
    RTCDevice device;
    RTCScene scene;
    size_t triangle_count;
    double middle[3], reach; // of the mesh, mm; the scene's origin, and its largest half side
    int turned;              // whether it encloses a negative volume
};

namespace embree {

struct hit {
    float along;
    uint32_t triangle;
    int leaves;
};

// A ray in the scene's frame; finds hits between `nearest` and infinity.
RTCRayHit ray_at(const sf_embree *e, const double from[3], const double direction[3],
                 double nearest);

// The nearest hit; 0 where there is none.
int cast(const sf_embree *e, RTCRayHit ray, hit *found);

// All hits of a ray of length 1, sorted; of those that lie together and face alike, one.
void cast_through(const sf_embree *e, RTCRayHit ray, std::vector<hit> *hits);

} // namespace embree

#endif
