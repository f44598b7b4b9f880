#include "fem/cell_loop.hpp"

namespace blockfsi::fem
{

void CellLoop::gather(std::size_t batch, NodalField field, Lanes* out) const
{
  const int n = mesh_->nodes_per_cell();
  for (int lane = 0; lane < lane_count; ++lane)
  {
    const std::int32_t* nodes = mesh_->cells.data() + cell(batch, lane) * n;
    for (int i = 0; i < n; ++i)
    {
      const double* values = field.values + static_cast<std::size_t>(nodes[i]) * field.components;
      for (int c = 0; c < field.components; ++c)
        out[c * n + i][lane] = values[c];
    }
  }
}

}  // namespace blockfsi::fem
