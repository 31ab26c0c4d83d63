// A planner's tree and path as SVG, and the proof of the path.
#pragma once

#include <ompl/base/PlannerData.h>
#include <ompl/geometric/SimpleSetup.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <taut/ompl.hpp>
#include <taut/taut.hpp>

namespace planning {

namespace ob = ompl::base;
namespace og = ompl::geometric;

/// SVG in world coordinates, y upwards.
class Picture {
 public:
  Picture(double x0, double y0, double x1, double y1) {
    const double width = 800, scale = width / (x1 - x0);
    out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << scale * (y1 - y0)
         << "\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n<g transform=\"matrix(" << scale << ",0,0,"
         << -scale << "," << -scale * x0 << "," << scale * y1 << ")\" stroke-width=\"" << 1 / scale << "\">\n";
  }
  void part(const taut::Part& part, const std::string& style) {
    out_ << "<path fill-rule=\"evenodd\" " << style << " d=\"" << ring(part.outline, {});
    for (const taut::Polygon& hole : part.holes) out_ << ring(hole, {});
    out_ << "\"/>\n";
  }
  void body(const taut::Body& body, const std::string& style, const taut::BodyPose& pose = {}) {
    if (!body.polygon.empty()) out_ << "<path " << style << " d=\"" << ring(body.polygon, pose) << "\"/>\n";
    for (const taut::Part& p : body.parts) part(p, style);
  }
  void line(const std::vector<taut::Point>& points, const std::string& style) {
    out_ << "<polyline fill=\"none\" " << style << " points=\"";
    for (const taut::Point& p : points) out_ << p.x << "," << p.y << " ";
    out_ << "\"/>\n";
  }
  void save(const std::string& file) { std::ofstream(file) << out_.str() << "</g>\n</svg>\n"; }

 private:
  static std::string ring(const taut::Polygon& polygon, const taut::BodyPose& pose) {
    std::ostringstream d;
    const taut::Point &o = pose.origin, &x = pose.axis;
    for (const taut::Point& p : polygon)
      d << (d.tellp() > 0 ? "L" : "M") << o.x + x.x * p.x - x.y * p.y << "," << o.y + x.y * p.x + x.x * p.y;
    return d.str() + "Z";
  }

  std::ostringstream out_;
};

/// Where states are between two of them, as OMPL interpolates.
inline std::vector<taut::Point> way_between(const ob::StateSpace& space, const ob::State* a, const ob::State* b) {
  std::vector<taut::Point> points;
  ob::State* at = space.allocState();
  for (int i = 0; i <= 20; ++i) {
    space.interpolate(a, b, i / 20.0, at);
    const auto* s = at->as<ob::SE2StateSpace::StateType>();
    points.push_back({s->getX(), s->getY()});
  }
  space.freeState(at);
  return points;
}

/// Draws map, tree, path and the robot on its way.
inline void draw(const og::SimpleSetup& setup, const taut::Scene& scene, Picture& picture, const std::string& file) {
  const ob::StateSpace& space = *setup.getStateSpace();
  const auto robot = static_cast<int>(scene.bodies.size()) - 1;
  for (int i = 0; i < robot; ++i)
    picture.body(scene.bodies[static_cast<std::size_t>(i)], "fill=\"#999\" stroke=\"none\"");
  ob::PlannerData data(setup.getSpaceInformation());
  setup.getPlannerData(data);
  for (unsigned i = 0; i < data.numVertices(); ++i) {
    std::vector<unsigned> next;
    data.getEdges(i, next);
    for (const unsigned k : next)
      picture.line(way_between(space, data.getVertex(i).getState(), data.getVertex(k).getState()), "stroke=\"#9bd\"");
  }
  const int frames = 60;
  for (int i = 0; i <= frames; ++i) {
    const taut::BodyPose pose = taut::poses_at(scene, scene.end * i / frames).back();
    picture.body(scene.bodies.back(), "fill=\"#e83\" fill-opacity=\"0.25\" stroke=\"#b50\"", pose);
  }
  picture.save(file);
}

/// Proves the path that was found, checks the proof, and writes NAME.svg, NAME.json and NAME.proof. For main().
inline int report(const og::SimpleSetup& setup, const taut::for_ompl::Robot& robot, Picture& picture,
                  const std::string& name) {
  if (!setup.haveExactSolutionPath()) {
    std::cout << "no path was found\n";
    return 1;
  }
  const taut::Scene scene =
      taut::for_ompl::path_scene(robot, *setup.getStateSpace(), setup.getSolutionPath().getStates());
  std::stringstream log;
  taut::prove(scene, log);
  const taut::Verified verified = taut::verify(scene, log);
  taut::write_file(name + ".json", taut::write_scene(scene));
  taut::write_file(name + ".proof", log.str());
  draw(setup, scene, picture, name + ".svg");
  std::cout << name << ": the path is " << to_string(verified.outcome) << ", by a proof of " << log.str().size()
            << " bytes\n";
  return verified.outcome == taut::Outcome::free ? 0 : 1;
}

}  // namespace planning
