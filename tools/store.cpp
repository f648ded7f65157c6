// percal store merge: the evaluations of several stores in one, as after the tasks of a cluster.
#include "percal/store/store.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "commands.hpp"

namespace percal::tools {
namespace {

// A store that is not there would be made by opening it.
void need_file(const std::string& path) {
  std::error_code no_matter;
  if (!std::filesystem::is_regular_file(path, no_matter))
    throw BadInput(Place{.file = path, .line = 0, .key = ""}, "no such file", "a store of percal");
}

}  // namespace

Exit run_store_merge(const StoreArguments& arguments, const Common& common) {
  for (const std::string& source : arguments.sources) need_file(source);
  Store store(common.store.empty() ? default_store_path() : common.store);
  for (const std::string& source : arguments.sources) {
    const Store other(source);
    const long taken = store.take_in(other);
    if (!common.quiet)
      fmt::print("{}: {} evaluations, {} of them new in {}\n", source, other.size(), taken, store.path());
  }
  return Exit::done;
}

}  // namespace percal::tools
