// Code that is compiled once for each instruction level (a KERNEL/kernel_level.cpp, cmake/PercalKernel.cmake), and which of its versions
// this processor runs.
#pragma once
#include <stdexcept>
#include <string>

namespace percal {

// The instruction level in use: the best that the processor has, or what the environment variable PERCAL_ISA names
// (x86_64_v2, x86_64_v3, x86_64_v4). Results of different levels differ in their last digits.
// Throws BadInput for a level that is unknown or that this processor lacks.
const std::string& instruction_level();

}  // namespace percal

// of(level, ...) for every level that may be chosen, each a namespace of percal.
#if defined(__x86_64__)
#define PERCAL_EACH_LEVEL(of, ...) of(x86_64_v4, __VA_ARGS__) of(x86_64_v3, __VA_ARGS__) of(x86_64_v2, __VA_ARGS__)
#else
#define PERCAL_EACH_LEVEL(of, ...) of(generic, __VA_ARGS__)
#endif

// The tables of functions that every level has under one name: declared outside of any namespace.
#define PERCAL_DECLARE_IN_LEVEL(level, Type, table) \
  namespace percal::level {                         \
  extern const Type table;                          \
  }
#define PERCAL_DECLARE_TABLES(Type, table) PERCAL_EACH_LEVEL(PERCAL_DECLARE_IN_LEVEL, Type, table)

// The body of a function that returns the one of instruction_level().
#define PERCAL_RETURN_OF_LEVEL(level, table) \
  if (instruction_level() == #level) return percal::level::table;
#define PERCAL_RETURN_TABLE(table)                 \
  PERCAL_EACH_LEVEL(PERCAL_RETURN_OF_LEVEL, table) \
  throw std::logic_error("no kernel of the instruction level " + instruction_level());
