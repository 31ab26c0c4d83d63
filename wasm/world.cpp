#include "world.hpp"

#include <algorithm>

#include "io/json_text.hpp"
#include "io/world_shapes.hpp"
#include "taut/io.hpp"
#include "taut/pose.hpp"

namespace taut::web {

namespace {

Answer answer_to(const Scene& scene, Touch touch, double max_seconds) {
  CheckOptions options;
  options.touch = touch;
  options.max_seconds = max_seconds;
  options.tell_touching = false;
  return check(scene, options);
}

}  // namespace

World::World(const Scene& scene, Touch touch, double max_seconds)
    : scene_(scene), touch_(touch), answer_(answer_to(scene, touch, max_seconds)) {}

double World::end() const {
  if (answer_.contact) return answer_.contact->time.lo;
  return answer_.outcome == Outcome::overlap_at_start ? scene_.start : answer_.free_until;
}

std::string World::picture(double t) const {
  const double shown = std::min(t, end());
  return draw_world_svg(scene_, shown, shown == end() ? marked(answer_) : WorldDrawOptions{});
}

std::string shapes_text(const Scene& scene) {
  const io::WorldShapes shapes(scene);
  std::string order, inner, looks;
  for (const std::size_t body : shapes.painting_order()) order += (order.empty() ? "" : ",") + std::to_string(body);
  for (std::size_t b = 0; b < shapes.size(); ++b) {
    const io::InnerPoint& p = shapes.inner(b);
    inner += (b ? "," : "") + io::array_text({p.at.x, p.at.y, p.room, static_cast<double>(p.part)});
  }
  for (std::size_t k = 0; k < io::body_looks; ++k) {
    const io::BodyLook look = io::body_look(k);
    looks += std::string(k ? "," : "") + "[\"" + look.fill + "\",\"" + look.line + "\",\"" + look.ink + "\"]";
  }
  return "{\"order\":[" + order + "],\"inner\":[" + inner + "],\"looks\":[" + looks + "]}";
}

std::vector<double> poses_of(const Scene& scene, double t) {
  std::vector<double> numbers;
  for (const BodyPose& p : poses_at(scene, t))
    numbers.insert(numbers.end(), {p.origin.x, p.origin.y, p.axis.x, p.axis.y});
  return numbers;
}

}  // namespace taut::web
