#include "image/hdr_header.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "base/error.h"

namespace calotype {
namespace {

using namespace std::string_view_literals;

/// x and y of red, green, blue and white: of Rec. 709 and, of Radiance, the default.
constexpr std::array<std::array<double, 8>, 2> kKnownPrimaries = {
    {{0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290},
     {0.64, 0.33, 0.29, 0.60, 0.15, 0.06, 0.3333, 0.3333}}};
constexpr double kSamePrimary = 0.005; // files have two or three digits

std::optional<double> numberOf(std::string_view text) {
    if (text.starts_with('+'))
        text.remove_prefix(1);
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool isNumber = error == std::errc() && end == text.data() + text.size();
    return isNumber ? std::optional(number) : std::nullopt;
}

/// The numbers of a text, separated by blanks; empty if anything else is in it.
std::vector<double> numbersIn(std::string_view text) {
    constexpr auto kBlanks = " \t"sv;
    std::vector<double> numbers;
    for (size_t at = text.find_first_not_of(kBlanks); at != std::string_view::npos;
         at = text.find_first_not_of(kBlanks, at)) {
        const size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
        const std::optional<double> number = numberOf(text.substr(at, end - at));
        if (!number)
            return {};
        numbers.push_back(*number);
        at = end;
    }
    return numbers;
}

class HeaderReader {
public:
    HeaderReader(std::string_view& file, const std::string& where) : rest_(file), where_(where) {}

    HdrHeader read() {
        for (std::string_view text = line(); !text.empty(); text = line())
            readVariable(text);
        readSize(line());
        return header_;
    }

private:
    [[noreturn]] void fail(const std::string& message) const {
        throw SceneError(where_, "the HDR picture " + message);
    }

    std::string_view line() {
        const size_t end = rest_.find('\n');
        if (end == std::string_view::npos)
            fail("is incomplete: its end is missing");
        std::string_view result = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        if (result.ends_with('\r'))
            result.remove_suffix(1);
        return result;
    }

    void readVariable(std::string_view text) {
        const size_t equals = text.find('=');
        if (equals == std::string_view::npos)
            return;
        const std::string_view name = text.substr(0, equals);
        const std::string_view value = text.substr(equals + 1);
        if (name == "FORMAT")
            requireRgbe(value);
        else if (name == "EXPOSURE" || name == "COLORCORR")
            readCorrection(name, value);
        else if (name == "PRIMARIES")
            requireRec709(value);
        else if (name == "GAMMA" && numbersIn(value) != std::vector{1.0})
            fail("has a GAMMA that is not 1, which cannot be read; save it without");
    }

    void requireRgbe(std::string_view format) const {
        const size_t start = format.find_first_not_of(" \t");
        if (start == std::string_view::npos || !format.substr(start).starts_with("32-bit_rle_rgbe"))
            fail("holds XYZ or unknown colours, which cannot be read; convert it to RGBE");
    }

    void readCorrection(std::string_view name, std::string_view value) {
        std::vector<double> factors = numbersIn(value);
        if (name == "EXPOSURE" && factors.size() == 1)
            factors.resize(3, factors.front());
        if (factors.size() != 3 ||
            !std::ranges::all_of(factors, [](double f) { return f > 0.0 && std::isfinite(f); }))
            fail("has an " + std::string(name) + " that is not " +
                 (name == "EXPOSURE" ? "a positive number" : "three positive numbers"));
        for (size_t i = 0; i < 3; ++i)
            header_.correction[i] *= factors[i];
    }

    void requireRec709(std::string_view value) const {
        const std::vector<double> primaries = numbersIn(value);
        const auto isNear = [&](const auto& known) {
            return std::ranges::equal(primaries, known, [](double a, double b) {
                return std::abs(a - b) <= kSamePrimary;
            });
        };
        // Photoshop writes zeros.
        const bool isStated = std::ranges::any_of(primaries, [](double x) { return x != 0.0; });
        if (primaries.empty() || (isStated && !std::ranges::any_of(kKnownPrimaries, isNear)))
            fail("has PRIMARIES other than those of Rec. 709, which cannot be read; convert it");
    }

    /// An axis such as "-Y 480", from the first to the last pixel along it.
    struct Axis {
        bool isX = false;
        bool isNegative = false;
        uint32_t length = 0;
    };

    Axis readAxis(std::string_view& text) const {
        const bool isAxis = text.size() > 2 && (text[0] == '-' || text[0] == '+') &&
                            (text[1] == 'X' || text[1] == 'Y') && text[2] == ' ';
        if (!isAxis)
            fail("has no valid size such as \"-Y 480 +X 640\"");
        Axis axis{text[1] == 'X', text[0] == '-', 0};
        text.remove_prefix(3);
        const size_t end = std::min(text.find(' '), text.size());
        const std::optional<double> length = numberOf(text.substr(0, end));
        if (!length || !(*length >= 0.0 && *length <= 0xffffffffu) ||
            *length != std::floor(*length))
            fail("has no valid size");
        axis.length = static_cast<uint32_t>(*length);
        text.remove_prefix(std::min(text.size(), end + 1));
        return axis;
    }

    void readSize(std::string_view text) {
        const Axis slow = readAxis(text);
        const Axis fast = readAxis(text);
        if (slow.isX == fast.isX)
            fail("has no valid size: one axis is stated twice");
        const Axis& x = slow.isX ? slow : fast;
        const Axis& y = slow.isX ? fast : slow;
        header_.size = {x.length, y.length};
        header_.storesColumns = slow.isX;
        header_.startsRight = x.isNegative;
        header_.startsAtBottom = !y.isNegative;
    }

    std::string_view& rest_;
    const std::string& where_;
    HdrHeader header_;
};

} // namespace

HdrHeader readHdrHeader(std::string_view& file, const std::string& where) {
    return HeaderReader(file, where).read();
}

} // namespace calotype
