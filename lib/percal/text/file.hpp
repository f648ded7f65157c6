// Files written whole or not at all.
#pragma once
#include <string>

namespace percal {

// Writes to a temporary name beside `path`, flushes to the disk, then renames. Throws IoFailure (and leaves neither a
// half-written file nor the temporary one) when the folder is unwritable or the disk full, BadInput where it would replace an input
// of this command (base/inputs.hpp). Creates missing folders, and removes temporary files that killed processes have left.
// A link is followed, the permissions of a file that was there are kept, and a device or pipe is written to directly.
void write_file(const std::string& path, const std::string& content);

// The whole file, an input of this command from now on. Throws BadInput where it is not there, is a folder or larger than 1 GiB,
// IoFailure where it cannot be read.
std::string read_file(const std::string& path);

// The same of a file that this command may replace: to see what it is.
std::string read_output(const std::string& path);

// Makes sure that results can be written to `folder` before anything is computed: creates it and writes, syncs and
// removes a probe. Throws IoFailure.
void ensure_writable_folder(const std::string& folder);

// The same of a single file: what write_file would throw for it, before anything is computed.
void ensure_writable_file(const std::string& path);

}  // namespace percal
