// The names of an enum's values: one table for printing and for reading.
//
//   constexpr NamedValue<Light> lights[] = {{Light::red, "red"}, {Light::green, "green"}};
//   std::string name_of(Light light) { return name_in(lights, light); }
//   std::optional<Light> light_named(std::string_view name) { return value_in(lights, name); }
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace continua {

template <class Enum>
struct NamedValue {
  Enum value;
  std::string_view name;
};

/// The name of `value`; empty if the table lacks the value.
template <class Enum, std::size_t count>
std::string name_in(const NamedValue<Enum> (&table)[count], Enum value) {
  for (const auto& row : table)
    if (row.value == value) return std::string(row.name);
  return {};
}

/// The value with this name; nothing if the table lacks the name.
template <class Enum, std::size_t count>
std::optional<Enum> value_in(const NamedValue<Enum> (&table)[count], std::string_view name) {
  for (const auto& row : table)
    if (row.name == name) return row.value;
  return std::nullopt;
}

/// All names, in the order of the table.
template <class Enum, std::size_t count>
std::vector<std::string> names_in(const NamedValue<Enum> (&table)[count]) {
  std::vector<std::string> names;
  for (const auto& row : table) names.emplace_back(row.name);
  return names;
}

}  // namespace continua
