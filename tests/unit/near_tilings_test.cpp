// The tilings of a world's near pairs, and the lines that pictures show of them.
#include <gtest/gtest.h>

#include <algorithm>

#include "draw/world_shapes.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/simulation.hpp"

namespace taut {
using namespace internal;
namespace {

Polygon box_at(double x, double y, double w, double h) { return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}; }

/// A room with two pillars, of which one is far, and a cart that moves to the right; a crate outside.
Scene room_with_cart() {
  Scene scene;
  scene.end = 4;
  Body room;
  room.name = "room";
  room.parts = {{box_at(0, 0, 20, 10), {box_at(1, 1, 18, 8)}}, {box_at(6, 4, 1, 1), {}}, {box_at(17, 7, 1, 1), {}}};
  MotionPiece right;
  right.x = {0, 1};
  scene.bodies = {room, {"cart", box_at(2, 4, 1, 1), Motion{{right}}}, {"crate", box_at(40, 4, 1, 1), {}}};
  return scene;
}

TEST(NearTilings, AreThoseOfPairsWhoseBoxesMeet) {
  const std::vector<NearTiling> tilings = tilings_of_near_pairs(room_with_cart(), 1);
  // The hole, and each of the two pillars; the crate is near nothing.
  ASSERT_EQ(tilings.size(), 3u);
  EXPECT_EQ(std::count_if(tilings.begin(), tilings.end(), [](const NearTiling& t) { return t.contained; }), 1);
  for (const NearTiling& tiling : tilings) {
    EXPECT_EQ(tiling.bodies, (std::array<BodyId, 2>{0, 1}));
    EXPECT_FALSE(tiling.edges.empty());
    for (const NearEdge& e : tiling.edges) {
      EXPECT_EQ(e.pq, e.from.body != e.to.body);
      const VertexRef& of_room = e.from.body == 0 ? e.from : e.to;
      if (of_room.body == 0) {
        EXPECT_EQ(of_room.ring, tiling.contained ? 1 : 0);
      }
    }
  }
}

/// At t = 3 the cart touches the near pillar: then it is the tiling of a moment before.
TEST(NearTilings, WhereBodiesTouchAreThoseOfAMomentBefore) {
  const std::vector<NearTiling> tilings = tilings_of_near_pairs(room_with_cart(), 3, Touch::closed);
  EXPECT_EQ(tilings.size(), 3u);
  EXPECT_THROW(tilings_of_near_pairs(room_with_cart(), 5), InputError);
}

TEST(NearTilings, PicturesLeaveOutPartsThatAreFar) {
  const Scene scene = room_with_cart();
  const io::WorldShapes shapes(scene);
  const auto touches = [](const NearEdge& l, int part) {
    return (l.from.body == 0 && l.from.part == part) || (l.to.body == 0 && l.to.part == part);
  };
  for (const double t : {0.5, 2.5}) {
    const auto lines = io::tiling_lines(shapes, poses_at(scene, t), tilings_of_near_pairs(scene, t));
    ASSERT_FALSE(lines.empty());
    EXPECT_TRUE(std::none_of(lines.begin(), lines.end(), [&](const auto& l) { return touches(l, 2); })) << t;
    const bool near = std::any_of(lines.begin(), lines.end(), [&](const auto& l) { return touches(l, 1); });
    EXPECT_EQ(near, t == 2.5);
    DrawOptions options;
    options.tilings = tilings_of_near_pairs(scene, t);
    EXPECT_NE(draw_svg(scene, t, options).find("class=\"tiling\""), std::string::npos);
  }
  EXPECT_EQ(draw_svg(scene, 1).find("class=\"tiling\""), std::string::npos);
}

TEST(NearTilings, OfMovingPicturesAreAskedForEachFrame) {
  const Scene scene = room_with_cart();
  AnimateOptions options;
  options.frames = 5;
  std::vector<double> asked;
  options.tilings = [&](double t) {
    asked.push_back(t);
    return tilings_of_near_pairs(scene, t);
  };
  const std::string svg = animate_svg(scene, 2, options);
  EXPECT_EQ(asked, (std::vector<double>{0, 0.5, 1, 1.5, 2}));
  EXPECT_NE(svg.find("class=\"tiling\""), std::string::npos);
}

}  // namespace
}  // namespace taut
