#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "image/texel_image_size.h"
#include "read/load.h"

namespace calotype {

/// Adds up what the images of a scene take once they are decoded, by the headers of their files, so
/// that a scene with too many of them is refused before any is decoded.
class TextureBudget {
public:
    /// Counts the image file at the true path `path` once. `isUploaded`: the device gets a copy. A
    /// file that cannot be read, or with a side above ImageTexture::kLargestSide, is not counted.
    void add(const std::string& path, bool isUploaded);

    /// Throws GpuError if the device of the options cannot hold the images, and Error if the host
    /// cannot; the message has both numbers and the largest files.
    void require(const LoadOptions& options) const;

    /// The files whose images are counted, without those of earlier calls.
    std::vector<std::string> takeNew() { return std::exchange(new_, {}); }

private:
    struct Entry {
        TexelImageSize image;
        bool isUploaded = false;
    };

    std::string largestFiles() const;

    std::vector<std::string> new_;
    std::map<std::string, Entry> entries_; ///< by path; the image of unreadable ones is empty
};

} // namespace calotype
