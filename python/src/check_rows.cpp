#include "check_rows.hpp"

#include <memory>
#include <optional>

#include "each_row.hpp"
#include "taut/warm_check.hpp"

namespace taut_python {

namespace {

/// What one thread asks. Rows of one scene mostly begin where others do, or near: the kinetic engine then goes on from
/// the tiling of the last row that this thread had, with the same answers.
class Questioner {
 public:
  explicit Questioner(const taut::CheckOptions& options) : options_(options) {
    if (options.engine == taut::EngineChoice::kinetic) warm_.emplace(options);
  }
  taut::Answer check(const taut::Scene& scene) { return warm_ ? warm_->check(scene) : taut::check(scene, options_); }

 private:
  const taut::CheckOptions& options_;
  std::optional<taut::WarmCheck> warm_;
};

}  // namespace

void check_rows(const RowScenes& scenes, const taut::CheckOptions& options, std::size_t threads, AnswerRow* answers) {
  each_row(scenes.size(), threads, *options.limits.stop, [&]() -> RowWork {
    // Shared, since what a function holds must be copyable.
    const auto scene = std::make_shared<taut::Scene>(scenes.blank());
    const auto questioner = std::make_shared<Questioner>(options);
    return [&scenes, answers, scene, questioner](std::size_t row) {
      scenes.fill(*scene, row);
      answers[row] = answer_row(questioner->check(*scene));
    };
  });
}

}  // namespace taut_python
