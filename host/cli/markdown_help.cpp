#include "cli/markdown_help.h"

#include <vector>

namespace calotype {
namespace {

/// Escapes bars and line breaks, which would end a table cell.
std::string cell(const std::string& text) {
    std::string escaped;
    for (const char c : text)
        escaped += c == '|' ? "\\|" : c == '\n' ? "<br>" : std::string(1, c);
    return escaped;
}

bool isPositional(const CLI::Option& option) { return option.get_positional(); }

std::string usageOf(const CLI::App& command) {
    std::string usage = "calotype " + command.get_name() + " [OPTIONS]";
    for (const CLI::Option* option : command.get_options())
        if (isPositional(*option)) {
            const bool isMany = option->get_expected_max() > 1;
            const std::string name = option->get_type_name() + (isMany ? "..." : "");
            usage += " " + (option->get_required() ? name : "[" + name + "]");
        }
    return usage;
}

std::string rowOf(const CLI::Option& option) {
    const std::string name =
        isPositional(option) ? option.get_type_name() : option.get_name(false, true);
    const std::string type = isPositional(option) ? "" : option.get_type_name();
    const std::string& value = option.get_default_str();
    return "| `" + name + (type.empty() ? "" : " " + cell(type)) + "` | " +
           cell(option.get_description()) + (value.empty() ? "" : " (default: " + value + ")") +
           " |\n";
}

/// Nothing if there is no footer.
std::string footerOf(const CLI::App& command) {
    return command.get_footer().empty() ? "" : "\n```\n" + command.get_footer() + "\n```\n";
}

std::string commandPage(const CLI::App& command) {
    std::string page = "\n## calotype " + command.get_name() + "\n\n" + command.get_description() +
                       ".\n\n```\n" + usageOf(command) + "\n```\n";
    for (const std::string& group : command.get_groups()) {
        if (group.empty())
            continue;
        page += "\n" + (group == "Options" ? std::string("General") : group) +
                ":\n\n| option | what it does |\n|---|---|\n";
        for (const CLI::Option* option : command.get_options())
            if (option->get_group() == group)
                page += rowOf(*option);
    }
    return page + footerOf(command);
}

} // namespace

std::string markdownHelp(CLI::App& app) {
    std::string page = "# The command line\n\n"
                       "This page is what `calotype --help-markdown` prints; `calotype COMMAND "
                       "--help` prints the same of one command.\n\n" +
                       app.get_description() + "\n" + footerOf(app);
    for (const CLI::App* command : app.get_subcommands({}))
        page += commandPage(*command);
    return page;
}

} // namespace calotype
