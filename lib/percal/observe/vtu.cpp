#include "percal/observe/vtu.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace percal {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say byte_order=\"LittleEndian\"");

constexpr std::size_t block_size = 1 << 15;
constexpr int zlib_level = 1;  // on fields of an impact, level 6 takes three times as long and gives no less

template <class T>
constexpr const char* vtk_type = nullptr;
template <>
constexpr const char* vtk_type<float> = "Float32";
template <>
constexpr const char* vtk_type<double> = "Float64";
template <>
constexpr const char* vtk_type<std::uint8_t> = "UInt8";
template <>
constexpr const char* vtk_type<std::int32_t> = "Int32";

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

std::string compressed(const std::string& block) {
  uLongf size = compressBound(block.size());
  std::string out(size, '\0');
  const int outcome = compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                                reinterpret_cast<const Bytef*>(block.data()), block.size(), zlib_level);
  if (outcome != Z_OK) throw std::bad_alloc();  // there is room for the output: memory is all that can lack
  out.resize(size);
  return out;
}

// The XML, with what its arrays refer to gathered behind.
class Writer {
 public:
  std::string text(const VtuMesh& mesh) {
    xml_ =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
        "compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n";
    xml_ += fmt::format(
        "<FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{:.17g}"
        "</DataArray></FieldData>\n",
        mesh.time);
    xml_ +=
        fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", mesh.points.size() / 3, mesh.ends.size());
    section("PointData", mesh.point_data);
    section("CellData", mesh.cell_data);
    section("Points", {{"Points", 3, mesh.points}});
    section("Cells", {{"connectivity", 1, mesh.corners}, {"offsets", 1, mesh.ends}, {"types", 1, types(mesh)}});
    xml_ += "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
    return xml_ + appended_ + "\n</AppendedData>\n</VTKFile>\n";
  }

 private:
  static std::vector<std::uint8_t> types(const VtuMesh& mesh) {
    constexpr std::uint8_t polygon = 7, quad = 9, hexahedron = 12;
    if (mesh.hexahedra) return std::vector(mesh.ends.size(), hexahedron);
    std::vector<std::uint8_t> types;
    std::int32_t begin = 0;
    for (const std::int32_t end : mesh.ends) {
      types.push_back(end - begin == 4 ? quad : polygon);
      begin = end;
    }
    return types;
  }

  void section(const char* name, const std::vector<VtuArray>& arrays) {
    xml_ += fmt::format("<{}>\n", name);
    for (const VtuArray& array : arrays) std::visit([&](const auto& values) { add(array, values); }, array.values);
    xml_ += fmt::format("</{}>\n", name);
  }

  template <class T>
  void add(const VtuArray& array, const std::vector<T>& values) {
    xml_ += fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
        vtk_type<T>, array.name, array.components, appended_.size());
    appended_ += zlib_blocks(bytes_of(values));
  }

  std::string xml_, appended_;
};

}  // namespace

std::string zlib_blocks(const std::string& bytes) {
  const std::size_t blocks = (bytes.size() + block_size - 1) / block_size;
  std::vector<std::uint64_t> header{blocks, block_size, bytes.size() % block_size};
  std::string data;
  for (std::size_t k = 0; k < blocks; ++k) {
    const std::string block = compressed(bytes.substr(k * block_size, block_size));
    header.push_back(block.size());
    data += block;
  }
  return bytes_of(header) + data;
}

std::string vtu_text(const VtuMesh& mesh) { return Writer().text(mesh); }

std::string pvd_text(const std::vector<PvdEntry>& entries) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const PvdEntry& entry : entries)
    for (std::size_t part = 0; part < entry.files.size(); ++part)
      text +=
          fmt::format("<DataSet timestep=\"{:.17g}\" part=\"{}\" file=\"{}\"/>\n", entry.time, part, entry.files[part]);
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace percal
