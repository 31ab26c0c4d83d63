#include "ask/map_answer.hpp"

#include <utility>

#include "taut/io.hpp"

namespace taut::internal {
namespace {

/// The bodies that an answer speaks of as a scene of their own, to which its references are changed.
class Mentioned {
 public:
  Mentioned(const StaticMap& map, const Body& mover) : map_(map), mover_(mover) {}

  void note(BodyId& body) {
    const std::size_t id = static_cast<std::size_t>(body);
    body = static_cast<BodyId>(scene.bodies.size());
    scene.bodies.push_back(id < map_.size() ? label(map_.body(static_cast<BodyId>(id))) : mover_);
  }
  void note(Contact& contact) {
    note(contact.vertex.body);
    note(contact.edge.body);
  }
  void note(PairAnswer& pair) {
    for (BodyId& body : pair.bodies) note(body);
    if (pair.contact) note(*pair.contact);
  }

  Scene scene;

 private:
  /// All of a body that texts of answers look at: not its shape, but whether it has parts.
  static Body label(const Body& body) {
    Body found;
    found.name = body.name;
    found.id = body.id;
    if (!body.parts.empty()) found.parts.resize(1);
    return found;
  }

  const StaticMap& map_;
  const Body& mover_;
};

}  // namespace

MapAnswerText map_answer_text(const StaticMap& map, const Body& mover, double start, double end, Answer answer,
                              Touch touch) {
  Mentioned mentioned(map, mover);
  if (answer.contact) mentioned.note(*answer.contact);
  if (answer.touching) mentioned.note(*answer.touching);
  if (answer.pair) {
    for (BodyId& body : *answer.pair) mentioned.note(body);
  }
  for (PairAnswer& pair : answer.also) mentioned.note(pair);
  mentioned.scene.start = start;
  mentioned.scene.end = end;
  const std::string text = answer_json(mentioned.scene, answer, touch);
  // The scope is the last member, and quotes within names are escaped: these marks are what they seem to be.
  const std::string opened = ",\"scope\":{\"bodies\":[", closed = "],\"time\":[";
  const std::size_t names = text.rfind(opened) + opened.size();
  return {text.substr(0, names), text.substr(text.find(closed, names))};
}

}  // namespace taut::internal
