#include "output/checkpoint.hpp"

#include "core/error.hpp"
#include "output/file.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <system_error>
#include <type_traits>
#include <utility>

namespace blockfsi::output
{

static_assert(std::endian::native == std::endian::little, "checkpoints are little-endian");

namespace
{

constexpr std::array<char, 8> magic = {'b', 'l', 'o', 'c', 'k', 'f', 's', 'i'};
constexpr std::uint32_t format_version = 1;

/// What stands before the arrays. The CRC-32 of all that follows this field is checked at reading.
struct Header
{
  std::array<char, 8> mark = magic;
  std::uint32_t version = format_version;
  std::uint32_t checksum = 0;
  std::uint64_t file_size = 0;
  std::int64_t step = 0;
  std::uint64_t run = 0;
  std::int32_t rank = 0;
  std::int32_t size = 1;
};
static_assert(sizeof(Header) == 48 && std::has_unique_object_representations_v<Header>);
constexpr std::size_t checked_from = offsetof(Header, file_size);

std::uint32_t checksum(std::string_view bytes)
{
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

template <typename T>
void put(std::string& bytes, const T& value)
{
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

std::string encode(Header header, const Arrays& arrays)
{
  std::string bytes(sizeof(Header), '\0');
  for (const auto& [name, array] : arrays)
  {
    put(bytes, static_cast<std::uint64_t>(name.size()));
    bytes += name;
    put(bytes, static_cast<std::uint64_t>(array.index()));
    std::visit(
        [&bytes](const auto& values)
        {
          put(bytes, static_cast<std::uint64_t>(values.size()));
          bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
        },
        array);
  }
  header.file_size = bytes.size();
  std::memcpy(bytes.data(), &header, sizeof(Header));
  header.checksum = checksum(std::string_view(bytes).substr(checked_from));
  std::memcpy(bytes.data(), &header, sizeof(Header));
  return bytes;
}

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view what)
{
  throw Error(fmt::format("checkpoint '{}' {}", path.string(), what));
}

/// Reads values off the front of bytes; throws if there are not enough. The checksum has been verified
/// before, so that this can only happen to files that were made wrong on purpose.
class Reader
{
public:
  Reader(const std::filesystem::path& path, std::string_view bytes) : path_(path), bytes_(bytes) {}

  bool at_end() const { return bytes_.empty(); }

  std::uint64_t number()
  {
    std::uint64_t value = 0;
    std::memcpy(&value, take(sizeof(value)).data(), sizeof(value));
    return value;
  }

  std::string_view take(std::uint64_t count)
  {
    if (count > bytes_.size())
      fail(path_, "holds an array that is longer than the file");
    const std::string_view front = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return front;
  }

  template <typename T>
  Array values()
  {
    using Value = typename T::value_type;
    const std::uint64_t count = number();
    if (count > std::numeric_limits<std::uint64_t>::max() / sizeof(Value))
      fail(path_, "holds an array that is longer than the file");
    const std::string_view bytes = take(count * sizeof(Value));
    T result(count, Value{});
    if (count > 0)
      std::memcpy(result.data(), bytes.data(), bytes.size());
    return result;
  }

  Array array()
  {
    switch (number())
    {
    case 0:
      return values<std::vector<double>>();
    case 1:
      return values<std::vector<std::int64_t>>();
    case 2:
      return values<std::vector<std::int32_t>>();
    case 3:
      return values<std::string>();
    default:
      fail(path_, "holds an array of unknown type");
    }
  }

private:
  const std::filesystem::path& path_;
  std::string_view bytes_;
};

struct File
{
  Header header;
  Arrays arrays;
};

Header verify(const std::filesystem::path& path, std::string_view bytes)
{
  Header header;
  if (!bytes.starts_with(std::string_view(magic.data(), std::min(magic.size(), bytes.size()))))
    fail(path, "is no checkpoint of this program");
  if (bytes.size() < sizeof(Header))
    fail(path,
         fmt::format("is cut off after {} bytes; remove it and continue from an older one", bytes.size()));
  std::memcpy(&header, bytes.data(), sizeof(Header));
  if (header.version != format_version)
    fail(path,
         fmt::format("has format version {}, but this program reads version {}; continue with the program "
                     "that wrote it",
                     header.version, format_version));
  if (header.file_size != bytes.size())
    fail(path, fmt::format("has {} bytes instead of {}; remove it and continue from an older one",
                           bytes.size(), header.file_size));
  if (header.checksum != checksum(bytes.substr(checked_from)))
    fail(path, "is damaged: its checksum is wrong; remove it and continue from an older one");
  return header;
}

File read(const std::filesystem::path& path)
{
  const std::string bytes = read_file(path);
  File file{verify(path, bytes), {}};
  Reader reader(path, std::string_view(bytes).substr(sizeof(Header)));
  while (!reader.at_end())
  {
    std::string name(reader.take(reader.number()));
    file.arrays.insert_or_assign(std::move(name), reader.array());
  }
  return file;
}

std::filesystem::path set_path(const std::filesystem::path& folder, std::int64_t step)
{
  return folder / fmt::format("step-{:06}", step);
}

std::filesystem::path rank_path(const std::filesystem::path& set, int rank)
{
  return set / fmt::format("rank-{}.bin", rank);
}

/// Steps of all sets in a folder, complete or not, newest first.
std::vector<std::int64_t> list_steps(const std::filesystem::path& folder)
{
  constexpr std::string_view prefix = "step-";
  std::vector<std::int64_t> steps;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
  {
    const std::string name = entry.path().filename().string();
    std::int64_t step = 0;
    const auto end = name.data() + name.size();
    if (name.starts_with(prefix) && std::from_chars(name.data() + prefix.size(), end, step).ptr == end &&
        set_path(folder, step) == entry.path())
      steps.push_back(step);
  }
  std::sort(steps.begin(), steps.end(), std::greater<>());
  return steps;
}

/// Header of a file whose length is right, without reading the rest.
std::optional<Header> read_header(const std::filesystem::path& path)
{
  Header header;
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(&header), sizeof(Header));
  std::error_code error;
  if (!stream || header.mark != magic || header.version != format_version ||
      header.file_size != std::filesystem::file_size(path, error))
    return std::nullopt;
  return header;
}

/// Number of processes of a set that has all its files, of one run; nothing if it has not.
std::optional<int> complete_size(const std::filesystem::path& folder, std::int64_t step)
{
  const std::filesystem::path set = set_path(folder, step);
  const auto first = read_header(rank_path(set, 0));
  if (!first)
    return std::nullopt;
  for (int rank = 0; rank < first->size; ++rank)
  {
    const auto header = read_header(rank_path(set, rank));
    if (!header || header->rank != rank || header->size != first->size || header->run != first->run ||
        header->step != step)
      return std::nullopt;
  }
  return first->size;
}

bool intact(const std::filesystem::path& folder, std::int64_t step, int size)
{
  try
  {
    for (int rank = 0; rank < size; ++rank)
    {
      const std::filesystem::path path = rank_path(set_path(folder, step), rank);
      verify(path, read_file(path));
    }
    return true;
  }
  catch (const Error&)
  {
    return false;
  }
}

void remove_set(const std::filesystem::path& path)
{
  std::error_code error;
  std::filesystem::remove_all(path, error);
  if (error)
    throw Error(fmt::format("cannot remove the old checkpoint '{}': {}; check that the folder is yours",
                            path.string(), error.message()));
}

}  // namespace

template <typename T>
const T& get(const Arrays& arrays, std::string_view name)
{
  const auto found = arrays.find(name);
  if (found == arrays.end())
    throw Error(
        fmt::format("the checkpoint has no array '{}'; it was written by another version of the program or "
                    "for another case",
                    name));
  if (const T* values = std::get_if<T>(&found->second))
    return *values;
  throw Error(
      fmt::format("array '{}' of the checkpoint has another type than expected; it was written by another "
                  "version of the program",
                  name));
}

template const std::vector<double>& get(const Arrays&, std::string_view);
template const std::vector<std::int64_t>& get(const Arrays&, std::string_view);
template const std::vector<std::int32_t>& get(const Arrays&, std::string_view);
template const std::string& get(const Arrays&, std::string_view);

void write_checkpoint(const std::filesystem::path& path, const Arrays& arrays)
{
  replace_file(path, encode(Header{}, arrays), Durability::machine);
}

Arrays read_checkpoint(const std::filesystem::path& path)
{
  return read(path).arrays;
}

void write_rank(const std::filesystem::path& folder, std::int64_t step, Part part, const Arrays& arrays,
                std::uint64_t run)
{
  Header header;
  header.step = step;
  header.run = run;
  header.rank = part.rank;
  header.size = part.size;
  replace_file(rank_path(set_path(folder, step), part.rank), encode(header, arrays), Durability::machine);
}

std::optional<std::int64_t> latest_complete(const std::filesystem::path& folder, int size)
{
  int other_size = 0;
  for (const std::int64_t step : list_steps(folder))
  {
    const auto found = complete_size(folder, step);
    if (!found || !intact(folder, step, *found))
      continue;
    if (*found == size)
      return step;
    other_size = *found;
  }
  if (other_size > 0)
    throw Error(fmt::format(
        "the checkpoints in '{}' were written by {} process{}, but now there {} {}; continue with "
        "the same number",
        folder.string(), other_size, other_size == 1 ? "" : "es", size == 1 ? "is" : "are", size));
  return std::nullopt;
}

Arrays read_rank(const std::filesystem::path& folder, std::int64_t step, Part part)
{
  const std::filesystem::path path = rank_path(set_path(folder, step), part.rank);
  File file = read(path);
  if (file.header.rank != part.rank || file.header.size != part.size || file.header.step != step)
    fail(path, fmt::format("is of step {} and process {} of {}, not of step {} and process {} of {}",
                           file.header.step, file.header.rank, file.header.size, step, part.rank, part.size));
  return std::move(file.arrays);
}

void remove_old(const std::filesystem::path& folder, int keep)
{
  int kept = 0;
  for (const std::int64_t step : list_steps(folder))
    if (kept >= keep)
      remove_set(set_path(folder, step));
    else if (complete_size(folder, step))
      ++kept;
}

void remove_all(const std::filesystem::path& folder)
{
  for (const std::int64_t step : list_steps(folder))
    remove_set(set_path(folder, step));
}

}  // namespace blockfsi::output
