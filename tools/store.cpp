// percal store merge: the evaluations of several stores in one, as after the tasks of a cluster.
#include "percal/store/store.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "colour.hpp"
#include "commands.hpp"

namespace percal::tools {
namespace {

void check_source(const std::string& path, const std::string& target) {
  std::error_code no_matter;
  if (!std::filesystem::is_regular_file(path, no_matter))
    throw BadInput(Place{.file = path, .line = 0, .key = ""}, "no such file", "a store of percal");
  if (std::filesystem::equivalent(path, target, no_matter))
    throw BadInput(Place{.file = path, .line = 0, .key = "--store"}, "one of the sources, which stay as they are",
                   "another store to write to");
}

}  // namespace

Exit run_store_merge(const StoreArguments& arguments, const Common& common) {
  const std::string target = store_file(common);
  for (const std::string& source : arguments.sources) check_source(source, target);
  Store store(target);
  for (const std::string& source : arguments.sources) {
    const Store other = Store::copy_of(source);
    const long taken = store.take_in(other);
    if (!common.quiet)
      print(fmt::format("{}: {} evaluations, {} of them new in {}\n", source, other.size(), taken, store.path()));
  }
  return Exit::done;
}

}  // namespace percal::tools
