#include "continua/machine_file/machine_beliefs.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "continua/machine_file/machine_keys.h"

namespace continua {
namespace {

class BeliefReader {
 public:
  BeliefReader(const TermReader& terms, SymbolReader& symbols) : terms_(terms), symbols_(symbols) {}

  BeliefTable read(const Item& item) {
    const auto concepts = item.required("concepts", "names and what they are, an object");
    const auto entries = concepts.members("the concepts");
    if (!concepts.is_object()) return table_;
    for (const auto& [name, entry] : entries) table_.concepts.push_back({name, {}, "", std::nullopt});
    for (std::size_t i = 0; i < entries.size(); ++i) read_concept(entries[i].item, table_.concepts[i]);
    for (const auto& each : item.member("evidence").elements("the evidence")) read_evidence(each);
    for (const auto& each : item.member("answers").elements("the answers")) read_answer(each);
    table_.overheard = item.member("overheard").number("a certainty", 0, 0, 1);
    return table_;
  }

 private:
  void read_concept(const Item& item, Concept& entry) {
    if (!expect_kind(item, "a concept")) return;
    entry.related = concepts_named(item.member("related"), "related concepts");
    entry.word = item.member("word").name("a word");
    std::transform(entry.word.begin(), entry.word.end(), entry.word.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (const auto fixed = item.member("fixed"); fixed.exists()) entry.fixed = fixed.number("a certainty", 0, -1, 1);
  }

  void read_evidence(const Item& item) {
    if (!expect_kind(item, "a piece of evidence")) return;
    Evidence entry{symbols_.symbols(item.required("inputs", "input symbols or sets")), {}, {}};
    entry.concepts = concepts_named(item.required("concepts", "the concepts that it raises"), "concepts");
    const auto levels = item.required("levels", "certainties, ascending");
    for (const auto& level : levels.elements("levels of certainty"))
      entry.levels.push_back(level.number("a level", 1, 0, 1));
    if (!levels.is_list()) return;
    if (entry.levels.empty() || !std::is_sorted(entry.levels.begin(), entry.levels.end()))
      levels.problem("expected one or more levels of certainty, ascending");
    table_.evidence.push_back(std::move(entry));
  }

  void read_answer(const Item& item) {
    if (!expect_kind(item, "an answer")) return;
    Answer entry{std::nullopt, symbols_.symbols(item.required("inputs", "input symbols or sets")), Term::null(),
                 std::nullopt};
    entry.when = terms_.term(item.member("when"), Type::truth());
    const auto about = item.required("about", "a term, the symbol that was asked about");
    if (const auto term = terms_.term(about, Type::text_type())) entry.about = *term;
    const auto set = item.member("set"), raise = item.member("raise");
    if (set.exists()) entry.set = set.number("a certainty", 0, 0, 1);
    if (raise.exists() && raise.json() != true) raise.mismatch("true");
    if (set.exists() == raise.exists())
      item.problem(fmt::format("found {}, expected one of set, raise", set.exists() ? "both" : "none"));
    table_.answers.push_back(std::move(entry));
  }

  std::vector<std::size_t> concepts_named(const Item& list, const char* what) const {
    std::vector<std::size_t> concepts;
    for (const auto& each : list.elements(what)) concepts.push_back(concept_named(each));
    return concepts;
  }

  // The first concept after a problem: a table with problems is not used.
  std::size_t concept_named(const Item& item) const {
    const auto name = item.name("a concept");
    std::vector<std::string> known;
    for (std::size_t i = 0; i < table_.concepts.size(); ++i) {
      if (table_.concepts[i].name == name) return i;
      known.push_back(table_.concepts[i].name);
    }
    if (!name.empty()) item.problem(item.unknown("concept", name, known));
    return 0;
  }

  const TermReader& terms_;
  SymbolReader& symbols_;
  BeliefTable table_;
};

}  // namespace

BeliefTable read_beliefs(const Item& item, const TermReader& terms, SymbolReader& symbols) {
  if (!item.exists() || !expect_kind(item, "beliefs")) return {};
  return BeliefReader(terms, symbols).read(item);
}

}  // namespace continua
