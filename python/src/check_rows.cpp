#include "check_rows.hpp"

#include <memory>

#include "each_row.hpp"
#include "taut/check.hpp"

namespace taut_python {

void check_rows(const RowScenes& scenes, const taut::CheckOptions& options, std::size_t threads, AnswerRow* answers) {
  each_row(scenes.size(), threads, *options.limits.stop, [&]() -> RowWork {
    // Shared, since what a function holds must be copyable.
    const auto scene = std::make_shared<taut::Scene>(scenes.blank());
    return [&scenes, &options, answers, scene](std::size_t row) {
      scenes.fill(*scene, row);
      answers[row] = answer_row(taut::check(*scene, options));
    };
  });
}

}  // namespace taut_python
