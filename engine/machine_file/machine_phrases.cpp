// What the avatar says: in the machine, or in the file of its phrases, whose terms are read as the machine's own.
#include <utility>

#include <fmt/format.h>

#include "machine_file/machine_reader.h"
#include "machine_file/phrase_file.h"

namespace continua {

void MachineReader::read_phrase_file(const Item& phrases) {
  if (!phrases.json) return;
  machine_.phrases = name_of(phrases, "the name of a phrase file");
  if (machine_.phrases.empty()) return;
  auto document = read_phrases(machine_.phrases, phrase_folder_);
  if (!document) {
    if (document.error().where.empty())
      problem(phrases, document.error().sentence);
    else
      phrase_problems_.push_back(document.error());
    return;
  }
  phrase_problems_ = phrase_problems(*document);
  machine_.phrase_document = compact(document->root());
  if (phrase_problems_.empty()) phrases_ = *std::move(document);
}

std::optional<Say> MachineReader::read_say(const Item& item) {
  auto variants = read_variants(item);
  if (variants.variants.empty()) return std::nullopt;
  return Say{{std::move(variants)}};
}

SayCase MachineReader::read_variants(const Item& item) {
  SayCase one;
  const auto add = [&](const Item& text) {
    if (auto words = read_template(text, "")) one.variants.push_back(std::move(*words));
  };
  if (!item.json || !item.json->is_array()) return add(item), one;
  if (item.json->empty()) mismatch(item, "what is said, or several ways to say it");
  for (std::size_t i = 0; i < item.json->size(); ++i) add(element(item, i));
  return one;
}

std::optional<Say> MachineReader::read_phrase(const Item& item) {
  const auto name = name_of(item, "the name of a phrase");
  if (name.empty()) return std::nullopt;
  if (machine_.phrases.empty() && !member({&machine_document_.root(), ""}, "phrases").json)
    problem(item, "there are no phrases without their file; expected \"phrases\" in the machine");
  if (!phrases_) return std::nullopt;
  if (const auto known = read_phrases_.find(name); known != read_phrases_.end()) return known->second;
  const auto say = member({&phrases_->root(), ""}, "say");
  const auto cases = member(say, name);
  if (!cases.json) {
    std::vector<std::string> names;
    for (const auto& [other, value] : say.json->items()) names.push_back(other);
    problem(item, fmt::format("no phrase {} in {}{}", in_quotes(name), phrases_->name(), nearest(name, names)));
    return std::nullopt;
  }
  document_ = &*phrases_;
  std::optional<Say> phrase = Say{};
  for (std::size_t i = 0; i < cases.json->size(); ++i) {
    const auto one = element(cases, i);
    auto variants = read_variants(member(one, "say"));
    variants.when = parse(member(one, "when"), Type::truth());
    phrase->cases.push_back(std::move(variants));
  }
  document_ = &machine_document_;
  return read_phrases_.emplace(name, std::move(phrase)).first->second;
}

}  // namespace continua
