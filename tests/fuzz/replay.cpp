// Reads every file of some folders, then so many variations of them that are the same in every run:
//   replay_TARGET VARIATIONS FOLDER...
// The everyday test of readers; libFuzzer (./dev fuzz) goes on from there.

#include "target.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace
{

std::vector<std::string> contents(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_regular_file())
      paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> result;
  for (const std::filesystem::path& path : paths)
  {
    std::ifstream stream(path, std::ios::binary);
    result.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return result;
}

/// Numbers and signs at which readers stumble.
const std::vector<std::string> pieces = {
    "-1", "0", "4294967295", "18446744073709551615", "1e999", "nan", "\n", "$", "<", ">", "\"", "[",
    "]",  "{", "=",          std::string(1, '\0')};

/// One to four small changes.
std::string vary(std::string text, const std::vector<std::string>& all, std::mt19937_64& random)
{
  const auto below = [&random](std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random() % n); };
  for (std::size_t changes = 1 + below(4); changes > 0; --changes)
  {
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::min(text.size() - at, below(32));
    switch (below(6))
    {
    case 0:
      if (at < text.size())
        text[at] = static_cast<char>(random());
      break;
    case 1:
      text.erase(at, length);
      break;
    case 2:
      text.insert(at, pieces[below(pieces.size())]);
      break;
    case 3:
      text.insert(at, text.substr(below(text.size() + 1), length));
      break;
    case 4:
      text.resize(at);
      break;
    default:
    {
      const std::string& other = all[below(all.size())];
      text.replace(at, length, other.substr(below(other.size() + 1), length));
    }
    }
  }
  return text;
}

}  // namespace

int main(int argc, char** argv)
{
  if (argc < 3)
    return 2;
  std::vector<std::string> all;
  for (int k = 2; k < argc; ++k)
    for (std::string& text : contents(argv[k]))
      all.push_back(std::move(text));
  if (all.empty())
    return 2;
  std::string input;
  try
  {
    for (const std::string& text : all)
      read_input(input = text);
    std::mt19937_64 random(1);
    const long variations = std::atol(argv[1]);
    for (long k = 0; k < variations; ++k)
      read_input(input = vary(all[random() % all.size()], all, random));
    std::printf("%zu files and %ld variations read\n", all.size(), variations);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "not an error of blockfsi: %s\n", error.what());
    std::ofstream("finding", std::ios::binary) << input;
    return 1;
  }
}
