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
    // Scenes and models of other programs.
    {0, "ply\n"sv, "a PLY mesh"},
    {0, "ply\r"sv, "a PLY mesh"},
    {0, "solid "sv, "an STL mesh"},
    {0, "Kaydara FBX Binary"sv, "an FBX file"},
    {0, "; FBX"sv, "an FBX file"},
    {0, "#usda"sv, "a USD file"},
    {0, "PXR-USDC"sv, "a USD file"},
    {0, "newmtl "sv, "an MTL material library"},
    {0, "<scene"sv, "an XML file"},
    {0, "BLENDER"sv, "a Blender scene"},
    {0, "glTF"sv, "a binary glTF file (GLB)"},
    // Images and others. Longer signatures before shorter ones that they begin with.
    {0, "\x89PNG"sv, "a PNG image"},
    {0, "\xff\xd8\xff"sv, "a JPEG image"},
    {0, "\x76\x2f\x31\x01"sv, "an EXR picture"},
    {0, "#?RADIANCE"sv, "a Radiance image (HDR)"},
    {0, "#?RGBE"sv, "a Radiance image (HDR)"},
    {0, "BM"sv, "a BMP image"},
    {0, "DDS "sv, "a DDS image"},
    {0, "II*\0"sv, "a TIFF image"},
    {0, "MM\0*"sv, "a TIFF image"},
    {0, "II+\0"sv, "a TIFF image"},
    {0, "MM\0+"sv, "a TIFF image"},
    {8, "WEBP"sv, "a WebP image"},
    {0, "GIF8"sv, "a GIF image"},
    {0, "8BPS"sv, "a Photoshop document"},
    {0, "gimp xcf"sv, "a GIMP image"},
    {0, "\xabKTX"sv, "a KTX texture"},
    {0, "\x13\xab\xa1\x5c"sv, "an ASTC texture"},
    {0, "PVR\3"sv, "a PVR texture"},
    {0, "VTF\0"sv, "a VTF texture"},
    {0, "qoif"sv, "a QOI image"},
    {0, "\0\0\0\x0cjP  "sv, "a JPEG 2000 image"},
    {0, "\xff\x4f\xff\x51"sv, "a JPEG 2000 image"},
    {0, "\0\0\0\x0cJXL "sv, "a JPEG XL image"},
    {0, "\xff\x0a"sv, "a JPEG XL image"},
    {4, "ftypavif"sv, "an AVIF image"},
    {4, "ftyphei"sv, "a HEIC image"},
    {4, "ftypmif1"sv, "a HEIC image"},
    {4, "ftyp"sv, "a video"},
    {0, "\0\0\1\0"sv, "an icon"},
    {0, "CALOFILM"sv, "a film of Calotype"},
    {0, "SIMPLE  ="sv, "a FITS image"},
    {0, "PF\n"sv, "a PFM picture"},
    {0, "Pf\n"sv, "a PFM picture"},
    {0, "P1\n"sv, "a PBM picture"},
    {0, "P2\n"sv, "a PGM picture"},
    {0, "P3\n"sv, "a PPM picture"},
    {0, "P4\n"sv, "a PBM picture"},
    {0, "P5\n"sv, "a PGM picture"},
    {0, "P6\n"sv, "a PPM picture"},
    {0, "%PDF"sv, "a PDF document"},
    {0, "<svg"sv, "an SVG drawing"},
    {0, "<?xml"sv, "an XML file"},
    {0, "<!DOCTYPE html"sv, "a web page"},
    {0, "<html"sv, "a web page"},
    {0, "version https://git-lfs"sv, "a Git LFS pointer, not the image itself"},
    {0, "\xff\xfe\0\0"sv, "a UTF-32 text"},
    {0, "\0\0\xfe\xff"sv, "a UTF-32 text"},
    {0, "\xff\xfe"sv, "a UTF-16 text"},
    {0, "\xfe\xff"sv, "a UTF-16 text"},
    {0, "PK\3\4"sv, "a ZIP archive"},
    {0, "\x1f\x8b"sv, "a gzip archive"},
    {0,
     "\x7f"
     "ELF"sv,
     "a program"},
};

} // namespace

std::string_view fileKind(std::string_view bytes) {
    if (bytes.empty())
        return "an empty file";
    const auto found = std::ranges::find_if(kSignatures, [&](const Signature& signature) {
        return bytes.size() >= signature.offset &&
               bytes.substr(signature.offset).starts_with(signature.bytes);
    });
    return found == std::end(kSignatures) ? std::string_view() : found->kind;
}

} // namespace calotype
