#include "core/characters.h"

#include "support/catch.h"

using namespace continua;

TEST_CASE("text is taken apart by its characters; bytes that are no UTF-8 stand for themselves") {
  using Characters = std::vector<std::string>;
  CHECK(characters("") == Characters{});
  CHECK(characters("aé€😀") == Characters{"a", "é", "€", "😀"});
  CHECK(characters("\xC3") == Characters{"\xC3"});
  CHECK(characters("\x80z\xFF") == Characters{"\x80", "z", "\xFF"});
  CHECK(characters("\xE2\x82z") == Characters{"\xE2", "\x82", "z"});
}

TEST_CASE("a character is UTF-8 only in its shortest form, within Unicode and no half of a pair") {
  for (const auto* text :
       {"\x7F", "\xC2\x80", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"})
    CHECK(character_length(text) == std::string(text).size());
  for (const auto* text : {"", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80",
                           "\xF5\x80\x80\x80", "\xC3(", "\xE2\x82("})
    CHECK(character_length(text) == 0);
}
