#include "percal/text/sha256.hpp"

#include <fmt/core.h>
#include <openssl/evp.h>

#include <array>
#include <filesystem>
#include <stdexcept>

#include "percal/text/file.hpp"

namespace percal {

namespace {

constexpr int digest_size = 32;
using Digest = std::array<unsigned char, digest_size>;

Digest digest_of(const std::string& bytes) {
  Digest digest;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("libcrypto: SHA-256 failed");
  return digest;
}

}  // namespace

std::string sha256(const std::string& bytes) {
  std::string text;
  for (const unsigned char byte : digest_of(bytes)) text += fmt::format("{:02x}", byte);
  return text;
}

std::string sha256_in_base64(const std::string& bytes) {
  unsigned char text[4 * (digest_size + 2) / 3 + 1];
  const int length = EVP_EncodeBlock(text, digest_of(bytes).data(), digest_size);
  return {text, text + length};
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
