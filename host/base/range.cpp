#include "base/range.h"

#include <cmath>
#include <sstream>

namespace calotype {

std::string toText(const Range& range) {
    std::ostringstream text;
    const bool hasLow = std::isfinite(range.low);
    const bool hasHigh = std::isfinite(range.high);
    if (!hasLow && !hasHigh)
        text << "a finite number";
    else if (!hasHigh)
        range.isLowOpen ? text << "greater than " << range.low : text << range.low << " or greater";
    else if (range.isLowOpen && range.isHighOpen)
        text << "between " << range.low << " and " << range.high << ", both excluded";
    else if (range.isLowOpen)
        text << "greater than " << range.low << " and at most " << range.high;
    else
        text << "in [" << range.low << ", " << range.high << "]";
    return text.str();
}

} // namespace calotype
