#pragma once

#include <string>

namespace blockfsi::case_file
{

/// All keys of a case file by section, each with type, default, unit and meaning: from the declarations that
/// parse them.
std::string describe();

}  // namespace blockfsi::case_file
