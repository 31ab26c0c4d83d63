// Many checks on several threads.
#pragma once

#include <cstddef>

#include "answer_row.hpp"
#include "row_scenes.hpp"

namespace taut_python {

/// Checks every row into `answers`, which has room for all, on so many threads. Rows do not depend on each other, so
/// that the answers are the same for any number of threads. Limits of the options are for each row; once `stop` of the
/// options is true, rows are left as they are. Where rows throw, the error of the first such row goes on, whose number
/// it names; the answers of later ones may be missing then.
void check_rows(const RowScenes& rows, const taut::CheckOptions& options, std::size_t threads, AnswerRow* answers);

}  // namespace taut_python
