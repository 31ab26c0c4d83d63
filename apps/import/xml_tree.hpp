// A whole XML document, in which elements are found by their ids.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "import/xml_reader.hpp"

namespace taut::drawing {

/// Elements in the order of the document. Those within the one at i are at i + 1 up to `end`, which is behind them.
class XmlTree {
 public:
  struct Node {
    XmlElement element;
    std::size_t end = 0;
    std::optional<std::size_t> parent = {}, previous = {};
  };

  /// Throws InputError.
  XmlTree(const std::string& text, const std::string& file);

  std::size_t size() const { return nodes_.size(); }
  const XmlElement& element(std::size_t node) const { return nodes_[node].element; }
  std::size_t end(std::size_t node) const { return nodes_[node].end; }
  /// The element around this one, and the one before it within the same.
  std::optional<std::size_t> parent(std::size_t node) const { return nodes_[node].parent; }
  std::optional<std::size_t> previous(std::size_t node) const { return nodes_[node].previous; }
  /// The first element that has this id.
  std::optional<std::size_t> by_id(const std::string& id) const;
  /// What stands within the <style> elements, in the order of the document; by node.
  const std::map<std::size_t, std::string>& style_texts() const { return styles_; }

 private:
  std::vector<Node> nodes_;
  std::map<std::string, std::size_t> ids_;
  std::map<std::size_t, std::string> styles_;
};

}  // namespace taut::drawing
