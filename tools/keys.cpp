// percal keys: the keys of a kind of file.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "key_reference.hpp"

namespace percal::tools {

Exit run_keys(const KeysArguments& arguments, const Common& common) {
  if (const auto faults = faults_of_meanings(); !faults.empty())
    throw std::logic_error(fmt::format("{}", fmt::join(faults, "\n")));
  if (arguments.markdown) {
    fmt::print("{}", as_markdown(file_kinds()));
    return Exit::done;
  }
  const FileKind& kind = file_kind(arguments.kind == "job" ? "calibrate" : arguments.kind);
  if (common.json)
    fmt::print("{}\n", to_json(kind).dump(2));
  else
    fmt::print("{}", as_text(kind));
  return Exit::done;
}

}  // namespace percal::tools
