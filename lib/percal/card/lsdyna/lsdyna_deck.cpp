#include <fmt/core.h>

#include "percal/card/card_text.hpp"
#include "percal/card/lsdyna/lsdyna.hpp"

namespace percal {
namespace {

std::string ten(const std::vector<std::string>& fields) { return fixed_line(fields, 10); }

std::string field(double value) { return number_field(value, 10); }

// *SET_NODE_LIST and what `face` may not do.
std::string node_set(int id, const Face& face) {
  return "*SET_NODE_LIST\n" + ten({std::to_string(id)}) + ten(fields_of(face));
}

// One direction is held: 1 in its column.
std::string held(int set, const std::string& x, const std::string& y, const std::string& z) {
  return "*BOUNDARY_SPC_SET\n" + ten({std::to_string(set), "0", x, y, z, "0", "0", "0"});
}

std::string control(int steps) {
  std::string text = "*CONTROL_TERMINATION\n" + ten({fmt::format("{}.", steps)});
  text += "*CONTROL_IMPLICIT_GENERAL\n$   IMFLAG       DT0\n" + ten({"1", "1."});
  text +=
      "*CONTROL_IMPLICIT_SOLUTION\n$   NSOLVR    ILIMIT    MAXREF     DCTOL     ECTOL     RCTOL     LSTOL    ABSTOL\n";
  text += ten({"12", "1", "50", "1.e-6", "1.e-9", "1.e10", "0.9", "1.e-30"});
  text += "*DATABASE_BNDOUT\n" + ten({"1."});
  text += "*DATABASE_NODOUT\n" + ten({"1."});
  text += "*DATABASE_GLSTAT\n" + ten({"1."});
  text += "*DATABASE_BINARY_D3PLOT\n" + ten({"1."});
  text += "*DATABASE_HISTORY_NODE\n" + ten({"2", "3", "6", "7"});
  return text;
}

// *NODE has columns of its own: 8, 3 x 16.
std::string mesh() {
  std::string text = "*NODE\n$    NID               X               Y               Z\n";
  for (const auto& [number, x, y, z] : cube_nodes(1)) {
    text +=
        fmt::format("{:8d}", number) + fixed_line({number_field(x, 16), number_field(y, 16), number_field(z, 16)}, 16);
  }
  text += "*ELEMENT_SOLID\n$    EID     PID      N1      N2      N3      N4      N5      N6      N7      N8\n";
  text += fixed_line({"1", "1", "1", "2", "3", "4", "5", "6", "7", "8"}, 8);
  text += "*PART\ncube\n$      PID     SECID       MID\n" + ten({"1", "1", "1"});
  return text + "*SECTION_SOLID\n$    SECID    ELFORM\n" + ten({"1", "2"});
}

std::string boundary(const DeckOrder& order) {
  std::string text = node_set(1, face_x0) + node_set(2, face_y0) + node_set(3, face_z0) + node_set(4, face_x1);
  text += held(1, "1", "0", "0") + held(2, "0", "1", "0") + held(3, "0", "0", "1");
  text += "*BOUNDARY_PRESCRIBED_MOTION_SET\n$     NSID       DOF       VAD      LCID        SF\n";
  text += ten({"4", "1", "2", "1", field(final_displacement(order, 1))});
  text += "*DEFINE_CURVE\n$     LCID\n" + ten({"1"});
  text += fixed_line({"0.", "0."}, 20);
  return text + fixed_line({fmt::format("{}.", order.test.increments), "1."}, 20);
}

}  // namespace

std::vector<DeckFile> lsdyna_deck(const DeckOrder& order) {
  std::string text =
      "*KEYWORD\n" +
      deck_comments(
          order, 1, SolverLaw::difference, "$",
          {"run: ls-dyna i=" + as_argument(deck_name(order, ".k")) +
               " (double precision); bndout then has the force on the moved nodes, nodout their displacement, at "
               "every step",
           "implicit statics: time runs from 0 to the number of steps and has no meaning; full Newton (ILIMIT 1)",
           "ELFORM 2: eight points for the shape and one for the pressure; it neither locks nor has modes without "
           "stiffness"});
  text += "*TITLE\nuniaxial test of one element\n";
  text += control(order.test.increments) + mesh() + order.card + boundary(order);
  return {{deck_name(order, ".k"), text + "*END\n"}};
}

}  // namespace percal
