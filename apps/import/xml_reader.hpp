// As much of XML as drawings have: elements and their attributes, one after the other.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taut::drawing {

/// The character that an entity stands for, "amp" or "#233", if there is one.
std::optional<std::string> xml_entity(const std::string& entity);

struct XmlElement {
  std::string name;  ///< "svg:" before it is dropped, other prefixes stay
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string place;  ///< file, line and column

  /// The attribute's value; null if it is not there.
  const std::string* find(const std::string& key) const;
};

/// Goes through a text. An element that closes itself is opened and closed. Comments, character data, processing
/// instructions and the document type are passed over. A document type may declare entities that are short texts;
/// others are refused, as there is nothing that may not hide behind them.
class XmlReader {
 public:
  XmlReader(const std::string& text, std::string file) : text_(text), file_(std::move(file)) {}

  enum class Event { open, close, end };
  /// Throws InputError.
  Event next();
  /// What was opened or closed last; when it is closed, it has no attributes.
  const XmlElement& element() const { return element_; }
  /// Where the mark of what was opened or closed last begins, and what is behind it. Of an element that closes itself
  /// both are behind it when it is closed.
  std::size_t begin() const { return begin_; }
  std::size_t position() const { return position_; }

 private:
  Event open();
  Event close();
  void read_attribute();
  std::string read_name();
  std::string decoded(std::size_t begin, std::size_t end);
  std::string decoded_entity(const std::string& entity, std::size_t at);
  void pass(const char* end, const char* what);
  void pass_document_type();
  void read_declarations();
  void skip_space();
  bool starts_with(const char* word) const { return text_.compare(position_, std::string(word).size(), word) == 0; }
  std::string place(std::size_t offset);
  [[noreturn]] void fail(std::size_t at, const std::string& problem, const std::string& hint);

  const std::string& text_;
  std::string file_;
  std::size_t position_ = 0, begin_ = 0;
  /// Up to where lines are counted.
  std::size_t counted_ = 0, line_start_ = 0;
  int line_ = 1;
  std::map<std::string, std::string> entities_;  ///< that the document type declares
  std::vector<std::string> open_;
  bool closing_ = false;
  XmlElement element_;
};

}  // namespace taut::drawing
