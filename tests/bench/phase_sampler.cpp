#include "bench/phase_sampler.hpp"

#include <dlfcn.h>
#include <link.h>
#include <signal.h>
#include <sys/time.h>
#include <ucontext.h>

#include <atomic>
#include <cstdint>
#include <vector>

namespace percal::bench {
namespace {

constexpr int most_samples = 1 << 20;
std::vector<std::uintptr_t> counters;
std::atomic<int> taken{0};

void take_sample(int, siginfo_t*, void* context) {
  const int n = taken.fetch_add(1);
  if (n >= most_samples) return;
#if defined(__x86_64__)
  counters[n] = static_cast<std::uintptr_t>(static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_RIP]);
#elif defined(__aarch64__)
  counters[n] = static_cast<std::uintptr_t>(static_cast<ucontext_t*>(context)->uc_mcontext.pc);
#endif
}

void set_timer(long microseconds) {
  const itimerval timer{{0, microseconds}, {0, microseconds}};
  setitimer(ITIMER_PROF, &timer, nullptr);
}

// The mangled name of the function there, or nothing.
std::string function_at(std::uintptr_t counter) {
  Dl_info info{};
  ElfW(Sym)* symbol = nullptr;
  if (!dladdr1(reinterpret_cast<void*>(counter), &info, reinterpret_cast<void**>(&symbol), RTLD_DL_SYMENT)) return "";
  if (!info.dli_sname || !symbol) return "";
  const bool inside = counter < reinterpret_cast<std::uintptr_t>(info.dli_saddr) + symbol->st_size;
  return inside ? info.dli_sname : "";
}

std::string phase_of(const std::string& function) {
  const auto has = [&](const char* name) { return function.find(name) != std::string::npos; };
  if (has("internal_forces")) return "internal forces";
  if (has("nodes_in_") || has("ContactZone") || has("RigidBody")) return "contact";
  if (has("kick_and_drift")) return "motion";
  return "rest";
}

}  // namespace

void start_sampling() {
  counters.assign(most_samples, 0);
  taken = 0;
  struct sigaction action {};
  action.sa_sigaction = take_sample;
  action.sa_flags = SA_SIGINFO | SA_RESTART;
  sigaction(SIGPROF, &action, nullptr);
  set_timer(1000);
}

std::map<std::string, long> stop_sampling() {
  set_timer(0);
  std::map<std::string, long> samples{{"internal forces", 0}, {"contact", 0}, {"motion", 0}, {"rest", 0}};
  for (int k = 0; k < taken && k < most_samples; ++k) ++samples[phase_of(function_at(counters[k]))];
  return samples;
}

}  // namespace percal::bench
