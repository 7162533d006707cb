#include "continua/machine_file/machine_keys.h"

#include <iterator>
#include <sstream>
#include <string_view>

namespace continua {
namespace {

struct KindOfObject {
  std::string_view name, keys;
};

constexpr KindOfObject kinds[] = {
    {"a machine",
     "$schema machine name about start accept choice epsilon rewrite_below minimum_confidence confidence near_tie gaze "
     "repeat_utterances perspective lexicon gestures phrases fusion context moves ignore programs parameters "
     "slots bottom memory inputs define wordings beliefs states transitions implied examples"},
    {"fusion", "before after lateness pause together"},
    {"a context", "focus among topic handled shown_things shown_places"},
    {"a move", "move inputs about"},
    {"confidences", "confirm ignore about"},
    {"the fading of looks", "half_life least about"},
    {"a parameter", "value until about"},
    {"a slot", "type persists about"},
    {"a register", "type initial cleared_by about"},
    {"a state", "gate enter passing about layout"},
    {"a gate", "when else push push_each pop rewrite rewrite_each flush pop_until none about"},
    {"a transition",
     "id from on when to push push_each pop rewrite rewrite_each flush pop_until none rank weight do about"},
    {"what is implied", "when to stack about"},
    {"an operation", "push push_each pop rewrite rewrite_each flush pop_until none"},
    {"an effect", "when say phrase gesture act remember learn forget attend rewrite rewrite_each do about"},
    {"what is learned", "gesture noun means word acts fixed"},
    {"what is forgotten", "gesture word noun"},
    {"a wording", "of when say about"},
    {"beliefs", "concepts evidence answers overheard about"},
    {"a concept", "related word fixed about"},
    {"a piece of evidence", "inputs concepts levels about"},
    {"an answer", "when inputs about set raise"},
    {"an example", "input ends about"},
    {"an example with a word", "word accepted by about"},
};

}  // namespace

const std::map<std::string, std::vector<std::string>, std::less<>>& machine_keys() {
  static const auto keys = [] {
    std::map<std::string, std::vector<std::string>, std::less<>> all;
    for (const auto& [name, words] : kinds) {
      std::istringstream in{std::string(words)};
      all[std::string(name)].assign(std::istream_iterator<std::string>(in), {});
    }
    return all;
  }();
  return keys;
}

bool expect_kind(const Item& item, const std::string& kind) {
  return item.expect_object(kind, machine_keys().find(kind)->second);
}

}  // namespace continua
