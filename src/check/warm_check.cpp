#include "taut/warm_check.hpp"

#include "check/run.hpp"
#include "kinetic/near_start.hpp"
#include "pair/validate_world.hpp"

namespace taut {
using namespace internal;

struct WarmCheck::Impl {
  CheckOptions options;
  NearStart near;
  std::uint64_t warm = 0;
};

namespace {

/// Requires two plain polygons with prepared shapes.
bool may_begin_near(const Scene& scene, const CheckOptions& options) {
  if (scene.bodies.size() != 2 || !scene.bodies[0].prepared || !scene.bodies[1].prepared) return false;
  return options.fit == 0 && !options.all_pairs && !is_world(scene);
}

}  // namespace

WarmCheck::WarmCheck(const CheckOptions& options) : impl_(std::make_unique<Impl>()) {
  impl_->options = options;
  impl_->options.engine = EngineChoice::kinetic;
}
WarmCheck::~WarmCheck() = default;
WarmCheck::WarmCheck(WarmCheck&&) noexcept = default;
WarmCheck& WarmCheck::operator=(WarmCheck&&) noexcept = default;

Answer WarmCheck::check(const Scene& scene) {
  if (!may_begin_near(scene, impl_->options)) return taut::check(scene, impl_->options);
  const NearAnswer found = run_kinetic(scene, impl_->options, impl_->near);
  impl_->warm += found.began_near;
  return found.answer;
}

std::uint64_t WarmCheck::warm_starts() const { return impl_->warm; }

}  // namespace taut
