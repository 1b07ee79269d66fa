#pragma once

#include <string>
#include <string_view>

#include "scratch_folder.h"

namespace calotype::fuzz {

/// Writes what scenes and materials may name: "mesh.obj" (a bent quad with texture coordinates and
/// two materials), "mesh.mtl" and "map.hdr" (2 x 2 texels).
inline void writeSmallAssets(const ScratchFolder& folder) {
    folder.write("mesh.obj", "mtllib mesh.mtl\n"
                             "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\n"
                             "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                             "vn 0 0 1\n"
                             "usemtl a\nf 1/1/1 2/2/1 3/3/1\n"
                             "usemtl b\nf 1/1 3/3 4/4\n");
    folder.write("mesh.mtl", "newmtl a\nKd 0.5 0.5 0.5\nmap_Kd map.hdr\nnewmtl b\nKe 1 1 1\n");
    using namespace std::string_view_literals;
    folder.write("map.hdr", "#?RADIANCE\n\n-Y 2 +X 2\n"
                            "\x80\x40\x20\x81\x10\x20\x80\x80\xff\xff\xff\x80\x00\x00\x00\x00"sv);
}

} // namespace calotype::fuzz
