// One function object of several, one for each case: for std::visit, which wants every case. So a form that is added to
// a variant, and forgotten somewhere, does not compile.
#pragma once

namespace taut::internal {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace taut::internal
