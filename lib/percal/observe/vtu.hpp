// VTK's file of an unstructured mesh (.vtu): XML with the numbers behind it, compressed, little-endian. And the list of a
// series (.pvd). The layout is VTK's "XML file formats", version 1.0, with 64-bit headers.
#pragma once
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace percal {

// One array of a mesh: `components` numbers a point or a cell, one after the other.
struct VtuArray {
  std::string name;
  int components = 1;
  std::variant<std::vector<float>, std::vector<double>, std::vector<std::uint8_t>, std::vector<std::int32_t>> values;
};

struct VtuMesh {
  double time = 0;                          // s
  std::vector<double> points;               // x, y, z of each
  std::vector<std::int32_t> corners, ends;  // cell k has the points corners[ends[k-1]] to corners[ends[k] - 1]
  std::vector<VtuArray> point_data, cell_data;
  bool hexahedra = false;  // the cells
};

// The file. Where cells are no hexahedra those with four corners are quads, others polygons.
std::string vtu_text(const VtuMesh& mesh);

// `bytes` as VTK's zlib compressor lays them out: number of blocks, size of a block, size of the last one if it is shorter (else
// 0), compressed size of each, all as 64-bit numbers; then the blocks.
std::string zlib_blocks(const std::string& bytes);

// One time of a series: files are named relative to the list.
struct PvdEntry {
  double time = 0;                 // s
  std::vector<std::string> files;  // the parts of that time
};
std::string pvd_text(const std::vector<PvdEntry>& entries);

}  // namespace percal
