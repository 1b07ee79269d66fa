// Orthonormal frames about a direction.
#ifndef CALOTYPE_CORE_FRAME_GLSL
#define CALOTYPE_CORE_FRAME_GLSL

/// A rotation whose third column is the unit vector n; continuous except on the plane n.z = 0, and
/// without cancellation anywhere (Duff et al. 2017, "Building an Orthonormal Basis, Revisited").
mat3 worldFromLocal(vec3 n) {
    float zSign = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (zSign + n.z);
    float b = n.x * n.y * a;
    return mat3(vec3(1.0 + zSign * n.x * n.x * a, zSign * b, -zSign * n.x),
                vec3(b, zSign + n.y * n.y * a, -n.y), n);
}

#endif
