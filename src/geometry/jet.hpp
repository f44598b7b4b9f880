#pragma once

#include "geometry/point.hpp"

namespace blockfsi::geometry
{

/// A point of a curve with its derivatives with respect to the parameter.
struct CurveJet
{
  Point x{};
  Point first{};
  Point second{};
};

/// A point of a surface with its derivatives with respect to the parameters u and v.
struct SurfaceJet
{
  Point x{};
  Point u{};
  Point v{};
  Point uu{};
  Point uv{};
  Point vv{};
};

}  // namespace blockfsi::geometry
