// The shorelines, where they are installed.
#include "gshhg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "taut/validate.hpp"

namespace taut::bench {
namespace {

TEST(Gshhg, Continents) {
  if (const std::string obstacle = gshhg_obstacle(); !obstacle.empty()) {
    EXPECT_THROW(read_gshhg(gshhg_africa), std::runtime_error);
    GTEST_SKIP() << obstacle;
  }
  const Polygon america = read_gshhg(gshhg_south_america), africa = read_gshhg(gshhg_africa);
  EXPECT_EQ(america.size(), static_cast<std::size_t>(gshhg_vertices));
  EXPECT_EQ(africa.size(), 257835u);
  EXPECT_NO_THROW(validate_polygon(america, "South America"));
  EXPECT_NO_THROW(validate_polygon(africa, "Africa"));
  const auto by_longitude = [](const Point& a, const Point& b) { return a.x < b.x; };
  const auto by_latitude = [](const Point& a, const Point& b) { return a.y < b.y; };
  // Almadies, Ras Hafun, Agulhas and Ras ben Sakka; Punta Parinas and Ponta do Seixas.
  EXPECT_NEAR(std::min_element(africa.begin(), africa.end(), by_longitude)->x, -17.5, 0.1);
  EXPECT_NEAR(std::max_element(africa.begin(), africa.end(), by_longitude)->x, 51.4, 0.1);
  EXPECT_NEAR(std::min_element(africa.begin(), africa.end(), by_latitude)->y, -34.8, 0.1);
  EXPECT_NEAR(std::max_element(africa.begin(), africa.end(), by_latitude)->y, 37.35, 0.1);
  EXPECT_NEAR(std::min_element(america.begin(), america.end(), by_longitude)->x, -81.33, 0.1);
  EXPECT_NEAR(std::max_element(america.begin(), america.end(), by_longitude)->x, -34.79, 0.1);
}

TEST(Gshhg, NoSuchPolygon) {
  if (!gshhg_obstacle().empty()) GTEST_SKIP() << gshhg_obstacle();
  EXPECT_THROW(read_gshhg(100000000), std::runtime_error);
}

}  // namespace
}  // namespace taut::bench
