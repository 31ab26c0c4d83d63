#include "import/xml_reader.hpp"

#include <cctype>
#include <cstdlib>

#include "import/text_encoding.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

constexpr std::size_t deepest_element = 256;
/// Of entities that a document declares.
constexpr std::size_t longest_entity = 1000, most_entities_declared = 100;

bool in_xml_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == '.' || c == ':' ||
         static_cast<unsigned char>(c) >= 0x80;
}

}  // namespace

const std::string* XmlElement::find(const std::string& key) const {
  for (const auto& [name_of_value, value] : attributes)
    if (name_of_value == key) return &value;
  return nullptr;
}

std::string XmlReader::place(std::size_t offset) {
  // Places are asked for in the order of the text, but for errors.
  if (offset < counted_) return io::place_in_text(text_, file_, offset);
  for (; counted_ < offset && counted_ < text_.size(); ++counted_) {
    if (text_[counted_] != '\n') continue;
    ++line_;
    line_start_ = counted_ + 1;
  }
  return file_ + ":" + std::to_string(line_) + ":" + std::to_string(offset - line_start_ + 1);
}

void XmlReader::fail(std::size_t at, const std::string& problem, const std::string& hint) {
  throw InputError(io::place_in_text(text_, file_, at), problem, hint);
}

XmlReader::Event XmlReader::next() {
  if (closing_) {
    closing_ = false;
    begin_ = position_;
    element_.attributes.clear();
    open_.pop_back();
    return Event::close;
  }
  for (;;) {
    position_ = text_.find('<', position_);
    if (position_ == std::string::npos) {
      position_ = text_.size();
      if (!open_.empty())
        fail(position_, "the file ends inside the element \"" + io::excerpt(open_.back()) + "\"",
             "the file was cut off: save it again");
      return Event::end;
    }
    if (starts_with("<!--"))
      pass("-->", "comment");
    else if (starts_with("<![CDATA["))
      pass("]]>", "CDATA section");
    else if (starts_with("<?"))
      pass("?>", "processing instruction");
    else if (starts_with("<!"))
      pass_document_type();
    else {
      begin_ = position_;
      return starts_with("</") ? close() : open();
    }
  }
}

void XmlReader::pass(const char* end, const char* what) {
  const std::size_t found = text_.find(end, position_ + 2);
  if (found == std::string::npos) fail(position_, std::string("a ") + what + " without an end", "save the file again");
  position_ = found + std::string(end).size();
}

void XmlReader::pass_document_type() {
  const std::size_t end = text_.find('>', position_), inside = text_.find('[', position_);
  if (end == std::string::npos) fail(position_, "a document type without an end", "save the file again");
  if (inside < end) {
    position_ = inside + 1;
    read_declarations();
    skip_space();
    if (position_ >= text_.size() || text_[position_] != '>')
      fail(position_, "a document type without an end", "save the file again");
    ++position_;
    return;
  }
  position_ = end + 1;
}

/// Programs abbreviate the names of their own by entities. What they stand for has no markup, and no entities, in it.
void XmlReader::read_declarations() {
  const std::string hint = "save the drawing as plain SVG, without such declarations";
  for (;;) {
    skip_space();
    const std::size_t start = position_;
    if (starts_with("]")) {
      ++position_;
      return;
    }
    if (starts_with("<!--")) {
      pass("-->", "comment");
      continue;
    }
    if (!starts_with("<!ENTITY")) fail(start, "the document type declares something else than entities", hint);
    position_ += 8;
    skip_space();
    if (starts_with("%")) fail(start, "the document type declares entities for itself", hint);
    const std::string name = read_name();
    skip_space();
    const char quote = position_ < text_.size() ? text_[position_] : ' ';
    const std::size_t begin = position_ + 1, end = text_.find(quote, begin);
    if ((quote != '"' && quote != '\'') || end == std::string::npos)
      fail(start, "an entity that is not declared as a text in quotes", hint);
    const std::string value = text_.substr(begin, end - begin);
    if (value.size() > longest_entity || value.find_first_of("&<%") != std::string::npos ||
        entities_.size() == most_entities_declared)
      fail(start, "the document type declares entities that are more than short texts", hint);
    entities_.emplace(name, value);
    position_ = end + 1;
    skip_space();
    if (!starts_with(">")) fail(position_, "a declaration without an end", hint);
    ++position_;
  }
}

