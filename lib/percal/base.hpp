// base: failures, progress, threads, what a command may not write over and when it may not end, version.
//
// Every layer may use it. Three failures end a command: BadInput (what the user gave cannot be used: file, line, key,
// what was found, what is accepted), IoFailure (a disk that cannot be read or written) and NoMemory. Numerical outcomes
// are values, never exceptions.
//
//     try {
//       const percal::Scene scene = percal::read_scene("gold.toml");
//     } catch (const percal::BadInput& error) {
//       std::cerr << error.what() << "\n";  // gold.toml:12: target.nu: found 0.5; accepted: ...
//     }
#pragma once
#include "percal/base/ending.hpp"
#include "percal/base/error.hpp"
#include "percal/base/inputs.hpp"
#include "percal/base/memory.hpp"
#include "percal/base/printable.hpp"
#include "percal/base/progress.hpp"
#include "percal/base/threads.hpp"
#include "percal/base/version.hpp"
