#pragma once

#include <string>

namespace calotype {

/// "1.25 M", "830", "12.1 k": three digits and a prefix.
std::string withPrefix(double number);

/// "0.25", "1e-09": as many digits as needed, at most `digits`.
std::string shortNumber(double number, int digits = 6);

/// "1.93 %": a relative error.
std::string percentText(double share);

/// "2 %": a target of a user, with as many digits as needed.
std::string targetText(double share);

/// "0.8 s", "12 s", "3:05" or "2:04:10".
std::string durationText(double seconds);

} // namespace calotype
