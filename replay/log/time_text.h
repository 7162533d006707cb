// Times for readers, in the one form that pages and commands have.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace continua {

/// An instant of a run: "0:05.05", "12:00"; to the millisecond, without zeros at its end.
std::string time_text(double seconds);

/// The seconds of an instant in that form; nothing where the text is not of it.
std::optional<double> seconds_of(std::string_view instant);

/// A length of time: "0.8 s".
std::string seconds_text(double seconds);

}  // namespace continua
