// Times for readers, in the one form that pages and commands have.
#pragma once

#include <string>

namespace continua {

/// An instant of a run: "0:05.05", "12:00"; to the millisecond, without zeros at its end.
std::string time_text(double seconds);

/// A length of time: "0.8 s".
std::string seconds_text(double seconds);

}  // namespace continua
