#include "import/xml_tree.hpp"

namespace taut::drawing {

XmlTree::XmlTree(const std::string& text, const std::string& file) {
  XmlReader reader(text, file);
  std::vector<std::size_t> open;
  std::size_t style_from = 0;
  for (;;) {
    const XmlReader::Event event = reader.next();
    if (event == XmlReader::Event::end) break;
    if (event == XmlReader::Event::close) {
      Node& node = nodes_[open.back()];
      node.end = nodes_.size();
      if (node.element.name == "style" && node.end == open.back() + 1)
        styles_[open.back()] = text.substr(style_from, reader.begin() - style_from);
      open.pop_back();
      continue;
    }
    open.push_back(nodes_.size());
    nodes_.push_back({reader.element(), 0});
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
