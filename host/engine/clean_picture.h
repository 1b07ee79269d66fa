#pragma once

#include <optional>
#include <string>

#include "denoise/denoised_error.h"
#include "image/image.h"

namespace calotype {

/// A picture after denoising.
struct CleanPicture {
    Image color;
    std::string denoiser; ///< with its version
    std::optional<DenoisedError> error;
    std::string whyUnstated; ///< why there is no error, in words such as "too few samples to tell"
};

} // namespace calotype
