// percal study: what a scene's settings are worth, and what the solver survives.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cluster.hpp"
#include "pages.hpp"
#include "percal/base/progress.hpp"
#include "percal/campaign/campaign.hpp"
#include "percal/impact/target/size.hpp"
#include "percal/math/instruction_level.hpp"
#include "percal/page/figures.hpp"
#include "percal/page/markdown.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/study/kept_ladder.hpp"
#include "percal/study/page/error_vs_time.hpp"
#include "percal/study/page/extremes.hpp"
#include "percal/study/page/omissions.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {
namespace {

using page::Json;

// Where the runs come from and the results go.
struct Study {
  Study(const std::string& first_input, const StudyArguments& arguments, const Common& common)
      : folder(writable_folder(first_input, arguments, common)),
        runs(common, first_input.empty() ? "study" : first_input) {}

  page::Cost cost() const {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    const CampaignCost done = campaign.cost();
    return {.runs = done.runs,
            .reused = done.reused,
            .cpu_seconds = done.cpu_seconds,
            .wall_seconds = wall.count(),
            .instruction_level = instruction_level()};
  }

  static std::string writable_folder(const std::string& first_input, const StudyArguments& arguments,
                                     const Common& common) {
    if (!arguments.markdown.empty()) ensure_writable_file(arguments.markdown);
    return out_folder(first_input, common);
  }

  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  std::string folder;
  Runs runs;
  Campaign& campaign = runs.campaign;
};

Exit checked_scene(const std::string& file, long runs, const Problem& largest, const Common& common) {
  const RunSize size = size_of(largest);
  return say_valid(
      fmt::format("{}: a scene that can be studied, {} runs, the largest of {}", file, runs, in_words(size)),
      {{"command", "study"}, {"scene", file}}, common, size);
}

// The page with links to its figures, which lie in the folder, or beside the page where there is none.
bool write_markdown(const page::Page& page, const std::string& file, const std::string& folder) {
  const auto beside = std::filesystem::absolute(file).parent_path();
  const auto figures = folder.empty() ? beside : std::filesystem::absolute(folder);
  write_file(file, page::markdown(page, page::Detail::more, std::filesystem::proximate(figures, beside).string()));
  return !folder.empty() || page::write_figures(page, figures.string(), page::Pictures::svg);
}

// Table and figures beside what every command writes and prints.
void finish(const Json& result, const std::string& csv_name, const std::string& csv, const Study& study,
            const StudyArguments& arguments, const Common& common) {
  deliver(result, study.folder, common);
  const page::Page page = study_page(result);
  bool drawn = true;
  if (!study.folder.empty()) {
    write_file(study.folder + "/" + csv_name, csv);
    drawn = page::write_figures(page, study.folder, page::Pictures::svg);
  }
  if (!arguments.markdown.empty()) drawn &= write_markdown(page, arguments.markdown, study.folder);
  if (!drawn && common.talks()) fmt::print("the figures were not drawn: no gnuplot; CSV files have their points\n");
}

Exit error_vs_time_study(const StudyArguments& arguments, const Common& common) {
  const Scene scene = read_scene(arguments.scene);
  LadderOptions options = usual_ladder(scene);
  if (!arguments.meshes.empty()) options.meshes = arguments.meshes;
  if (arguments.replicates) options.replicates = *arguments.replicates;
  options = checked(options, scene);
  if (common.check) return checked_scene(arguments.scene, ladder_runs(options), finest_problem(options, scene), common);
  Study study(arguments.scene, arguments, common);
  const Ladder ladder = [&] {
    Progress progress("study", ladder_runs(options));
    return run_ladder(scene, options, study.campaign, &progress);
  }();
  keep_ladder(study.runs.store, study_key(scene), ladder.options);
  const ErrorVsTime found = error_vs_time(ladder);
  std::vector<AdvisedSetting> advice;
  for (const double target : advised_errors) advice.push_back(advise(ladder, found, target));
  const Json result = error_vs_time_to_json(scene, ladder, found, advice, study.cost());
  finish(result, "error_vs_time.csv", error_vs_time_csv(result), study, arguments, common);
  return found.is_answered() ? Exit::done : Exit::outcome_not_reached;
}

Exit omissions_study(const StudyArguments& arguments, const Common& common) {
  const Scene scene = read_scene(arguments.scene);
  const int replicates = arguments.replicates.value_or(audit_replicates);
  const Reduction reduction = reduce(scene);
  refuse_what_is_too_large(reduction.problem, arguments.scene);
  if (common.check) {
    const auto plan = plan_omissions(scene, reduction, std::nullopt);
    Problem largest = reduction.problem;
    for (const auto& variant : plan.variants)
      if (const Problem p = reduce(variant.scene).problem; size_of(p).elements > size_of(largest).elements) largest = p;
    return checked_scene(arguments.scene, replicates * (1 + static_cast<long>(plan.variants.size())), largest, common);
  }
  Study study(arguments.scene, arguments, common);
  const Omissions audit = [&] {
    Progress progress("study", 0);
    return audit_omissions(scene, replicates, [&](const std::vector<Problem>& problems, int runs) {
      progress.expect(static_cast<long>(problems.size()) * runs);
      return study.campaign.replicate(problems, runs, &progress);
    });
  }();
  const Json result = omissions_to_json(scene, audit, study.cost());
  finish(result, "omissions.csv", omissions_csv(result), study, arguments, common);
  return audit.baseline.penetration.depth ? Exit::done : Exit::outcome_not_reached;
}

Exit extremes_study(const StudyArguments& arguments, const Common& common) {
  const auto cells = extreme_cells();
  if (common.check)
    return say_valid(fmt::format("{} cells", cells.size()), {{"command", "study"}, {"cells", cells.size()}}, common);
  Study study("extremes", arguments, common);
  const auto results = [&] {
    Progress progress("study", static_cast<long>(cells.size()));
    return run_extremes(cells, instruction_level(), [&](const std::vector<Problem>& problems) {
      return study.campaign.evaluate(problems, &progress);
    });
  }();
  const Json result = extremes_to_json(results, study.cost());
  finish(result, "extremes.csv", extremes_csv(result), study, arguments, common);
  return has_troubles(results) ? Exit::check_failed : Exit::done;
}

}  // namespace

Exit run_study(const StudyArguments& arguments, const Common& common) {
  if (arguments.extremes) return extremes_study(arguments, common);
  if (arguments.scene.empty())
    throw BadInput(Place{.file = "", .line = 0, .key = "scene"}, "none",
                   "a TOML scene: percal study SCENE --error-vs-time, or --omissions; --extremes takes none");
  return arguments.omissions ? omissions_study(arguments, common) : error_vs_time_study(arguments, common);
}

}  // namespace percal::tools
