// Where a command's runs are made: here, or by Slurm.
#pragma once
#include <memory>
#include <string>

#include "commands.hpp"
#include "percal/campaign/campaign.hpp"

namespace percal::tools {

// A campaign with the store of the command line, whose batches are made where it says.
class Runs {
 public:
  // `input`: the file that the command is about. Throws IoFailure where the folder for the tasks of a cluster cannot be used.
  Runs(const Common& common, const std::string& input);
  Store store;
  Campaign campaign;

 private:
  std::unique_ptr<Elsewhere> cluster_;
};

// The script of the array that these would be, on standard output.
Exit print_script(const Common& common, const std::string& input, const std::vector<Problem>& problems);

}  // namespace percal::tools
