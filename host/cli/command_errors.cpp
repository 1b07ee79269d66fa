#include "cli/command_errors.h"

#include <algorithm>
#include <vector>

#include "base/names.h"

namespace calotype {
namespace {

/// The command that was given, or the program itself.
const CLI::App& givenCommand(const CLI::App& app) {
    const std::vector<CLI::App*> commands = app.get_subcommands();
    return commands.empty() ? app : *commands.front();
}

std::string fullName(const CLI::App& command) {
    return command.get_parent() ? "calotype " + command.get_name() : command.get_name();
}

std::string helpOf(const CLI::App& command) { return " (see " + fullName(command) + " --help)"; }

std::string sentenceOfUnknownOption(const CLI::App& command, const std::string& text) {
    const std::string name = text.substr(0, text.find('='));
    if (name == "--frames")
        return "animations cannot be rendered yet; give each frame a scene file and a command of "
               "its own";
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& known : option->get_lnames())
            names.push_back("--" + known);
    const std::string nearest = nearestName(name, names);
    return fullName(command) + " has no option " + inQuotes(name) +
           (nearest.empty() ? "" : "; did you mean " + nearest + "?") + helpOf(command);
}

/// Words that are left over: the first option among them, since the others may be its values.
std::string sentenceOfExtras(const CLI::App& app) {
    const CLI::App& command = givenCommand(app);
    const std::vector<std::string> words = app.remaining(true);
    const auto option =
        std::ranges::find_if(words, [](const std::string& word) { return word.starts_with('-'); });
    if (option != words.end())
        return sentenceOfUnknownOption(command, *option);
    if (command.get_parent() == nullptr)
        return unknownCommandSentence(app, words.front());
    return fullName(command) + " takes no further argument " + inQuotes(words.front()) +
           helpOf(command);
}

} // namespace

std::string unknownCommandSentence(const CLI::App& app, const std::string& name) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({}))
        names.push_back(command->get_name());
    return "there is no command " + inQuotes(name) + suggestion(name, names) + helpOf(app);
}

std::string sentenceOf(const CLI::App& app, const CLI::ParseError& error) {
    if (dynamic_cast<const CLI::ExtrasError*>(&error) && !app.remaining(true).empty())
        return sentenceOfExtras(app);
    return error.what() + helpOf(givenCommand(app));
}

std::string noCommandSentence() {
    return "a command is required, such as: calotype render scenes/cornell-box.json -o box.png "
           "(see "
           "calotype --help)";
}

} // namespace calotype
