#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace calotype {

/// Base of all errors that a user can cause or get. `what()` is one complete sentence.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The caller or the command line requests something invalid.
class UsageError : public Error {
public:
    using Error::Error;
};

/// A setting of a render is out of its range, or does not fit the others or the scene. `setting` is
/// its name, such as "max_bounces"; `what()` reads "max_bounces is 7, ...".
class SettingError : public UsageError {
public:
    SettingError(std::string setting, std::string problem)
        : UsageError(setting + " " + problem), setting_(std::move(setting)),
          problem_(std::move(problem)) {}

    const std::string& setting() const { return setting_; }
    const std::string& problem() const { return problem_; }

private:
    std::string setting_;
    std::string problem_;
};

/// The caller stopped the work before there was any result.
class Interrupted : public Error {
public:
    Interrupted() : Error("interrupted before the first sample; nothing was written") {}
};

/// A scene, or a file that it names, is invalid. `where` is a file with line and column, or a file
/// with a JSON pointer; `what()` reads "where: message".
class SceneError : public Error {
public:
    SceneError(std::string where, const std::string& message)
        : Error(where + ": " + message), where_(std::move(where)) {}

    const std::string& where() const { return where_; }

private:
    std::string where_;
};

/// The device or its driver does not support something, or fails.
class GpuError : public Error {
public:
    using Error::Error;
};

/// A result cannot be written.
class OutputError : public Error {
public:
    using Error::Error;
};

} // namespace calotype
