// A cluster for tests: sbatch, squeue and scontrol as scripts that run the tasks here. Where the file "lose" is, the first task of the next
// array never starts, as on a node that is gone.
#pragma once
#include <algorithm>
#include <cstdlib>
#include <string>

#include "support/program.hpp"
#include "sweep/small_plan.hpp"

namespace percal::test {

class FakeSlurm : public PlanFolder {
 protected:
  FakeSlurm() {
    script("sbatch", R"(cat > "$HERE/script.$$"
[ -e "$HERE/refuse" ] && { echo 'sbatch: error: invalid partition specified' >&2; exit 1; }
name=$(sed -n 's/^#SBATCH --job-name=//p' "$HERE/script.$$")
last=$(sed -n 's/^#SBATCH --array=0-\([0-9]*\).*/\1/p' "$HERE/script.$$")
for task in $(seq 0 "$last"); do
  if [ "$task" = 0 ] && [ -e "$HERE/lose" ]; then rm "$HERE/lose"; continue; fi
  echo "$name $task" > "$HERE/queue/$name.$task"
  (SLURM_ARRAY_TASK_ID=$task sh "$HERE/script.$$" > "$HERE/log.$task" 2>&1; rm "$HERE/queue/$name.$task") > /dev/null 2>&1 &
done
echo $$ >> "$HERE/submitted"
echo $$
)");
    script("squeue", "cat \"$HERE\"/queue/* 2>/dev/null\nexit 0\n");
    script("scontrol", "echo 'MaxArraySize            = 5'\n");
    std::filesystem::create_directories(path("cluster/queue"));
  }

  // The program where this cluster is on PATH.
  Ended run_there(const std::vector<std::string>& arguments) const { return wait_for(start_there(arguments)); }
  pid_t start_there(const std::vector<std::string>& arguments) const {
    return start(arguments, [&] {
      setenv("HERE", path("cluster").c_str(), 1);
      setenv("PATH", (path("cluster/bin") + ":" + std::getenv("PATH")).c_str(), 1);
    });
  }
  int arrays() const {
    const std::string text = read("cluster/submitted");
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  }
  // Eight runs.
  std::string eight() const { return plan_file(ranged("particle.speed", "\"60 m/s\"", "\"180 m/s\"", "count = 8\n")); }

 private:
  void script(const std::string& name, const std::string& text) const {
    const std::string file = write("cluster/bin/" + name, "#!/bin/sh\n" + text);
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }
};

}  // namespace percal::test
