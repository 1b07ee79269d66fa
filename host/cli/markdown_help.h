#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace calotype {

/// The help of a program and its commands as one page of Markdown: docs/command-line.md.
std::string markdownHelp(CLI::App& app);

} // namespace calotype
