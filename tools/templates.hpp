// Templates of the files that percal reads. They are what `percal new` writes and, with every comment taken off, sample documents
// that the readers are run over for the reference of the keys.
//
// A line that begins with "# " is a key or table that may be left out; one with "## " is a sentence. A note behind " #> "
// says when a key may not stand as it is: "instead of KEY", or "only ..." and what it takes. STEM stands for the name of
// the file without its ending: tables of data are written beside it.
#pragma once
#include <string>
#include <vector>

namespace percal::tools {

struct TextFile {
  std::string name;  // "STEM.toml", "STEM_shots.csv"
  std::string text;
};

// The keys of a table [solver] that scenes and jobs share.
inline const std::string solver_keys = R"(# contact_stiffness = 0.6
# hourglass = 0.5
# hourglass_form = "stiffness"
# volumetric_law = "log-quadratic"
# eroded_nodes = "released"
# linear_viscosity = 0.06
# quadratic_viscosity = 1.2
# time_step_factor = 0.9
# rates = 2
# stiffen_supersonic = false
# arithmetic = "single"
)";

// The first file is the document, the others are what it reads.
using Template = std::vector<TextFile>;

Template scene_template();
Template scale_template();
Template identify_template();
Template calibrate_template();

// Documents that reach what the template leaves out: other shapes, other ways to say a thing. Only their keys matter.
std::vector<Template> scene_variants();
std::vector<Template> scale_variants();
std::vector<Template> identify_variants();
std::vector<Template> calibrate_variants();

// The template with its comments taken off, but for keys whose note says "instead of" or "only".
std::string uncommented(const std::string& text);

// Every STEM in it replaced.
std::string with_stem(std::string text, const std::string& stem);

}  // namespace percal::tools
