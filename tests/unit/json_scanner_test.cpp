// The scanner of plain JSON against the parser that it stands in for.
#include <gtest/gtest.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "io/json_document.hpp"
#include "support/effort.hpp"
#include "support/rng.hpp"

namespace taut::internal::io {
namespace {

constexpr std::size_t deepest = 32;

JsonDocument with_text(const std::string& text) {
  JsonDocument document;
  document.name = "text";
  document.text = text;
  return document;
}

std::optional<JsonDocument> parsed(const std::string& text) {
  JsonDocument document = with_text(text);
  try {
    parse_any_json(document, Quoting::allowed);
  } catch (const InputError&) {
    return std::nullopt;
  }
  return document;
}

/// Where the scanner makes tokens, they are the parser's; returns whether it did.
bool scans_as_parsed(const std::string& text) {
  JsonDocument scanned = with_text(text);
  if (!scan_plain_json(scanned, deepest)) return false;
  const std::optional<JsonDocument> wanted = parsed(text);
  EXPECT_TRUE(wanted) << text;
  if (!wanted) return true;
  EXPECT_EQ(scanned.strings, wanted->strings);
  EXPECT_EQ(scanned.tokens.size(), wanted->tokens.size());
  for (std::size_t k = 0; k < std::min(scanned.tokens.size(), wanted->tokens.size()); ++k) {
    const JsonToken &token = scanned.tokens[k], &other = wanted->tokens[k];
    EXPECT_EQ(token.kind_and_offset, other.kind_and_offset) << text << ", token " << k;
    EXPECT_EQ(token.link, other.link) << text << ", token " << k;
  }
  return true;
}

TEST(JsonScanner, ReadsTheScenesOfTheRepository) {
  int scanned = 0, all = 0;
  for (const char* const folder : {"examples", "tests/corpus", "fuzz/scenes"}) {
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder)) {
      if (file.path().extension() != ".json") continue;
      std::ifstream in(file.path(), std::ios::binary);
      scanned += scans_as_parsed({std::istreambuf_iterator<char>(in), {}}) ? 1 : 0;
      ++all;
    }
  }
  EXPECT_GT(all, 40);
  EXPECT_GT(scanned, all * 9 / 10);
}

TEST(JsonScanner, ReadsNumbersAndNesting) {
  for (const char* const text : {"0",
                                 "-0",
                                 "-0.0",
                                 "0.1",
                                 "1E5",
                                 "1e-5",
                                 "-1.5e+3",
                                 "18446744073709551615",
                                 "18446744073709551616",
                                 "-9223372036854775808",
                                 "-9223372036854775809",
                                 "123456789012345678901234567890",
                                 "5e-324",
                                 "1e-400",
                                 "2.2250738585072011e-308",
                                 "0.1000000000000000055511151231257827021181583404541015625",
                                 "[]",
                                 "{}",
                                 "[[],{}]",
                                 " [ 1 , 2 ] ",
                                 "{\"a\":{\"b\":[null,true,false,\"c\"]},\"d\":\"\"}",
                                 "\"x\"",
                                 "null"})
    EXPECT_TRUE(scans_as_parsed(text)) << text;
}

TEST(JsonScanner, LeavesTheRestToTheParser) {
  for (const std::string& text :
       std::vector<std::string>{"",
                                " ",
                                "[",
                                "]",
                                "[1",
                                "[1,]",
                                "[,1]",
                                "[1 2]",
                                "[1]]",
                                "{",
                                "{\"a\"}",
                                "{\"a\":}",
                                "{\"a\":1,}",
                                "{1:2}",
                                "{\"a\" 1}",
                                "01",
                                "1.",
                                ".5",
                                "+1",
                                "-",
                                "1e",
                                "1e+",
                                "1e999",
                                "-1e999",
                                "NaN",
                                "Infinity",
                                "tru",
                                "nulll",
                                "\"a",
                                "\"\\n\"",
                                "\"\xC3\xA4\"",
                                "\"\x01\"",
                                "'a'",
                                "[1]x",
                                "// c\n1",
                                "\xEF\xBB\xBF[1]",
                                std::string("[1]\0", 4),
                                std::string(deepest + 1, '[') + std::string(deepest + 1, ']')})
    EXPECT_FALSE(scans_as_parsed(text)) << text;
}

/// A character is replaced, left out or put in, here and there.
TEST(JsonScanner, OfDamagedTextSaysWhatTheParserSays) {
  const std::string whole =
      R"({"format": "taut-scene/1", "time": [0, 1.5e1], "id": null, "bodies": [{"name": "P", "polygon": [[0,0],[-1.25,0],[0,1E-2]]}, {}]})";
  const std::string characters = "[]{},:\"\\ 0123456789.-+eE\n\tntfu\x80'";
  taut::testing::Rng rng(5);
  int good = 0;
  for (std::uint64_t k = 0; k < taut::testing::effort(20000); ++k) {
    std::string text = whole;
    for (int changes = rng.between(1, 3); changes > 0; --changes) {
      const auto at = static_cast<std::size_t>(rng.below(static_cast<int>(text.size())));
      const char c = characters[static_cast<std::size_t>(rng.below(static_cast<int>(characters.size())))];
      switch (rng.below(3)) {
        case 0:
          text[at] = c;
          break;
        case 1:
          text.erase(at, 1);
          break;
        default:
          text.insert(at, 1, c);
      }
    }
    const bool scanned = scans_as_parsed(text);
    good += scanned ? 1 : 0;
    // What it leaves to the parser is wrong, or not plain.
    if (scanned || !parsed(text)) continue;
    EXPECT_NE(text.find_first_of("\\\x80\x7F"), std::string::npos) << text;
  }
  EXPECT_GE(good, static_cast<int>(taut::testing::enough(500)));
}

}  // namespace
}  // namespace taut::internal::io
