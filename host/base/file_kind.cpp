#include "base/file_kind.h"

#include <algorithm>

namespace calotype {
namespace {

using namespace std::string_view_literals;

/// Bytes at a fixed place of every file of a kind.
struct Signature {
    size_t offset;
    std::string_view bytes;
    std::string_view kind;
};

constexpr Signature kSignatures[] = {
    // Models and scenes of other programs.
    {0, "ply\n"sv, "a PLY mesh"},
    {0, "ply\r"sv, "a PLY mesh"},
    {0, "solid "sv, "an STL mesh"},
    {0, "glTF"sv, "a binary glTF file (GLB)"},
    {0, "Kaydara FBX Binary"sv, "an FBX file"},
    {0, "; FBX"sv, "an FBX file"},
    {0, "BLENDER"sv, "a Blender file"},
    {0, "#usda"sv, "a USD file"},
    {0, "PXR-USDC"sv, "a USD file"},
    {0, "<?xml"sv, "an XML file"},
    {0, "<scene"sv, "an XML file"},
    {0, "newmtl "sv, "an MTL material library"},
    // Films and pictures.
    {0, "\x89PNG"sv, "a PNG picture"},
    {0, "\xff\xd8\xff"sv, "a JPEG picture"},
    {0, "\x76\x2f\x31\x01"sv, "an OpenEXR picture"},
    {0, "#?RADIANCE"sv, "a Radiance picture (HDR)"},
    {0, "#?RGBE"sv, "a Radiance picture (HDR)"},
    {0, "PF\n"sv, "a PFM picture"},
    {0, "Pf\n"sv, "a PFM picture"},
    {0, "DDS "sv, "a DDS picture"},
    {0, "II*\0"sv, "a TIFF picture"},
    {0, "MM\0*"sv, "a TIFF picture"},
    {8, "WEBP"sv, "a WebP picture"},
    {4, "ftypavif"sv, "an AVIF picture"},
    {4, "ftypheic"sv, "a HEIF picture"},
    {0, "\xabKTX "sv, "a KTX picture"},
    {0, "8BPS"sv, "a Photoshop picture"},
    {0, "GIF8"sv, "a GIF picture"},
    {0, "BM"sv, "a BMP picture"},
    {0, "%PDF"sv, "a PDF document"},
    // Containers.
    {0, "PK\x03\x04"sv, "a ZIP archive"},
    {0, "\x1f\x8b"sv, "a gzip archive"},
    {0,
     "\x7f"
     "ELF"sv,
     "a program"},
};

} // namespace

std::string_view fileKind(std::string_view bytes) {
    const auto found = std::ranges::find_if(kSignatures, [&](const Signature& signature) {
        return bytes.size() >= signature.offset &&
               bytes.substr(signature.offset).starts_with(signature.bytes);
    });
    return found == std::end(kSignatures) ? std::string_view() : found->kind;
}

} // namespace calotype
