// Reads the answer of /api/runs/ID/columns (replay/inspector/run_columns.h).
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "continua/core/located_json.h"

namespace continua {

struct Columns {
  explicit Columns(const std::string& answer) {
    std::uint32_t size = 0;
    std::memcpy(&size, answer.data(), sizeof size);
    header = Json::parse(answer.substr(sizeof size, size));
    bytes = answer.substr((sizeof size + size + 7) / 8 * 8);
  }

  std::vector<double> numbers(const std::string& name) const {
    const auto& column = header["columns"].at(name);
    const std::string type = column["type"];
    if (type == "f64") return read<double>(column);
    if (type == "f32") return read<float>(column);
    if (type == "i32") return read<std::int32_t>(column);
    if (type == "u16") return read<std::uint16_t>(column);
    return read<std::uint32_t>(column);
  }
  std::vector<std::string> names(const std::string& name) const {
    std::vector<std::string> found;
    for (const auto number : numbers(name)) found.push_back(header["names"].at(static_cast<std::size_t>(number)));
    return found;
  }

  Json header;

 private:
  template <class T>
  std::vector<double> read(const Json& column) const {
    std::vector<T> values(column["length"].get<std::size_t>());
    const auto offset = column["offset"].get<std::size_t>();
    if (offset % 8 != 0 || offset + values.size() * sizeof(T) > bytes.size()) return {-1e9};
    if (!values.empty()) std::memcpy(values.data(), bytes.data() + offset, values.size() * sizeof(T));
    return {values.begin(), values.end()};
  }

  std::string bytes;
};

}  // namespace continua
