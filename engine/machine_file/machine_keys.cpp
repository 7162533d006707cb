#include "machine_file/machine_keys.h"

namespace continua {

const std::map<std::string, std::vector<std::string>, std::less<>>& machine_keys() {
  static const std::map<std::string, std::vector<std::string>, std::less<>> keys = {
      {"a machine",
       {"$schema",
        "machine",
        "name",
        "about",
        "start",
        "accept",
        "choice",
        "epsilon",
        "rewrite_below",
        "minimum_confidence",
        "repeat_utterances",
        "perspective",
        "lexicon",
        "context",
        "moves",
        "ignore",
        "programs",
        "slots",
        "bottom",
        "memory",
        "inputs",
        "define",
        "wordings",
        "beliefs",
        "states",
        "transitions",
        "examples"}},
      {"a context", {"focus", "among", "topic"}},
      {"a slot", {"type", "persists", "about"}},
      {"a register", {"type", "initial", "about"}},
      {"a state", {"gate", "enter", "passing", "about", "layout"}},
      {"a gate",
       {"when", "else", "push", "push_each", "pop", "rewrite", "rewrite_each", "flush", "pop_until", "none", "about"}},
      {"a transition",
       {"id", "from", "on", "when", "to", "push", "push_each", "pop", "rewrite", "rewrite_each", "flush", "pop_until",
        "none", "weight", "do", "about"}},
      {"an effect", {"when", "say", "gesture", "act", "remember", "rewrite", "rewrite_each", "do", "about"}},
      {"a wording", {"of", "when", "say", "about"}},
      {"beliefs", {"concepts", "evidence", "answers", "overheard", "about"}},
      {"a concept", {"related", "word", "fixed", "about"}},
      {"a piece of evidence", {"inputs", "concepts", "levels", "about"}},
      {"an answer", {"when", "inputs", "about", "set", "raise"}},
      {"an example", {"input", "ends", "about"}},
      {"an example with a word", {"word", "accepted", "by", "about"}},
  };
  return keys;
}

}  // namespace continua
