// Logged terms taken apart as text: a name with its arguments, and the parts around a joint.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace continua {

struct Applied {
  std::string_view name;
  std::vector<std::string_view> arguments;
};

/// A name with its arguments, or alone; nothing for other terms.
std::optional<Applied> applied(std::string_view term);

/// The parts of a term between joints, for example " and ", that no bracket encloses.
std::vector<std::string_view> parted(std::string_view term, std::string_view joint);

/// The term without the brackets around all of it.
std::string_view unbracketed(std::string_view term);

}  // namespace continua
