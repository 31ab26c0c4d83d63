#include "import/xml_tree.hpp"

namespace taut::drawing {

namespace {

/// Character data with its entities replaced, but for what is in a CDATA section, where there are none, and what is no
/// entity.
std::string with_entities(const std::string& text) {
  if (text.find("<![CDATA[") != std::string::npos) return text;
  std::string s;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t end = text[i] == '&' ? text.find(';', i) : std::string::npos;
    const auto character = end == std::string::npos ? std::nullopt : xml_entity(text.substr(i + 1, end - i - 1));
    s += character ? *character : std::string(1, text[i]);
    if (character) i = end;
  }
  return s;
}

}  // namespace

XmlTree::XmlTree(const std::string& text, const std::string& file) {
  XmlReader reader(text, file);
  std::vector<std::size_t> open;
  std::vector<std::optional<std::size_t>> last(1);  // that was closed, at each depth
  std::size_t style_from = 0;
  for (;;) {
    const XmlReader::Event event = reader.next();
    if (event == XmlReader::Event::end) break;
    if (event == XmlReader::Event::close) {
      Node& node = nodes_[open.back()];
      node.end = nodes_.size();
      if (node.element.name == "style" && node.end == open.back() + 1)
        styles_[open.back()] = with_entities(text.substr(style_from, reader.begin() - style_from));
      last.pop_back();
      last.back() = open.back();
      open.pop_back();
      continue;
    }
    nodes_.push_back({reader.element(), 0, std::nullopt, last.back()});
    if (!open.empty()) nodes_.back().parent = open.back();
    open.push_back(nodes_.size() - 1);
    last.emplace_back();
    style_from = reader.position();
    if (const std::string* id = reader.element().find("id")) ids_.emplace(*id, open.back());
  }
}

std::optional<std::size_t> XmlTree::by_id(const std::string& id) const {
  const auto found = ids_.find(id);
  if (found == ids_.end()) return std::nullopt;
  return found->second;
}

}  // namespace taut::drawing
