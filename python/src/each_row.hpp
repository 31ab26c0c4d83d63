// Rows of work on several threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace taut_python {

/// Does what is to be done to a row.
using RowWork = std::function<void(std::size_t row)>;

/// Does all rows, on so many threads; `worker` makes what each thread works with. Rows do not depend on each other, so
/// that what they give is the same for any number of threads. Once `stop` is true, rows are left as they are. Where
/// rows throw, the error of the first such row goes on, whose number it names; later ones may not have been done then.
void each_row(std::size_t rows, std::size_t threads, const std::atomic<bool>& stop,
              const std::function<RowWork()>& worker);

}  // namespace taut_python
