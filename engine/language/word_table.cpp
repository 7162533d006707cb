#include "continua/language/word_table.h"

#include <algorithm>
#include <utility>

#include "continua/language/spellings.h"

namespace continua {

// Builds the places of one key: first and last ones of each of its parts, and which follow which.
struct WordTable::Build {
  struct Piece {
    std::vector<int> first = {}, last = {};
    bool may_be_empty = true;
    std::size_t most_words = 0;
  };

  WordTable& table;

  Piece of(const Spelling& spelling) {
    if (spelling.kind == Spelling::Kind::word) return of_word(spelling.word);
    Piece all;
    all.may_be_empty = spelling.kind == Spelling::Kind::sequence;
    for (const auto& part : spelling.parts) {
      const auto more = of(part);
      if (spelling.kind == Spelling::Kind::sequence)
        follow(all, more);
      else
        choose(all, more);
    }
    return all;
  }

  Piece of_word(std::string_view word) {
    const int place = static_cast<int>(table.places_.size());
    auto found = table.parts_.find(word);
    if (found == table.parts_.end()) {
      found = table.parts_.emplace(word, static_cast<int>(table.parts_.size())).first;
      table.first_.emplace_back();
    }
    table.places_.push_back({found->second, static_cast<int>(table.entries_.size()), false, {}});
    return {{place}, {place}, false, 1};
  }

  void follow(Piece& all, const Piece& more) {
    for (const auto place : all.last) append(table.places_[place].next, more.first);
    if (all.may_be_empty) append(all.first, more.first);
    if (!more.may_be_empty) all.last.clear();
    append(all.last, more.last);
    all.may_be_empty = all.may_be_empty && more.may_be_empty;
    all.most_words += more.most_words;
  }

  static void choose(Piece& all, const Piece& more) {
    append(all.first, more.first);
    append(all.last, more.last);
    all.may_be_empty = all.may_be_empty || more.may_be_empty;
    all.most_words = std::max(all.most_words, more.most_words);
  }

  static void append(std::vector<int>& places, const std::vector<int>& more) {
    places.insert(places.end(), more.begin(), more.end());
  }
};

bool WordTable::add(std::string_view key, WordEntry entry) {
  const auto spelling = read_spelling(key);
  if (!spelling) return false;
  const auto begin = places_.size();
  const auto piece = Build{*this}.of(*spelling);
  if (piece.may_be_empty) {
    places_.resize(begin);
    return false;
  }
  const auto by_part = [this](int a, int b) { return places_[a].part < places_[b].part; };
  for (auto place = begin; place < places_.size(); ++place)
    std::sort(places_[place].next.begin(), places_[place].next.end(), by_part);
  for (const auto place : piece.last) places_[place].is_last = true;
  for (const auto place : piece.first) first_[places_[place].part].push_back(place);
  entries_.push_back(std::move(entry));
  most_words_ = std::max(most_words_, piece.most_words);
  return true;
}

bool WordTable::Walk::step(std::string_view word) {
  if (places_ && places_->empty()) return false;
  const auto part = table_->parts_.find(word);
  std::vector<int> next;
  if (part != table_->parts_.end()) {
    if (!places_) {
      next = table_->first_[part->second];
    } else {
      const auto part_of = [this](int place) { return table_->places_[place].part; };
      for (const auto place : *places_) {
        const auto& follow = table_->places_[place].next;
        auto each = std::partition_point(follow.begin(), follow.end(),
                                         [&](int other) { return part_of(other) < part->second; });
        for (; each != follow.end() && part_of(*each) == part->second; ++each) next.push_back(*each);
      }
    }
  }
  places_ = std::move(next);
  return !places_->empty();
}

std::vector<const WordEntry*> WordTable::Walk::entries() const {
  std::vector<int> numbers;
  if (places_)
    for (const auto place : *places_)
      if (table_->places_[place].is_last) numbers.push_back(table_->places_[place].entry);
  // A text may be read in several ways in one key.
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  std::vector<const WordEntry*> entries;
  entries.reserve(numbers.size());
  for (const auto number : numbers) entries.push_back(&table_->entries_[number]);
  return entries;
}

std::vector<const WordEntry*> WordTable::find(std::string_view words) const {
  Walk walk(*this);
  for (const auto word : parts_of_entry(words))
    if (!walk.step(word)) return {};
  return walk.entries();
}

std::set<std::string> WordTable::texts() const {
  std::vector<std::string_view> names(parts_.size());
  for (const auto& [name, number] : parts_) names[number] = name;
  std::set<std::string> all;
  const auto add = [&](int place, std::string text, const auto& self) -> void {
    text += names[places_[place].part];
    for (const auto next : places_[place].next) self(next, text + " ", self);
    if (places_[place].is_last) all.insert(std::move(text));
  };
  for (const auto& places : first_)
    for (const auto place : places) add(place, "", add);
  return all;
}

std::vector<std::string_view> parts_of_entry(std::string_view words) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; at <= words.size();) {
    const auto end = std::min(words.find(' ', at), words.size());
    parts.push_back(words.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

}  // namespace continua
