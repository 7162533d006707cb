// From words and gestures to moves. Words are read once; then each of their moves is interpreted in the context that
// the moves before it have left.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "continua/language/demonstratives.h"
#include "continua/language/parser.h"
#include "continua/language/pointing.h"
#include "continua/language/vocabulary.h"
#include "continua/moves/move.h"
#include "continua/perception/gesture.h"
#include "continua/term/raising.h"

namespace continua {

class Catalogue;

/// The engine's knowledge of words and gestures: data, loaded once.
struct Language {
  std::shared_ptr<const Lexicon> lexicon;
  std::shared_ptr<const GestureCatalogue> gestures;
  RaisingRules raising;
  std::shared_ptr<const Catalogue> voxemes;   ///< meanings of words in space; null: there are none
  std::optional<DeicticProgram> deixis = {};  ///< [[point]], if the voxemes have it
};

class Understanding {
 public:
  /// `rules`: the functions in conditions on objects. `language` and `rules` must outlive the understanding.
  Understanding(const Language& language, std::shared_ptr<const Vocabulary> words, const RuleTable& rules)
      : language_(language), rules_(rules), vocabulary_(std::move(words)) {}

  const std::shared_ptr<const Vocabulary>& words() const { return vocabulary_; }
  /// The program by whose application a pointing comes about; nullptr if there is none.
  const DeicticProgram* deixis() const { return language_.deixis ? &*language_.deixis : nullptr; }
  /// The spread of a pointing over this distance, metres.
  double pointing_sd_m(std::optional<double> distance_m) const {
    return language_.deixis ? language_.deixis->sd_m(distance_m) : hand_sd_m;
  }

  Utterance read(std::string_view text) const { return continua::read(text, *vocabulary_); }

  /// The words that pointing can go with, by the likeliest reading of each fragment.
  std::vector<Demonstrative> demonstratives(const Utterance& utterance) const;

  /// The move of a fragment of the utterance.
  Move understood(const Utterance& utterance, std::size_t fragment, const Context& context) const;
  /// The move of an utterance without fragments.
  Move not_understood(const Utterance& utterance) const;
  /// The move of a gesture with this meaning: \x: e. grasp(x), \x: e. cup(x), grasp(the(\x. cup(x))).
  Move shown(const Term& term, const std::string& kind, const Context& context) const;
  /// The meaning of a gesture as a term; null if the text uses names that are not known here.
  Term meaning_of(const std::string& text) const;

 private:
  Meanings meanings() const;
  bool is_topic(const Term& term) const;
  Term noun_in(const WordSpan& words, const Utterance& utterance) const;
  std::vector<std::vector<Term>> nouns(const Reading& reading, const Utterance& utterance,
                                       const std::vector<Phrase>& phrases, std::size_t before) const;
  Term in_machine_terms(const Term& meaning) const;
  Context within(const Reading& reading, const Utterance& utterance, Context context) const;

  const Language& language_;
  const RuleTable& rules_;
  std::shared_ptr<const Vocabulary> vocabulary_;
};

}  // namespace continua
