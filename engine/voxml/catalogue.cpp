#include "continua/voxml/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "continua/core/digest.h"
#include "continua/core/located_json.h"

namespace continua {
namespace fs = std::filesystem;

std::string_view name_of(Voxeme::Entity entity) {
  switch (entity) {
    case Voxeme::Entity::object:
      return "object";
    case Voxeme::Entity::program:
      return "program";
    case Voxeme::Entity::attribute:
      return "attribute";
    case Voxeme::Entity::relation:
      return "relation";
    case Voxeme::Entity::function:
      return "function";
  }
  return "";
}

std::vector<std::string> halves_of(const std::string& type) {
  constexpr std::string_view dot = "•";
  std::vector<std::string> halves;
  for (std::size_t from = 0; from <= type.size();) {
    const auto end = std::min(type.find(dot, from), type.size());
    halves.push_back(type.substr(from, end - from));
    from = end + dot.size();
  }
  return halves;
}

void Catalogue::add(Voxeme voxeme) {
  auto key = std::pair(voxeme.entity, voxeme.predicate);
  voxemes_.insert_or_assign(std::move(key), std::move(voxeme));
}

const Voxeme* Catalogue::find(Voxeme::Entity entity, std::string_view predicate) const {
  const auto found = voxemes_.find({entity, std::string(predicate)});
  return found == voxemes_.end() ? nullptr : &found->second;
}

const Voxeme* Catalogue::for_object(std::string_view name, std::string_view type) const {
  const auto* own = find(Voxeme::Entity::object, name);
  return own ? own : find(Voxeme::Entity::object, type);
}

ReadCatalogue read_catalogue(const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code problem, unknown;
  for (fs::recursive_directory_iterator each(folder, problem), end; !problem && each != end; each.increment(problem))
    if (each->path().extension() == ".xml" && each->is_regular_file(unknown))
      paths.push_back(each->path().lexically_normal().string());
  std::sort(paths.begin(), paths.end());

  ReadCatalogue read;
  RunningDigest bytes;
  for (const auto& path : paths) {
    const auto text = read_file(path);
    if (!text) {
      read.problems.push_back(text.error());
      continue;
    }
    auto document = read_voxeme(*text, path);
    if (!document) {
      read.problems.push_back(document.error());
      continue;
    }
    bytes.add(fmt::format("{}\n{}\n", fs::path(path).lexically_relative(folder).generic_string(), digest(*text)));
    ++read.documents;
    read.notes.insert(read.notes.end(), document->notes.begin(), document->notes.end());
    auto& voxeme = document->voxeme;
    if (const auto* earlier = read.catalogue.find(voxeme.entity, voxeme.predicate))
      read.notes.push_back({path, fmt::format("the {} {} replaces that of {}", name_of(voxeme.entity),
                                              in_quotes(voxeme.predicate), earlier->path)});
    read.catalogue.add(std::move(voxeme));
  }
  if (read.documents > 0) read.catalogue.digest_ = bytes.text();
  return read;
}

}  // namespace continua
