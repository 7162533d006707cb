// Reads the effects of a machine file: the consequences of a state or transition besides the change of the stack.
#pragma once

#include <optional>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/document_reader.h"
#include "continua/machine_file/machine_operations.h"
#include "continua/machine_file/machine_phrases.h"
#include "continua/machine_file/machine_terms.h"

namespace continua {

class EffectReader {
 public:
  /// `declared` has the registers. All must outlive the reader.
  EffectReader(const Machine& declared, const TermReader& terms, OperationReader& operations, PhraseReader& phrases)
      : declared_(declared), terms_(terms), operations_(operations), phrases_(phrases) {}

  std::vector<Effect> effects(const Item& list);

 private:
  using What = decltype(Effect::what);

  std::optional<Effect> effect(const Item& object);
  /// The effect that the member `kind` of the object describes; nothing after a problem.
  std::optional<What> what(const Item& object, const std::string& kind);
  Remember remember(const Item& registers) const;
  std::optional<Learn> learn(const Item& lesson) const;
  std::optional<Forget> forget(const Item& lesson) const;

  const Machine& declared_;
  const TermReader& terms_;
  OperationReader& operations_;
  PhraseReader& phrases_;
};

}  // namespace continua
