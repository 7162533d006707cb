#include "continua/moves/known_words.h"

#include <utility>

namespace continua {

KnownWords known_words(const std::shared_ptr<const Lexicon>& lexicon, const WorldSnapshot& world) {
  auto untaught = std::make_shared<const Vocabulary>(lexicon, world);
  return {untaught, untaught, {}, {}};
}

KnownWords with_taught(KnownWords words, const Learned& learned) {
  if (!words.untaught || (words.taught == learned.programs && words.nouns == learned.nouns)) return words;
  Vocabulary all = *words.untaught;
  for (const auto& [name, program] : learned.programs)
    all.learn(program.word.empty() ? name : program.word, name, program.type());
  for (const auto& [name, condition] : learned.nouns) all.learn_noun(name, condition);
  words.nouns = learned.nouns;
  words.all = std::make_shared<const Vocabulary>(std::move(all));
  words.taught = learned.programs;
  return words;
}

}  // namespace continua
