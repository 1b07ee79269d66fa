#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace calotype {

/// Base of every error that the user can cause or meet. `what()` is one complete sentence.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The command line asks for something that makes no sense.
class UsageError : public Error {
public:
    using Error::Error;
};

/// A scene, or a file that it names, is wrong. `where` is a file with line and column, or a file
/// with a JSON pointer; `what()` reads "where: message".
class SceneError : public Error {
public:
    SceneError(std::string where, const std::string& message)
        : Error(where + ": " + message), where_(std::move(where)) {}

    const std::string& where() const { return where_; }

private:
    std::string where_;
};

/// The device or its driver cannot do what is asked.
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
