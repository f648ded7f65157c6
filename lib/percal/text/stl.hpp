// STL: the surface of a body as triangles, as text or in binary. It has no units.
#pragma once
#include <array>
#include <string>
#include <vector>

namespace percal {

struct StlTriangle {
  std::array<std::array<double, 3>, 3> corners;
  std::array<int, 3> lines{};  // 1-based, of the corners; 0 in a binary file
};

inline constexpr std::size_t most_triangles = 20'000;

// Throws BadInput, which names the line (of a binary file the triangle): neither form, cut off, a number that is none, no triangle, too many.
// What it says of normals is not looked at.
std::vector<StlTriangle> read_stl(const std::string& path);
std::vector<StlTriangle> parse_stl(const std::string& content, const std::string& name);

}  // namespace percal
