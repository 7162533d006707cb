#include "continua/core/characters.h"

#include "support/catch.h"

using namespace continua;

TEST_CASE("text is taken apart by its characters, bytes that are no UTF-8 stand for themselves") {
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

TEST_CASE("folded text is equal whatever the case, in any alphabet and however its marks are written") {
  CHECK(folded("Put IT There, 3.5 [@`{") == "put it there, 3.5 [@`{");
  CHECK(folded("ÖFFNE die Tür, Ærø, ÇELİK, ŻÓŁĆ") == folded("öffne DIE tÜR, ærØ, çelİk, żółć"));
  CHECK(folded("ÖFFNE") == "öffne");
  CHECK(folded("STRAẞE") == "straße");
  CHECK(folded("ΤΙΣ Άλφα") == folded("τις άλφα"));
  CHECK(folded("ПОСТАВЬ ёлку Ђ") == "поставь ёлку ђ");
  CHECK(folded("ԱՐԵՎ") == folded("արեվ"));
  CHECK(folded("U\u0308bung") == "übung");
  CHECK(folded("×÷ 日本 😀") == "×÷ 日本 😀");
  CHECK(folded("A\xFFZ\xC3") == "a\xFFz\xC3");
  CHECK(folded("").empty());
}

TEST_CASE("characters have a kind by their Unicode category") {
  for (const auto* text : {"a", "Ö", "ß", "ж", "Ω", "日", "\u0308"}) CHECK(kind_of(text) == CharacterKind::letter);
  for (const auto* text : {"0", "9", "٣", "½"}) CHECK(kind_of(text) == CharacterKind::digit);
  for (const auto* text : {"$", "+", "°", "😀", "→"}) CHECK(kind_of(text) == CharacterKind::symbol);
  for (const auto* text : {".", "'", "’", "„", "–", "¿", "_"}) CHECK(kind_of(text) == CharacterKind::punctuation);
  for (const auto* text : {" ", "\t", "\n", "\u00A0", "\u2003"}) CHECK(kind_of(text) == CharacterKind::space);
  for (const auto* text : {"", "\xFF", "\uFEFF", "\u200D", "\u00AD"}) CHECK(kind_of(text) == CharacterKind::invisible);
}
