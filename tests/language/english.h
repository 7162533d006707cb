// The English lexicon, and a scene to speak of, for tests.
#pragma once

#include <memory>
#include <string>

#include "continua/facts/world_facts.h"
#include "continua/language/parser.h"
#include "continua/term/term_text.h"
#include "support/catch.h"
#include "support/folders.h"

namespace continua {

inline const std::string english_folder = source_dir() + "/engine/knowledge/lexicon/english";

inline std::shared_ptr<const Lexicon> english() {
  static const auto lexicon = [] {
    auto loaded = load_lexicon(english_folder, WorldFacts::signature());
    if (!loaded) FAIL(loaded.error().text());
    return std::make_shared<const Lexicon>(*std::move(loaded));
  }();
  return lexicon;
}

/// An object with these attributes in the scene, "type=banana color=cyan".
inline ObjectState object_of(const std::string& name, const std::string& attributes) {
  ObjectState object;
  object.name = name;
  for (std::size_t at = 0; at < attributes.size();) {
    const auto end = std::min(attributes.find(' ', at), attributes.size());
    const auto equals = attributes.find('=', at);
    object.attributes[attributes.substr(at, equals - at)] = attributes.substr(equals + 1, end - equals - 1);
    at = end + 1;
  }
  return object;
}

/// The words that need no scene.
inline const Vocabulary& english_words() {
  static const Vocabulary words(english(), WorldSnapshot());
  return words;
}

/// The first reading of each fragment, "; " between them.
inline std::string reading_of(const std::string& text, const Vocabulary& words = english_words()) {
  std::string all;
  for (const auto& fragment : read(text, words).fragments)
    all += (all.empty() ? "" : "; ") + print(fragment.readings.front().term);
  return all;
}

}  // namespace continua
