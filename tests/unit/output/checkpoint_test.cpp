#include "output/checkpoint.hpp"

#include "core/error.hpp"
#include "output/file.hpp"
#include "temporary.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <fcntl.h>
#include <limits>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace blockfsi;

namespace
{

output::Arrays sample(double value = 1.0)
{
  output::Arrays arrays;
  arrays["velocity"] = std::vector{value, -0.0, 0.1, std::numeric_limits<double>::denorm_min()};
  arrays["lattice"] = std::vector<std::int64_t>{1, -(std::int64_t{1} << 60)};
  arrays["flags"] = std::vector<std::int32_t>{7, -7};
  arrays["case"] = std::string("name = \"flap\"\n\0end", 18);
  arrays["empty"] = std::vector<double>{};
  return arrays;
}

void write_set(const std::filesystem::path& folder, std::int64_t step, int size, std::uint64_t run = 0)
{
  for (int rank = 0; rank < size; ++rank)
    output::write_rank(folder, step, {rank, size}, sample(static_cast<double>(step + rank)), run);
}

std::filesystem::path file(const std::filesystem::path& folder, std::string_view set, int rank)
{
  return folder / set / ("rank-" + std::to_string(rank) + ".bin");
}

void cut(const std::filesystem::path& path, std::size_t size)
{
  output::replace_file(path, output::read_file(path).substr(0, size));
}

void flip(const std::filesystem::path& path, std::size_t at)
{
  std::string bytes = output::read_file(path);
  bytes[at] = static_cast<char>(bytes[at] ^ 1);
  output::replace_file(path, bytes);
}

}  // namespace

TEST_CASE("a checkpoint gives back every array, bit for bit")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "state.bin";
  output::Arrays arrays = sample();
  std::get<0>(arrays["velocity"]).push_back(std::numeric_limits<double>::quiet_NaN());
  output::write_checkpoint(path, arrays);
  const output::Arrays read = output::read_checkpoint(path);
  const auto& before = output::get<std::vector<double>>(arrays, "velocity");
  const auto& after = output::get<std::vector<double>>(read, "velocity");
  REQUIRE(after.size() == before.size());
  CHECK(std::memcmp(before.data(), after.data(), before.size() * sizeof(double)) == 0);
  for (const char* name : {"lattice", "flags", "case", "empty"})
    CHECK(read.at(name) == arrays.at(name));
  CHECK(read.size() == arrays.size());
  CHECK_FALSE(std::filesystem::exists(folder.path() / "state.bin.tmp"));
}

TEST_CASE("an array that is missing or of another type is told")
{
  const output::Arrays arrays = sample();
  CHECK_THROWS_WITH_AS(output::get<std::string>(arrays, "pressure"),
                       doctest::Contains("the checkpoint has no array 'pressure'"), Error);
  CHECK_THROWS_WITH_AS(output::get<std::string>(arrays, "velocity"),
                       doctest::Contains("array 'velocity' of the checkpoint has another type"), Error);
}

TEST_CASE("a checkpoint cut off anywhere is refused")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "state.bin";
  output::write_checkpoint(path, sample());
  const std::string bytes = output::read_file(path);
  for (std::size_t size = 0; size < bytes.size(); ++size)
  {
    output::replace_file(path, std::string_view(bytes).substr(0, size));
    CHECK_THROWS_AS(output::read_checkpoint(path), Error);
  }
  output::replace_file(path, bytes + "x");
  CHECK_THROWS_AS(output::read_checkpoint(path), Error);
}

TEST_CASE("a checkpoint with any one bit changed is refused")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "state.bin";
  output::write_checkpoint(path, sample());
  const std::size_t size = output::read_file(path).size();
  for (std::size_t at = 0; at < size; ++at)
  {
    flip(path, at);
    CHECK_THROWS_AS(output::read_checkpoint(path), Error);
    flip(path, at);
  }
  CHECK(output::read_checkpoint(path) == sample());
}

TEST_CASE("the reason why a checkpoint is refused is told")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "state.bin";
  output::write_checkpoint(path, sample());
  flip(path, 8);
  CHECK_THROWS_WITH_AS(output::read_checkpoint(path),
                       doctest::Contains("has format version 0, but this program reads version 1"), Error);
  flip(path, 8);
  flip(path, 100);
  CHECK_THROWS_WITH_AS(output::read_checkpoint(path), doctest::Contains("is damaged: its checksum is wrong"),
                       Error);
  cut(path, 90);
  CHECK_THROWS_WITH_AS(output::read_checkpoint(path), doctest::Contains("has 90 bytes instead of"), Error);
  output::replace_file(path, "step,time\n");
  CHECK_THROWS_WITH_AS(output::read_checkpoint(path), doctest::Contains("is no checkpoint of this program"),
                       Error);
}

