#pragma once

#include "mesh/quality.hpp"
#include "mesh/validity.hpp"

namespace blockfsi::run
{

/// The worst over all processes, known to each.
mesh::Quality combine(const mesh::Quality& mine);
mesh::Validity combine(const mesh::Validity& mine);

}  // namespace blockfsi::run
