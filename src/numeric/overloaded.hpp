// One function object composed of several, one for each case: for std::visit, which requires every case. So if an
// alternative is added to a variant and one of its uses is forgotten, the code does not compile.
#pragma once

namespace taut::internal {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace taut::internal
