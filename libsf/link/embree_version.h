// SPDX-License-Identifier: MIT
// Embree 3 and 4 behind one pair of words: they differ in where a ray's context and filter are
// named.

#ifndef SF_LINK_EMBREE_VERSION_H
#define SF_LINK_EMBREE_VERSION_H

#ifdef SF_EMBREE_4
#include <embree4/rtcore.h>
#define SF_EMBREE_SCENE_FILTER RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS
typedef RTCRayQueryContext embree_context;
#else
#include <embree3/rtcore.h>
#define SF_EMBREE_SCENE_FILTER RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION
typedef RTCIntersectContext embree_context;
#endif

// Cast one ray. The filter, which may be NULL, is called at each hit that is met on the way; it
// finds the context again in its arguments.
static inline void embree_cast(RTCScene scene, embree_context *context, RTCFilterFunctionN filter,
                               RTCRayHit *ray)
{
#ifdef SF_EMBREE_4
    RTCIntersectArguments arguments;
    rtcInitRayQueryContext(context);
    rtcInitIntersectArguments(&arguments);
    arguments.context = context;
    arguments.filter = filter;
    arguments.flags =
        filter != nullptr ? RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER : RTC_RAY_QUERY_FLAG_NONE;
    rtcIntersect1(scene, ray, &arguments);
#else
    rtcInitIntersectContext(context);
    context->filter = filter;
    rtcIntersect1(scene, context, ray);
#endif
}

#endif
