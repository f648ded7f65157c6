#include "cluster.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "colour.hpp"
#include "percal/cluster/coordinator.hpp"
#include "percal/cluster/worker.hpp"
#include "percal/math/instruction_level.hpp"

namespace percal::tools {
namespace {

SlurmOptions slurm_options(const Common& common, const std::string& input) {
  const Common::Cluster& cluster = common.cluster;
  const std::string folder =
      cluster.folder.empty() ? std::filesystem::path(input).stem().string() + ".slurm" : cluster.folder;
  return {.partition = cluster.partition,
          .time = cluster.time,
          .batch = cluster.batch,
          .at_once = cluster.at_once,
          .folder = std::filesystem::absolute(folder).lexically_normal().string(),
          .program = std::filesystem::canonical("/proc/self/exe").string(),
          .level = instruction_level()};
}

}  // namespace

Runs::Runs(const Common& common, const std::string& input)
    : store(store_file(common)), campaign(&store, common.threads) {
  if (!common.cluster.wanted) return;
  cluster_ = std::make_unique<Coordinator>(slurm_options(common, input), store);
  campaign.have_made(*cluster_);
}

Exit print_script(const Common& common, const std::string& input, const std::vector<Problem>& problems) {
  const SlurmOptions options = slurm_options(common, input);
  const std::size_t tasks = in_tasks(problems, options).size();
  print(tasks > 0 ? array_script(options, "ARRAY", static_cast<int>(tasks)) : "nothing is left to run\n");
  return Exit::done;
}

Exit run_work(const WorkArguments& arguments) {
  const WorkDone work = work_through(arguments.list);
  print(fmt::format("{}: {} runs done, {} were there\n", arguments.list, work.done, work.found));
  return Exit::done;
}

}  // namespace percal::tools
