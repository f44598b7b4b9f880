#include "motion/update.hpp"

#include "core/error.hpp"

#include <utility>

namespace blockfsi::motion
{

Update make_update(const Parameters& parameters, const Domain& domain, block::CornerMotion corners)
{
  return std::visit(
      [&](const auto& kind) -> Update
      {
        if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, Regeneration>)
          return Regenerate(domain.skeleton, domain.plan, domain.interface, std::move(corners));
        else
          return Extension(kind, domain);
      },
      parameters);
}

Report follow(Update& update, std::span<const double> displacement, std::span<double> x)
{
  if (auto* extension = std::get_if<Extension>(&update))
    return extension->follow(displacement, x);
  std::get<Regenerate>(update).follow(displacement, x);
  return {};
}

void accept(Update& update, std::span<const double> displacement, std::span<const double> x)
{
  if (auto* extension = std::get_if<Extension>(&update))
    extension->accept(displacement, x);
}

std::vector<double> memory(const Update& update)
{
  return std::visit([](const auto& kind) { return kind.memory(); }, update);
}

void recall(Update& update, std::span<const double> memory_of_past)
{
  if (memory(update).size() != memory_of_past.size())
    throw Error("the mesh was moved in another way before; start anew without --restart, or choose the same "
                "[motion]");
  std::visit([&](auto& kind) { kind.recall(memory_of_past); }, update);
}

}  // namespace blockfsi::motion
