// The program: reads the command line, runs one command, turns the failures into exit codes. The commands are in files of their own.
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "colour.hpp"
#include "command_line.hpp"
#include "commands.hpp"
#include "percal/base/error.hpp"
#include "percal/text/file.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {

double positive_quantity(const std::string& text, const std::string& option, const Dimension& wanted,
                         const std::string& accepted) {
  const Place place{"", 0, option};
  try {
    const Quantity quantity = parse_quantity(text);
    if (quantity.dimension == wanted && quantity.value > 0) return quantity.value;
  } catch (const std::invalid_argument& error) {
    throw BadInput(place, in_quotes(text) + " (" + error.what() + ")", accepted);
  }
  throw BadInput(place, in_quotes(text), accepted);
}

std::string out_folder(const std::string& first_input, const Common& common) {
  if (common.out == "none") return "";
  const std::string folder =
      common.out.empty() ? std::filesystem::path(first_input).stem().string() + ".out" : common.out;
  ensure_writable_folder(folder);
  return folder;
}

namespace {

// Ends at once, by calls that a signal handler may make. Evaluations are in the store as soon as they are finished, and files
// that are being written hold the signal back (text/file.cpp), so nothing half-written stays behind.
void end_interrupted(int) {
  constexpr char message[] =
      "\npercal: interrupted; what is finished is in the store, and the same command goes on from there\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, message, sizeof message - 1);
  _exit(static_cast<int>(Exit::interrupted));
}

void resume_after_interruption() {
  for (const int number : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    action.sa_handler = end_interrupted;
    sigfillset(&action.sa_mask);
    struct sigaction before {};
    sigaction(number, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(number, &action, nullptr);  // ignored by the caller (nohup): stays so
  }
}

// What is still in the buffer may be more than the disk holds.
void flush_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout))
    throw IoFailure(std::string("standard output: cannot be written: ") + std::strerror(errno));
}

void say(const std::string& message) {
  std::fprintf(stderr, "%s %s\n", red("percal:", stderr).c_str(), message.c_str());
}

}  // namespace
}  // namespace percal::tools

int main(int argc, char** argv) {
  using percal::Exit;
  using percal::tools::say;
  std::signal(SIGXFSZ, SIG_IGN);  // a file over its size limit is a failure to write, told as one
  try {
    const Exit exit = percal::tools::run_command_line(argc, argv, percal::tools::resume_after_interruption);
    percal::tools::flush_output();
    return static_cast<int>(exit);
  } catch (const percal::BadInput& error) {
    say(error.what());
    return static_cast<int>(Exit::bad_input);
  } catch (const percal::IoFailure& error) {
    say(error.what());
    return static_cast<int>(Exit::io_failure);
  } catch (const std::system_error& error) {  // fmt::print on a full disk
    say(std::string("standard output: ") + error.what());
    return static_cast<int>(Exit::io_failure);
  } catch (const std::exception& error) {
    say(std::string("internal error: ") + error.what());
    return 70;
  }
}
