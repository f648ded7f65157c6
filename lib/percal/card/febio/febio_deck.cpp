#include <fmt/core.h>

#include <algorithm>

#include "percal/card/card_text.hpp"
#include "percal/card/febio/febio.hpp"

namespace percal {
namespace {

constexpr const char* ending = ".feb";

std::string control(const DeckOrder& order) {
  const double mu = shear_modulus(order.material) / order.units.stress;
  std::string text = "<Control>\n  <analysis>STATIC</analysis>\n";
  text += fmt::format("  <time_steps>{}</time_steps>\n  <step_size>1</step_size>\n", order.test.increments);
  text += "  <solver type=\"solid\">\n    <symmetric_stiffness>symmetric</symmetric_stiffness>\n";
  text += "    <max_refs>50</max_refs>\n    <dtol>1e-6</dtol>\n    <etol>1e-9</etol>\n    <rtol>0</rtol>\n";
  text += "    <min_residual>" + fmt::format("{:.3g}", 1e-20 * mu * mu) + "</min_residual>\n";
  text += "    <qn_method type=\"BFGS\">\n      <max_ups>0</max_ups>\n    </qn_method>\n  </solver>\n";
  return text + "</Control>\n";
}

std::string mesh(const std::string& material) {
  std::string text = "<Mesh>\n  <Nodes name=\"cube_nodes\">\n";
  for (const auto& [number, x, y, z] : cube_nodes(1)) {
    text +=
        fmt::format("    <node id=\"{}\">{},{},{}</node>\n", number, number_field(x), number_field(y), number_field(z));
  }
  text += "  </Nodes>\n  <Elements type=\"hex8\" name=\"" + material +
          "\">\n    <elem id=\"1\">1,2,3,4,5,6,7,8</elem>\n  "
          "</Elements>\n";
  const auto set = [&](const std::string& name, const Face& face) {
    text += "  <NodeSet name=\"" + name + "\">" + listed(face, ",") + "</NodeSet>\n";
  };
  set("x0", face_x0);
  set("y0", face_y0);
  set("z0", face_z0);
  set("x1", face_x1);
  text +=
      "</Mesh>\n<MeshDomains>\n  <SolidDomain name=\"" + material + "\" mat=\"" + material + "\"/>\n</MeshDomains>\n";
  return text;
}

std::string held(const std::string& set, int x, int y, int z) {
  return fmt::format(
      "  <bc name=\"hold_{0}\" type=\"zero displacement\" node_set=\"{0}\">\n    <x_dof>{1}</x_dof>\n    "
      "<y_dof>{2}</y_dof>\n    <z_dof>{3}</z_dof>\n  </bc>\n",
      set, x, y, z);
}

std::string boundary(const DeckOrder& order) {
  std::string text = "<Boundary>\n" + held("x0", 1, 0, 0) + held("y0", 0, 1, 0) + held("z0", 0, 0, 1);
  text += "  <bc name=\"stretch\" type=\"prescribed displacement\" node_set=\"x1\">\n    <dof>x</dof>\n";
  text +=
      "    <value lc=\"1\">" + number_field(final_displacement(order, 1)) + "</value>\n    <relative>0</relative>\n";
  text += "  </bc>\n</Boundary>\n<LoadData>\n  <load_controller id=\"1\" type=\"loadcurve\">\n";
  text += "    <interpolate>LINEAR</interpolate>\n    <extend>CONSTANT</extend>\n    <points>\n      <pt>0,0</pt>\n";
  text += fmt::format("      <pt>{},1</pt>\n    </points>\n  </load_controller>\n</LoadData>\n", order.test.increments);
  return text;
}

std::string output(const DeckOrder& order) {
  std::string text =
      "<Output>\n  <plotfile type=\"febio\">\n    <var type=\"displacement\"/>\n    <var type=\"stress\"/>\n";
  text += "  </plotfile>\n  <logfile>\n    <node_data data=\"ux;Rx\" delim=\",\" file=\"" + order.job +
          "_nodes.csv\">" + listed(face_x1, ",") + "</node_data>\n";
  text += "    <element_data data=\"sx;J\" delim=\",\" file=\"" + order.job + "_element.csv\">1</element_data>\n";
  return text + "  </logfile>\n</Output>\n";
}

std::string comment(const DeckOrder& order) {
  const std::string file = deck_name(order, ending);
  const std::string run =
      file.find("--") == std::string::npos ? as_argument(file) : "with this file";  // "--" ends a comment
  std::vector<std::string> notes{
      "run: febio4 -i " + run + "; " + order.job +
          "_nodes.csv then has displacement ux and reaction Rx of the four moved nodes at every step "
          "(sum them), " +
          order.job + "_element.csv the true stress sx and J: nominal stress = sx J / stretch",
      "hex8 with an uncoupled material: FEBio takes its three-field element, pressure and volume "
      "constant in the "
      "element, which does not lock",
      "time runs from 0 to the number of steps; full Newton (max_ups 0)"};
  if (order.material.erosion)
    notes.push_back("an element that has gone keeps its last stress in " + order.job +
                    "_element.csv: the reactions show that it carries nothing");
  return "<!--\n" + deck_comments(order, 1, SolverLaw::logarithmic, " ", notes) + "-->\n";
}

}  // namespace

// The card is a <Material> section, with a <MeshAdaptor> where it erodes, which stands behind the mesh.
std::vector<DeckFile> febio_deck(const DeckOrder& order) {
  const std::string material = text_after(order.card.substr(order.card.find("<material ")), "name=\"", "\"");
  const std::size_t adaptor =
      std::min(order.card.find("<MeshAdaptor>"), order.card.size());  // after Mesh: it names elements
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + comment(order);
  text += "<febio_spec version=\"4.0\">\n<Module type=\"solid\"/>\n" + control(order);
  text += order.card.substr(0, adaptor) + mesh(material) + order.card.substr(adaptor) + boundary(order) + output(order);
  return {{deck_name(order, ending), text + "</febio_spec>\n"}};
}

}  // namespace percal
