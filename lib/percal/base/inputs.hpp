// The files that a command reads, so that nothing it writes replaces one of them: known by device and inode, whatever name or link
// leads to them.
#pragma once
#include <string>

namespace percal {

// While one of these is alive, the files that are read are remembered, by every thread. Nothing is remembered otherwise: a program
// that uses the library may write over what it has read. They may not be nested.
class InputsAreKept {
 public:
  InputsAreKept();
  ~InputsAreKept();
  InputsAreKept(const InputsAreKept&) = delete;
  InputsAreKept& operator=(const InputsAreKept&) = delete;
};

// Remembers a file as an input. Pipes and devices are none, nor is what is no longer there.
void remember_input(const std::string& path);

// Throws BadInput where `path` leads to an input.
void refuse_to_replace_input(const std::string& path);

}  // namespace percal
