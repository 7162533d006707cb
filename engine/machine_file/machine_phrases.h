// Reads the avatar's utterances: texts of the machine itself, and phrases of its phrase file. Terms of the phrase file
// are read like the machine's own.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/document_reader.h"
#include "continua/machine_file/machine_terms.h"

namespace continua {

class PhraseReader {
 public:
  /// `folder`: of phrase files. All must outlive the reader.
  PhraseReader(DocumentReader& reader, const TermReader& terms, const std::string& folder)
      : reader_(reader), terms_(terms), folder_(folder) {}

  /// Opens the phrase file `name` for a machine of this name; `phrases` is the item that asks for it. Call it after all
  /// declarations of the machine. Returns the file's compact JSON; empty if the item is absent or the file cannot be
  /// read.
  std::string open(const Item& phrases, const std::string& name, const std::string& machine);

  /// Definitions and wordings of the phrase file.
  struct Terms {
    TermReader::Definitions definitions;
    std::vector<Wording> wordings;
  };
  Terms take_terms() { return std::move(file_terms_); }
  /// Problems of the phrase file's shape. If there are any, its terms are not read.
  const std::vector<Error>& file_problems() const { return file_problems_; }

  /// A text, or a list of variants; nothing if none of them is sound.
  std::optional<Say> say(const Item& item) const;
  /// The phrase that the item names; nothing if there is none, or the phrase file is not sound.
  std::optional<Say> phrase(const Item& item);

 private:
  SayCase variants(const Item& item, const TermReader& terms) const;
  Say cases(const Item& phrase) const;

  DocumentReader& reader_;
  const TermReader& terms_;
  const std::string& folder_;
  bool machine_names_file_ = false;
  std::optional<LocatedJson> document_;
  std::vector<Error> file_problems_;
  Item phrases_;  ///< "say" of the phrase file; absent unless the file is sound
  /// Reads terms with the names of the machine and the definitions of the phrase file. The machine's own terms cannot
  /// use these definitions, so the machine decides the same in every language.
  std::optional<TermReader> phrase_terms_;
  Terms file_terms_;
  std::map<std::string, Say, std::less<>> read_;
};

}  // namespace continua
