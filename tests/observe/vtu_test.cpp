// The files are decoded here by rules written down anew: offsets, headers of blocks, zlib.
#include <gtest/gtest.h>

#include "observe/vtu_reader.hpp"

namespace percal {
namespace {

VtuMesh a_square_and_a_triangle() {
  VtuMesh mesh;
  mesh.time = 1.25e-7;
  mesh.points = {0, 0, 0, 1e-6, 0, 0, 1e-6, 1e-6, 0, 0, 1e-6, 0, 5e-7, 2e-6, 0};
  mesh.corners = {0, 1, 2, 3, 3, 2, 4};
  mesh.ends = {4, 7};
  mesh.point_data = {{"velocity", 3, std::vector<float>{1, 2, 0, 3, 4, 0, 5, 6, 0, 7, 8, 0, 9, 10, 0}}};
  mesh.cell_data = {{"eroded", 1, std::vector<std::uint8_t>{0, 1}}, {"energy", 1, std::vector<float>{0.5f, -2}}};
  return mesh;
}

TEST(Vtu, ComesBackWithEveryArray) {
  const VtuMesh mesh = a_square_and_a_triangle();
  const VtuReader file(vtu_text(mesh));
  EXPECT_EQ(file.attribute("<Piece ", "NumberOfPoints"), "5");
  EXPECT_EQ(file.attribute("<Piece ", "NumberOfCells"), "2");
  EXPECT_EQ(file.array<double>("Points", "Float64"), mesh.points);
  EXPECT_EQ(file.array<std::int32_t>("connectivity", "Int32"), mesh.corners);
  EXPECT_EQ(file.array<std::int32_t>("offsets", "Int32"), mesh.ends);
  EXPECT_EQ(file.array<std::uint8_t>("types", "UInt8"), (std::vector<std::uint8_t>{9, 7}));
  EXPECT_EQ(file.array<float>("velocity", "Float32"), std::get<std::vector<float>>(mesh.point_data[0].values));
  EXPECT_EQ(file.array<std::uint8_t>("eroded", "UInt8"), (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(file.array<float>("energy", "Float32"), (std::vector<float>{0.5f, -2}));
  EXPECT_EQ(file.attribute("Name=\"velocity\"", "NumberOfComponents"), "3");
  EXPECT_NE(file.text().find(">1.2499999999999999e-07</DataArray>"), std::string::npos);
}

// Below a block, exactly one, exactly two, and more.
TEST(ZlibBlocks, ComeBackWhateverTheirNumber) {
  for (const std::size_t size : {0, 1, 1000, 32767, 32768, 32769, 65536, 200001}) {
    std::string bytes;
    for (std::size_t k = 0; k < size; ++k) bytes += static_cast<char>(k * k % 251);
    EXPECT_EQ(unpacked(zlib_blocks(bytes)), bytes) << size;
  }
}

TEST(ZlibBlocks, OfZerosAreSmall) { EXPECT_LT(zlib_blocks(std::string(1 << 20, '\0')).size(), 1u << 14); }

TEST(Pvd, ListsThePartsOfEachTime) {
  const std::string text = pvd_text({{0, {"a_0.vtu", "b_0.vtu"}}, {1e-6, {"a_1.vtu"}}});
  EXPECT_NE(text.find("<DataSet timestep=\"0\" part=\"0\" file=\"a_0.vtu\"/>\n"
                      "<DataSet timestep=\"0\" part=\"1\" file=\"b_0.vtu\"/>\n"
                      "<DataSet timestep=\"9.9999999999999995e-07\" part=\"0\" file=\"a_1.vtu\"/>\n</Collection>"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace percal
