#include "percal/cluster/worker.hpp"

#include "percal/base/error.hpp"
#include "percal/campaign/campaign.hpp"
#include "percal/cluster/work_folder.hpp"
#include "percal/math/instruction_level.hpp"
#include "percal/text/file.hpp"

namespace percal {

WorkDone work_through(const std::string& list_file) {
  const WorkFolder folder(work_folder_of(list_file));
  Campaign campaign(nullptr, 1);
  WorkDone work;
  int line = 0;
  for (const std::string& key : keys_of(read_file(list_file))) {
    ++line;
    const auto problem = problem_of_key(key, instruction_level());
    if (!problem)
      throw BadInput(
          {.file = list_file, .line = line, .key = ""}, "\"" + key + "\"",
          "an evaluation of this version of percal at this processor's instruction level, " + instruction_level());
    if (folder.has_result(key)) {
      ++work.found;
      continue;
    }
    folder.put_result({key, as_stored(campaign.evaluate(*problem))});
    ++work.done;
  }
  return work;
}

}  // namespace percal
