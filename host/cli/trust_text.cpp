#include "cli/trust_text.h"

namespace calotype {

std::string trustText(const ErrorEstimate& error) {
    switch (error.trust()) {
    case Trust::TooFewSamples:
        return " (too few samples to tell)";
    case Trust::RareLight:
        return " (not to be trusted)";
    case Trust::Trusted:
        break;
    }
    return "";
}

} // namespace calotype
