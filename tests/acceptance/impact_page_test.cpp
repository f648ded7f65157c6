// docs/formats/impact.md names every key of the result.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

namespace {

std::string output_of(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  char part[4096];
  while (const std::size_t n = fread(part, 1, sizeof part, pipe)) text.append(part, n);
  pclose(pipe);
  return text;
}

TEST(ImpactPage, NamesEveryKeyOfTheResult) {
  const auto store = std::filesystem::temp_directory_path() / ("impact_page_" + std::to_string(getpid()) + ".store");
  const auto result = nlohmann::json::parse(output_of(std::string(PERCAL_PROGRAM) + " impact " + PERCAL_DATA +
                                                      "/guha2009/gold.toml --elements-per-radius 3 --json --store " + store.string()));
  std::filesystem::remove(store);
  std::ifstream file(PERCAL_DATA "/../docs/formats/impact.md");
  std::stringstream page;
  page << file.rdbuf();
  const auto is_named = [&](const std::string& key) { return page.str().find("`" + key + "`") != std::string::npos; };
  EXPECT_GT(result.size(), 20u);
  for (const auto& [key, value] : result.items()) EXPECT_TRUE(is_named(key)) << key;
  for (const auto& [key, value] : result.at("energy").items()) EXPECT_TRUE(is_named(key)) << "energy." << key;
  for (const auto& [key, value] : result.at("runs").at(0).items()) EXPECT_TRUE(is_named(key)) << "runs." << key;
}

}  // namespace
