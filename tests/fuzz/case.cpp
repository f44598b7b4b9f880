#include "case/case.hpp"
#include "core/error.hpp"
#include "target.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace
{

/// The reader of cases takes paths; a file in memory where the system has a folder for them.
std::filesystem::path input_path()
{
  const std::filesystem::path memory = "/dev/shm";
  const std::filesystem::path folder =
      std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path();
  return folder / ("blockfsi-fuzz-" + std::to_string(getpid()) + ".toml");
}

/// Removed at the end of the program.
struct InputFile
{
  std::filesystem::path path = input_path();
  ~InputFile() { std::filesystem::remove(path); }
};

}  // namespace

void read_input(std::string_view content)
{
  static const InputFile file;
  std::ofstream(file.path, std::ios::binary)
      .write(content.data(), static_cast<std::streamsize>(content.size()));
  try
  {
    blockfsi::case_file::read(file.path);
  }
  catch (const blockfsi::Error&)
  {
  }
}
