#include "fem/tensor.hpp"

namespace blockfsi::fem
{

namespace
{

/// out(point, j) = sum_i table(point, i) nodal(i, j): along xi for every row j of nodes.
void along_xi(int points, int nodes, const double* table, const Lanes* nodal, Lanes* out)
{
  for (int j = 0; j < nodes; ++j)
    for (int q = 0; q < points; ++q)
    {
      Lanes sum{};
      for (int i = 0; i < nodes; ++i)
        sum += table[q * nodes + i] * nodal[j * nodes + i];
      out[j * points + q] = sum;
    }
}

/// out(q, r) = sum_j table(r, j) rows(q, j): along eta for every column q of points.
void along_eta(int points, int nodes, const double* table, const Lanes* rows, Lanes* out)
{
  for (int r = 0; r < points; ++r)
    for (int q = 0; q < points; ++q)
    {
      Lanes sum{};
      for (int j = 0; j < nodes; ++j)
        sum += table[r * nodes + j] * rows[j * points + q];
      out[r * points + q] = sum;
    }
}

}  // namespace

void interpolate(const LineTable& table, const Lanes* nodal, const ReferenceValues& out)
{
  const int m = table.points;
  const int n = table.nodes;
  Lanes rows[max_line * max_line];
  along_xi(m, n, table.value.data(), nodal, rows);
  if (out.value != nullptr)
    along_eta(m, n, table.value.data(), rows, out.value);
  if (out.eta != nullptr)
    along_eta(m, n, table.first.data(), rows, out.eta);
  if (out.eta_eta != nullptr)
    along_eta(m, n, table.second.data(), rows, out.eta_eta);
  if (out.xi != nullptr)
  {
    along_xi(m, n, table.first.data(), nodal, rows);
    along_eta(m, n, table.value.data(), rows, out.xi);
    if (out.xi_eta != nullptr)
      along_eta(m, n, table.first.data(), rows, out.xi_eta);
  }
  if (out.xi_xi != nullptr)
  {
    along_xi(m, n, table.second.data(), nodal, rows);
    along_eta(m, n, table.value.data(), rows, out.xi_xi);
  }
}

void integrate(const LineTable& table, const Lanes* value, const Lanes* xi, const Lanes* eta, Lanes* nodal)
{
  const int m = table.points;
  const int n = table.nodes;
  for (int j = 0; j < n; ++j)
  {
    Lanes of_value[max_line];
    Lanes of_xi[max_line];
    for (int q = 0; q < m; ++q)
    {
      of_value[q] = Lanes{};
      of_xi[q] = Lanes{};
    }
    for (int r = 0; r < m; ++r)
    {
      const double v = table.value[r * n + j];
      const double d = table.first[r * n + j];
      for (int q = 0; q < m; ++q)
      {
        of_value[q] += v * value[r * m + q] + d * eta[r * m + q];
        of_xi[q] += v * xi[r * m + q];
      }
    }
    for (int i = 0; i < n; ++i)
    {
      Lanes sum{};
      for (int q = 0; q < m; ++q)
        sum += table.value[q * n + i] * of_value[q] + table.first[q * n + i] * of_xi[q];
      nodal[j * n + i] += sum;
    }
  }
}

}  // namespace blockfsi::fem
