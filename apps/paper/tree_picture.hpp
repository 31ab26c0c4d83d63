// A part of a chain tree, with the faces of its nodes (Fig. 4 of the paper).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "taut/simulation.hpp"

namespace taut::paper {

/// The subtree of one node of a body's tree, in the order of the chain.
class SubtreePicture {
 public:
  /// The `place`-th node of depth `depth`, counted from 0.
  SubtreePicture(const Scene& scene, const Tiling& tiling, int body, int depth, int place);

  /// The vertices of the chain (indices into Tiling::vertices), lettered from "a" on.
  const std::vector<std::pair<int, std::string>>& letters() const { return letters_; }
  /// A place within each face of the subtree, and its number.
  const std::vector<std::pair<Point, std::string>>& face_labels() const { return face_labels_; }
  std::string draw(int width) const;

 private:
  struct Node {
    int depth, from, to;  ///< ends of the chain, as positions in letters_
    double x;             ///< 0 to 1
    int parent;
    std::string face;
  };
  std::vector<std::pair<int, std::string>> letters_;
  std::vector<std::pair<Point, std::string>> face_labels_;
  std::vector<Node> nodes_;
};

}  // namespace taut::paper
