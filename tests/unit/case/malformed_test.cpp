#include "case/case.hpp"

#include "core/error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace blockfsi;

namespace
{

const std::filesystem::path folder = std::filesystem::path(BLOCKFSI_TESTS_FOLDER) / "cases" / "malformed";

std::vector<std::filesystem::path> case_files()
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".toml")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string contents(const std::filesystem::path& path)
{
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// The text without the folder of the file, so that it reads the same on every machine.
std::string without_folder(std::string text, const std::filesystem::path& file)
{
  const std::string prefix = file.parent_path().string() + "/";
  for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix))
    text.erase(at, prefix.size());
  return text;
}

std::string complaint(const std::filesystem::path& file)
{
  try
  {
    case_file::read(file);
  }
  catch (const Error& error)
  {
    REQUIRE(error.location().has_value());
    return without_folder(error.what(), file) + "\n";
  }
  return "accepted\n";
}

}  // namespace

TEST_CASE("every malformed case is refused with its exact message and place")
{
  const std::vector<std::filesystem::path> files = case_files();
  CHECK(files.size() >= 100);
  for (const std::filesystem::path& file : files)
  {
    CAPTURE(file.filename().string());
    CHECK(complaint(file) == contents(std::filesystem::path(file).replace_extension(".expected")));
  }
}
