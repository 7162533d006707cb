#include "continua/machine_file/machine_phrases.h"

#include <utility>

#include <fmt/format.h>

#include "continua/machine_file/phrase_file.h"

namespace continua {

std::string PhraseReader::open(const Item& phrases, const std::string& name, const std::string& machine) {
  machine_names_file_ = phrases.exists();
  if (phrases.name("the name of a phrase file").empty()) return {};
  auto read = read_phrases(name, folder_);
  if (!read) {
    if (read.error().where.empty())
      phrases.problem(read.error().sentence);
    else
      file_problems_ = {read.error()};
    return {};
  }
  document_ = *std::move(read);
  file_problems_ = phrase_problems(*document_);
  if (file_problems_.empty()) {
    const auto root = reader_.root(*document_, fmt::format(" (read for the machine {})", machine));
    phrases_ = root.member("say");
    phrase_terms_ = terms_;
    file_terms_.definitions = phrase_terms_->definitions(root.member("define"));
    file_terms_.wordings = phrase_terms_->wordings(root.member("wordings"));
  }
  return compact(document_->root());
}

std::optional<Say> PhraseReader::say(const Item& item) const {
  auto read = variants(item, terms_);
  if (read.variants.empty()) return std::nullopt;
  return Say{{std::move(read)}};
}

SayCase PhraseReader::variants(const Item& item, const TermReader& terms) const {
  SayCase read;
  if (item.is_list() && item.json().empty()) item.mismatch("what is said, or several ways to say it");
  for (const auto& text : item.is_list() ? item.elements("ways to say it") : std::vector{item})
    if (auto words = terms.text_template(text)) read.variants.push_back(std::move(*words));
  return read;
}

std::optional<Say> PhraseReader::phrase(const Item& item) {
  const auto name = item.name("the name of a phrase");
  if (name.empty()) return std::nullopt;
  if (!machine_names_file_)
    item.problem("there are no phrases without their file; expected \"phrases\" in the machine");
  if (!phrases_.exists()) return std::nullopt;
  if (const auto known = read_.find(name); known != read_.end()) return known->second;
  const auto found = phrases_.member(name);
  if (!found.exists()) {
    std::vector<std::string> names;
    for (const auto& [other, value] : phrases_.json().items()) names.push_back(other);
    item.problem(fmt::format("no phrase {} in {}{}", in_quotes(name), document_->name(), item.nearest(name, names)));
    return std::nullopt;
  }
  return read_.emplace(name, cases(found)).first->second;
}

Say PhraseReader::cases(const Item& phrase) const {
  Say say;
  for (const auto& each : phrase.elements("the cases of a phrase")) {
    auto read = variants(each.member("say"), *phrase_terms_);
    read.when = phrase_terms_->term(each.member("when"), Type::truth());
    say.cases.push_back(std::move(read));
  }
  return say;
}

}  // namespace continua
