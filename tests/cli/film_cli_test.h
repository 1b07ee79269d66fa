#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/cli_test.h"
#include "film/film_file.h"

namespace calotype::test {

/// Renders the small scene to films.
class FilmTest : public CliTest {
protected:
    /// Arguments of a render with these at the end.
    std::vector<std::string> render(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments = {"render", scene_, "-q"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }

    /// Renders a film with these options, which must succeed. Returns its path.
    std::string film(const std::string& name, const std::vector<std::string>& more) const {
        std::vector<std::string> arguments = render(more);
        arguments.insert(arguments.end(), {"--film", folder_ / name});
        const ProgramResult result = runProgram(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.errors;
        EXPECT_EQ(result.errors, "");
        return folder_ / name;
    }

    void expectSameFilm(const std::string& a, const std::string& b) const {
        EXPECT_TRUE(readText(a) == readText(b)) << a << " and " << b;
    }
};

} // namespace calotype::test
