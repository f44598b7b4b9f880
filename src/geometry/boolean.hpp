#pragma once

#include "geometry/level_set.hpp"

#include <vector>

namespace blockfsi::geometry
{

/// The points that do not belong to the domain.
LevelSet complement(const LevelSet& domain);

/// The points of any of the domains: φ = min φ_i. With blend r > 0 the concave corners between two domains
/// are filled: where |φ_a - φ_b| < r, φ = (φ_a + φ_b) / 2 - r + sqrt(2 r² - (φ_a - φ_b)²) / 2, which is once
/// continuously differentiable and makes a circular fillet of radius r where two signed distances meet at a
/// right angle (Quilez 2024, "circular geometrical" smooth minimum). More than two domains are blended one
/// after the other. Throws Error for no domain or a negative blend.
LevelSet unite(const std::vector<LevelSet>& domains, double blend = 0.0);

/// The points of all domains: φ = max φ_i; a blend rounds convex corners likewise. Throws as `unite`.
LevelSet intersect(const std::vector<LevelSet>& domains, double blend = 0.0);

/// The points of the first domain that belong to none of the others. Throws as `unite`.
LevelSet difference(const std::vector<LevelSet>& domains, double blend = 0.0);

}  // namespace blockfsi::geometry
