// Every reader of a user's file, fed by libFuzzer with anything. PERCAL_FUZZ names the reader. A reader may refuse (BadInput, IoFailure); what else
// it throws, and what a sanitizer finds, is a finding.                                             docs/testing.md
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "pages.hpp"
#include "percal/base/error.hpp"
#include "percal/calibrate/job.hpp"
#include "percal/card/solver.hpp"
#include "percal/fit/read/read_curves.hpp"
#include "percal/identify/job.hpp"
#include "percal/page/html.hpp"
#include "percal/page/text.hpp"
#include "percal/powder/job.hpp"
#include "percal/predict/predictor.hpp"
#include "percal/problem/problem.hpp"
#include "percal/scaling/scale_job.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/store/store.hpp"
#include "percal/sweep/scene_at.hpp"
#include "percal/text/csv.hpp"
#include "percal/units/quantity.hpp"

namespace percal {
namespace {

// A folder of its own, with the tables and scenes that the jobs of data/ and of percal new name, in which the input is a file.
const std::string& folder() {
  static const std::string& place = *new std::string([] {  // outlives what atexit does
    std::string name = std::filesystem::temp_directory_path() / "percal_fuzz_XXXXXX";
    if (!mkdtemp(name.data())) std::abort();
    for (const char* tables : {PERCAL_DATA "/guha2009", PERCAL_DATA "/synthetic", PERCAL_TEMPLATES})
      for (const auto& entry : std::filesystem::directory_iterator(tables))
        if (const auto file = entry.path().filename();
            file.extension() == ".csv" || file == "gold.toml" || file == "campaign_scene.toml")
          std::filesystem::copy(entry, name);
    std::atexit([] { std::filesystem::remove_all(folder()); });
    return name;
  }());
  return place;
}

std::string as_file(const std::string& input, const std::string& name) {
  const std::string path = folder() + "/" + name;
  std::ofstream(path, std::ios::binary) << input;
  return path;
}

void read_card_of(const char* solver, const std::string& input) {
  read_card({.text = input, .file = "card", .solver = solver, .units = "mm-t-s-MPa", .name = ""});
}

void read_result_and_show(const std::string& input) {
  const page::ReadResult result = tools::read_result(as_file(input, "result.json"));
  page::as_text(result.page, {.columns = 80, .colour = false, .detail = page::Detail::more});
  page::html(result.page, {});
}

void open_store(const std::string& input) {
  const std::string path = as_file(input, "percal.store");
  for (const char* beside : {"-wal", "-shm"}) std::filesystem::remove(path + beside);
  Store store(path);
  store.with_prefix("");
}

// The first points alone: a plan may have a hundred thousand.
void read_plan_and_scenes(const std::string& input) {
  const Plan plan = read_plan(as_file(input, "plan.toml"));
  for (std::size_t k = 0; k < std::min<std::size_t>(plan.points.size(), 4); ++k) scene_at(plan, k);
}

void read_points_of_plan(const std::string& input) {
  as_file(input, "points.csv");
  read_plan_and_scenes("scene = \"gold.toml\"\nlist = \"points.csv\"\n");
}

// The input as the table of sizes by mass, and as that of speeds by size.
void read_tables_of_powder(const std::string& input) {
  as_file(input, "table.csv");
  const std::string gold = "calibration = \"skin.out\"\n[powder]\ndensity = \"19300 kg/m3\"\n";
  for (const char* rest : {"speed = \"600 m/s\"\n[powder.radius]\nfile = \"table.csv\"\nweighting = \"mass\"\n",
                           "radius = \"1 um\"\n[powder.speed]\nby_size = \"table.csv\"\n"})
    try {
      read_powder_job(as_file(gold + rest, "powder.toml"));
    } catch (const BadInput&) {
    }
}

// What a calibration keeps, and a shot by each of its hypotheses.
void predict_by(const std::string& input) {
  const std::string file = as_file(input, "result.json");
  const ShotModel model = kept_shot_model(tools::read_json_result(file).json, file);
  const FiredShot& fired = model.shots.front();
  const SphereShot shot = fired;
  for (std::size_t k = 0; k < model.hypotheses.size(); ++k)
    Predictor(model, static_cast<int>(k), fired.material, model.level).depths(std::span(&shot, 1), 0);
}

void need(bool is_so) {
  if (!is_so) std::abort();
}

// The input as the corners of a body, in STL and as a table. A body that is accepted has a size and can be computed.
void read_bodies(const std::string& input) {
  as_file(input, "body.stl");
  as_file(input, "body.csv");
  for (const char* corners : {"\"body.stl\"\nstl_unit = \"1 mm\"", "\"body.csv\""}) try {
      const Scene scene = read_scene(as_file(std::string("geometry = \"block\"\n[particle]\nshape = \"polyhedron\"\n"
                                                         "density = \"7 t/m3\"\nspeed = \"50 m/s\"\nvertices = ") +
                                                 corners +
                                                 "\n[target]\ndensity = \"1 t/m3\"\nmu = \"1 MPa\"\nalpha = 9\n"
                                                 "depth = \"1 m\"\nwidth = \"1 m\"\n",
                                             "scene.toml"));
      const RigidPolyhedron body = std::get<RigidPolyhedron>(reduce(scene).problem.particle);
      need(std::isfinite(body.mass) && body.mass > 0);
      for (const auto& vertex : body.vertices)
        for (const double coordinate : vertex) need(std::isfinite(coordinate));
    } catch (const BadInput&) {
    }
}

// The input as the record of a shot, of depths and of speeds; what is read of it is a number.
void read_trajectories(const std::string& input) {
  as_file(input, "flight.csv");
  const std::string job =
      "[parameters.mu]\nkind = \"modulus\"\nlow = \"50 kPa\"\nhigh = \"900 kPa\"\n[materials.gel]\n"
      "density = \"1010 kg/m3\"\nmu = \"mu\"\nalpha = 8\nerosion_strain = 0.8\n[[shots]]\nname = \"balls\"\n"
      "material = \"gel\"\nlayer_depth = \"1 m\"\n[[shots.points]]\ndiameter = \"3 mm\"\n"
      "particle_density = \"7800 kg/m3\"\nspeed = \"80 m/s\"\ntrajectory = \"flight.csv\"\n";
  for (const char* column : {"trajectory_depth = \"depth\"\n", "trajectory_speed = \"speed\"\n"}) try {
      for (const MeasuredShot& shot : read_calibration_job(as_file(job + column, "calibrate.toml")).shots) {
        need(std::isfinite(shot.depth) && shot.depth > 0);
        need(std::isfinite(shot.depth_error) && shot.depth_error >= 0);
      }
    } catch (const BadInput&) {
    }
}

void read_quantity(const std::string& input) {
  try {
    parse_quantity(input);
  } catch (const std::invalid_argument&) {
  }
}

using Reader = std::function<void(const std::string&)>;
const std::map<std::string, Reader> readers{
    {"scene", [](const std::string& input) { read_scene(as_file(input, "scene.toml")); }},
    {"scale", [](const std::string& input) { read_scale_job(as_file(input, "scale.toml")); }},
    {"identify", [](const std::string& input) { read_identify_job(as_file(input, "identify.toml")); }},
    {"calibrate", [](const std::string& input) { read_calibration_job(as_file(input, "calibrate.toml")); }},
    {"campaign", read_plan_and_scenes},
    {"points", read_points_of_plan},
    {"dose", [](const std::string& input) { read_powder_job(as_file(input, "powder.toml")); }},
    {"powder", read_tables_of_powder},
    {"model", predict_by},
    {"csv", [](const std::string& input) { read_csv(as_file(input, "table.csv")); }},
    {"curves", [](const std::string& input) { read_curves({as_file(input, "curve.csv")}, {.mode = "uniaxial"}); }},
    {"quantity", read_quantity},
    {"stl", read_bodies},
    {"trajectory", read_trajectories},
    {"lsdyna", [](const std::string& input) { read_card_of("lsdyna", input); }},
    {"abaqus", [](const std::string& input) { read_card_of("abaqus", input); }},
    {"calculix", [](const std::string& input) { read_card_of("calculix", input); }},
    {"openradioss", [](const std::string& input) { read_card_of("openradioss", input); }},
    {"febio", [](const std::string& input) { read_card_of("febio", input); }},
    {"ansys", [](const std::string& input) { read_card_of("ansys", input); }},
    {"result", read_result_and_show},
    {"store", open_store},
};

const Reader& chosen() {
  const char* name = std::getenv("PERCAL_FUZZ");
  const auto found = readers.find(name ? name : "");
  if (found != readers.end()) return found->second;
  std::fprintf(stderr, "PERCAL_FUZZ names the reader:");
  for (const auto& [word, reader] : readers) std::fprintf(stderr, " %s", word.c_str());
  std::fprintf(stderr, "\n");
  std::exit(2);
}

}  // namespace
}  // namespace percal

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  percal::chosen();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const percal::Reader reader = percal::chosen();
  try {
    reader(std::string(reinterpret_cast<const char*>(data), size));
  } catch (const percal::BadInput&) {
  } catch (const percal::IoFailure&) {
  }
  return 0;
}