XmlReader::Event XmlReader::open() {
  const std::size_t start = position_++;
  element_ = {read_name(), {}, place(start)};
  if (open_.size() == deepest_element)
    fail(start, "elements are nested more than " + std::to_string(deepest_element) + " deep", "ungroup the drawing");
  open_.push_back(element_.name);
  for (;;) {
    skip_space();
    if (position_ >= text_.size()) fail(start, "an element without a \">\"", "the file was cut off: save it again");
    if (starts_with("/>")) {
      position_ += 2;
      closing_ = true;
      return Event::open;
    }
    if (text_[position_] == '>') {
      ++position_;
      return Event::open;
    }
    read_attribute();
  }
}

XmlReader::Event XmlReader::close() {
  const std::size_t start = position_;
  position_ += 2;
  element_ = {read_name(), {}, place(start)};
  skip_space();
  if (position_ >= text_.size() || text_[position_] != '>')
    fail(position_, "expected \">\" after the element's name", "save the file again");
  ++position_;
  if (open_.empty() || open_.back() != element_.name)
    fail(start, "the end of an element that is not open", "save the file again with a program for drawings");
  open_.pop_back();
  return Event::close;
}

void XmlReader::read_attribute() {
  const std::size_t start = position_;
  const std::string name = read_name();
  const auto fail_here = [&] {
    fail(start, "expected an attribute as name=\"value\"", "save the file again with a program for drawings");
  };
  skip_space();
  if (position_ >= text_.size() || text_[position_] != '=') fail_here();
  ++position_;
  skip_space();
  if (position_ >= text_.size() || (text_[position_] != '"' && text_[position_] != '\'')) fail_here();
  const std::size_t begin = position_ + 1, end = text_.find(text_[position_], begin);
  if (end == std::string::npos) fail(position_, "a quotation mark without its second one", "save the file again");
  position_ = end + 1;
  if (element_.find(name)) fail(start, "an attribute appears twice", "keep one of the two");
  element_.attributes.emplace_back(name, decoded(begin, end));
}

std::string XmlReader::read_name() {
  const std::size_t start = position_;
  while (position_ < text_.size() && in_xml_name(text_[position_])) ++position_;
  if (position_ == start) fail(start, "expected a name", "\"<\" in a text is written &lt;");
  const std::string name = text_.substr(start, position_ - start);
  return name.rfind("svg:", 0) == 0 ? name.substr(4) : name;
}

std::string XmlReader::decoded(std::size_t begin, std::size_t end) {
  std::string s;
  for (std::size_t i = begin; i < end; ++i) {
    if (text_[i] != '&') {
      s += text_[i];
      continue;
    }
    const std::size_t semicolon = text_.find(';', i);
    if (semicolon == std::string::npos || semicolon >= end) fail(i, "\"&\" without \";\"", "\"&\" is written &amp;");
    s += decoded_entity(text_.substr(i + 1, semicolon - i - 1), i);
    i = semicolon;
  }
  return s;
}

std::string XmlReader::decoded_entity(const std::string& entity, std::size_t at) {
  const auto declared = entities_.find(entity);
  if (declared != entities_.end()) return declared->second;
  const auto character = xml_entity(entity);
  if (!character) fail(at, "an entity that XML does not have", "write the character itself");
  return *character;
}

std::optional<std::string> xml_entity(const std::string& entity) {
  for (const auto& [name, c] : {std::pair("lt", "<"), {"gt", ">"}, {"amp", "&"}, {"quot", "\""}, {"apos", "'"}})
    if (entity == name) return c;
  if (entity.size() < 2 || entity.size() >= 10 || entity[0] != '#') return std::nullopt;
  const bool hexadecimal = entity[1] == 'x';
  char* end = nullptr;
  const unsigned long c = std::strtoul(entity.c_str() + (hexadecimal ? 2 : 1), &end, hexadecimal ? 16 : 10);
  if (*end != 0 || c == 0 || c >= 0x110000 || (c >= 0xD800 && c < 0xE000)) return std::nullopt;
  return utf8_of(c);
}

void XmlReader::skip_space() {
  while (position_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[position_]))) ++position_;
}

}  // namespace taut::drawing
