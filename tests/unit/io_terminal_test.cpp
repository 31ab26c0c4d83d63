// What other people wrote does nothing to the terminal that shows it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/json_writer.hpp"
#include "io/text.hpp"

namespace taut::internal::io {
namespace {

TEST(TerminalText, ShowsWhatCannotBeSeen) {
  EXPECT_EQ(for_terminal("\x1b[31mred\x07"), "\\u001b[31mred\\u0007");
  EXPECT_EQ(for_terminal("a\r\tb\x7f"), "a\\u000d\\u0009b\\u007f");
  EXPECT_EQ(for_terminal(std::string("a\0b", 3)), "a\\u0000b");
  EXPECT_EQ(for_terminal("\u009b31m"), "\\u009b31m");  // C1: the same as ESC [
  for (const char* direction : {"\u200e", "\u200f", "\u202a", "\u202e", "\u2066", "\u2069", "\u2028", "\u2029"}) {
    const std::string shown = for_terminal(std::string("a") + direction + "b");
    EXPECT_EQ(shown.substr(0, 4), "a\\u2") << shown;
    EXPECT_EQ(shown.size(), 8u) << shown;
  }
}

TEST(TerminalText, KeepsWhatCanBeSeen) {
  const std::string text = "lid, Größe, 蓋, 🙂, \u00a0 \\u001b";
  EXPECT_EQ(for_terminal(text), text);
  EXPECT_EQ(for_terminal("two\nlines"), "two\nlines");
  EXPECT_EQ(line_for_terminal("two\nlines"), "two\\u000alines");
}

TEST(TerminalText, ShowsBytesThatAreNoCharacters) {
  EXPECT_EQ(for_terminal("\xff"), "\\xff");
  EXPECT_EQ(for_terminal("a\xc3"), "a\\xc3");  // cut off
  EXPECT_EQ(for_terminal("\xc3("), "\\xc3(");
  EXPECT_EQ(for_terminal("\xc0\x9b"), "\\xc0\\x9b");           // longer than need be
  EXPECT_EQ(for_terminal("\xe0\x82\x9b"), "\\xe0\\x82\\x9b");  // the same
  EXPECT_EQ(for_terminal("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // half of a pair
  EXPECT_EQ(for_terminal("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
  EXPECT_EQ(for_terminal("\x9b"), "\\x9b");
}

TEST(TerminalText, OnlyTheHintOfAnErrorIsALineOfItsOwn) {
  EXPECT_EQ(for_terminal(InputError("a\nb.json", "bad \x1b", "mend\nit")),
            "a\\u000ab.json: bad \\u001b\nhint: mend\\u000ait");
  EXPECT_EQ(for_terminal(InputError("", "bad")), "bad");
}

TEST(JsonText, EscapesWhatATerminalWouldObey) {
  for (const std::string& text :
       {std::string("\x1b\x7f\u0085\u202e\u2028 Größe 🙂\n\"\\"), std::string("a\0b", 3)}) {
    const std::string json = string_text(text);
    EXPECT_EQ(for_terminal(json), json);
    EXPECT_EQ(json.find('\n'), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(json).get<std::string>(), text);
  }
  EXPECT_EQ(string_text("\x7f"), "\"\\u007f\"");
  EXPECT_EQ(string_text("Größe"), "\"Größe\"");
}

}  // namespace
}  // namespace taut::internal::io
