// The state of a path between two of its rays, as shared/declare_structs.h says, but without STRUCT
// and END. The struct Path (path/path_state.glsl) has these fields, and so has the form in which a
// kernel keeps a path between dispatches (kernels/parked_task_table.h), which also fills the last
// row.
ROW(vec3, rayOrigin, xyz) ///< of the ray to trace next, metres
FIELD(float, rayTMax, w)
ROW(vec3, rayDirection, xyz) ///< unit vector
FIELD(uint, target, w) ///< the primitive that the ray ignores: a shadow ray's light, else kNone
ROW(vec3, vertex, xyz) ///< where the last event sent the path from; the ray may start farther along
FIELD(uint, bounce, w) ///< scattering events so far
ROW(vec3, throughput, xyz)    ///< product of the weights so far
FIELD(float, bsdfPdf, w)      ///< density per solid angle of the path's direction, after an event
ROW(vec3, radiance, xyz)      ///< found so far, W/(m^2 sr)
FIELD(float, etaScale, w)     ///< the factor that undoes the scaling of `throughput` by refraction
ROW(vec3, arriving, xyz)      ///< of a shadow ray: what it adds if nothing blocks it
FIELD(uint, rayKind, w)       ///< kPathRay, kShadowRay or kHiddenRay
ROW(vec3, nextDirection, xyz) ///< in which the path leaves its vertex after a shadow ray
