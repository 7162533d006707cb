#include "continua/replay/noise/confusions.h"

#include <cmath>

#include "continua/core/document_reader.h"

namespace continua {
namespace {

std::vector<double> read_quantiles(const Item& item) {
  std::vector<double> values;
  for (const auto& one : item.elements("confidences in ascending order")) {
    const double least = values.empty() ? 0 : values.back();
    values.push_back(one.number("a confidence, 0 to 1, not below the one before", least, least, 1));
  }
  if (item.exists() && values.size() < 2) item.problem("expected two confidences or more");
  return values;
}

Confusions::Row read_row(const Item& item) {
  Confusions::Row row;
  for (const auto& [word, count] : item.members("words that were heard, and how often"))
    row.emplace_back(word, count.number("how often it was heard, above 0", 1, 1e-9, 1e9));
  return row;
}

// The words of all rows, each as often as it was heard.
Confusions::Row all_of(const std::map<std::string, Confusions::Row>& rows) {
  std::map<std::string, double> counts;
  for (const auto& [said, row] : rows)
    for (const auto& [word, count] : row) counts[word] += count;
  return {counts.begin(), counts.end()};
}

}  // namespace

const std::string& Confusions::heard(const std::string& said, double chance) const {
  const auto known = rows.find(said);
  const auto& row = known == rows.end() ? anything : known->second;
  double sum = 0;
  for (const auto& [word, count] : row) sum += count;
  double left = chance * sum;
  for (const auto& [word, count] : row)
    if ((left -= count) < 0) return word;
  return row.back().first;
}

double quantile(const std::vector<double>& quantiles, double at) {
  const double place = at * static_cast<double>(quantiles.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), quantiles.size() - 2);
  return std::lerp(quantiles[below], quantiles[below + 1], place - static_cast<double>(below));
}

Result<Confusions> read_confusions(const std::string& path) {
  const auto document = LocatedJson::read(path);
  if (!document) return document.error();
  DocumentReader reader;
  const auto root = reader.root(*document);
  Confusions confusions;
  if (root.expect_object("a table of confusions", {"confusions", "about", "heard", "confidence", "words"})) {
    root.expect_version("confusions", 1);
    const auto confidence = root.required("confidence", "how sure the recogniser is, an object");
    confidence.expect_object("confidences", {"share_wrong", "right", "wrong"});
    confusions.share_wrong = confidence.required("share_wrong", "the share of wrong words")
                                 .number("the share of wrong words, 0.001 to 0.999", 0.5, 0.001, 0.999);
    confusions.sure_right = read_quantiles(confidence.required("right", "those of words that were heard right"));
    confusions.sure_wrong = read_quantiles(confidence.required("wrong", "those of words that were heard wrong"));
    const auto words = root.required("words", "words that were said, an object");
    for (const auto& [said, heard] : words.members("words that were said"))
      if (auto row = read_row(heard); !row.empty()) confusions.rows.emplace(said, std::move(row));
    confusions.anything = all_of(confusions.rows);
    if (reader.sound() && confusions.anything.empty()) words.problem("expected a word that was heard wrong");
  }
  if (!reader.sound()) return reader.problems().front();
  return confusions;
}

}  // namespace continua
