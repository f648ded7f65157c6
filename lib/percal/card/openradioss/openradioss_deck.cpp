#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/card/card_text.hpp"
#include "percal/card/openradioss/openradioss.hpp"

namespace percal {
namespace {

// The run lasts this many times edge sqrt(rho/mu), the time of a shear wave through the cube.
constexpr double shear_wave_passages = 200;
constexpr double run_on = 1.02;                  // of that time, so that the last stretch is recorded too
constexpr std::size_t least_job_characters = 4;  // OpenRadioss'

std::string ten(const std::vector<std::string>& fields) { return fixed_line(fields, 10); }
// The engine file is free-form: two fields that touch are one.
std::string free_line(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) line += " " + field;
  return line + "\n";
}
std::string twenty(const std::vector<std::string>& fields) { return fixed_line(fields, 20); }

// Edge 1 in the deck's units.
double duration(const DeckOrder& order) {
  const double density = order.material.density / order.units.density();
  return shear_wave_passages * std::sqrt(density / (shear_modulus(order.material) / order.units.stress));
}

// sum (2 mu/alpha^2) (lambda^alpha + 2 lambda^(-alpha/2) - 3), in the deck's units.
double strain_energy(const DeckOrder& order, double stretch) {
  double sum = 0;
  for (const Ogden& term : order.material.terms) {
    sum += 2 * term.mu / (term.alpha * term.alpha) *
           (std::pow(stretch, term.alpha) + 2 * std::pow(stretch, -term.alpha / 2) - 3);
  }
  return sum / order.units.stress;
}

// Kinetic over strain energy of the incompressible cube at half time, when it is fastest: the velocity is linear in the
// place, v along x and v lambda^(-3/2)/2 along both sides.
double energy_ratio(const DeckOrder& order) {
  const double middle = (1 + order.test.stretch) / 2;
  const double speed = 2 * final_displacement(order, 1) / duration(order);
  const double density = order.material.density / order.units.density();
  const double kinetic = density * speed * speed / 6 * (1 + std::pow(middle, -3) / 2);
  return kinetic / strain_energy(order, middle);
}

std::string comments(const DeckOrder& order) {
  return deck_comments(
      order, 1, SolverLaw::quadratic, "#",
      {"run: starter_linux64_gf -i " + order.job + "_0000.rad, then engine_linux64_gf -i " + order.job +
           "_0001.rad, then th_to_csv " + order.job +
           "T01: the displacement DX of the moved nodes 2, 3, 6, 7, and true stress SX and density DENS of the "
           "element: "
           "nominal stress = SX J / stretch with J = RHO_I / DENS. REACX is an impulse: the force is its slope over "
           "time",
       fmt::format(
           "explicit, but slow: {:g} times the time a shear wave takes through the cube. The speed grows linearly "
           "to half time and falls linearly to 0 (/FUNCT/1), so that nothing is struck, and the run goes on a little, "
           "so that "
           "the last stretch is recorded. Kinetic energy halfway: "
           "about {:.1g} of the strain energy",
           shear_wave_passages, energy_ratio(order)),
       "Isolid 24 (one point, stabilised): no locking at a large K/mu; Ismstr 10: total strain, as Ogden's law wants "
       "it"});
}

// SI values of the units, twice: read in these units, computed in them.
std::string begin(const DeckOrder& order) {
  const std::string units =
      twenty({number_field(order.units.mass), number_field(order.units.length), number_field(order.units.time)});
  return "/BEGIN\n" + order.job + "\n" + ten({"2022", "0"}) +
         "#               mass              length                time\n" + units + units;
}

std::string mesh(const std::string& material) {
  std::string text = "/NODE\n#  node_ID                   X                   Y                   Z\n";
  for (const auto& [number, x, y, z] : cube_nodes(1)) {
    text += fmt::format("{:10d}", number) + twenty({number_field(x), number_field(y), number_field(z)});
  }
  text += "/BRICK/1\n" + ten({"1", "1", "2", "3", "4", "5", "6", "7", "8"});
  text += "/PART/1\ncube\n" + ten({"1", material, "0"});
  text += "/PROP/SOLID/1\ncube\n";
  text += "#   Isolid    Ismstr      Iale     Icpre  Itetra10     Inpts   Itetra4    Iframe                  dn\n";
  text += fmt::format("{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:>20}\n", 24, 10, 0, 0, 0, 0, 0, 0, "0.");
  text += "#                 qa                  qb                   h\n" + twenty({"0.", "0.", "0.", "0.", "0."});
  return text + "#             dt_min   Istrain\n" + fmt::format("{:>20}{:10d}\n", "0.", 0);
}

std::string group(int id, const std::string& name, const Face& face) {
  return fmt::format("/GRNOD/NODE/{}\n{}\n", id, name) + ten(fields_of(face));
}

std::string held(int id, const std::string& name, const std::string& directions) {
  return fmt::format("/BCS/{0}\nhold_{1}\n#  Tra rot   skew_ID  grnod_ID\n   {2} 000{3:10d}{0:10d}\n", id, name,
                     directions, 0);
}

std::string boundary(const DeckOrder& order) {
  const double time = duration(order);
  std::string text =
      group(1, "x0", face_x0) + group(2, "y0", face_y0) + group(3, "z0", face_z0) + group(4, "x1", face_x1);
  text += held(1, "x0", "100") + held(2, "y0", "010") + held(3, "z0", "001");
  text += "/FUNCT/1\nspeed, whose integral is the displacement\n";
  text += twenty({"0.", "0."}) +
          twenty({number_field(time / 2), number_field(2 * final_displacement(order, 1) / time)}) +
          twenty({number_field(time), "0."}) + twenty({number_field(2 * time), "0."});
  text += "/IMPVEL/1\nstretch\n#  funct_ID       Dir   skew_ID sensor_ID  grnod_ID  frame_ID     Icoor\n";
  text += ten({"1", "X", "0", "0", "4", "0", "0"});
  text += "#           Ascale_x            Fscale_Y              Tstart               Tstop\n";
  return text + twenty({"1.", "1.", "0.", "1.e30"});
}

std::string history() {
  std::string text = "/TH/NODE/1\nmoved nodes\n" + fmt::format("{:<10}{:<10}\n", "DX", "REACX");
  for (const int node : face_x1) text += ten({std::to_string(node), "0"});
  text += "/TH/BRIC/2\ncube\n" + fmt::format("{:<10}\n", "DEF") + ten({"1"});
  return text + "/TH/PART/3\nenergies\n" + fmt::format("{:<10}{:<10}\n", "IE", "KE") + ten({"1"});
}

std::string engine(const DeckOrder& order) {
  const double time = duration(order);
  std::string text = comment_lines("#", "engine file of " + order.job + ": run after the starter");
  text += "/RUN/" + order.job + "/1\n" + free_line({number_field(run_on * time)});
  text += "/VERS/2022\n/DT\n" + free_line({"0.9", "0."});
  text += "/TFILE\n" + free_line({number_field(time / order.test.increments)}) + "/TH/TITLE\n";
  text += "/PRINT/-1000\n/ANIM/DT\n" + free_line({"0.", number_field(time / 10)});
  return text + "/ANIM/VECT/DISP\n/ANIM/VECT/FREAC\n/ANIM/BRICK/TENS/STRESS/ALL\n";
}

}  // namespace

std::vector<DeckFile> openradioss_deck(const DeckOrder& given) {
  DeckOrder order = given;
  order.job.resize(std::max(order.job.size(), least_job_characters), '_');
  std::string text = "#RADIOSS STARTER\n" + comments(order) + begin(order);
  text += mesh(text_after(order.card, "/MAT/LAW42/", "/ ")) + order.card + boundary(order) + history();
  return {{order.job + "_0000.rad", text + "/END\n"}, {order.job + "_0001.rad", engine(order)}};
}

}  // namespace percal
