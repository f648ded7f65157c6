// What the command line says, one struct a command. options.cpp fills them; a file for each command runs it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/base/error.hpp"
#include "percal/one_depth/request.hpp"
#include "percal/predict/request.hpp"

namespace percal::tools {

struct Common {
  std::string out;     // folder for results; empty: NAME.out in the working folder; none: no files
  std::string store;   // evaluation store; empty: default_store_path()
  int threads = 0;     // evaluations side by side; 0: as many as there are cores
  bool json = false;   // print the result on standard output
  bool check = false;  // read and validate, run nothing
  bool quiet = false;
  bool details = false;  // print everything that the page has, not the answer alone

  // Batches of runs are made by Slurm, by this much that its options say; none: here.
  struct Cluster {
    bool wanted = false;
    std::string partition, time, folder;  // empty: the cluster's own; NAME.slurm in the working folder
    int batch = 0, at_once = 0;           // 0: about a minute's work a task; as many tasks as the cluster lets
    bool dry_run = false;                 // print the script, run nothing
  } cluster = {};

  bool talks() const { return !quiet && !json; }
};

struct FitArguments {
  std::vector<std::string> files;  // or WORD=FILE, with the deformation of that file
  std::vector<std::string> mode;   // WORD of all files, WORD=FILE of one; empty: from the `mode` column
  std::string model = "ogden";
  std::string residual = "relative";                                    // relative, absolute, error
  std::string weights = "points";                                       // points, tests, NAME=NUMBER,...
  std::string loss = "squares";                                         // squares, huber, cauchy
  bool unconstrained = false;                                           // single moduli may be negative
  bool compare = false;                                                 // all models
  std::string stable = "0.1:10";                                        // stretches over which stability is looked at
  std::string x, y, error;                                              // columns; empty: found by their names
  std::vector<std::string> where;                                       // COLUMN=VALUE
  std::string gauge_length, area, width, thickness, specimen_diameter;  // of the specimen of force and displacement
  std::string branch, until, without;                                   // loading, unloading or a number; peak; holds
  std::string relaxation;                                               // 1, 2, 3 or auto; empty: none
  std::string time;                                                     // column; empty: found by its name
  std::vector<std::string> rate;  // RATE of all files, RATE=FILE of one: of tables without times
  bool intervals = true;
  double level = 0.95;
  int bootstrap = 0;         // replicates; 0: none
  bool rate_factor = false;  // two curves, low rate first: one factor between them
  std::string rate_column;   // one file instead: its rows have one of two rates here
};

struct ScaleArguments {
  std::string job;
  std::string write_scene;  // write the similar scene here; empty: as the job says
};

struct ImpactArguments {
  std::string scene;
  std::optional<double> elements_per_radius;
  std::optional<int> replicates;
  std::optional<std::string> arithmetic;
  std::string history;          // CSV file; empty: as the scene says
  std::string fields;           // every=...; empty: none
  std::string picture;          // PNG, SVG or PDF file; empty: none
  std::string accuracy;         // "2%" or "0.02"; empty: mesh and replicates as the scene says
  bool measure_errors = false;  // of wall, time step and K by more runs, not by rule
  bool extrapolate = false;     // to h = 0 from this mesh and one of half its elements
};

struct IdentifyArguments {
  std::string job;
};

struct CalibrateArguments {
  std::string job;
  std::string budget;  // "60s"; empty: no limit
};

struct PredictArguments {
  std::string result;
  PredictWords words;
  bool verify = false;  // run the solver at every shot
};

// Of percal dose and percal design.
struct PowderArguments {
  std::string job;
};

struct InvertArguments {
  InvertWords words;
};

// One of the three kinds of study; `scene` is empty where it brings its own.
struct StudyArguments {
  std::string scene;
  bool error_vs_time = false;
  bool omissions = false;
  bool extremes = false;
  std::string markdown;        // page to write; empty: none
  std::vector<double> meshes;  // elements per radius; empty: the default ladder
  std::optional<int> replicates;
};

struct CampaignArguments {
  std::string plan;
  bool estimate = false;  // say what it will cost, and run nothing but samples
};

struct WorkArguments {
  std::string list;
};

struct AtlasArguments {
  std::string plan;  // of write
  std::string file;  // where to write
  int points = 20;   // of check
};

struct CardArguments {
  std::string result;  // of write
  std::string card;    // of read and check
  std::string solver;  // a word of solvers(), or csv
  std::string units;   // empty: si to write, the card's own to read
  std::string file;    // where to write; empty: standard output
  std::string deck;    // uniaxial; empty: the card alone
  double stretch = 2;
  int increments = 20;
  std::string name;          // of the card to take, or of the card of a fit
  std::string density;       // with its unit
  std::string element_size;  // the user's, with its unit; empty: the erosion strain as it was found
  std::string shot;          // a scene of the result that says how deep; empty: the first
  std::optional<double> bulk_to_shear, nu;
  std::string mode = "uniaxial";  // of a curve
  std::string range;              // LOW:HIGH of its stretches; empty: 0.5:2, in shear 0:1
  int points = 31;
  std::string csv;     // of check: file for the curve
  bool force = false;  // of write: a card of contradicted data too
};

struct ReportArguments {
  std::vector<std::string> results;  // one, or two to compare
  std::string file;                  // page; empty: report.html beside the first result, explore.html of `explore`
  std::string plots;                 // folder for the figures; empty: none
  bool explore = false;              // a page to play with, of a calibration
  bool open = false;                 // show the page in the browser
};

struct StoreArguments {
  std::vector<std::string> sources;  // of merge
};

struct NewArguments {
  std::string kind;
  std::string file;  // where to write; empty: standard output
  bool all = false;  // every key, not those alone that one needs
};

struct KeysArguments {
  std::string kind = "scene";
  bool markdown = false;
};

struct CompletionArguments {
  std::string shell;
};

struct ManArguments {
  std::vector<std::string> words;  // of the command
  std::string folder;              // for all pages; empty: one on standard output
};

struct DescribedCommand;

Exit run_fit(const FitArguments&, const Common&);
Exit run_scale(const ScaleArguments&, const Common&);
Exit run_impact(const ImpactArguments&, const Common&);
Exit run_identify(const IdentifyArguments&, const Common&);
Exit run_calibrate(const CalibrateArguments&, const Common&);
Exit run_predict(const PredictArguments&, const Common&);
Exit run_dose(const PowderArguments&, const Common&);
Exit run_design(const PowderArguments&, const Common&);
Exit run_invert(const InvertArguments&, const Common&);
Exit run_study(const StudyArguments&, const Common&);
Exit run_campaign(const CampaignArguments&, const Common&);
Exit run_atlas_write(const AtlasArguments&, const Common&);
Exit run_atlas_check(const AtlasArguments&, const Common&);
Exit run_work(const WorkArguments&);
Exit run_card_write(const CardArguments&, const Common&);
Exit run_card_read(const CardArguments&, const Common&);
Exit run_card_check(const CardArguments&, const Common&);
Exit run_store_merge(const StoreArguments&, const Common&);
Exit run_report(const ReportArguments&, const Common&);
Exit run_new(const NewArguments&, const Common&);
Exit run_keys(const KeysArguments&, const Common&);
Exit run_completion(const CompletionArguments&, const DescribedCommand& program);
Exit run_man(const ManArguments&, const DescribedCommand& program);

// Where a command's files go: NAME.out in the working folder, NAME the stem of its first input, or what --out says; empty where --out
// is none.
std::string folder_named(const std::string& first_input, const Common&);

// The same, made. Throws IoFailure where it cannot be written to, BadInput where a result would replace an input.
std::string out_folder(const std::string& first_input, const Common&);
// The file of the evaluation store: --store, or the user's own.
std::string store_file(const Common&);

// Throws BadInput where a TOML file is a scene or a job, which this command does not take. Others are left to their readers.
void refuse_document(const std::string& file, const std::string& accepted);

}  // namespace percal::tools
