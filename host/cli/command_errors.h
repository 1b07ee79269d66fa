#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace calotype {

/// The sentence for a command line that `app` could not parse: what is wrong, the nearest command
/// or option if a name is misspelt, and the help to read.
std::string sentenceOf(const CLI::App& app, const CLI::ParseError& error);

/// The sentence for a command that does not exist.
std::string unknownCommandSentence(const CLI::App& app, const std::string& name);

/// The sentence for a command line without a command.
std::string noCommandSentence();

} // namespace calotype
