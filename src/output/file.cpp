#include "output/file.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace blockfsi::output
{

namespace
{

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view action, int error)
{
  const std::string remedy = error == ENOSPC || error == EDQUOT ? "free some space there"
                                                                : "check that the folder exists and is yours";
  throw Error(fmt::format("cannot {} '{}': {}; {} or choose another folder", action, path.string(),
                          std::generic_category().message(error), remedy));
}

/// An open file that closes itself.
class Descriptor
{
public:
  Descriptor(const std::filesystem::path& path, int flags)
      : path_(path), number_(::open(path.c_str(), flags, 0644))
  {
    if (number_ < 0)
      fail(path_, "open", errno);
  }
  ~Descriptor()
  {
    if (number_ >= 0)
      ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  void write(std::string_view content)
  {
    while (!content.empty())
    {
      const ::ssize_t count = ::write(number_, content.data(), content.size());
      if (count < 0 && errno != EINTR)
        fail(path_, "write", errno);
      if (count > 0)
        content.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  void synchronise()
  {
    if (::fsync(number_) != 0)
      fail(path_, "write", errno);
  }
  /// Reports what network file systems only tell at the end.
  void close()
  {
    if (::close(std::exchange(number_, -1)) != 0)
      fail(path_, "write", errno);
  }

private:
  std::filesystem::path path_;
  int number_;
};

void make_folders(const std::filesystem::path& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    fail(folder, "make the folder", error.value());
}

void synchronise_folder(const std::filesystem::path& folder)
{
  Descriptor(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC).synchronise();
}

}  // namespace

void replace_file(const std::filesystem::path& path, std::string_view content, Durability durability)
{
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  make_folders(folder);
  std::filesystem::path temporary = path;
  temporary += ".tmp";
  Descriptor file(temporary, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC);
  file.write(content);
  if (durability == Durability::machine)
    file.synchronise();
  file.close();
  std::error_code error;
  std::filesystem::rename(temporary, path, error);
  if (error)
    fail(path, "write", error.value());
  if (durability == Durability::machine)
  {
    synchronise_folder(folder);
    synchronise_folder(folder / "..");  // which may have got the folder just now
  }
}

std::string read_file(const std::filesystem::path& path)
{
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw Error(fmt::format("cannot read '{}': {}", path.string(), std::generic_category().message(errno)));
  std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad())
    throw Error(fmt::format("cannot read '{}': the system reports a failing read", path.string()));
  return content;
}

}  // namespace blockfsi::output
