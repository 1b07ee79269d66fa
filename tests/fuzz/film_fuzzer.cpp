// The input is a film without a checksum: the right one is put in, so that what it guards is
// reached.

#include <optional>

#include "base/check.h"
#include "base/content_hash.h"
#include "film/error_estimate.h"
#include "film/film_file.h"
#include "harness.h"
#include "scratch_folder.h"

namespace calotype::fuzz {
namespace {

constexpr size_t kChecksumAt = 16;
constexpr size_t kContentsAt = 24;

std::string withChecksum(std::string_view text) {
    std::string film(text);
    if (film.size() < kContentsAt)
        return film;
    ContentHash hash;
    hash.add(text.substr(kContentsAt));
    for (size_t i = 0; i < sizeof hash.value(); ++i)
        film[kChecksumAt + i] = static_cast<char>(hash.value() >> 8 * i);
    return film;
}

/// What was read is a film: its picture can be made, and written it is the same again.
void checkFilm(const KeptFilm& kept, const ScratchFolder& folder) {
    const Film& film = kept.film;
    CALOTYPE_CHECK_EQ(film.picture().pixels.size(), film.pixelCount());
    (void)estimateError(film);
    const std::string path = folder.write("again", "");
    writeFilm(path, kept.label, film, kept.features);
    const KeptFilm again = readFilm(path);
    CALOTYPE_CHECK_EQ(again.features.has_value(), kept.features.has_value());
    CALOTYPE_CHECK_EQ(again.film.width(), film.width());
    CALOTYPE_CHECK_EQ(again.film.height(), film.height());
    CALOTYPE_CHECK_EQ(again.film.unit(), film.unit());
    CALOTYPE_CHECK_EQ(again.film.sums() == film.sums(), true);
    CALOTYPE_CHECK_EQ(again.label.sceneHash, kept.label.sceneHash);
    CALOTYPE_CHECK_EQ(again.label.settings == kept.label.settings, true);
    CALOTYPE_CHECK_EQ(again.label.devices == kept.label.devices, true);
}

} // namespace
} // namespace calotype::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace calotype::fuzz;
    static const ScratchFolder folder;
    const std::string path = folder.write("film", withChecksum(textOf(data, size)));
    std::optional<calotype::KeptFilm> kept;
    readOrRefuse([&] { kept = calotype::readFilm(path); });
    if (kept)
        checkFilm(*kept, folder);
    return 0;
}
