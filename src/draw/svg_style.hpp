// The styles of the picture, shared by picture and legend.
#pragma once

namespace taut::internal::io {

/// Those of the first two bodies in pictures of many: see body_style().
inline constexpr const char* body_fill[2] = {"#2a6f9e", "#e59345"};
inline constexpr const char* body_line[2] = {"#032e4b", "#683e15"};
inline constexpr const char* tiling_colour = "#5f6b76";
inline constexpr const char* pq_colour = "#c2187a";
inline constexpr const char* convex_colour = "#1b1b1b";
inline constexpr const char* reflex_colour = "#138a4e";
inline constexpr const char* geodesic_colour[2] = {"#0b4f9e", "#8f3d00"};
inline constexpr const char* separator_colour = "#6a2fb5";
inline constexpr const char* gone_colour = "#8a8a8a";
inline constexpr const char* come_colour = "#d7191c";
inline constexpr const char* contact_colour = "#d7191c";
/// Of the bar of time of a motion in which nothing is marked: green is a claim, for which somebody has to have asked.
inline const char* bar_colour(bool proved_free) { return proved_free ? reflex_colour : tiling_colour; }

}  // namespace taut::internal::io
