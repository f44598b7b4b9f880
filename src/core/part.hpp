#pragma once

namespace blockfsi
{

/// Which share of a distributed mesh this process makes: rank in [0, size).
struct Part
{
  int rank = 0;
  int size = 1;
};

}  // namespace blockfsi
