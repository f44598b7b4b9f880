#include "block/kernel.hpp"

#include "block/kernel_row.hpp"

namespace blockfsi::block
{

std::size_t kernel_work(const BlockPlan& plan, int dim)
{
  const auto own = [&]() -> std::size_t
  {
    switch (plan.grid.shape)
    {
    case element::Shape::triangle:
      return triangle_work(plan, dim);
    case element::Shape::hexahedron:
      return hexahedron_work(plan);
    case element::Shape::prism:
      return prism_work(plan);
    case element::Shape::tetrahedron:
      return tetrahedron_work(plan);
    case element::Shape::pyramid:
      return pyramid_work(plan);
    default:
      return 0;
    }
  };
  return coordinate_work(plan, dim) + own();
}

}  // namespace blockfsi::block
