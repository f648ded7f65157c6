// The program: reads the command line, runs one command, turns the failures into exit codes. The commands are in files of their own.
#include <malloc.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include "colour.hpp"
#include "command_line.hpp"
#include "commands.hpp"
#include "percal/base/ending.hpp"
#include "percal/base/error.hpp"
#include "percal/base/inputs.hpp"
#include "percal/base/printable.hpp"
#include "percal/base/threads.hpp"
#include "percal/store/store.hpp"
#include "percal/text/file.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {

std::string folder_named(const std::string& first_input, const Common& common) {
  if (common.out == "none") return "";
  return common.out.empty() ? std::filesystem::path(first_input).stem().string() + ".out" : common.out;
}

std::string store_file(const Common& common) { return common.store.empty() ? default_store_path() : common.store; }

std::string out_folder(const std::string& first_input, const Common& common) {
  const std::string folder = folder_named(first_input, common);
  if (folder.empty()) return folder;
  ensure_writable_folder(folder);
  refuse_to_replace_input(folder + "/result.json");
  return folder;
}

namespace {

constexpr const char* interrupted = "interrupted";
// Evaluations are in the store as soon as they are finished.
constexpr const char* interrupted_between_runs =
    "interrupted; what is finished is in the store, and the same command goes on from there";
std::atomic<const char*> last_words{interrupted};

void resume_after_interruption() { last_words = interrupted_between_runs; }

// The signals that ask the program to end and that its caller does not ignore (nohup).
sigset_t signals_to_end_on() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    sigaction(number, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaddset(&signals, number);
  }
  return signals;
}

// Signals are blocked in every thread and taken in this one, which ends the process when no file is half written. Where there is no
// thread to be had they end it as they always did. Call it before any other thread is there.
void end_when_interrupted() {
  const sigset_t signals = signals_to_end_on();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  auto watch = threads_to_be_had(1, [signals](int) {
    int number = 0;
    while (sigwait(&signals, &number) != 0) {
    }
    end_process(static_cast<int>(Exit::interrupted), std::string("\npercal: ") + last_words.load() + "\n");
  });
  for (auto& thread : watch) thread.detach();
  if (watch.empty()) pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

// Matrices of a Gaussian process come and go a hundred times in a search: given back to the system each time, and asked for again, they cost
// twice as much as the search.
void keep_freed_memory() {
  constexpr int largest_kept_block = 32 << 20, kept = 128 << 20;  // bytes
  mallopt(M_MMAP_THRESHOLD, largest_kept_block);
  mallopt(M_TRIM_THRESHOLD, kept);
}

// What is still in the buffer may be more than the disk holds.
void flush_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout))
    throw IoFailure(std::string("standard output: cannot be written: ") + std::strerror(errno));
}

int fail(Exit exit, const std::string& message) {
  std::fprintf(stderr, "%s %s\n", red("percal:", stderr).c_str(), printable(message).c_str());
  return static_cast<int>(exit);
}

}  // namespace

// What went wrong, as a sentence and an exit code.
int run(int argc, char** argv) {
  try {
    const InputsAreKept kept;
    const Exit exit = run_command_line(argc, argv, resume_after_interruption);
    flush_output();
    return static_cast<int>(exit);
  } catch (const BadInput& error) {
    return fail(Exit::bad_input, error.what());
  } catch (const IoFailure& error) {
    return fail(Exit::io_failure, error.what());
  } catch (const NoMemory& error) {
    return fail(Exit::io_failure, error.what());
  } catch (const std::bad_alloc&) {
    return fail(Exit::io_failure, "out of memory");
  } catch (const std::length_error&) {  // a size that no memory has
    return fail(Exit::io_failure, "out of memory");
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(Exit::io_failure, error.what());
  } catch (const std::system_error& error) {  // fmt::print on a full disk
    return fail(Exit::io_failure, std::string("standard output: ") + error.what());
  } catch (const std::exception& error) {
    return fail(Exit::internal_error, std::string("internal error: ") + error.what());
  }
}

}  // namespace percal::tools

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file over its size limit is a failure to write, told as one
  percal::tools::keep_freed_memory();
  percal::tools::end_when_interrupted();
  return percal::tools::run(argc, argv);
}
