#include "percal/text/sha256.hpp"

#include <fmt/core.h>
#include <openssl/evp.h>

#include <filesystem>
#include <stdexcept>

#include "percal/text/file.hpp"

namespace percal {

std::string sha256(const std::string& bytes) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest, &length, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("libcrypto: SHA-256 failed");
  std::string text;
  for (unsigned int i = 0; i < length; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

std::optional<std::string> sha256_of_file(const std::string& path) {
  std::error_code fault;
  if (!std::filesystem::is_regular_file(path, fault)) return std::nullopt;
  try {
    return sha256(read_file(path));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace percal
