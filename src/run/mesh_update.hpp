#pragma once

#include "case/case.hpp"
#include "motion/update.hpp"

namespace blockfsi::run
{

/// The way in which the fluid mesh of a case follows the interface of its domain.
motion::Update make_update(const case_file::Case& description, const motion::Domain& domain);

}  // namespace blockfsi::run