TEST_CASE("the newest complete set is found and read rank by rank")
{
  const TemporaryFolder folder;
  const auto sets = folder.path() / "checkpoint";
  CHECK_FALSE(output::latest_complete(sets, 2).has_value());
  write_set(sets, 100, 2);
  write_set(sets, 1000000, 2);
  write_set(sets, 99, 2);
  CHECK(output::latest_complete(sets, 2) == 1000000);
  CHECK(output::read_rank(sets, 100, {1, 2}) == sample(101.0));
}

TEST_CASE("a set that lacks a rank, or has one cut off, damaged or of another run, is passed over")
{
  const TemporaryFolder folder;
  const auto& sets = folder.path();
  write_set(sets, 100, 3);
  write_set(sets, 200, 3);
  const auto last = file(sets, "step-000200", 2);
  const std::string bytes = output::read_file(last);
  CHECK(output::latest_complete(sets, 3) == 200);

  flip(last, bytes.size() - 1);
  CHECK(output::latest_complete(sets, 3) == 100);
  output::replace_file(last, bytes.substr(0, bytes.size() / 2));
  CHECK(output::latest_complete(sets, 3) == 100);
  std::filesystem::remove(last);
  output::replace_file(sets / "step-000200" / "rank-2.bin.tmp", bytes);
  CHECK(output::latest_complete(sets, 3) == 100);
  output::write_rank(sets, 200, {2, 3}, sample(), 77);
  CHECK(output::latest_complete(sets, 3) == 100);
  output::write_rank(sets, 200, {2, 3}, sample());
  CHECK(output::latest_complete(sets, 3) == 200);
  std::filesystem::create_directory(sets / "step-000300");
  CHECK(output::latest_complete(sets, 3) == 200);
}

TEST_CASE("a set of another number of processes is told, not read")
{
  const TemporaryFolder folder;
  write_set(folder.path(), 100, 4);
  CHECK_THROWS_WITH_AS(output::latest_complete(folder.path(), 2),
                       doctest::Contains("were written by 4 processes, but now there are 2; continue with"),
                       Error);
  CHECK_THROWS_WITH_AS(
      output::read_rank(folder.path(), 100, {0, 2}),
      doctest::Contains("is of step 100 and process 0 of 4, not of step 100 and process 0 of 2"), Error);
}

TEST_CASE("removing old sets keeps the two newest complete ones and whatever is being written")
{
  const TemporaryFolder folder;
  const auto& sets = folder.path();
  for (const int step : {100, 200, 300, 400})
    write_set(sets, step, 2);
  std::filesystem::remove(file(sets, "step-000400", 1));
  output::replace_file(sets / "step-notes.txt", "mine");
  output::remove_old(sets);
  CHECK_FALSE(std::filesystem::exists(sets / "step-000100"));
  CHECK(std::filesystem::exists(file(sets, "step-000200", 1)));
  CHECK(std::filesystem::exists(file(sets, "step-000300", 1)));
  CHECK(std::filesystem::exists(file(sets, "step-000400", 0)));
  CHECK(output::latest_complete(sets, 2) == 300);
  output::remove_all(sets);
  CHECK_FALSE(output::latest_complete(sets, 2).has_value());
  CHECK(std::filesystem::exists(sets / "step-notes.txt"));
}

TEST_CASE("a process killed while it writes checkpoints leaves an intact set")
{
  const TemporaryFolder folder;
  const auto& sets = folder.path();
  write_set(sets, 1, 1);
  for (int trial = 0; trial < 5; ++trial)
  {
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0)
    {
      for (std::int64_t step = 2;; ++step)
      {
        output::Arrays arrays = sample(static_cast<double>(step));
        arrays["large"] = std::vector<double>(20000, static_cast<double>(step));
        output::write_rank(sets, step, {0, 1}, arrays);
        output::remove_old(sets);
      }
    }
    ::usleep(20000 + 3700 * trial);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const auto step = output::latest_complete(sets, 1);
    REQUIRE(step.has_value());
    const output::Arrays arrays = output::read_rank(sets, *step, {0, 1});
    CHECK(output::get<std::vector<double>>(arrays, "velocity")[0] == static_cast<double>(*step));
  }
}

TEST_CASE("a folder that cannot be written is told with the system's reason")
{
  const TemporaryFolder folder;
  output::replace_file(folder.path() / "plain", "a file where a folder should be");
  CHECK_THROWS_WITH_AS(output::write_rank(folder.path() / "plain", 1, {0, 1}, sample()),
                       doctest::Contains("Not a directory"), Error);
}
