#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace calotype::test {

/// How a run of build/calotype ended.
struct ProgramResult {
    int exitCode = -1;  ///< 128 + n if signal n killed it
    std::string output; ///< standard output
    std::string errors; ///< standard error
    double seconds = 0.0;
};

struct ProgramOptions {
    std::map<std::string, std::string> environment; ///< in addition to this process's
    std::optional<std::string> input; ///< of standard input, at most 64 KiB; not for a terminal
    bool onTerminal = false; ///< standard error and output go to a pseudo-terminal, into `errors`
    uint16_t columns = 0;    ///< of the pseudo-terminal; 0: it does not say
    std::vector<int> ignoredSignals = {}; ///< at the program's start, as by nohup
    std::vector<int> closedStreams = {};  ///< numbers of standard streams
    /// Called about every 20 ms with the process's id and its age until it has ended.
    std::function<void(int pid, double seconds)> whileRunning;
};

/// Runs the program with these arguments.
ProgramResult runProgram(const std::vector<std::string>& arguments,
                         const ProgramOptions& options = {});

/// A folder of its own for a test's files, removed with all its contents.
class TestFolder {
public:
    TestFolder();
    ~TestFolder();
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    std::filesystem::path path() const { return path_; }

    /// Writes a file and returns its path.
    std::string write(const std::string& name, const std::string& text) const;

    std::vector<std::string> names() const; ///< of the files in it, sorted

private:
    std::filesystem::path path_;
};

std::string readText(const std::string& path);

} // namespace calotype::test
