// JSON of any struct that declares its members by fields(), both ways. For the sources of `log`, for parts of records
// and for tests; whole records go through the functions of records.h, which are compiled once.
#pragma once

#include <cmath>
#include <type_traits>

#include <fmt/format.h>

#include "continua/core/result.h"
#include "continua/replay/log/fields.h"

namespace continua::log {

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

template <class T>
inline constexpr bool is_or_null = false;
template <class T>
inline constexpr bool is_or_null<OrNull<T>> = true;
template <>
inline constexpr bool is_or_null<Margin> = true;

template <class T>
inline constexpr bool is_named = false;
template <class T>
inline constexpr bool is_named<Named<T>> = true;

template <class T>
inline constexpr bool is_list = false;
template <class T>
inline constexpr bool is_list<std::vector<T>> = !is_named<std::vector<T>>;

template <class T>
inline constexpr bool is_array = false;
template <class T, std::size_t size>
inline constexpr bool is_array<std::array<T, size>> = true;

template <class T>
struct InnermostOf {
  using type = T;
};
template <class T>
requires(is_optional<T> || is_or_null<T> || is_list<T> || is_array<T>) struct InnermostOf<T>
    : InnermostOf<typename T::value_type> {
};
template <class T>
requires is_named<T>
struct InnermostOf<T> : InnermostOf<typename T::value_type::second_type> {
};

/// The type of the values in lists, objects named by data, and optional values, however deep.
template <class T>
using Innermost = typename InnermostOf<T>::type;

// The work on each of some three hundred members, compiled once.
void put(Json::object_t& object, std::string_view name, Json value);
const Json* find_member(const Json& object, std::string_view name);

/// An error about a value.
Error unexpected(std::string_view expected, const Json& found);

/// The same error, told from one level further out.
Outcome within_member(std::string_view name, Outcome problem);
Outcome within_element(std::size_t index, Outcome problem);

template <class T>
Json to_json(const T& value) {
  if constexpr (HasFields<T>) {
    Json::object_t object;
    for_each_field<T>([&](const auto& field) {
      const auto& member = value.*(field.member);
      if constexpr (is_optional<std::decay_t<decltype(member)>>) {
        if (member) put(object, field.name, to_json(*member));
      } else {
        put(object, field.name, to_json(member));
      }
    });
    return Json(std::move(object));
  } else if constexpr (is_or_null<T>) {
    return value ? to_json(*value) : Json(nullptr);
  } else if constexpr (is_named<T>) {
    Json::object_t object;
    for (const auto& [name, member] : value) object.emplace_back(name, to_json(member));
    return Json(std::move(object));
  } else if constexpr (is_list<T> || is_array<T>) {
    Json::array_t array;
    for (const auto& element : value) array.push_back(to_json(element));
    return Json(std::move(array));
  } else if constexpr (std::is_same_v<T, JsonText>) {
    return Json::parse(value.text);
  } else {
    return Json(value);
  }
}

template <class T>
Outcome read_value(const Json& json, T& value);

template <class T>
Outcome read_number(const Json& json, T& value) {
  if constexpr (std::is_floating_point_v<T>) {
    if (!json.is_number()) return unexpected("a number", json);
  } else if constexpr (std::is_unsigned_v<T>) {
    if (!json.is_number_unsigned()) return unexpected("a whole number from 0", json);
  } else if (!json.is_number_integer()) {
    return unexpected("a whole number", json);
  }
  value = json.get<T>();
  return std::nullopt;
}

template <HasFields T>
Outcome read_members(const Json& json, T& value) {
  if (!json.is_object()) return unexpected("an object", json);
  Outcome problem;
  for_each_field<T>([&](const auto& field) {
    if (problem) return;
    if (const auto* found = find_member(json, field.name))
      problem = within_member(field.name, read_value(*found, value.*(field.member)));
  });
  return problem;
}

template <class List>
Outcome read_elements(const Json& json, List& list) {
  if (!json.is_array()) return unexpected("a list", json);
  if constexpr (is_array<List>) {
    if (json.size() != list.size()) return unexpected(fmt::format("a list of {} elements", list.size()), json);
  } else {
    list.assign(json.size(), {});
  }
  for (std::size_t i = 0; i < json.size(); ++i) {
    typename List::value_type element{};
    if (auto problem = read_value(json[i], element)) return within_element(i, std::move(problem));
    list[i] = std::move(element);
  }
  return std::nullopt;
}

template <class T>
Outcome read_value(const Json& json, T& value) {
  if constexpr (HasFields<T>) {
    return read_members(json, value);
  } else if constexpr (is_optional<T> || is_or_null<T>) {
    if constexpr (!is_optional<T> || !is_or_null<std::decay_t<decltype(*value)>>) {
      if (json.is_null()) {
        value.reset();
        return std::nullopt;
      }
    }
    return read_value(json, value.emplace());
  } else if constexpr (is_named<T>) {
    if (!json.is_object()) return unexpected("an object", json);
    value.clear();
    for (const auto& [name, member] : json.items()) {
      value.emplace_back(name, typename T::value_type::second_type{});
      if (auto problem = read_value(member, value.back().second)) return within_member(name, std::move(problem));
    }
    return std::nullopt;
  } else if constexpr (is_list<T> || is_array<T>) {
    return read_elements(json, value);
  } else if constexpr (std::is_same_v<T, std::string>) {
    if (!json.is_string()) return unexpected("text", json);
    value = json.get_ref<const std::string&>();
    return std::nullopt;
  } else if constexpr (std::is_same_v<T, bool>) {
    if (!json.is_boolean()) return unexpected("true or false", json);
    value = json.get<bool>();
    return std::nullopt;
  } else if constexpr (std::is_same_v<T, Json>) {
    value = json;
    return std::nullopt;
  } else if constexpr (std::is_same_v<T, JsonText>) {
    value.text = compact(json);
    return std::nullopt;
  } else {
    return read_number(json, value);
  }
}

/// Calls `use(margin)` for each Margin in the value, however deep.
template <class T, class Use>
void for_each_margin(const T& value, const Use& use) {
  if constexpr (std::is_same_v<T, Margin>) {
    use(value);
  } else if constexpr (HasFields<T>) {
    for_each_field<T>([&](const auto& field) { for_each_margin(value.*(field.member), use); });
  } else if constexpr (is_optional<T> || is_or_null<T>) {
    if (value) for_each_margin(*value, use);
  } else if constexpr (is_list<T>) {
    for (const auto& element : value) for_each_margin(element, use);
  }
}

}  // namespace continua::log
