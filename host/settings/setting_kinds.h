#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "settings/settings_table.h"
#include "settings/value_text.h"

/// The usual kinds of settings: each function adds to a row how its value is read and printed.
/// `field` returns a reference to the value in RenderSettings, const or not.
namespace calotype {

/// As many digits as are needed to read the same number back.
template <typename T>
std::string shortestText(T number) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return {text.data(), end};
}

template <typename T>
nlohmann::ordered_json orNull(const std::optional<T>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

/// A whole number.
template <typename Field>
Setting wholeNumber(Setting row, uint32_t least, uint32_t most, Field field) {
    row.type = "N";
    row.expected = "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
    row.read = [=](std::string_view text, RenderSettings& settings) {
        const auto number = parseNumber<uint32_t>(text);
        const bool isValid = number && *number >= least && *number <= most;
        if (isValid)
            field(settings) = *number;
        return isValid;
    };
    row.print = [=](const RenderSettings& settings) { return std::to_string(field(settings)); };
    row.value = [=](const RenderSettings& settings) {
        return nlohmann::ordered_json(field(settings));
    };
    row.fault = [=](const RenderSettings& settings) -> std::string {
        const uint32_t number = field(settings);
        if (number >= least && number <= most)
            return "";
        return "is " + std::to_string(number) + ", and not from " + std::to_string(least) + " to " +
               std::to_string(most);
    };
    return row;
}

/// A switch: "on" or "off".
template <typename Field>
Setting onOff(Setting row, Field field) {
    row.type = "on|off";
    row.expected = "on or off";
    row.read = [=](std::string_view text, RenderSettings& settings) {
        field(settings) = text == "on";
        return text == "on" || text == "off";
    };
    row.print = [=](const RenderSettings& settings) { return field(settings) ? "on" : "off"; };
    row.value = [=](const RenderSettings& settings) {
        return nlohmann::ordered_json(bool(field(settings)));
    };
    return row;
}

/// An option without a value.
template <typename Field>
Setting flag(Setting row, Field field) {
    row = onOff(std::move(row), field);
    row.type.clear();
    return row;
}

template <typename T>
struct Named {
    const char* name;
    T value;

    /// Also of the same value where there may be none.
    constexpr operator Named<std::optional<T>>() const { return {name, value}; }
};

/// The value of an enum, with the name that its own header gives it.
template <typename T>
constexpr Named<T> named(T value) {
    return {nameOf(value), value};
}

/// One of several names.
template <typename T, size_t kCount, typename Field>
Setting choice(Setting row, const Named<T> (&choices)[kCount], Field field) {
    const std::vector<Named<T>> all(choices, choices + kCount);
    for (size_t i = 0; i < kCount; ++i) {
        row.type += (i > 0 ? "|" : "") + std::string(all[i].name);
        row.expected += (i == 0 ? "" : i + 1 < kCount ? ", " : " or ") + std::string(all[i].name);
    }
    row.read = [=](std::string_view text, RenderSettings& settings) {
        for (const Named<T>& one : all)
            if (text == one.name) {
                field(settings) = one.value;
                return true;
            }
        return false;
    };
    row.print = [=](const RenderSettings& settings) -> std::string {
        for (const Named<T>& one : all)
            if (field(settings) == one.value)
                return one.name;
        return "";
    };
    row.value = [print = row.print](const RenderSettings& settings) {
        return nlohmann::ordered_json(print(settings));
    };
    return row;
}

} // namespace calotype
