#include "coupling/predictor.hpp"

#include "element/line.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>

namespace blockfsi::coupling
{

namespace
{

/// Value at `ratio` of the polynomial through known[j] at -j.
void extrapolate(std::span<const std::vector<double>> known, double ratio, std::span<double> out)
{
  std::vector<double> times(known.size());
  for (std::size_t j = 0; j < times.size(); ++j)
    times[j] = -static_cast<double>(j);
  const element::Table functions = element::lagrange(times, std::span(&ratio, 1));
  std::fill(out.begin(), out.end(), 0.0);
  for (std::size_t j = 0; j < times.size(); ++j)
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] += functions.value[j] * known[j][i];
}

/// Sum of squares by which the newest differs from its prediction from all the others.
double squared_miss(std::span<const std::vector<double>> known)
{
  const std::vector<double>& newest = known.front();
  std::vector<double> predicted(newest.size());
  extrapolate(known.subspan(1), 1.0, predicted);
  double sum = 0.0;
  for (std::size_t i = 0; i < newest.size(); ++i)
    sum += (predicted[i] - newest[i]) * (predicted[i] - newest[i]);
  return sum;
}

}  // namespace

void remember(Past& past, std::span<const double> d, double step)
{
  if (step != past.step)
    past.d.resize(1);
  past.step = step;
  if (past.d.size() == most_kept)
    past.d.pop_back();
  past.d.emplace(past.d.begin(), d.begin(), d.end());
}

int best_order(const Past& past)
{
  const int known = static_cast<int>(past.d.size());
  if (known < 3)
    return known - 1;
  const int steps = std::clamp(known - highest_order - 1, 1, judged);
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int order = 0; order + 1 + steps <= known && order <= highest_order; ++order)
  {
    double missed = 0.0;
    for (int step = 0; step < steps; ++step)
      missed += squared_miss(std::span(past.d).subspan(step, order + 2));
    if (missed < least)
    {
      least = missed;
      best = order;
    }
  }
  return best;
}

void predict(std::optional<int> order, const Past& past, double step, std::span<double> out)
{
  assert(!past.d.empty() && (!order || (0 <= *order && *order <= highest_order)));
  const bool same = step == past.step;
  const int known = static_cast<int>(past.d.size());
  const int wanted = order ? *order : best_order(past);
  const int used = std::min({wanted, known - 1, same ? highest_order : 1});
  extrapolate(std::span(past.d).first(used + 1), known > 1 ? step / past.step : 1.0, out);
}

}  // namespace blockfsi::coupling
