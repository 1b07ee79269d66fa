#include "image/file_kind.h"

#include "image/exr_check.h"

namespace calotype {
namespace {

using namespace std::string_view_literals;

struct Signature {
    std::string_view bytes;
    std::string_view kind;
    size_t at = 0; ///< where the bytes are
};

/// Longer ones before shorter ones that they begin with.
constexpr Signature kSignatures[] = {
    {"DDS "sv, "a DDS image"},
    {"II*\0"sv, "a TIFF image"},
    {"MM\0*"sv, "a TIFF image"},
    {"II+\0"sv, "a TIFF image"},
    {"MM\0+"sv, "a TIFF image"},
    {"WEBP"sv, "a WebP image", 8},
    {"GIF8"sv, "a GIF image"},
    {"8BPS"sv, "a Photoshop document"},
    {"gimp xcf"sv, "a GIMP image"},
    {"\xabKTX"sv, "a KTX texture"},
    {"\x13\xab\xa1\x5c"sv, "an ASTC texture"},
    {"PVR\3"sv, "a PVR texture"},
    {"VTF\0"sv, "a VTF texture"},
    {"qoif"sv, "a QOI image"},
    {"\0\0\0\x0cjP  "sv, "a JPEG 2000 image"},
    {"\xff\x4f\xff\x51"sv, "a JPEG 2000 image"},
    {"\0\0\0\x0cJXL "sv, "a JPEG XL image"},
    {"\xff\x0a"sv, "a JPEG XL image"},
    {"ftypavif"sv, "an AVIF image", 4},
    {"ftyphei"sv, "a HEIC image", 4},
    {"ftypmif1"sv, "a HEIC image", 4},
    {"ftyp"sv, "a video", 4},
    {"\0\0\1\0"sv, "an icon"},
    {"SIMPLE  ="sv, "a FITS image"},
    {"PF\n"sv, "a PFM picture"},
    {"Pf\n"sv, "a PFM picture"},
    {"P1\n"sv, "a PBM picture"},
    {"P2\n"sv, "a PGM picture"},
    {"P3\n"sv, "a PPM picture"},
    {"P4\n"sv, "a PBM picture"},
    {"P5\n"sv, "a PGM picture"},
    {"P6\n"sv, "a PPM picture"},
    {"%PDF"sv, "a PDF document"},
    {"<svg"sv, "an SVG drawing"},
    {"<?xml"sv, "an XML file"},
    {"<!DOCTYPE html"sv, "a web page"},
    {"<html"sv, "a web page"},
    {"version https://git-lfs"sv, "a Git LFS pointer, not the image itself"},
    {"PK\3\4"sv, "a ZIP archive"},
    {"\x1f\x8b"sv, "a gzip archive"},
    {"BLENDER"sv, "a Blender scene"},
    {"glTF"sv, "a glTF model"},
};

} // namespace

std::string_view kindOfFile(std::string_view file) {
    if (file.empty())
        return "an empty file";
    if (isExr(file))
        return "an EXR picture";
    for (const Signature& signature : kSignatures)
        if (file.size() >= signature.at && file.substr(signature.at).starts_with(signature.bytes))
            return signature.kind;
    return {};
}

} // namespace calotype
