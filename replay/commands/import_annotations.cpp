#include "continua/replay/commands/import_annotations.h"

#include <filesystem>

#include "continua/core/characters.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/replay/annotation/eaf.h"
#include "continua/replay/annotation/textgrid.h"
#include "continua/replay/annotation/tier_import.h"

namespace continua {
namespace {

Result<TierMap> read_map(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return text.error();
  return parse_tier_map(*text, path);
}

Result<TierMap> guess_map(const Annotations& annotations) {
  const auto data = find_data_paths();
  if (!data) return data.error();
  const auto path = (data->knowledge / "tier_names.json").string();
  const auto text = read_file(path);
  if (!text) return text.error();
  const auto names = parse_tier_names(*text, path);
  if (!names) return names.error();
  return guessed_map(annotations, *names);
}

}  // namespace

bool is_annotation_file(const std::string& path) {
  const auto ending = folded(std::filesystem::path(path).extension().string());
  return ending == ".eaf" || ending == ".textgrid";
}

Result<Trace> import_annotations(const std::string& path, const std::string& tiers, std::string& guessed) {
  const auto text = read_file(path);
  if (!text) return text.error();
  const auto annotations = is_textgrid(*text) ? read_textgrid(*text, path) : read_eaf(*text, path);
  if (!annotations) return annotations.error();
  const auto map = tiers.empty() ? guess_map(*annotations) : read_map(tiers);
  if (!map) return map.error();
  if (tiers.empty() && annotations->header.empty()) guessed = print(*map);
  return trace_of_annotations(*annotations, *map);
}

}  // namespace continua
