#include "coupling/accelerator.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <variant>

namespace blockfsi::coupling
{

namespace
{

/// Smaller relaxations, and quasi-Newton increments smaller than this part of the residual, would repeat the
/// same iteration for ever: nothing new would be learnt.
constexpr double least_progress = 1e-6;

double dot(std::span<const double> a, std::span<const double> b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

double norm(std::span<const double> a)
{
  return std::sqrt(dot(a, a));
}

/// y <- y + factor x
void add(double factor, std::span<const double> x, std::span<double> y)
{
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] += factor * x[i];
}

std::vector<double> difference(std::span<const double> a, std::span<const double> b)
{
  std::vector<double> result(a.begin(), a.end());
  add(-1.0, b, result);
  return result;
}

std::vector<double> scaled(double factor, std::span<const double> a)
{
  std::vector<double> result(a.size(), 0.0);
  add(factor, a, result);
  return result;
}

std::span<const double> row(const std::vector<double>& array, std::size_t size, std::size_t i)
{
  return std::span(array).subspan(i * size, size);
}

/// Q R = the columns of V that are not nearly a combination of newer ones.
struct Factors
{
  std::vector<std::vector<double>> q;  ///< orthonormal
  std::vector<std::vector<double>> r;  ///< column j has the j + 1 entries r_0j ... r_jj
  std::vector<std::size_t> kept;       ///< number in V of each column
};

/// Takes the part of v along the columns of q away, and adds it to r.
void orthogonalise(const std::vector<std::vector<double>>& q, std::span<double> v, std::span<double> r)
{
  for (std::size_t i = 0; i < q.size(); ++i)
  {
    const double part = dot(q[i], v);
    add(-part, q[i], v);
    r[i] += part;
  }
}

/// Modified Gram-Schmidt, done twice, from the newest of the columns begin .. end - 1 of V to the oldest.
Factors factorise(const std::vector<double>& V, std::size_t size, std::size_t begin, std::size_t end,
                  double filter)
{
  Factors factors;
  for (std::size_t left = end; left > begin && factors.kept.size() < size; --left)
  {
    const std::span<const double> column = row(V, size, left - 1);
    std::vector<double> v(column.begin(), column.end());
    std::vector<double> r(factors.q.size(), 0.0);
    orthogonalise(factors.q, v, r);
    orthogonalise(factors.q, v, r);
    const double r_jj = norm(v);
    if (!(r_jj > 0.0) || r_jj < filter * norm(column))
      continue;
    r.push_back(r_jj);
    factors.q.push_back(scaled(1.0 / r_jj, v));
    factors.r.push_back(std::move(r));
    factors.kept.push_back(left - 1);
  }
  return factors;
}

/// c of R c = -Q^T residual: the combination of the kept columns of V that cancels most of the residual.
std::vector<double> least_squares(const Factors& factors, std::span<const double> residual)
{
  std::vector<double> c(factors.q.size());
  for (std::size_t j = 0; j < c.size(); ++j)
    c[j] = -dot(factors.q[j], residual);
  for (std::size_t j = c.size(); j-- > 0;)
  {
    c[j] /= factors.r[j][j];
    for (std::size_t i = 0; i < j; ++i)
      c[i] -= factors.r[j][i] * c[j];
  }
  return c;
}

/// The change of d, given the residual and what was remembered before it.
std::vector<double> increment(const Constant& constant, History&, std::span<const double> residual)
{
  return scaled(constant.relaxation, residual);
}

std::vector<double> increment(const Aitken& aitken, History& history, std::span<const double> residual)
{
  double omega = history.omega == 0.0 ? aitken.initial : std::min(std::abs(history.omega), aitken.initial);
  if (!history.last_residual.empty())
  {
    const std::vector<double> change = difference(residual, history.last_residual);
    const double square = dot(change, change);
    omega = square > 0.0 ? -history.omega * dot(history.last_residual, change) / square : history.omega;
  }
  history.omega = std::abs(omega) > least_progress && std::isfinite(omega) ? omega : aitken.initial;
  return scaled(history.omega, residual);
}

/// step <- step + W c, c = argmin |V c + residual| over the columns begin .. end - 1; takes what they
/// explain, -V c, away from the residual. Returns false where no column counts.
bool explain(const History& history, std::size_t begin, std::size_t end, double filter,
             std::span<double> residual, std::span<double> step)
{
  const std::size_t size = residual.size();
  const Factors factors = factorise(history.V, size, begin, end, filter);
  const std::vector<double> c = least_squares(factors, residual);
  for (std::size_t j = 0; j < c.size(); ++j)
  {
    add(c[j], row(history.W, size, factors.kept[j]), step);
    add(c[j], row(history.V, size, factors.kept[j]), residual);
  }
  return !c.empty();
}

/// The step, unless it undoes that of the solvers, so that the same iteration would repeat.
std::vector<double> unless_standing_still(std::vector<double> step, std::span<const double> residual,
                                          double initial)
{
  const double length = norm(step);
  const bool stands_still = length <= least_progress * norm(residual);
  return stands_still || !std::isfinite(length) ? scaled(initial, residual) : step;
}

std::vector<double> increment(const IqnIls& iqn, History& history, std::span<const double> residual)
{
  std::vector<double> step(residual.begin(), residual.end());
  std::vector<double> rest = step;
  if (!explain(history, 0, history.V.size() / residual.size(), iqn.filter, rest, step))
    return scaled(iqn.initial, residual);
  return unless_standing_still(std::move(step), residual, iqn.initial);
}

/// J_s r = J_{s-1} (r - V_s c) + W_s c with c = argmin |V_s c - r|: each step, the newest first, hands what
/// its columns leave unexplained to the one before. This is the recursion of J read backwards, so no J is
/// stored (cost linear in the number of columns, as in Spenke, Hosters & Behr 2020).
std::vector<double> increment(const IqnImvj& iqn, History& history, std::span<const double> residual)
{
  std::vector<double> step(residual.begin(), residual.end());
  std::vector<double> rest = step;
  bool knows = false;
  std::size_t end = history.V.size() / residual.size();
  for (std::size_t s = history.columns_per_step.size(); s-- > 0;)
  {
    const std::size_t begin = end - static_cast<std::size_t>(history.columns_per_step[s]);
    knows = explain(history, begin, end, iqn.filter, rest, step) || knows;
    end = begin;
  }
  return knows ? unless_standing_still(std::move(step), residual, iqn.initial)
               : scaled(iqn.initial, residual);
}

void check(double value, const char* name)
{
  if (!(value > 0.0 && value <= 1.0))
    throw Error(fmt::format("the {} of the coupling is {}; choose one above 0 and at most 1", name, value));
}

void check(const Constant& constant)
{
  check(constant.relaxation, "relaxation");
}

void check(const Aitken& aitken)
{
  check(aitken.initial, "initial relaxation");
}

template <typename QuasiNewton>
requires requires(QuasiNewton method)
{
  method.reuse;
}
void check(const QuasiNewton& iqn)
{
  check(iqn.initial, "initial relaxation");
  if (iqn.reuse < 0)
    throw Error(fmt::format("the coupling reuses {} steps; choose 0 or more", iqn.reuse));
  if (!(iqn.filter >= 0.0 && iqn.filter < 1.0))
    throw Error(fmt::format("the filter of the coupling is {}; choose at least 0 and below 1", iqn.filter));
}

/// Steps whose columns a method keeps; nothing where it has no columns.
std::optional<int> reused_steps(const Accelerator& accelerator)
{
  if (const auto* ils = std::get_if<IqnIls>(&accelerator))
    return ils->reuse;
  if (const auto* imvj = std::get_if<IqnImvj>(&accelerator))
    return imvj->reuse;
  return {};
}

}  // namespace

Acceleration::Acceleration(const Parameters& parameters, std::size_t size)
    : method_(parameters.accelerator), size_(size)
{
  std::visit([](const auto& method) { check(method); }, method_);
}

void Acceleration::start_step()
{
  const auto under_way = static_cast<std::ptrdiff_t>(history_.columns_per_step.back());
  const auto entries = under_way * static_cast<std::ptrdiff_t>(size_);
  history_.V.erase(history_.V.end() - entries, history_.V.end());
  history_.W.erase(history_.W.end() - entries, history_.W.end());
  history_.columns_per_step.back() = 0;
  history_.last_residual.clear();
  history_.last_answer.clear();
}

void Acceleration::next(std::span<double> d, std::span<const double> d_tilde)
{
  const std::vector<double> residual = difference(d_tilde, d);
  add_column(residual, d_tilde);
  const std::vector<double> step =
      std::visit([&](const auto& method) { return increment(method, history_, residual); }, method_);
  history_.last_residual = residual;
  history_.last_answer.assign(d_tilde.begin(), d_tilde.end());
  add(1.0, step, d);
}

void Acceleration::observe(std::span<const double> d, std::span<const double> d_tilde)
{
  const std::vector<double> residual = difference(d_tilde, d);
  add_column(residual, d_tilde);
  history_.last_residual = residual;
  history_.last_answer.assign(d_tilde.begin(), d_tilde.end());
}

void Acceleration::add_column(std::span<const double> residual, std::span<const double> answer)
{
  if (!reused_steps(method_) || history_.last_residual.empty())
    return;
  const std::vector<double> v = difference(residual, history_.last_residual);
  const std::vector<double> w = difference(answer, history_.last_answer);
  // Equal residuals teach nothing, and NaN would spoil all later steps.
  if (const double length = norm(v); !(length > 0.0) || !std::isfinite(length + norm(w)))
    return;
  history_.V.insert(history_.V.end(), v.begin(), v.end());
  history_.W.insert(history_.W.end(), w.begin(), w.end());
  ++history_.columns_per_step.back();
}

void Acceleration::accept_step()
{
  const auto reuse = static_cast<std::size_t>(reused_steps(method_).value_or(0));
  std::vector<std::int32_t>& steps = history_.columns_per_step;
  // A step without columns must not push out what earlier ones taught.
  if (steps.back() > 0)
    steps.push_back(0);
  while (steps.size() > reuse + 1)
  {
    const auto entries = static_cast<std::ptrdiff_t>(steps.front()) * static_cast<std::ptrdiff_t>(size_);
    history_.V.erase(history_.V.begin(), history_.V.begin() + entries);
    history_.W.erase(history_.W.begin(), history_.W.begin() + entries);
    steps.erase(steps.begin());
  }
  history_.last_residual.clear();
  history_.last_answer.clear();
}

void Acceleration::restore(History history)
{
  const auto columns = static_cast<std::size_t>(
      std::accumulate(history.columns_per_step.begin(), history.columns_per_step.end(), std::int64_t{0}));
  const auto fits = [this](const std::vector<double>& last) { return last.empty() || last.size() == size_; };
  if (history.columns_per_step.empty() || history.V.size() != columns * size_ ||
      history.W.size() != columns * size_ || !fits(history.last_residual) || !fits(history.last_answer))
    throw Error(
        fmt::format("the saved history of the coupling does not belong to an interface of {} unknowns; "
                    "restart with the case file that wrote it, or start anew",
                    size_));
  history_ = std::move(history);
}

}  // namespace blockfsi::coupling
