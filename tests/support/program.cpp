#include "support/program.h"
#include "support/paths.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <pty.h>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace calotype::test {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void executeChild(const std::vector<std::string>& arguments,
                               const ProgramOptions& options) {
    for (const auto& [name, value] : options.environment)
        setenv(name.c_str(), value.c_str(), 1);
    // Whatever started the tests may ignore some, as a shell does in the background.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1, SIGUSR2})
        std::signal(signal, SIG_DFL);
    for (const int signal : options.ignoredSignals)
        std::signal(signal, SIG_IGN);
    for (const int stream : options.closedStreams)
        close(stream);
    std::vector<char*> argv = {const_cast<char*>(kProgram)};
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    execv(kProgram, argv.data());
    _exit(127);
}

/// Appends what can be read at once. False at the end.
bool drain(int fd, std::string& text) {
    char buffer[4096];
    const ssize_t n = read(fd, buffer, sizeof buffer);
    if (n > 0)
        text.append(buffer, static_cast<size_t>(n));
    return n > 0;
}

/// The end to read from of a pipe that holds all of the text.
int inputPipe(const std::string& text) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0 ||
        write(ends[1], text.data(), text.size()) != static_cast<ssize_t>(text.size()))
        throw std::runtime_error("cannot fill a pipe");
    close(ends[1]);
    return ends[0];
}

struct Child {
    int pid = -1;
    int outputFd = -1;
    int errorFd = -1;
};

Child start(const std::vector<std::string>& arguments, const ProgramOptions& options) {
    Child child;
    if (options.onTerminal) {
        const winsize size{.ws_row = 24, .ws_col = options.columns, .ws_xpixel = 0, .ws_ypixel = 0};
        child.pid = forkpty(&child.errorFd, nullptr, nullptr, &size);
        if (child.pid == 0)
            executeChild(arguments, options);
        return child;
    }
    int out[2];
    int err[2];
    if (pipe2(out, O_CLOEXEC) != 0 || pipe2(err, O_CLOEXEC) != 0)
        throw std::runtime_error("pipe2 failed");
    const int input = options.input ? inputPipe(*options.input) : -1;
    child.pid = fork();
    if (child.pid == 0) {
        if (input >= 0)
            dup2(input, STDIN_FILENO);
        dup2(out[1], STDOUT_FILENO);
        dup2(err[1], STDERR_FILENO);
        executeChild(arguments, options);
    }
    if (input >= 0)
        close(input);
    close(out[1]);
    close(err[1]);
    child.outputFd = out[0];
    child.errorFd = err[0];
    return child;
}

} // namespace

ProgramResult runProgram(const std::vector<std::string>& arguments, const ProgramOptions& options) {
    ProgramResult result;
    const Clock::time_point begin = Clock::now();
    const Child child = start(arguments, options);
    const auto age = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    pollfd fds[2] = {{child.outputFd, POLLIN, 0}, {child.errorFd, POLLIN, 0}};
    while (fds[0].fd >= 0 || fds[1].fd >= 0) {
        poll(fds, 2, 20);
        if (fds[0].fd >= 0 && fds[0].revents != 0 && !drain(fds[0].fd, result.output))
            fds[0].fd = -1;
        if (fds[1].fd >= 0 && fds[1].revents != 0 && !drain(fds[1].fd, result.errors))
            fds[1].fd = -1;
        if (options.whileRunning)
            options.whileRunning(child.pid, age());
    }
    int status = 0;
    waitpid(child.pid, &status, 0);
    result.seconds = age();
    result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    for (const int fd : {child.outputFd, child.errorFd})
        if (fd >= 0)
            close(fd);
    return result;
}

TestFolder::TestFolder() {
    std::string pattern =
        (std::filesystem::temp_directory_path() / "calotype-test-XXXXXX").string();
    if (!mkdtemp(pattern.data()))
        throw std::runtime_error("mkdtemp failed");
    path_ = pattern;
}

TestFolder::~TestFolder() { std::filesystem::remove_all(path_); }

std::string TestFolder::write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return *this / name;
}

std::vector<std::string> TestFolder::names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
        names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

std::string readText(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

} // namespace calotype::test
