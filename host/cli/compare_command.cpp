#include "cli/commands.h"

#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/names.h"
#include "base/number_text.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/output_claims.h"
#include "cli/read_scene.h"
#include "engine/json_document.h"
#include "image/denoised_mark.h"
#include "image/difference.h"
#include "image/difference_picture.h"
#include "image/exr.h"
#include "image/exr_check.h"
#include "image/image_format.h"
#include "image/png.h"
#include "image/read_image.h"

namespace calotype {
namespace {

using Json = nlohmann::ordered_json;

/// Checks before reading everything that could prevent writing the picture.
OutputClaims checkDifferenceFile(const CompareOptions& options) {
    const std::string& path = options.differenceFile;
    if (imageFormatOf(path) != ImageFormat::Png)
        throw UsageError("--diff '" + path + "' is not a PNG; name it .png");
    OutputClaims claims;
    claims.reserve(options.a);
    claims.reserve(options.b);
    claims.claim(path);
    return claims;
}

/// One of the two pictures.
struct ComparedPicture {
    std::string path;
    Image image;
    std::optional<DenoisedMark> mark;

    explicit ComparedPicture(std::string file)
        : path(std::move(file)), image(readImage(path)), mark(readMark(path)) {
        throwIfInterrupted("interrupted; nothing was compared");
        if (isExr(signatureOf(path)) && hasOtherPrimaries(path))
            printWarning(path + " has other primaries (its attribute chromaticities) than those "
                                "of Rec. 709; its numbers are compared as they are");
    }
};

/// ", denoised by Open Image Denoise 2.5.1 (error 4.2 %, at most 4.8 %)"; empty if it is not.
std::string markText(const std::optional<DenoisedMark>& mark) {
    if (!mark)
        return "";
    std::string text = ", denoised by " + printable(mark->denoiser);
    if (mark->error)
        text += " (error " + percentText(*mark->error) +
                (mark->bound ? ", at most " + percentText(*mark->bound) : "") + ")";
    return text;
}

void printPicture(const char* label, const ComparedPicture& picture, uint64_t infinite) {
    std::printf("%-13s %s, %u x %u pixels, %" PRIu64 " infinite%s\n", label, picture.path.c_str(),
                picture.image.width, picture.image.height, infinite,
                markText(picture.mark).c_str());
}

void printLargest(const LargestDifference& largest, const Image& a, const Image& b) {
    if (largest.magnitude == 0.0) {
        std::printf("largest       0\n");
        return;
    }
    const glm::vec3& pixelA = a.at(largest.x, largest.y);
    const glm::vec3& pixelB = b.at(largest.x, largest.y);
    // Nine digits distinguish any two floats.
    std::printf("largest       %.6g in %c at (%u, %u) from the top left: A (%.9g, %.9g, %.9g), "
                "B (%.9g, %.9g, %.9g)\n",
                largest.magnitude, "RGB"[largest.channel], largest.x, largest.y, pixelA.r, pixelA.g,
                pixelA.b, pixelB.r, pixelB.g, pixelB.b);
}

void printErrors(const ImageDifference& difference) {
    const glm::dvec3& mean = difference.meanError;
    std::printf("mean error    %.6g (R %.6g, G %.6g, B %.6g), of A - B\n",
                (mean.r + mean.g + mean.b) / 3.0, mean.r, mean.g, mean.b);
    std::printf("RMSE          %.6g\n", difference.rmse);
    std::printf("relative MSE  %.6g, the mean of (A - B)^2 / (B^2 + 0.01)\n",
                difference.relativeMse);
    std::printf("PSNR          %.6g dB, for a peak of %.6g, the largest value of B\n",
                difference.psnr(), difference.peak);
}

/// JSON has no infinity: null.
Json finiteOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json numberOrNull(const std::optional<double>& value) {
    return value ? finiteOrNull(*value) : Json();
}

Json toJson(const ComparedPicture& picture, uint64_t infinite) {
    const std::optional<DenoisedMark>& mark = picture.mark;
    return {{"file", picture.path},
            {"resolution", {picture.image.width, picture.image.height}},
            {"infinite_pixels", infinite},
            {"denoiser", mark ? Json(mark->denoiser) : Json()},
            {"denoised_error", mark ? numberOrNull(mark->error) : Json()},
            {"denoised_bound", mark ? numberOrNull(mark->bound) : Json()}};
}

void printJson(const ComparedPicture& a, const ComparedPicture& b,
               const ImageDifference& difference) {
    const glm::dvec3& mean = difference.meanError;
    const LargestDifference& largest = difference.largest;
    Json json = newJsonDocument();
    json["a"] = toJson(a, difference.infiniteInA);
    json["b"] = toJson(b, difference.infiniteInB);
    json["mean_error"] = {mean.r, mean.g, mean.b};
    json["rmse"] = difference.rmse;
    json["relative_mse"] = difference.relativeMse;
    json["psnr"] = finiteOrNull(difference.psnr());
    json["peak"] = difference.peak;
    json["largest"] = {{"difference", largest.magnitude},
                       {"x", largest.x},
                       {"y", largest.y},
                       {"channel", largest.channel}};
    json["left_out_pixels"] = difference.leftOut;
    std::fputs(jsonText(json).c_str(), stdout);
}

void print(const ComparedPicture& a, const ComparedPicture& b, const ImageDifference& difference) {
    printPicture("A", a, difference.infiniteInA);
    printPicture("B", b, difference.infiniteInB);
    printErrors(difference);
    printLargest(difference.largest, a.image, b.image);
    if (difference.leftOut > 0)
        std::printf("left out      %" PRIu64 " of %zu pixels, infinite in A or B\n",
                    difference.leftOut, a.image.pixels.size());
}

/// Whether A is near enough to B; if not, prints the reason on standard error.
bool isWithin(double maxRelativeMse, const ImageDifference& difference) {
    if (difference.relativeMse > maxRelativeMse)
        std::fprintf(stderr, "calotype: the relative MSE of %.9g exceeds --max-relmse %.9g\n",
                     difference.relativeMse, maxRelativeMse);
    else if (difference.infiniteInOne() > 0)
        std::fprintf(stderr,
                     "calotype: pixels that are infinite in A or B only (%" PRIu64
                     ") exceed any --max-relmse\n",
                     difference.infiniteInOne());
    else
        return true;
    return false;
}

} // namespace

int compareCommand(const CompareOptions& options) {
    const bool isDrawn = !options.differenceFile.empty();
    catchInterrupts();
    OutputClaims claims;
    if (isDrawn)
        claims = checkDifferenceFile(options);
    const ComparedPicture a(options.a);
    const ComparedPicture b(options.b);
    requireComparable(a.image, a.path, b.image, b.path);
    const ImageDifference difference = measureDifference(a.image, b.image);
    (options.asJson ? printJson : print)(a, b, difference);
    if (isDrawn)
        writePng(options.differenceFile, differencePicture(a.image, b.image));
    const bool isNear = !options.maxRelativeMse || isWithin(*options.maxRelativeMse, difference);
    return isNear ? kExitDone : kExitDiffers;
}

} // namespace calotype
