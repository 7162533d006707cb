#include "continua/replay/commands/instant_option.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/replay/log/time_text.h"

namespace continua {

CLI::Option* takes_instants(CLI::Option* option) {
  return option->type_name("SECONDS|M:SS")->transform([](const std::string& text) {
    const auto seconds = seconds_of(text);
    return seconds ? fmt::format("{}", *seconds) : text;
  });
}

}  // namespace continua
