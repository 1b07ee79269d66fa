#pragma once

#include <string>

namespace calotype {

/// The version, and the commit that was built if that is known: "0.1.0 (commit 844ccc3)".
std::string versionText();

} // namespace calotype
