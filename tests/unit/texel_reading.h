#pragma once

#include <string>

#include <gtest/gtest.h>

#include "image/read_texel_image.h"
#include "unit/scene_files.h"

namespace calotype::test {

inline constexpr uint32_t kLargestSide = 64;

inline TexelImage read(const std::string& file) {
    return readTexelImage(file, kLargestSide, "image");
}

/// Expects that the file is refused, with a message that contains `fragment`.
inline void expectRefused(const std::string& file, const std::string& fragment) {
    const SceneError error = errorOf([&] { read(file); });
    EXPECT_EQ(error.where(), "image");
    EXPECT_NE(std::string(error.what()).find(fragment), std::string::npos)
        << error.what() << "\ndoes not say: " << fragment;
}

} // namespace calotype::test
