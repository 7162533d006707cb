#include "continua/machine_file/machine_keys.h"

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
        "gestures",
        "phrases",
        "fusion",
        "context",
        "moves",
        "ignore",
        "programs",
        "parameters",
        "slots",
        "bottom",
        "memory",
        "inputs",
        "define",
        "wordings",
        "beliefs",
        "states",
        "transitions",
        "implied",
        "examples"}},
      {"fusion", {"before", "after", "lateness"}},
      {"a context", {"focus", "among", "topic"}},
      {"a parameter", {"value", "until", "about"}},
      {"a slot", {"type", "persists", "about"}},
      {"a register", {"type", "initial", "about"}},
      {"a state", {"gate", "enter", "passing", "about", "layout"}},
      {"a gate",
       {"when", "else", "push", "push_each", "pop", "rewrite", "rewrite_each", "flush", "pop_until", "none", "about"}},
      {"a transition",
       {"id", "from", "on", "when", "to", "push", "push_each", "pop", "rewrite", "rewrite_each", "flush", "pop_until",
        "none", "weight", "do", "about"}},
      {"what is implied", {"when", "to", "stack", "about"}},
      {"an operation", {"push", "push_each", "pop", "rewrite", "rewrite_each", "flush", "pop_until", "none"}},
      {"an effect",
       {"when", "say", "phrase", "gesture", "act", "remember", "learn", "forget", "rewrite", "rewrite_each", "do",
        "about"}},
      {"what is learned", {"gesture", "means", "word", "acts"}},
      {"what is forgotten", {"gesture", "word"}},
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

bool expect_kind(const Item& item, const std::string& kind) {
  return item.expect_object(kind, machine_keys().find(kind)->second);
}

}  // namespace continua
