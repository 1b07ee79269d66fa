#include "image/denoised_mark.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <variant>

#include "base/read_file.h"
#include "image/exr.h"
#include "image/exr_check.h"
#include "image/image_check.h"
#include "image/png.h"
#include "image/png_chunk.h"
#include "image/read_image.h"

namespace calotype {
namespace {

constexpr const char* kDenoiser = "denoiser";
constexpr const char* kError = "denoisedError";
constexpr const char* kBound = "denoisedBound";

const Attribute* findAttribute(const std::vector<Attribute>& metadata, std::string_view name) {
    const auto found = std::ranges::find(metadata, name, &Attribute::name);
    return found == metadata.end() ? nullptr : &*found;
}

/// Also of a number's text, as PNG files have it.
std::optional<double> numberIn(const std::vector<Attribute>& metadata, std::string_view name) {
    const Attribute* attribute = findAttribute(metadata, name);
    if (!attribute)
        return std::nullopt;
    if (const auto* number = std::get_if<double>(&attribute->value))
        return *number;
    const auto* text = std::get_if<std::string>(&attribute->value);
    if (!text)
        return std::nullopt;
    char* end = nullptr;
    const double number = std::strtod(text->c_str(), &end);
    return end == text->c_str() ? std::nullopt : std::optional(number);
}

std::vector<Attribute> metadataOfPng(const std::string& path) {
    const std::string bytes = readFile(path, path);
    checkPng(bytes, path);
    std::vector<Attribute> metadata;
    for (PngText& text : pngTexts(bytes))
        if (text.keyword.starts_with(kMetadataPrefix))
            metadata.push_back({text.keyword.substr(kMetadataPrefix.size()), std::move(text.text)});
    return metadata;
}

} // namespace

void addMark(const DenoisedMark& mark, std::vector<Attribute>& metadata) {
    metadata.push_back({kDenoiser, mark.denoiser});
    if (mark.error)
        metadata.push_back({kError, *mark.error});
    if (mark.bound)
        metadata.push_back({kBound, *mark.bound});
}

void removeMark(std::vector<Attribute>& metadata) {
    std::erase_if(metadata, [](const Attribute& attribute) {
        return attribute.name == kDenoiser || attribute.name == kError || attribute.name == kBound;
    });
}

std::optional<DenoisedMark> markOf(const std::vector<Attribute>& metadata) {
    const Attribute* denoiser = findAttribute(metadata, kDenoiser);
    const auto* name = denoiser ? std::get_if<std::string>(&denoiser->value) : nullptr;
    if (!name)
        return std::nullopt;
    return DenoisedMark{*name, numberIn(metadata, kError), numberIn(metadata, kBound)};
}

std::optional<DenoisedMark> readMark(const std::filesystem::path& path) {
    const std::string signature = signatureOf(path);
    if (isExr(signature))
        return markOf(readExrMetadata(path));
    return isPng(signature) ? markOf(metadataOfPng(path.string())) : std::nullopt;
}

} // namespace calotype
