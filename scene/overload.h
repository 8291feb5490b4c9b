// overload.h: one lambda per alternative of a variant.
#pragma once

namespace litmus {

/// std::visit(Overload{[](const Sphere&) { ... }, [](const Plane&) { ... }}, shape)
template <class... F>
struct Overload : F... {
  using F::operator()...;
};
template <class... F>
Overload(F...) -> Overload<F...>;

}  // namespace litmus
