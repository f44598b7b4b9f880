#include "run/layouts.hpp"

#include "../output/temporary.hpp"
#include "output/file.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

using namespace blockfsi;

namespace
{

using Paths = std::vector<std::filesystem::path>;

case_file::Case with_layouts(const std::vector<std::string>& paths)
{
  case_file::Case result;
  for (const std::string& path : paths)
    result.switches.emplace_back().path = path;
  return result;
}

}  // namespace

TEST_CASE(
    "each layout has a folder of its own, also if a case takes over twice or is named as another folder")
{
  CHECK(run::layout_folders(with_layouts({}), "out") == Paths{"out"});
  CHECK(run::layout_folders(with_layouts({"a/left.toml", "a/right.toml", "a/left.toml", "a/fields.toml"}),
                            "out") == Paths{"out", "out/left", "out/right", "out/left-2", "out/fields-2"});
}

TEST_CASE("a run has come to the layouts that took over one after the other, until that is forgotten")
{
  const TemporaryFolder folder;
  const case_file::Case description = with_layouts({"left.toml", "right.toml", "end.toml"});
  const std::filesystem::path& root = folder.path();
  output::replace_file(root / "left/transfer.csv", "step\n");
  output::replace_file(root / "end/transfer.csv", "step\n");  // from a run before
  CHECK(run::reached_folders(description, root) == Paths{root, root / "left"});
  output::replace_file(root / "right/transfer.csv", "step\n");
  CHECK(run::reached_folders(description, root).size() == 4);
  run::forget(root / "left");
  CHECK(run::reached_folders(description, root) == Paths{root});
}
